// The test sheet: the same lines once for every pixel format, whose bytes must
// be the same on every machine.
//
// A page is 160 x 176 px: five fonts at several sizes with each preset filter,
// at sub-pixel origins, and two turned lines, over a dark ground and a
// half-tone. Three pages more show every
/// style, and fonts of outlines.
#pragma once

#include "fonts.hpp"
#include "inkcell/port/pixel.hpp"
#include "inkcell/strip.hpp"

namespace golden {

inline constexpr int32_t kPageWidth = 160;
inline constexpr int32_t kPageHeight = 176;

/// One a pixel format and order of its bits or bytes, then the styles.
inline constexpr int kPageCount = 17;

struct Page {
  const char* name;
  inkcell::port::PixelFormat format;
};
const Page& page(int number);

/// Bytes that draw_page() needs for strips of `rows` rows.
constexpr size_t page_buffer_bytes(inkcell::port::PixelFormat format,
                                   int32_t rows) {
  return inkcell::port::strip_bytes(format, kPageWidth, rows);
}

using TakeStrip = void (*)(void* context, const inkcell::Strip& strip);

/// Draws a page in strips of `rows` rows, a multiple of 8, into `buffer`, which
/// begins at a multiple of 4, and hands each to `take`. False if a font did
/// not open or a sink was refused.
bool draw_page(int number,
               int32_t rows,
               inkcell::Span<uint8_t> buffer,
               TakeStrip take,
               void* context);

}  // namespace golden
