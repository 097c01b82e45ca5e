#include "picture.hpp"

#include "base/bit_table.hpp"
#include "base/bytes.hpp"
#include "base/math.hpp"
#include "base/words.hpp"
#include "inkcell/format/rom.hpp"
#include "rows/band.hpp"

namespace inkcell::detail {
namespace {

namespace at = format::strike;

constexpr int32_t kMaxSide = format::strikes::kMaxSide;

int32_t nearest_px(int32_t at_q10) noexcept {
  return (at_q10 + 512) >> 10;
}

uint32_t low_bits(uint32_t number, uint32_t width) noexcept {
  return number & ~(~uint32_t{0} << (width & 31));
}

bool is_side(int32_t px) noexcept {
  return static_cast<uint32_t>(px) - 1 < kMaxSide;
}

// Bits from the lowest of a byte on; zeros follow the last byte. Inline: what
// it has at hand lies in registers then.
class PictureBits {
 public:
  explicit PictureBits(const Picture& picture) noexcept
      : at_(picture.begin), end_(picture.end) {}

  static constexpr int32_t kMost = 25;

  // Has kMost bits or more at hand, if it has less than `width`.
  __attribute__((always_inline)) void need(int32_t width) noexcept {
    if (count_ < width) {
      do {
        if (at_ != end_) {
          window_ |= uint32_t{*at_++} << count_;
        }
        count_ += 8;
      } while (count_ < kMost);
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

// A row of bits, magnified.
struct BitRow {
  const Sink& sink;
  Rect shown;  // the picture's pixels in the sink's window
  int32_t scale;
  int32_t y;  // those of the row in `shown`
  int32_t y_end;
};

// The runs of ink of up to 24 pixels, the first of them at `x`. Not inline:
// more lies in registers. By kScales, pixels may be magnified.
template <bool kScales>
__attribute__((noinline)) void draw_runs(uint32_t bits,
                                         int32_t x,
                                         const BitRow& row) noexcept {
  const int32_t scale = kScales ? row.scale : 1;
  while (bits != 0) {
    for (; (bits & 1) == 0; bits >>= 1) {
      x += scale;
    }
    const int32_t begin = max(x, row.shown.x0);
    for (; (bits & 1) != 0; bits >>= 1) {
      x += scale;
    }
    const int32_t count = min(x, row.shown.x1) - begin;
    if (count <= 0) {
      continue;
    }
    for (int32_t y = row.y; y < row.y_end; ++y) {
      row.sink.solid(row.sink.context, begin, y, count);
    }
  }
}

// Reads a row of 2 or 4 bits as coverage. In place, if `above` is `to`. Not
// inline: more lies in registers.
__attribute__((noinline)) void read_row(PictureBits& given,
                                        const Picture& picture,
                                        bool is_first,
                                        const uint8_t* above,
                                        uint8_t* to) noexcept {
  PictureBits bits = given;
  uint8_t* const end = to + picture.width;
  bits.need(1);
  if (!is_first && bits.take(1) != 0) {
    while (to != end) {
      *to++ = *above++;
    }
    given = bits;
    return;
  }
  const auto raw_bits = static_cast<int32_t>(picture.bits) + 1;
  const uint32_t mask = (1u << picture.bits) - 1;
  const uint32_t step = picture.bits == 4 ? 17 : 85;
  const uint32_t guesses = picture.guesses;
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

}  // namespace

const uint8_t* strike_at(const Span<const uint8_t>& strikes,
                         uint32_t index) noexcept {
  namespace head = format::strikes;
  const size_t end = head::kBytes + size_t{at::kBytes} * (index + 1);
  // Pages of stored fonts may have them anywhere.
  if (strikes.size < end ||
      reinterpret_cast<uintptr_t>(strikes.data) % 4 != 0 ||
      index >= load_u16(strikes.data + head::kCount)) {
    return nullptr;
  }
  return strikes.data + end - at::kBytes;
}

bool find_picture(const Span<const uint8_t>& strikes,
                  const PictureCall& call,
                  Picture& out) noexcept {
  const uint8_t* entry;
  uint32_t word;
  uint32_t index;  // of the glyph's row
  for (uint32_t i = 0;; ++i) {
    entry = strike_at(strikes, i);
    if (entry == nullptr) {
      return false;
    }
    word = load_u32(entry);
    index = call.glyph - load_u16(entry + at::kFirst);
    if ((word & call.key.mask) == call.key.word &&
        index < load_u16(entry + at::kGlyphs)) {
      break;
    }
  }
  const uint8_t* const widths = entry + at::kColumnBits;
  // A corner and a size have 18 and 16 bits at most, and come at once.
  const uint32_t corner_bits = widths[0] + uint32_t{widths[1]};
  const uint32_t size_bits = widths[2] + uint32_t{widths[3]};
  const uint32_t offset_bits = widths[4];
  const uint32_t row_bits = corner_bits + size_bits + offset_bits;
  uint32_t bit = load_u32(entry + at::kBoxes) * 8 + row_bits * index;
  const uint32_t corner = read_bits(strikes, bit, corner_bits);
  bit += corner_bits;
  const uint32_t size = read_bits(strikes, bit, size_bits);
  bit += size_bits;
  const uint32_t offset = read_bits(strikes, bit, offset_bits);
  const uint32_t next = read_bits(strikes, bit + row_bits, offset_bits);
  const uint32_t base = load_u32(entry + at::kPictures);
  const uint32_t step = load_u16(entry + at::kStep);
  const uint32_t begin = base + (index * step >> 8) + offset;
  const uint32_t end = base + ((index + 1) * step >> 8) + next;
  const uint32_t bits = word >> 16 & 255;
  const auto width = static_cast<int32_t>(low_bits(size, widths[2]));
  const auto height = static_cast<int32_t>(size >> (widths[2] & 31));
  constexpr uint32_t kBitsAllowed = 1 << 1 | 1 << 2 | 1 << 4;
  if (entry[at::kCoding] != 0 || bits > 4 || (kBitsAllowed >> bits & 1) == 0 ||
      !is_side(width) || !is_side(height) || begin > end ||
      end > strikes.size) {
    return false;
  }
  const auto left = static_cast<int8_t>(entry[at::kLeftBase]) +
                    static_cast<int32_t>(low_bits(corner, widths[0]));
  const auto top = static_cast<int8_t>(entry[at::kTopBase]) +
                   static_cast<int32_t>(corner >> (widths[0] & 31));
  const int32_t scale = call.scale;
  const int32_t x = nearest_px(call.placed.x_q10) + left * scale;
  const int32_t y = nearest_px(call.placed.y_q10) + top * scale;
  out = {{x, y, x + width * scale, y + height * scale},
         scale,
         width,
         bits,
         load_u32(entry + at::kGuesses),
         strikes.data + begin,
         strikes.data + end};
  return true;
}

namespace {

// Ink is solid: no coverage is made of it.
template <bool kScales>
void draw_bit_rows(const Picture& picture, const Sink& sink) noexcept {
  constexpr int32_t kChunk = PictureBits::kMost - 1;
  const int32_t scale = kScales ? picture.scale : 1;
  BitRow row = {sink, intersect(picture.box, sink.window), scale, 0, 0};
  uint32_t chunks[(kMaxSide + kChunk - 1) / kChunk];
  PictureBits bits(picture);
  for (int32_t y = picture.box.y0; y < row.shown.y1; y += scale) {
    row.y = max(y, row.shown.y0);
    row.y_end = min(y + scale, row.shown.y1);
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
      draw_runs<kScales>(*chunk++, x, row);
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
  clear_pixels(bytes, stride);
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
  (picture.bits == 1 ? draw_bit_rows<false> : draw_greys<false>)(picture, sink);
}

bool draw_found(const Span<const uint8_t>& strikes,
                const PictureCall& call,
                DrawPicture* draw,
                const Sink& sink) noexcept {
  Picture picture;
  if (!find_picture(strikes, call, picture)) {
    return false;
  }
  if (!is_empty(intersect(picture.box, sink.window))) {
    draw(picture, sink);
  }
  return true;
}

}  // namespace inkcell::detail
