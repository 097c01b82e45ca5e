// A mock sink for small pictures, and expected pictures as text.
//
//   Picture<8, 4> picture;
//   draw(..., picture.sink());
//   CHECK_PICTURE(picture,
//                 "..##....\n"
//                 "..##....\n");
//
// The mock fails the running test when a pixel is drawn twice, lies outside the
// window, or a call breaks the contract of Sink.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "check.hpp"
#include "inkcell/strip.hpp"
#include "pixels.hpp"
#include "sink_calls.hpp"

/// Coverage as a character, in five steps.
constexpr char shade(uint8_t coverage) {
  if (coverage == 255) {
    return '#';
  }
  return coverage == 0 ? '.' : ":+*"[(coverage - 1) / 85];
}

/// What becomes of a pixel that is drawn again.
enum class Overlap : uint8_t {
  once,      // it fails the test, but after next_glyph() the greater stays
  greatest,  // the greater coverage stays
  light      // as light on light: 1 - (1 - a) (1 - b)
};

template <int32_t kWidth, int32_t kHeight, Overlap kOverlap = Overlap::once>
class Picture : public SinkCalls<Picture<kWidth, kHeight, kOverlap>> {
 public:
  /// The first pixel is at (x0, y0) of the screen.
  explicit Picture(int32_t x0 = 0, int32_t y0 = 0) : x0_(x0), y0_(y0) {}

  inkcell::Rect all() const { return {x0_, y0_, x0_ + kWidth, y0_ + kHeight}; }
  /// Valid until the next call, and as long as the picture stays where it is.
  inkcell::Sink sink() { return sink(all()); }
  /// The window is what lies in `part`.
  inkcell::Sink sink(const inkcell::Rect& part) {
    window_ = inkcell::intersect(part, all());
    return {window_, this, Calls::coverage, Calls::solid};
  }
  /// Calls draw(sink) for strips of `rows` rows, each cut in two `columns` from
  /// the left.
  template <typename Draw>
  void draw_parts(int32_t rows, int32_t columns, const Draw& draw) {
    const inkcell::Rect whole = all();
    for (int32_t y = whole.y0; y < whole.y1; y += rows) {
      draw(sink({whole.x0, y, whole.x0 + columns, y + rows}));
      draw(sink({whole.x0 + columns, y, whole.x1, y + rows}));
    }
  }
  template <typename Draw>
  void draw_strips(int32_t rows, const Draw& draw) {
    for (int32_t y = y0_; y < y0_ + kHeight; y += rows) {
      draw(sink({x0_, y, x0_ + kWidth, y + rows}));
    }
  }

  /// Coverage of a pixel in screen coordinates.
  uint8_t at(int32_t x, int32_t y) const { return pixels_[y - y0_][x - x0_]; }

  int32_t calls() const { return calls_; }

  /// The sum of all coverages, or of those in `part`.
  int32_t ink() const { return ink(all()); }
  int32_t ink(const inkcell::Rect& part) const {
    const inkcell::Rect seen = inkcell::intersect(part, all());
    int32_t sum = 0;
    for (const auto [x, y] : pixels_of(seen)) {
      sum += at(x, y);
    }
    return sum;
  }
  /// Whether nothing was drawn outside `box`.
  bool lies_in(const inkcell::Rect& box) const { return ink() == ink(box); }

  /// The greatest difference of a pixel, wherever the two pictures are.
  int32_t difference(const Picture& other) const {
    int32_t greatest = 0;
    for (const auto [x, y] : pixels_of(kWidth, kHeight)) {
      const int32_t apart = pixels_[y][x] - other.pixels_[y][x];
      greatest = apart > greatest ? apart : greatest;
      greatest = -apart > greatest ? -apart : greatest;
    }
    return greatest;
  }
  bool operator==(const Picture& other) const { return difference(other) == 0; }

  /// An empty picture, there or elsewhere.
  void clear() {
    clear(pixels_);
    clear(drawn_);
  }
  void clear(const inkcell::Rect& part) {
    const inkcell::Rect seen = inkcell::intersect(part, all());
    for (const auto [x, y] : pixels_of(seen)) {
      pixels_[y - y0_][x - x0_] = 0;
    }
  }
  void clear_at(int32_t x0, int32_t y0) {
    x0_ = x0;
    y0_ = y0;
    clear();
  }
  /// From here on pixels may be drawn again, over the old ones.
  void next_glyph() { clear(drawn_); }

