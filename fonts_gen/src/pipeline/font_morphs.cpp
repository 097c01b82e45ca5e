#include "pipeline/font_morphs.hpp"

#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <utility>

#include "morph/find_morph.hpp"
#include "morph/master_morph.hpp"
#include "morph/morph_record.hpp"
#include "outlines/outline_steps.hpp"
#include "parallel.hpp"
#include "rom/outline_font.hpp"

namespace inkcell::gen {
namespace {

// The characters of each group: blanks part them.
std::vector<CharSet> groups_of(const GenerateRequest& request) {
  std::vector<CharSet> groups;
  for (const std::string& text : request.morphs) {
    std::istringstream words(text);
    std::string word;
    while (words >> word) {
      CharSet group;
      add_text(word, "--morph", group);
      if (group.size() < 2) {
        throw Error("--morph " +
                    (group.empty() ? word : describe(*group.begin())) +
                    ": a glyph morphs into another one; name at least two "
                    "characters, such as 01");
      }
      groups.push_back(std::move(group));
    }
  }
  return groups;
}

using GlyphPair = std::pair<uint16_t, uint16_t>;

std::set<GlyphPair> pairs_of(const std::vector<CharSet>& groups,
                             const RomContent& content) {
  std::set<GlyphPair> pairs;
  for (const CharSet& group : groups) {
    std::set<uint16_t> glyphs;
    for (const char32_t c : group) {
      const auto found = content.glyph_of.find(c);
      // Characters that are missing have their warning.
      if (found != content.glyph_of.end() &&
          content.glyphs[found->second].has_ink()) {
        glyphs.insert(found->second);
      }
    }
    for (auto first = glyphs.begin(); first != glyphs.end(); ++first) {
      for (auto second = std::next(first); second != glyphs.end(); ++second) {
        pairs.emplace(*first, *second);
      }
    }
  }
  return pairs;
}

// As docs/FORMAT.md numbers the points of a contour, from `first` on: its
// start, the points after it, and the start once more.
void add_numbers(const MinimalContour& contour,
                 int first,
                 SegmentPoints& numbers) {
  const size_t n = contour.points.size();
  const auto off = [&](size_t i) {
    return contour.points[i % n].kind == PointKind::off_curve;
  };
  for (size_t i = 1; i <= n; ++i) {
    numbers.push_back(first + static_cast<int>(i));
    i += off(i) && !off(i + 1) ? 1u : 0u;
  }
}

// None if steps were halved on the way to the record.
SegmentPoints numbers_of(const RomContent& content, size_t glyph) {
  std::vector<size_t> parts;
  for (const OutlineReference& part : content.glyphs[glyph].references) {
    parts.push_back(part.glyph);
  }
  if (parts.empty()) {
    parts.push_back(glyph);
  }
  SegmentPoints numbers;
  int first = 0;
  for (const size_t part : parts) {
    const RomGlyph& simple = content.glyphs[part];
    const int begin = first;
    for (const MinimalContour& contour : simple.outline.contours) {
      add_numbers(contour, first, numbers);
      first += static_cast<int>(contour.points.size()) + 1;
    }
    const auto steps = outline_steps(
        simple.outline, record_start(simple.metrics.x_min, simple.metrics.y_min,
                                     content.outlines.grid_shift));
    if (point_count(steps) != first - begin) {
      return {};
    }
  }
  return numbers;
}

std::optional<MorphPair> find_pair(const SourceFont& font,
                                   const RomContent& content,
                                   const GlyphPair& glyphs) {
  const Outline first = decoded_outline(content, glyphs.first);
  const Outline second = decoded_outline(content, glyphs.second);
  if (!font.glyphs[glyphs.second].master.empty()) {
    auto pair = find_master_morph(first, second,
                                  {font.glyphs[glyphs.first].outline,
                                   font.glyphs[glyphs.second].outline});
    if (pair) {
      return pair;
    }
  }
  return find_morph(first, second);
}

RomMorph make_morph(const SourceFont& font,
                    const RomContent& content,
                    const GlyphPair& glyphs) {
  RomMorph morph;
  morph.first = glyphs.first;
  morph.second = glyphs.second;
  if (!content.glyphs[glyphs.first].has_ink() &&
      !content.glyphs[glyphs.second].has_ink()) {
    morph.record = {0};  // no contours: only the advance changes
    return morph;
  }
  const SegmentPoints numbers[] = {numbers_of(content, glyphs.first),
                                   numbers_of(content, glyphs.second)};
  if (numbers[0].empty() || numbers[1].empty()) {
    return morph;
  }
  try {
    if (const auto pair = find_pair(font, content, glyphs)) {
      morph.record = morph_record(*pair, numbers);
      morph.points =
          morph_points(*pair) + numbers[0].back() + numbers[1].back() + 2;
    }
  } catch (const GeometryError&) {
    // Too large for the format.
  }
  return morph;
}

// The plain glyphs with their second masters, and where these begin.
std::set<GlyphPair> master_pairs(const SourceFont& font, size_t& begin) {
  std::set<GlyphPair> pairs;
  std::map<std::pair<size_t, uint32_t>, uint16_t> plain;
  begin = 0;
  for (size_t i = 0; i < font.glyphs.size(); ++i) {
    const SourceGlyph& glyph = font.glyphs[i];
    const auto id = static_cast<uint16_t>(i);
    const std::pair key(glyph.face, glyph.source);
    if (glyph.master.empty()) {
      plain.emplace(key, id);
      continue;
    }
    begin = begin == 0 ? i : begin;
    pairs.emplace(plain.at(key), id);
  }
  return pairs;
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) {
    text += (text.empty() ? " " : ", ") + name;
  }
  return text;
}

void tell_of_missing(const std::vector<std::string>& pairs,
                     const std::vector<std::string>& masters,
                     Warnings& warnings) {
  if (!pairs.empty()) {
    warnings.push_back(
        {Warning::Kind::no_morph,
         "--morph: no way without crossing outlines for" + listed(pairs) +
             "; the font leaves these pairs out, GlyphMorph blends them by "
             "their distances"});
  }
  if (!masters.empty()) {
    warnings.push_back(
        {Warning::Kind::no_morph,
         "--axis: no way without crossing outlines to" + listed(masters) +
             "; these letters stay as they are while others morph; bring "
             "the values of the axis nearer to each other, or leave the "
             "letters out"});
  }
}

}  // namespace

