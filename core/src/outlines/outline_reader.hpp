// From a glyph's record to points on the screen.
#pragma once

#include <stdint.h>

#include "inkcell/font.hpp"
#include "inkcell/span.hpp"
#include "outlines/screen_point.hpp"

namespace inkcell {
namespace detail {

// Where a grid unit to the right and one up lead on the screen. [px, Q18]
// Computed modulo 2^32, so that pictures do not depend on strips.
struct OutlineMap {
  int32_t x_right;
  int32_t x_down;
  int32_t y_right;
  int32_t y_down;
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
             int32_t pen_x_q18,
             int32_t pen_y_q18) noexcept {
    record_ = record.data;
    size_ = static_cast<uint32_t>(record.size);
    bit_ = 1;
    x_q18_ = static_cast<uint32_t>(pen_x_q18);
    y_q18_ = static_cast<uint32_t>(pen_y_q18);
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
