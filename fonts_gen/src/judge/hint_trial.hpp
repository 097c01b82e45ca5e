// Hints tried out with the device's own code.
#pragma once

#include <cstdint>
#include <vector>

#include "judge/canvas.hpp"
#include "rom/rom_content.hpp"

namespace inkcell::gen {

/// What a reader tells letters by.
struct Topology {
  int parts = 0;     // of ink; pixels that touch at a corner are joined
  int counters = 0;  // enclosed by ink
};

/// Counts the pixels that are more than a third covered.
Topology topology_of(const Canvas& canvas);

/// Draws every glyph of `content` small, with its hints and without some of
/// them, and drops those with which it loses parts or counters, or gains false
/// ones. Records must be encoded. `jobs`: threads; 0: all cores.
void drop_harmful_hints(RomContent& content, int jobs);

}  // namespace inkcell::gen
