// The points of a simple glyph of a TrueType file, as they lie on the screen.
#pragma once

#include <stdint.h>

#include "outlines/outline_glyph.hpp"
#include "tables.hpp"

namespace inkcell::detail {

// Reads the points of one simple glyph: a stream of flags, one of x and one of
// y. Stays in the file whatever the bytes are, and if they change: each stream
// takes two bytes a point at most, so that room for all is compared once.
class SimpleReader {
 public:
  // `record` lies in `file`, and is a simple glyph's or empty. What its
  // points take of the budget is taken off. False: it has none, or does not
  // fit.
  bool begin(const Table& file, const Table& record, int16_t& budget) noexcept;
  void set_pen(const int32_t (&at_q18)[2]) noexcept {
    x_q18_ = static_cast<uint32_t>(at_q18[0]);
    y_q18_ = static_cast<uint32_t>(at_q18[1]);
  }

  // Writes the next points, `room` at most; stops where fewer than kLeastRoom
  // are left. Returns the end of what is written.
  ScreenPoint* read(const OutlineMap& map,
                    ScreenPoint* out,
                    int32_t room) noexcept;
  static constexpr int32_t kLeastRoom = 2;

  bool has_ended() const noexcept { return contours_ == 0 && !is_open_; }

 private:
  void open_contour() noexcept;
  void take(const OutlineMap& map, ScreenPoint* out, int32_t count) noexcept;
  template <typename NextByte>
  void take_by(const NextByte& next,
               const OutlineMap& map,
               ScreenPoint* out,
               int32_t count) noexcept;

  const uint8_t* end_;   // of the file
  const uint8_t* ends_;  // last points of the contours that come yet
  const uint8_t* flags_;
  const uint8_t* xs_;
  const uint8_t* ys_;
  uint32_t x_q18_;  // [px, modulo 2^32]
  uint32_t y_q18_;
  ScreenPoint start_;  // of the contour
  ScreenPoint tail_;   // a control point that comes last
  uint16_t contours_;
  uint16_t points_;  // of contours that come yet
  uint16_t next_;    // the number of the first of them
  uint16_t left_;    // points of the contour
  uint8_t flag_;
  uint8_t repeats_;
  bool is_open_;  // a contour is
  bool has_tail_;
};

}  // namespace inkcell::detail