void add_morph_characters(const GenerateRequest& request, CharSet& characters) {
  for (const CharSet& group : groups_of(request)) {
    characters.insert(group.begin(), group.end());
  }
}

void add_morphs(const GenerateRequest& request,
                const SourceFont& font,
                RomContent& content,
                Warnings& warnings) {
  std::set<GlyphPair> set = master_pairs(font, content.first_master);
  set.merge(pairs_of(groups_of(request), content));
  const std::vector<GlyphPair> pairs(set.begin(), set.end());
  std::vector<RomMorph> morphs(pairs.size());
  parallel_for(pairs.size(), request.threads, [&](size_t i) {
    morphs[i] = make_morph(font, content, pairs[i]);
  });
  std::vector<std::string> missing_pairs;
  std::vector<std::string> missing_masters;
  for (RomMorph& morph : morphs) {
    const SourceGlyph& second = font.glyphs[morph.second];
    if (!morph.record.empty()) {
      content.morphs.push_back(std::move(morph));
    } else if (second.master.empty()) {
      missing_pairs.push_back(font.glyphs[morph.first].name() + " and " +
                              second.name());
    } else {
      missing_masters.push_back(second.name());
    }
  }
  tell_of_missing(missing_pairs, missing_masters, warnings);
}

}  // namespace inkcell::gen
