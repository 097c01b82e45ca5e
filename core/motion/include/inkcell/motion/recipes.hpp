// Small animations of text that products need, ready-made.
//
//   Counter counter(font, style, {8, 60}, 4);
//   counter.roll(0, 1250, timing);
//   for (;;) {
//     const Rect changed = counter.at(now_ms());
//     INKCELL_TRY(port::run_strips(loop, changed));  // counter.draw(painter)
//   }
//
// All are functions of time: at() takes any time, in any order, and returns the
// pixels that differ from those of the last call, all of them at first, none if
// nothing changed. draw() draws into any strip, over the caller's background,
// and changes nothing. Fonts, styles and texts must outlive a recipe; styles
// must be upright. No heap, no grids; what a program does not use is not
// linked.
//
// Text that scrolls by, a ticker, is ScrollingLabel (inkcell/layout/label.hpp)
// in a SoftWindow (fade.hpp).
#pragma once

#include "inkcell/motion/clock.hpp"
#include "inkcell/motion/counter.hpp"
#include "inkcell/motion/fade.hpp"
#include "inkcell/motion/moving_letters.hpp"
#include "inkcell/motion/typewriter.hpp"
#include "inkcell/motion/weight_pulse.hpp"
#include "inkcell/motion/wipe.hpp"
