// How effects draw glyphs.
#pragma once

#include "rows/source.hpp"

namespace inkcell {
namespace detail {

// Makes coverage of painted bands and hands it to sinks. The style's effect
// names it, so that the linker drops the others.
struct Mixer {
  const Painter* painter;  // the kind of band that it takes; null: the style's
  // Changes the plan that the style's filter asks for.
  void (*plan)(const TextStyle& style, BandPlan& plan) noexcept;
  // Draws job.pixels of the painted job.band into job.sink.
  void (*mix)(const GlyphJob& job) noexcept;
};

}  // namespace detail
}  // namespace inkcell
