// The field of a glyph, generated from its outline: inkcell/field/generate.hpp.
#include "inkcell/field/cell.hpp"
#include "inkcell/field/generate.hpp"
#include "web.h"

using namespace inkcell;

namespace {

alignas(4) uint8_t ram[1 << 17];
constexpr int32_t kMargin = 128;  // around the ink [u]
GlyphField field;                 // the last glyph's, in ram

// The middle of the part `index` of `count` that a side has. [u, Q16]
int32_t middle_q16(int32_t index, int32_t side, int32_t count) {
  return static_cast<int32_t>((int64_t{2 * index + 1} * side << 15) / count);
}

}  // namespace

inkcell_status_t web_field(const web_job_t* job, uint32_t code_point) {
  inkcell_font_t opened;
  const inkcell_status_t status =
      inkcell_font_open(job->rom, job->rom_size, &opened);
  if (status != INKCELL_OK) {
    return status;
  }
  const size_t points =
      static_cast<size_t>(job->width) * static_cast<size_t>(job->width);
  if (job->pixels_size < (WEB_FIELD_HEAD + 4 * points) * sizeof(int32_t)) {
    return INKCELL_BUFFER_SMALL;
  }
  // The types of C are those of C++ in the same memory (port/c/mirror.hpp).
  const Font& font = reinterpret_cast<const Font&>(opened);
  FieldLimits limits;
  limits.band_u = kMargin;
  limits.tolerance = Q22_10::from_int(3);
  const Status made = generate_field(font, font.glyph_or_notdef(code_point),
                                     limits, ram, field);
  if (made != Status::ok) {
    return static_cast<inkcell_status_t>(made);
  }
  const InkBox ink = field.ink;
  const int32_t wide = ink.x1_u - ink.x0_u;
  const int32_t high = ink.y1_u - ink.y0_u;
  if (field.cell_count == 0 || wide <= 0 || high <= 0) {
    return INKCELL_NO_GLYPH;
  }
  const int32_t side = (wide > high ? wide : high) + 2 * kMargin;
  const int32_t x0_u = ink.x0_u - (side - wide) / 2;
  const int32_t y0_u = ink.y0_u - (side - high) / 2;
  auto* out = reinterpret_cast<int32_t*>(job->pixels);
  const int32_t head[WEB_FIELD_HEAD] = {
      x0_u, y0_u, side, static_cast<int32_t>(record_bytes(field)),
      field.cell_count};
  for (const int32_t number : head) {
    *out++ = number;
  }
  for (int32_t row = 0; row < job->width; ++row) {
    for (int32_t column = 0; column < job->width; ++column) {
      // The middle of a square; row 0 is the highest.
      const int32_t x_q16 = middle_q16(column, side, job->width);
      const int32_t y_q16 = middle_q16(job->width - 1 - row, side, job->width);
      const int32_t x_u = x0_u + (x_q16 >> 16);
      const int32_t y_u = y0_u + (y_q16 >> 16);
      Cell cell;
      if (x_u >= field.x0_u && x_u < field.x1_u() && y_u >= field.y0_u &&
          y_u < field.y1_u()) {
        cell = locate(field, x_u, y_u);
      }
      *out++ = distance_at(field, Q16_16::from_raw((x0_u << 16) + x_q16),
                           Q16_16::from_raw((y0_u << 16) + y_q16))
                   .raw;
      *out++ = cell.x0_u;
      *out++ = cell.y0_u;
      *out++ = cell.is_saturated() ? 0 : 1 << cell.size_log2;
    }
  }
  return INKCELL_OK;
}

int32_t web_distance(int32_t x_q16, int32_t y_q16) {
  return distance_at(field, Q16_16::from_raw(x_q16), Q16_16::from_raw(y_q16))
      .raw;
}
