#include "pipeline/font_morphs.hpp"

#include <algorithm>
#include <set>
#include <sstream>
#include <utility>

#include "base/work_pool.hpp"
#include "morph/find_morph.hpp"
#include "morph/morph_record.hpp"
#include "outlines/outline_steps.hpp"
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

RomMorph make_morph(const RomContent& content, const GlyphPair& glyphs) {
  RomMorph morph;
  morph.first = glyphs.first;
  morph.second = glyphs.second;
  const SegmentPoints numbers[] = {numbers_of(content, glyphs.first),
                                   numbers_of(content, glyphs.second)};
  if (numbers[0].empty() || numbers[1].empty()) {
    return morph;
  }
  try {
    const auto pair = find_morph(decoded_outline(content, glyphs.first),
                                 decoded_outline(content, glyphs.second));
    if (pair) {
      morph.record = morph_record(*pair, numbers);
      morph.points =
          morph_points(*pair) + numbers[0].back() + numbers[1].back() + 2;
    }
  } catch (const GeometryError&) {
    // Too large for the format.
  }
  return morph;
}

// The least character of a glyph, for messages.
std::string name_of(const RomContent& content, uint16_t glyph) {
  for (const auto& [c, of] : content.glyph_of) {
    if (of == glyph) {
      return describe(c);
    }
  }
  return "?";
}

}  // namespace

void add_morph_characters(const GenerateRequest& request, CharSet& characters) {
  for (const CharSet& group : groups_of(request)) {
    characters.insert(group.begin(), group.end());
  }
}

void add_morphs(const GenerateRequest& request,
                RomContent& content,
                Warnings& warnings) {
  const std::set<GlyphPair> set = pairs_of(groups_of(request), content);
  const std::vector<GlyphPair> pairs(set.begin(), set.end());
  std::vector<RomMorph> morphs(pairs.size());
  parallel_for(pairs.size(), request.threads,
               [&](size_t i) { morphs[i] = make_morph(content, pairs[i]); });
  std::string missing;
  for (RomMorph& morph : morphs) {
    if (morph.record.empty()) {
      missing += (missing.empty() ? " " : ", ") +
                 name_of(content, morph.first) + " and " +
                 name_of(content, morph.second);
    } else {
      content.morphs.push_back(std::move(morph));
    }
  }
  if (!missing.empty()) {
    warnings.push_back(
        {Warning::Kind::no_morph,
         "--morph: no way without crossing outlines for" + missing +
             "; the font leaves these pairs out, GlyphMorph blends them by "
             "their distances"});
  }
}

}  // namespace inkcell::gen
