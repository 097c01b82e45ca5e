// How effects draw glyphs.
#pragma once

#include "rows/source.hpp"

namespace inkcell {
namespace detail {

// Makes coverage of painted bands and hands it to sinks. The style's effect
// names it, so that the linker drops the others.
struct Mixer {
  const BandPainter*
      painter;  // the kind of band that it takes; null: the style's
  // Changes the plan that the style's filter asks for.
  void (*plan)(const Style& style, BandPlan& plan) noexcept;
  // Draws job.pixels of the painted job.band into job.sink.
  void (*mix)(GlyphJob& job) noexcept;
  // Asks the field of the job: other sources, and styles that stretch edges
  // differently, are not drawn (check_effect()).
  bool needs_field = false;
};

// Whether a mixer draws glyphs of a source with a style.
inline bool can_mix(const Mixer& mixer,
                    const Source& source,
                    const Style& style) noexcept {
  return !mixer.needs_field || (source.has_field && !style.is_stretched());
}

// For mix(): paints the band anew, with the glyph moved by so much from where
// it was painted last. [px]
void repaint(GlyphJob& job, int32_t right_q8, int32_t down_q8) noexcept;

}  // namespace detail
}  // namespace inkcell
