#include "pipeline/font_hints.hpp"

#include <cstddef>
#include <vector>

#include "base/work_pool.hpp"
#include "hints/grid_section.hpp"
#include "inkcell/format/rom.hpp"
#include "rom/outline_font.hpp"

namespace inkcell::gen {
namespace {

// Offsets of records are limited: what does not fit has no hints.
void limit_records(FontHints& hints) {
  constexpr size_t kMostBytes = (size_t{1} << format::grid::kMaxOffsetBits) - 1;
  size_t bytes = 0;
  for (GlyphHints& glyph : hints.glyphs) {
    const size_t record = hint_record(glyph).size();
    if (bytes + record > kMostBytes) {
      glyph = GlyphHints();
    } else {
      bytes += record;
    }
  }
}

}  // namespace

FontHints find_hints(const RomContent& content, int jobs) {
  const size_t count = content.glyphs.size();
  std::vector<GlyphFeatures> features(count);
  parallel_for(count, jobs, [&](size_t i) {
    features[i] = find_features(decoded_outline(content, i));
  });
  FontHints hints;
  hints.face = find_face(features, content.glyph_of);
  const double u = 1024.0 / content.metrics.units_per_em;
  for (size_t i = 0; i < count; ++i) {
    const GlyphMetrics& metrics = content.glyphs[i].metrics;
    hints.glyphs.push_back(make_glyph_hints(
        features[i], hints.face, {metrics.x_min * u, metrics.x_max * u}));
  }
  limit_records(hints);
  return hints;
}

}  // namespace inkcell::gen
