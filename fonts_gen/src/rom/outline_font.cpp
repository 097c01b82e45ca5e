#include "rom/outline_font.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "outlines/code_search.hpp"
#include "outlines/composites.hpp"
#include "outlines/expand.hpp"
#include "outlines/outline_steps.hpp"

namespace inkcell::gen {
namespace {

// `outline` [u] where the reference puts it.
Outline placed(Outline outline, const OutlineReference& at, double u) {
  const auto& m = at.matrix_q14;
  const auto times = [&m](size_t i, double value) {
    return std::ldexp(m[i] * value, -14);
  };
  for (Contour& contour : outline.contours) {
    for (Segment& segment : contour.segments) {
      for (Point& p : segment.p) {
        p = {times(0, p.x) + times(1, p.y) + at.dx * u,
             times(2, p.x) + times(3, p.y) + at.dy * u};
      }
    }
  }
  return outline;
}

template <typename MakeCode>
void encode(RomContent& content, const MakeCode& make_code) {
  OutlineCoding& coding = content.outlines;
  std::vector<std::vector<OutlineStep>> steps(content.glyphs.size());
  std::vector<int> points(content.glyphs.size());
  StepCounts counts;
  for (size_t i = 0; i < content.glyphs.size(); ++i) {
    const RomGlyph& glyph = content.glyphs[i];
    if (!glyph.outline.contours.empty() && glyph.references.empty()) {
      steps[i] = outline_steps(
          glyph.outline, record_start(glyph.metrics.x_min, glyph.metrics.y_min,
                                      coding.grid_shift));
      counts.add(steps[i]);
      points[i] = point_count(steps[i]);
    }
  }
  const OutlineCode code = make_code(counts);
  coding.code_bits = code.code_bits();
  coding.table = code.table();
  coding.max_points = 0;
  for (size_t i = 0; i < content.glyphs.size(); ++i) {
    RomGlyph& glyph = content.glyphs[i];
    glyph.outline_record.clear();
    glyph.record_bits = 0;
    int sum = points[i];
    if (!glyph.references.empty()) {
      glyph.outline_record = composite_record(glyph.references);
      glyph.record_bits = composite_bits(glyph.references);
      for (const OutlineReference& reference : glyph.references) {
        sum += points[reference.glyph];
      }
    } else if (!steps[i].empty()) {
      glyph.outline_record = outline_record(steps[i], code);
      glyph.record_bits = outline_bits(steps[i], code);
    }
    coding.max_points = std::max(coding.max_points, sum);
  }
}

}  // namespace

void encode_outlines(RomContent& content) {
  encode(content, [&content](const StepCounts& counts) {
    return make_outline_code(counts, content.outlines.most_entries);
  });
}

void encode_outlines_widely(RomContent& content) {
  encode(content, [](const StepCounts&) { return widest_outline_code(); });
}

Outline decoded_outline(const RomContent& content, size_t glyph) {
  const int units_per_em = content.metrics.units_per_em;
  const int grid_shift = content.outlines.grid_shift;
  const RomGlyph& decoded = content.glyphs[glyph];
  if (decoded.references.empty()) {
    return expand(decoded.outline, units_per_em, grid_shift);
  }
  Outline whole;
  for (const OutlineReference& part : decoded.references) {
    const Outline component = placed(
        expand(content.glyphs[part.glyph].outline, units_per_em, grid_shift),
        part, 1024.0 / units_per_em);
    whole.contours.insert(whole.contours.end(), component.contours.begin(),
                          component.contours.end());
  }
  return whole;
}

void find_references(const std::vector<OutlineReferences>& source,
                     RomContent& content) {
  std::vector<CompositeCandidate> candidates(content.glyphs.size());
  for (size_t i = 0; i < candidates.size(); ++i) {
    candidates[i].outline = content.glyphs[i].outline;
    candidates[i].simple_bytes = content.glyphs[i].outline_record.size();
    candidates[i].source = source[i];
  }
  std::vector<OutlineReferences> found =
      find_composites(candidates, content.outlines.grid_shift);
  for (size_t i = 0; i < found.size(); ++i) {
    content.glyphs[i].references = std::move(found[i]);
    content.glyphs[i].simple_bytes =
        content.glyphs[i].references.empty() ? 0 : candidates[i].simple_bytes;
  }
}

std::vector<size_t> used_glyphs(RomContent& content,
                                const std::function<bool(size_t)>& is_needed) {
  const size_t count = content.glyphs.size();
  std::vector<bool> used(count);
  for (size_t i = 0; i < count; ++i) {
    if (is_needed(i)) {
      used[i] = true;
      for (const OutlineReference& part : content.glyphs[i].references) {
        used[part.glyph] = true;
      }
    }
  }
  std::vector<size_t> kept;
  std::vector<size_t> place(count);
  for (size_t i = 0; i < count; ++i) {
    if (used[i]) {
      place[i] = kept.size();
      kept.push_back(i);
    }
  }
  for (RomGlyph& glyph : content.glyphs) {
    for (OutlineReference& part : glyph.references) {
      part.glyph = place[part.glyph];
    }
  }
  return kept;
}

}  // namespace inkcell::gen
