// How LVGL turns, scales and skews a letter.
#pragma once

#include <stdint.h>

#include "inkcell/matrix.hpp"
#include "lvgl_private.h"

namespace inkcell::port {

/// A linear map, right and up, as Matrix, of a size of 1. [Q15]
struct LetterMatrix {
  int32_t x_right = 1 << 15;
  int32_t x_up = 0;
  int32_t y_right = 0;
  int32_t y_up = 1 << 15;
  bool is_upright = true;

  /// The map of a glyph of a task: letters (lv_draw_letter) may be scaled and
  /// skewed as well. LVGL's order: skewed, scaled, turned clockwise.
  LetterMatrix(const lv_draw_task_t& task,
               const lv_draw_glyph_dsc_t& glyph) noexcept;

  /// The same for glyphs of that size. [px to the em, Q6]
  Matrix of_size(int32_t size_q6) const noexcept;
};

}  // namespace inkcell::port
