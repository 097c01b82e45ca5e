#include "picture.hpp"

#include "base/math.hpp"
#include "inkcell/format/rom.hpp"
#include "rows/band.hpp"

namespace inkcell::detail {
namespace {

constexpr int32_t kMaxSide = format::strikes::kMaxSide;

// Bits from the lowest of a byte on; zeros follow the last byte of the section.
// Inline: what it has at hand lies in registers then.
class PictureBits {
 public:
  explicit PictureBits(const Picture& picture) noexcept
      : at_(picture.begin), end_(picture.end) {}

  static constexpr int32_t kMost = 25;

  // Has `width` bits at hand, kMost at most.
  __attribute__((always_inline)) void need(int32_t width) noexcept {
    while (count_ < width) {
      if (at_ != end_) {
        window_ |= uint32_t{*at_++} << count_;
      }
      count_ += 8;
    }
  }
  // Those from the lowest on; any above them.
  uint32_t window() const noexcept { return window_; }
  __attribute__((always_inline)) void drop(int32_t width) noexcept {
    window_ >>= width;
    count_ -= width;
  }
  // Of those at hand, less than kMost.
  __attribute__((always_inline)) uint32_t take(int32_t width) noexcept {
    const uint32_t bits = window_ & ~(~uint32_t{0} << width);
    drop(width);
    return bits;
  }

