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

// Bits from the lowest of a byte on; zeros follow the last byte.
class PictureBits {
 public:
  explicit PictureBits(const Picture& picture) noexcept
      : at_(picture.begin), end_(picture.end) {}

  // 1 to 24 bits.
  uint32_t take(int32_t width) noexcept {
    need(width);
    const uint32_t bits = window_ & ~(~uint32_t{0} << width);
    drop(width);
    return bits;
  }

  // Has 24 bits or more at hand, if it has less than `width`.
  void need(int32_t width) noexcept {
    if (count_ < width) {
      fill();
    }
  }
  uint32_t window() const noexcept { return window_; }
  void drop(int32_t width) noexcept {
    window_ >>= width;
    count_ -= width;
  }

 private:
  // Not inline for its size.
  __attribute__((noinline)) void fill() noexcept {
    do {
      if (at_ != end_) {
        window_ |= uint32_t{*at_++} << count_;
      }
      count_ += 8;
    } while (count_ <= 24);
  }

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

// The runs of ink of up to 24 pixels.
void draw_runs(uint32_t bits,
               int32_t scale,
               Squares row,
               const Sink& sink) noexcept {
  while (bits != 0) {
    for (; (bits & 1) == 0; bits >>= 1) {
      row.x += scale;
    }
    row.x_end = row.x;
    for (; (bits & 1) != 0; bits >>= 1) {
      row.x_end += scale;
    }
    draw_squares(row, 255, sink);
    row.x = row.x_end;
  }
}

// A row of 2 or 4 bits as coverage. In place, if `above` is `to`.
void read_row(PictureBits& given,
              const Picture& picture,
              const uint8_t* above,
              uint8_t* to) noexcept {
  PictureBits bits = given;
  const auto raw_bits = static_cast<int32_t>(picture.bits) + 1;
  const uint32_t mask = (1u << picture.bits) - 1;
  const uint32_t step = picture.bits == 4 ? 17 : 85;
  const uint32_t guesses = picture.guesses;
  uint32_t left = 0;
  for (uint8_t* const end = to + picture.width; to != end; ++to) {
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
        left = (guess & 1) != 0 ? 255 : 0;
      } else if ((guess & 1) == 0) {
        left = up;
      }
    }
    *to = static_cast<uint8_t>(left);
  }
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

void draw_rows(const PictureRows& rows,
               const Rect& box,
               int32_t scale,
               const Sink& sink) noexcept {
  if (scale != 1) {
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
                  const StrikeKey& key,
                  uint32_t glyph,
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
    index = glyph - load_u16(entry + at::kFirst);
    if ((word & key.mask) == key.word &&
        index < load_u16(entry + at::kGlyphs)) {
      break;
    }
  }
  const uint8_t* const widths = entry + at::kColumnBits;
  uint32_t row_bits = 0;
  for (uint32_t i = 0; i != at::kColumns; ++i) {
    row_bits += widths[i];
  }
  uint32_t bit = load_u32(entry + at::kBoxes) * 8 + row_bits * index;
  uint32_t numbers[at::kColumns];
  for (uint32_t i = 0; i != at::kColumns; ++i) {
    numbers[i] = read_bits(strikes, bit, widths[i]);
    bit += widths[i];
  }
  const uint32_t offset_bits = widths[at::kColumns - 1];
  const uint32_t next =
      read_bits(strikes, bit + row_bits - offset_bits, offset_bits);
  const uint32_t base = load_u32(entry + at::kPictures);
  const uint32_t step = load_u16(entry + at::kStep);
  const uint32_t begin = base + (index * step >> 8) + numbers[4];
  const uint32_t end = base + ((index + 1) * step >> 8) + next;
  const uint32_t bits = word >> 16 & 255;
  constexpr uint32_t kBitsAllowed = 1 << 1 | 1 << 2 | 1 << 4;
  constexpr uint32_t kNumbers = 511;
  if (entry[at::kCoding] != 0 || bits > 4 || (kBitsAllowed >> bits & 1) == 0 ||
      numbers[2] - 1 >= kMaxSide || numbers[3] - 1 >= kMaxSide || begin > end ||
      end > strikes.size) {
    return false;
  }
  out = {static_cast<int8_t>(entry[at::kLeftBase]) +
             static_cast<int32_t>(numbers[0] & kNumbers),
         static_cast<int8_t>(entry[at::kTopBase]) +
             static_cast<int32_t>(numbers[1] & kNumbers),
         static_cast<int32_t>(numbers[2]),
         static_cast<int32_t>(numbers[3]),
         strikes.data + begin,
         strikes.data + end,
         load_u32(entry + at::kGuesses),
         bits};
  return true;
}

Rect box_of(const Picture& picture,
            int32_t x,
            int32_t y,
            int32_t scale) noexcept {
  x += picture.left * scale;
  y += picture.top * scale;
  return {x, y, x + picture.width * scale, y + picture.height * scale};
}

void draw_bits(const Picture& picture,
               const Rect& box,
               int32_t scale,
               const Sink& sink) noexcept {
  constexpr int32_t kChunk = 24;
  uint32_t row[(kMaxSide + kChunk - 1) / kChunk];
  PictureBits bits(picture);
  const int32_t y_end = min(box.y1, sink.window.y1);
  for (int32_t y = box.y0; y < y_end; y += scale) {
    const bool is_new = y == box.y0 || bits.take(1) == 0;
    uint32_t* chunk = row;
    int32_t x = box.x0;
    for (int32_t left = picture.width; left > 0; left -= kChunk) {
      if (is_new) {
        *chunk = bits.take(min(left, kChunk));
      }
      draw_runs(*chunk++, scale, {x, x, y, y + scale}, sink);
      x += kChunk * scale;
    }
  }
}

void draw_picture(const Picture& picture,
                  const Rect& box,
                  int32_t scale,
                  const Sink& sink) noexcept {
  if (picture.bits == 1) {
    draw_bits(picture, box, scale, sink);
    return;
  }
  // Words begin where x is a multiple of 4.
  const int32_t before = box.x0 & 3;
  const int32_t stride = (before + picture.width + 3) & ~3;
  alignas(4) uint8_t bytes[kRowBytes];
  clear_pixels(bytes, kRowBytes);
  PictureBits bits(picture);
  const uint8_t* const last = bytes + kRowBytes - stride;
  const uint8_t* above = bytes;
  uint8_t* to = bytes;
  const int32_t y_end = min(box.y1, sink.window.y1);
  int32_t from = box.y0;
  for (int32_t y = box.y0; y < y_end;) {
    if (y == box.y0 || bits.take(1) == 0) {
      read_row(bits, picture, above + before, to + before);
    } else if (to != above) {
      __builtin_memcpy(to, above, static_cast<size_t>(stride));
    }
    above = to;
    to += stride;
    y += scale;
    if (to > last || y >= y_end) {
      draw_rows({bytes + before, stride, from, y}, box, scale, sink);
      to = bytes;
      from = y;
    }
  }
}

}  // namespace inkcell::detail
