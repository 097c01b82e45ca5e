// Draws glyphs of outlines in one style and checks the promises of the
// renderer, with small windows, small workspaces and any bytes.
#pragma once

#include "inkcell/font.hpp"
#include "inkcell/geometry.hpp"
#include "inkcell/span.hpp"
#include "inkcell/style.hpp"

namespace hostile {

/// The effects that take outlines, by number.
inline constexpr uint32_t kEffectCount = 12;

/// Filters by number; the last one is exact coverage.
inline constexpr uint32_t kFilterCount = 9;

/// Directions and matrices by number; 0 is upright.
inline constexpr uint32_t kMapCount = 12;

struct OutlineLook {
  int32_t size_q6 = 16 * 64;  // 4 to 1024 px; matrices are within it
  uint8_t filter = 0;
  uint8_t effect = 0;  // 0: none
  uint8_t map = 0;
  bool is_fitted = false;  // upright text only
};

/// The windows of a picture, and the RAM for drawing it.
struct OutlineCut {
  inkcell::Point origin;
  int32_t x0 = 0;  // the picture's first pixel
  int32_t y0 = 0;
  int32_t x_cut = 7;          // 1 to kPictureWidth: windows end here
  int32_t y_cut = 5;          // 1 to kPictureHeight
  uint32_t whole_bytes = 0;   // of the workspace for the whole picture
  uint32_t part_bytes = 700;  // and of the one for windows
  uint8_t odd = 0;            // addresses of workspaces modulo 4
};

inline constexpr int32_t kPictureWidth = 29;
inline constexpr int32_t kPictureHeight = 22;

/// Draws the glyph whole, in four windows, into a sink with blocks, and
/// prepared. Ends the program if pixels leave the window, come twice in a
/// window, or a block is not laid out as promised; with `is_exact` also if the
/// pictures differ.
void check_outline(const inkcell::Font& font,
                   uint16_t glyph,
                   const OutlineLook& look,
                   const OutlineCut& cut,
                   bool is_exact);

/// Generates the field of the glyph in a buffer of 4 cut.part_bytes, at most
/// 4092, draws it upright at style.size_q6, and looks up points. Ends the
/// program if the field is not in this buffer, its record does not open, or
/// pixels leave the window.
void check_generated_field(const inkcell::Font& font,
                           uint16_t glyph,
                           const OutlineLook& look,
                           const OutlineCut& cut);

}  // namespace hostile
