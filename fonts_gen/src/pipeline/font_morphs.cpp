#include "pipeline/font_morphs.hpp"

#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string_view>
#include <utility>

#include "morph/find_morph.hpp"
#include "morph/master_morph.hpp"
#include "morph/morph_record.hpp"
#include "outlines/outline_steps.hpp"
#include "parallel.hpp"
#include "rom/outline_font.hpp"

namespace inkcell::gen {
namespace {

// Characters whose glyphs are paired.
struct Group {
  CharSet characters;
  bool by_points = false;  // see find_master_morph()
};

// Blanks part them.
std::vector<Group> groups_of(const GenerateRequest& request) {
  constexpr std::string_view kByPoints = "points:";
  std::vector<Group> groups;
  for (const std::string& text : request.morphs) {
    std::istringstream words(text);
    std::string word;
    while (words >> word) {
      Group group;
      group.by_points = word.rfind(kByPoints, 0) == 0;
      if (group.by_points) {
        word.erase(0, kByPoints.size());
      }
      const CharSet& characters = group.characters;
      add_text(word, "--morph", group.characters);
      if (characters.size() < 2) {
        throw Error(
            "--morph " +
            (characters.empty() ? word : describe(*characters.begin())) +
            ": a glyph morphs into another one; name at least two "
            "characters, such as 01");
      }
      groups.push_back(std::move(group));
    }
  }
  return groups;
}

using GlyphPair = std::pair<uint16_t, uint16_t>;
using GlyphPairs = std::map<GlyphPair, bool>;  // whether by points

void add_pairs(const std::vector<Group>& groups,
               const RomContent& content,
               GlyphPairs& pairs) {
  for (const Group& group : groups) {
    std::set<uint16_t> glyphs;
    for (const char32_t c : group.characters) {
      const auto found = content.glyph_of.find(c);
      // Characters that are missing have their warning.
      if (found != content.glyph_of.end() &&
          content.glyphs[found->second].has_ink()) {
        glyphs.insert(found->second);
      }
    }
    for (auto first = glyphs.begin(); first != glyphs.end(); ++first) {
      for (auto second = std::next(first); second != glyphs.end(); ++second) {
        pairs[{*first, *second}] |= group.by_points;
      }
    }
  }
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

std::string count_of(const SourceGlyph& glyph) {
  size_t count = 0;
  for (const Contour& contour : glyph.outline.contours) {
    count += contour.segments.size();
  }
  return glyph.name() + " has " + std::to_string(count) + " in " +
         std::to_string(glyph.outline.contours.size()) + " contours";
}

std::optional<MorphPair> find_pair(const SourceFont& font,
                                   const RomContent& content,
                                   const GlyphPair& glyphs,
                                   bool by_points) {
  const Outline first = decoded_outline(content, glyphs.first);
  const Outline second = decoded_outline(content, glyphs.second);
  if (!by_points) {
    return find_morph(first, second);
  }
  const SourceGlyph* const sources[] = {&font.glyphs[glyphs.first],
                                        &font.glyphs[glyphs.second]};
  const bool is_master = !sources[1]->master.empty();
  if (!is_master &&
      !have_equal_points(sources[0]->outline, sources[1]->outline)) {
    throw Error("--morph points: " + count_of(*sources[0]) + ", " +
                count_of(*sources[1]) +
                ": both need the same contours of the same lines and curves, "
                "in the same order; draw them so, or leave 'points:' out");
  }
  auto pair = find_master_morph(first, second,
                                {sources[0]->outline, sources[1]->outline});
  return pair || !is_master ? pair : find_morph(first, second);
}

RomMorph make_morph(const SourceFont& font,
                    const RomContent& content,
                    const GlyphPair& glyphs,
                    bool by_points) {
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
    if (const auto pair = find_pair(font, content, glyphs, by_points)) {
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
GlyphPairs master_pairs(const SourceFont& font, size_t& begin) {
  GlyphPairs pairs;
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
    pairs[{plain.at(key), id}] = true;
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
  for (const Group& group : groups_of(request)) {
    characters.insert(group.characters.begin(), group.characters.end());
  }
}

void add_morphs(const GenerateRequest& request,
                const SourceFont& font,
                RomContent& content,
                Warnings& warnings) {
  GlyphPairs map = master_pairs(font, content.first_master);
  add_pairs(groups_of(request), content, map);
  const std::vector<std::pair<GlyphPair, bool>> pairs(map.begin(), map.end());
  std::vector<RomMorph> morphs(pairs.size());
  parallel_for(pairs.size(), request.threads, [&](size_t i) {
    morphs[i] = make_morph(font, content, pairs[i].first, pairs[i].second);
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
