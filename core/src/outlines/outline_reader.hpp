// From a glyph's record to points on the screen.
#pragma once

#include <stdint.h>

#include "inkcell/font.hpp"
#include "inkcell/span.hpp"
#include "outlines/screen_point.hpp"

namespace inkcell {
namespace detail {

// Where grid units lead on the screen, to the right and down. Computed modulo
// 2^32, so that pictures do not depend on strips.
struct OutlineMap {
  struct Axis {
    int32_t per_x;  // by a unit to the right [px, Q18]
    int32_t per_y;  // by a unit up
  };
  Axis axes[2];
};

// Reads records of simple outlines. Reads any bytes: beyond the record's end
// there are zeros, and no more than the budget of points comes of it.
class OutlineReader {
 public:
  // How many points may come, of one record or of several.
  void set_budget(int32_t points) noexcept { budget_ = points; }

  // The record's first bit, which says that it is an outline, is skipped.
  // `pen`: where steps begin. [px, Q18]
  void begin(const Span<const uint8_t>& record,
             const int32_t (&pen_q18)[2]) noexcept {
    record_ = record.data;
    size_ = static_cast<uint32_t>(record.size);
    bit_ = 1;
    x_q18_ = static_cast<uint32_t>(pen_q18[0]);
    y_q18_ = static_cast<uint32_t>(pen_q18[1]);
    start_ = ScreenPoint::at(0, 0, kStart);
  }

  // Writes the next points, at most `room`. Returns the end of what is written.
  ScreenPoint* read(const OutlineCoding& coding,
                    const OutlineMap& map,
                    ScreenPoint* out,
                    int32_t room) noexcept;

  // Whether the record has no more points, and whether no more may come.
  bool has_ended() const noexcept { return record_ == nullptr; }
  bool is_spent() const noexcept { return budget_ == 0; }

 private:
  const uint8_t* record_;  // null: it has no more points
  uint32_t size_;          // [bytes]
  uint32_t bit_;           // the next one
  uint32_t x_q18_;         // [px, modulo 2^32]
  uint32_t y_q18_;
  ScreenPoint start_;  // of the contour; kind kStart: it comes yet
  int32_t budget_;     // points that may come
};

}  // namespace detail
}  // namespace inkcell