  /// Whether `art`, lines of characters of shade(), shows this picture from a
  /// column and a row on; pixels that art does not reach must be empty.
  bool matches(const char* art, int32_t left = 0, int32_t top = 0) const {
    for (int32_t y = 0; y < kHeight; ++y) {
      for (int32_t x = 0; x < kWidth; ++x) {
        const bool is_given =
            y >= top && x >= left && *art != '\n' && *art != '\0';
        if (shade(pixels_[y][x]) != (is_given ? *art++ : '.')) {
          return false;
        }
      }
      if (y >= top && *art != '\0' && *art++ != '\n') {
        return false;
      }
    }
    return *art == '\0';
  }

  void print() const {
    for (int32_t y = 0; y < kHeight; ++y) {
      char line[kColumnCount + 1];
      for (int32_t x = 0; x < kWidth; ++x) {
        line[x] = shade(pixels_[y][x]);
      }
      line[kWidth] = '\n';
      check::write(line, sizeof(line));
    }
  }

  /// For Sink::coverage_rgb: a mean in which channels count differently, so
  /// that none can stand for another.
  static void coverage_rgb(void* context,
                           int32_t x,
                           int32_t y,
                           const uint8_t* values,
                           int32_t count) {
    for (int32_t i = 0; i < count; ++i, values += 3) {
      const auto mean =
          static_cast<uint8_t>((values[0] + 2 * values[1] + 4 * values[2]) / 7);
      Calls::coverage(context, x + i, y, &mean, 1);
    }
  }

 private:
  using Calls = SinkCalls<Picture>;
  friend Calls;

  static constexpr auto kColumnCount = static_cast<size_t>(kWidth);
  static constexpr auto kRowCount = static_cast<size_t>(kHeight);

  template <size_t kBytes>
  static void clear(uint8_t (&rows)[kRowCount][kBytes]) {
    for (auto& row : rows) {
      for (uint8_t& byte : row) {
        byte = 0;
      }
    }
  }

  // Whether a pixel had been drawn since the last glyph; now it is.
  bool mark(int32_t column, int32_t row) {
    uint8_t& eight = drawn_[row][column / 8];
    const auto bit = static_cast<uint8_t>(1 << column % 8);
    const bool was_drawn = (eight & bit) != 0;
    eight |= bit;
    return was_drawn;
  }
  // `values`: null for full coverage.
  void put(int32_t x, int32_t y, const uint8_t* values, int32_t count) {
    ++calls_;
    const bool fits = Calls::fits(window_, x, y, count);
    for (int32_t i = 0; fits && i < count; ++i) {
      const uint8_t value = values == nullptr ? 255 : values[i];
      const int32_t column = x - x0_ + i;
      uint8_t& pixel = pixels_[y - y0_][column];
      if (kOverlap == Overlap::once) {
        CHECK(!mark(column, y - y0_) && "pixel drawn once");
      }
      if (kOverlap == Overlap::light) {
        pixel = static_cast<uint8_t>(pixel + (255u - pixel) * value / 255);
      } else {
        pixel = pixel > value ? pixel : value;
      }
    }
  }

  int32_t x0_;
  int32_t y0_;
  inkcell::Rect window_;
  int32_t calls_ = 0;
  uint8_t pixels_[kRowCount][kColumnCount] = {};
  // Bits; those of overlapping pictures are never used.
  uint8_t drawn_[kRowCount][(kColumnCount + 7) / 8] = {};
};

/// `art`: the rows of ink from a column and a row of the picture on, of '.' 0,
/// ':' 1..85, '+' 86..170, '*' 171..254 and '#' 255, each closed by a line
/// feed. Prints the picture if it differs.
#define CHECK_PICTURE_AT(picture, left, top, art)              \
  do {                                                         \
    if (!(picture).matches(art, left, top)) {                  \
      ::check::fail(__FILE__, __LINE__, #picture " differs:"); \
      (picture).print();                                       \
    }                                                          \
  } while (false)
#define CHECK_PICTURE(picture, art) CHECK_PICTURE_AT(picture, 0, 0, art)