 private:
  const uint8_t* at_;
  const uint8_t* end_;
  uint32_t window_ = 0;
  int32_t count_ = 0;
};

// Squares of a row's pixels, from x to x_end before they are clipped, of one
// coverage.
struct Squares {
  int32_t x;
  int32_t x_end;
  int32_t y;
  int32_t y_end;
};

void draw_squares(Squares all, uint32_t coverage, const Sink& sink) noexcept {
  const Rect& window = sink.window;
  const int32_t y_end = min(all.y_end, window.y1);
  const int32_t x = max(all.x, window.x0);
  const int32_t count = min(all.x_end, window.x1) - x;
  if (count <= 0) {
    return;
  }
  for (int32_t y = max(all.y, window.y0); y < y_end; ++y) {
    if (coverage == 255) {
      sink.solid(sink.context, x, y, count);
      continue;
    }
    uint8_t pixels[kMaxSpan];
    __builtin_memset(pixels, static_cast<int>(coverage), sizeof pixels);
    for (int32_t done = 0; done < count; done += kMaxSpan) {
      sink.coverage(sink.context, x + done, y, pixels,
                    min(count - done, kMaxSpan));
    }
  }
}

// A row of bits, magnified, as far as the sink's window has it.
struct BitRow {
  const Sink& sink;
  int32_t scale;
  int32_t y;
  int32_t y_end;
};

// The runs of ink of up to 24 pixels, the first of them at `x`. Not inline:
// more lies in registers. By kScales, pixels may be magnified.
template <bool kScales>
__attribute__((noinline)) void draw_runs(uint32_t bits,
                                         int32_t x,
                                         const BitRow& row) noexcept {
  const int32_t scale = kScales ? row.scale : 1;
  const Sink& sink = row.sink;
  while (bits != 0) {
    for (; (bits & 1) == 0; bits >>= 1) {
      x += scale;
    }
    const int32_t begin = max(x, sink.window.x0);
    for (; (bits & 1) != 0; bits >>= 1) {
      x += scale;
    }
    const int32_t count = min(x, sink.window.x1) - begin;
    if (count <= 0) {
      continue;
    }
    int32_t y = row.y;
    do {
      sink.solid(sink.context, begin, y, count);
    } while (kScales && ++y < row.y_end);
  }
}

// Reads a row as coverage. In place, if `above` is `to`. Not inline: more lies
// in registers.
__attribute__((noinline)) void read_row(PictureBits& given,
                                        const Picture& picture,
                                        bool is_first,
                                        const uint8_t* above,
                                        uint8_t* to) noexcept {
  uint8_t* const end = to + picture.width;
  given.need(1);
  if (!is_first && given.take(1) != 0) {
    while (to != end) {
      *to++ = *above++;
    }
    return;
  }
  PictureBits bits = given;
  // Of 1 bit, a 1 is a guess that is full, and a 0 a value without bits.
  const bool is_bit = picture.bits == 1;
  const uint32_t value_bits = is_bit ? 0 : picture.bits;
  const auto raw_bits = static_cast<int32_t>(value_bits) + 1;
  const uint32_t mask = (1u << value_bits) - 1;
  const uint32_t step = picture.bits == 4 ? 17 : 85;
  const uint32_t guesses = is_bit ? 0x55555555 : picture.guesses;
  uint32_t left = 0;
  do {
    const uint32_t up = *above++;
    bits.need(raw_bits);
    const uint32_t window = bits.window();
    if ((window & 1) == 0) {
      left = (window >> 1 & mask) * step;
      bits.drop(raw_bits);
    } else {
      const uint32_t guess = guesses >> (left >> 6 << 3 | up >> 6 << 1);
      bits.drop(1);
      if ((guess & 2) == 0) {
        left = (guess & 1) * 255;
      } else if ((guess & 1) == 0) {
        left = up;
      }
    }
    *to++ = static_cast<uint8_t>(left);
  } while (to != end);
  given = bits;
}

// Room for rows of coverage: one of the widest, which may begin within a word.
constexpr int32_t kRowBytes = (3 + kMaxSide + 3) & ~3;

// PictureRows of coverage, one below the other.
struct PictureRows {
  const uint8_t* first;  // pixel of the first row
  int32_t stride;
  int32_t y;  // of their pixels, magnified
  int32_t y_end;
};

// Every pixel a square.
void draw_magnified(const PictureRows& rows,
                    const Rect& box,
                    int32_t scale,
                    const Sink& sink) noexcept {
  const uint8_t* from = rows.first;
  for (int32_t y = rows.y; y < rows.y_end; y += scale) {
    const uint8_t* pixel = from;
    Squares run = {box.x0, box.x0, y, y + scale};
    while (run.x != box.x1) {
      const uint8_t coverage = *pixel;
      do {
        ++pixel;
        run.x_end += scale;
      } while (run.x_end != box.x1 && *pixel == coverage);
      if (coverage != 0) {
        draw_squares(run, coverage, sink);
      }
      run.x = run.x_end;
    }
    from += rows.stride;
  }
}

template <bool kScales>
void draw_rows(const PictureRows& rows,
               const Rect& box,
               int32_t scale,
               const Sink& sink) noexcept {
  if (kScales && scale != 1) {
    draw_magnified(rows, box, scale, sink);
    return;
  }
  const Rect shown =
      intersect({box.x0, rows.y, box.x1, rows.y_end}, sink.window);
  if (!is_empty(shown)) {
    emit(sink, shown,
         rows.first + (shown.y0 - rows.y) * rows.stride + (shown.x0 - box.x0),
         rows.stride);
  }
}

// Ink is solid: no coverage is made of it.
template <bool kScales>
void draw_bit_rows(const Picture& picture, const Sink& sink) noexcept {
  constexpr int32_t kChunk = PictureBits::kMost - 1;
  const int32_t scale = kScales ? picture.scale : 1;
  BitRow row = {sink, scale, 0, 0};
  uint32_t chunks[(kMaxSide + kChunk - 1) / kChunk];
  PictureBits bits(picture);
  const int32_t y_end = min(picture.box.y1, sink.window.y1);
  for (int32_t y = picture.box.y0; y < y_end; y += scale) {
    row.y = max(y, sink.window.y0);
    row.y_end = min(y + scale, y_end);
    bool is_new = true;
    uint32_t* chunk = chunks;
    int32_t x = picture.box.x0;
    for (int32_t left = picture.width; left > 0; left -= kChunk) {
      if (is_new) {
        bits.need(kChunk + 1);
        if (chunk == chunks && y != picture.box.y0) {
          is_new = bits.take(1) == 0;
        }
      }
      if (is_new) {
        *chunk = bits.take(min(left, kChunk));
      }
      if (row.y < row.y_end) {
        draw_runs<kScales>(*chunk, x, row);
      }
      ++chunk;
      x += kChunk * scale;
    }
  }
}

// Not inline: bits take less of the stack.
template <bool kScales>
__attribute__((noinline)) void draw_greys(const Picture& picture,
                                          const Sink& sink) noexcept {
  const Rect& box = picture.box;
  const int32_t scale = kScales ? picture.scale : 1;
  // Words begin where x is a multiple of 4.
  const int32_t before = box.x0 & 3;
  const int32_t stride = (before + picture.width + 3) & ~3;
  alignas(4) uint8_t bytes[kRowBytes];
  // Above the first row.
  __builtin_memset(bytes, 0, static_cast<size_t>(stride));
  PictureBits bits(picture);
  const uint8_t* const last = bytes + kRowBytes - stride;
  uint8_t* const first = bytes + before;
  const uint8_t* above = first;
  uint8_t* to = first;
  const int32_t y_end = min(box.y1, sink.window.y1);
  int32_t from = box.y0;
  for (int32_t y = box.y0; y < y_end;) {
    read_row(bits, picture, y == box.y0, above, to);
    above = to;
    to += stride;
    y += scale;
    if (to - before > last || y >= y_end) {
      draw_rows<kScales>({first, stride, from, y}, box, scale, sink);
      to = first;
      from = y;
    }
  }
}

}  // namespace

void draw_bits(const Picture& picture, const Sink& sink) noexcept {
  draw_bit_rows<true>(picture, sink);
}
void draw_picture(const Picture& picture, const Sink& sink) noexcept {
  (picture.bits == 1 ? draw_bit_rows<true> : draw_greys<true>)(picture, sink);
}
void draw_bits_as_is(const Picture& picture, const Sink& sink) noexcept {
  draw_bit_rows<false>(picture, sink);
}
void draw_picture_as_is(const Picture& picture, const Sink& sink) noexcept {
  draw_greys<false>(picture, sink);
}

}  // namespace inkcell::detail
