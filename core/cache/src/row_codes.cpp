// Over 400 lines: both ends of one code, which share its tables.
#include "row_codes.hpp"

#include <stddef.h>

#include "base/bytes.hpp"
#include "base/math.hpp"
#include "base/words.hpp"
#include "rows/band.hpp"

namespace inkcell::detail {
namespace {

// What a pair holds.
constexpr uint32_t kEmpty = 0;
constexpr uint32_t kSolid = 1;
constexpr uint32_t kMixed = 2;

constexpr uint8_t kinds(uint32_t a, uint32_t b, uint32_t c, uint32_t d) {
  return static_cast<uint8_t>(a | b << 2 | c << 4 | d << 6);
}

// What the codes say. Two bits are for a four whose pairs are alike, the first
// one lowest. Codes with 3 are the most frequent other eights of text of 24 to
// 48 px.
constexpr uint8_t kKinds[16] = {
    kinds(kEmpty, kEmpty, kEmpty, kEmpty),
    kinds(kSolid, kSolid, kEmpty, kEmpty),
    kinds(kMixed, kMixed, kEmpty, kEmpty),
    kinds(kMixed, kEmpty, kEmpty, kEmpty),  // 3
    kinds(kEmpty, kEmpty, kSolid, kSolid),
    kinds(kSolid, kSolid, kSolid, kSolid),
    kinds(kMixed, kMixed, kSolid, kSolid),
    kinds(kEmpty, kEmpty, kEmpty, kMixed),  // 7
    kinds(kEmpty, kEmpty, kMixed, kMixed),
    kinds(kSolid, kSolid, kMixed, kMixed),
    kinds(kMixed, kMixed, kMixed, kMixed),  // kAllMixed
    kinds(kSolid, kMixed, kEmpty, kEmpty),  // 11
    kinds(kMixed, kSolid, kMixed, kEmpty),  // 12
    kinds(kEmpty, kMixed, kSolid, kMixed),  // 13
    kinds(kEmpty, kMixed, kMixed, kEmpty),  // 14
    kinds(kEmpty, kEmpty, kMixed, kSolid),  // 15
};
constexpr uint32_t kAllMixed = 10;

// Whether one of the two halves of a code is 3.
constexpr bool is_by_pairs(uint32_t code) noexcept {
  return (code & code >> 1 & 5) != 0;
}

// Whether a row of so many eights has these: they take longer.
constexpr bool is_wide(int32_t eights) noexcept {
  return eights > 2;
}

constexpr int32_t kMostEqual = 16;

// The bits of a group's first byte that count its rows.
constexpr uint32_t kRowsMask = kMostEqual - 1;

constexpr uint32_t kLowHalves = 0x0f0f0f0f;

inline int32_t rows_of(const uint8_t* group) noexcept {
  return static_cast<int32_t>(*group & kRowsMask) + 1;
}

inline int32_t eights_of(int32_t width, Packing packing) noexcept {
  return (width * packing.channels + 7) >> 3;
}

// Four of `count` values, from the `first` on, as they are drawn; what is
// behind the last one is empty.
uint32_t four_of(const uint8_t* values,
                 int32_t first,
                 int32_t count,
                 uint32_t bits) noexcept {
  uint32_t four = 0;
  for (int32_t i = 0; i != 4 && first + i < count; ++i) {
    const uint32_t value = values[first + i];
    four |= (bits == 4 ? (value + 8) / 17 * 17 : value) << 8 * i;
  }
  return four;
}

uint32_t kind_of_pair(uint32_t pair) noexcept {
  return pair == 0 ? kEmpty : pair == 0xffff ? kSolid : kMixed;
}

// The code of two fours.
uint32_t code_of(uint32_t first, uint32_t second, bool by_pairs) noexcept {
  const uint32_t pairs[4] = {
      kind_of_pair(first & 0xffff), kind_of_pair(first >> 16),
      kind_of_pair(second & 0xffff), kind_of_pair(second >> 16)};
  const uint32_t wanted = kinds(pairs[0], pairs[1], pairs[2], pairs[3]);
  for (uint32_t code = 0; by_pairs && code != 16; ++code) {
    if (kKinds[code] == wanted) {
      return code;
    }
  }
  const auto half = [&pairs](int32_t i) noexcept {
    return pairs[i] == pairs[i + 1] ? pairs[i] : kMixed;
  };
  return half(0) | half(2) << 2;
}

uint8_t* put_bytes(uint32_t word, uint32_t count, uint8_t* out) noexcept {
  for (; count != 0; --count) {
    *out++ = static_cast<uint8_t>(word);
    word >>= 8;
  }
  return out;
}

// Writes the values of two fours that follow a code.
uint8_t* put_eight(uint32_t first,
                   uint32_t second,
                   uint32_t code,
                   uint32_t bits,
                   uint8_t* out) noexcept {
  if (bits == 4 && code == kAllMixed) {
    return put_bytes((first & kLowHalves) | (second & ~kLowHalves), 4, out);
  }
  const uint32_t pairs[4] = {first & 0xffff, first >> 16, second & 0xffff,
                             second >> 16};
  for (uint32_t i = 0; i != 4; ++i) {
    if ((kKinds[code] >> 2 * i & 3) == kMixed) {
      const uint32_t pair = pairs[i];
      out = bits == 8 ? put_bytes(pair, 2, out)
                      : put_bytes((pair & 15) | (pair >> 8 & 0xf0), 1, out);
    }
  }
  return out;
}

// Values of 4 bits, each in both halves of its byte. `packed`: the pairs in
// bytes 0 and 2.
inline uint32_t spread(uint32_t packed) noexcept {
  const uint32_t halves = (packed | packed << 4) & kLowHalves;
  return halves | halves << 4;
}

// A pair of a kind, whose values are at `at` if it is mixed.
uint32_t read_pair(uint32_t kind, uint32_t bits, const uint8_t*& at) noexcept {
  if (kind != kMixed) {
    return kind == kSolid ? 0xffff : 0;
  }
  const uint32_t low = *at++;
  return bits == 4 ? spread(low) & 0xffff : low | uint32_t{*at++} << 8;
}

// The same of two pairs of 2 bits.
__attribute__((noinline)) uint32_t read_pairs(uint32_t both,
                                              uint32_t bits,
                                              const uint8_t*& at) noexcept {
  const uint32_t first = read_pair(both & 3, bits, at);
  return first | read_pair(both >> 2 & 3, bits, at) << 16;
}

// Reads the codes of a group.
struct Codes {
  uint32_t left;  // of a byte, and a 1 above them

  explicit Codes(uint32_t first_byte) noexcept : left(first_byte >> 4 | 16) {}

  // The next one; `at` passes a byte of further ones.
  uint32_t next(const uint8_t*& at) noexcept {
    if (left == 1) {
      left = *at++ | 256u;
    }
    const uint32_t code = left & 15;
    left >>= 4;
    return code;
  }
};

// Behind a group of rows of `eights` eights.
const uint8_t* behind(const uint8_t* at,
                      int32_t eights,
                      uint32_t bits) noexcept {
  Codes codes(*at++);
  for (; eights != 0; --eights) {
    uint32_t mixed = kKinds[codes.next(at)] >> 1 & 0x55u;
    mixed = (mixed & 0x33) + (mixed >> 2 & 0x33);
    at += ((mixed & 15) + (mixed >> 4)) * (bits >> 2);
  }
  return at;
}

// A four whose pairs are alike.
inline uint32_t read_four(uint32_t kind,
                          uint32_t bits,
                          const uint8_t*& at) noexcept {
  if (kind != kMixed) {
    return 0u - kind;
  }
  if (bits == 8) {
    at += 4;
    return load_any_u32(at - 4);
  }
  at += 2;
  return spread(at[-2] | uint32_t{at[-1]} << 16);
}

inline void copy_row(const uint8_t* from, uint8_t* to, int32_t bytes) noexcept {
  for (; bytes != 0; bytes -= 4) {
    store_pixels(to, load_pixels(from));
    from += 4;
    to += 4;
  }
}

// How the rows of a glyph are kept, and how they lie in a block of coverage.
struct Layout {
  uint8_t bits;  // of a value
  uint8_t channels;
  int32_t eights;
  int32_t before;  // bytes before a row: words begin where x is a multiple of 4
  int32_t stride;  // [bytes]

  Layout(Packing packing, const Rect& box) noexcept
      : bits(packing.bits),
        channels(packing.channels),
        eights(eights_of(box.x1 - box.x0, packing)),
        before(packing.channels == 1 ? box.x0 & 3 : 0),
        stride((before + (box.x1 - box.x0) * packing.channels + 3) & ~3) {}
};

// Writes the row of the group at `at` to `to`, a multiple of 4, and up to two
// words behind it. Returns what follows the group.
template <bool kIsWide>
inline const uint8_t* write_row(const uint8_t* at,
                                const Layout& layout,
                                uint8_t* to) noexcept {
  Codes codes(*at++);
  const uint32_t bits = layout.bits;
  const uint32_t shift = static_cast<uint32_t>(layout.before) * 8;
  const uint32_t back = 31 - shift;
  uint32_t carried = 0;
  int32_t left = layout.eights;
  do {
    const uint32_t code = codes.next(at);
    uint32_t first;
    uint32_t second;
    if (code == kAllMixed && bits == 4) {
      const uint32_t packed = load_any_u32(at);
      first = packed & kLowHalves;
      first |= first << 4;
      second = packed & ~kLowHalves;
      second |= second >> 4;
      at += 4;
    } else if (!kIsWide || !is_by_pairs(code)) {
      first = read_four(code & 3, bits, at);
      second = read_four(code >> 2, bits, at);
    } else {
      const uint8_t* pairs = at;
      first = read_pairs(kKinds[code], bits, pairs);
      second = read_pairs(kKinds[code] >> 4, bits, pairs);
      at = pairs;
    }
    store_pixels(to, carried | first << shift);
    store_pixels(to + 4, first >> 1 >> back | second << shift);
    carried = second >> 1 >> back;
    to += 8;
  } while (--left != 0);
  store_pixels(to, carried);
  return at;
}

// Rows of a glyph, from the top down.
struct Rows {
  const uint8_t* at;    // the next group
  int32_t passed = 0;   // rows of it
  int32_t repeats = 0;  // of the last row
  const uint8_t* last = nullptr;

  // Passes rows, before any are written.
  void skip(const Layout& layout, int32_t rows) noexcept {
    while (rows >= rows_of(at)) {
      rows -= rows_of(at);
      at = behind(at, layout.eights, layout.bits);
    }
    passed = rows;
  }
};

// Writes rows from `to` up to `end`, multiples of 4; and up to two words behind
// that. The last row that was written before must still be there.
template <bool kIsWide>
__attribute__((noinline)) void write_rows(Rows& rows,
                                          const Layout& given,
                                          uint8_t* to,
                                          uint8_t* end) noexcept {
  const Layout layout = given;
  const uint8_t* at = rows.at;
  const uint8_t* last = rows.last;
  int32_t repeats = rows.repeats - rows.passed;
  for (; to != end; to += layout.stride) {
    if (repeats > 0) {
      copy_row(last, to, layout.stride);
      --repeats;
    } else {
      repeats += rows_of(at) - 1;
      at = write_row<kIsWide>(at, layout, to);
    }
    last = to;
  }
  rows = {at, 0, repeats, last};
}

// A block of three coverages a pixel.
void emit_rgb(const Sink& sink,
              const Rect& pixels,
              const uint8_t* coverage,
              int32_t stride) noexcept {
  for (int32_t y = pixels.y0; y != pixels.y1; ++y) {
    const uint8_t* at = coverage;
    for (int32_t x = pixels.x0; x < pixels.x1; x += kMaxSpan) {
      sink.coverage_rgb(sink.context, x, y, at, min(kMaxSpan, pixels.x1 - x));
      at += kMaxSpan * 3;
    }
    coverage += stride;
  }
}

// A glyph that is drawn.
struct Job {
  const Sink& sink;
  Layout layout;
  Rows rows;
  Rect shown;     // what is not drawn yet
  int32_t first;  // of the bytes of a row that are shown

  // As many rows at once as there is room for.
  __attribute__((noinline)) void draw() noexcept {
    constexpr int32_t kBytes = kMostRowValues + 4;
    alignas(4) uint8_t bytes[kBytes + 8];  // two words behind the rows
    for (int32_t left = shown.y1 - shown.y0; left != 0;) {
      const int32_t count =
          left * layout.stride <= kBytes ? left : kBytes / layout.stride;
      draw_rows(bytes, count);
      left -= count;
    }
  }

  // Not inline, as the one before: so that no frame is large.
  __attribute__((noinline)) void draw_rows(uint8_t* bytes,
                                           int32_t count) noexcept {
    const int32_t end = shown.y1;
    shown.y1 = shown.y0 + count;
    const auto write =
        is_wide(layout.eights) ? write_rows<true> : write_rows<false>;
    write(rows, layout, bytes, bytes + count * layout.stride);
    const auto draw = layout.channels == 1 ? emit : emit_rgb;
    draw(sink, shown, bytes + first, layout.stride);
    shown.y0 = shown.y1;
    shown.y1 = end;
  }
};

// Not memcmp(): a program need not have one.
bool are_equal(const uint8_t* a, const uint8_t* b, int32_t count) noexcept {
  while (count != 0 && *a == *b) {
    ++a;
    ++b;
    --count;
  }
  return count == 0;
}

}  // namespace

int32_t most_row_bytes(int32_t width, Packing packing) noexcept {
  const int32_t eights = eights_of(width, packing);
  return 1 + (eights >> 1) + eights * packing.bits;
}

uint8_t* record_row(const uint8_t* coverage,
                    int32_t width,
                    Packing packing,
                    uint8_t* last,
                    uint8_t* end) noexcept {
  uint8_t* codes = end;
  uint8_t* out = end + 1;
  *codes = 0;
  uint32_t shift = 4;
  const int32_t values = width * packing.channels;
  const bool by_pairs = is_wide(eights_of(width, packing));
  for (int32_t i = 0; i < values; i += 8) {
    if (shift == 8) {
      shift = 0;
      codes = out++;
      *codes = 0;
    }
    const uint32_t first = four_of(coverage, i, values, packing.bits);
    const uint32_t second = four_of(coverage, i + 4, values, packing.bits);
    const uint32_t code = code_of(first, second, by_pairs);
    *codes = static_cast<uint8_t>(*codes | code << shift);
    out = put_eight(first, second, code, packing.bits, out);
    shift += 4;
  }
  const auto bytes = static_cast<int32_t>(out - end);
  if (last != nullptr && rows_of(last) != kMostEqual && end - last == bytes &&
      ((*last ^ *end) & ~kRowsMask) == 0 &&
      are_equal(last + 1, end + 1, bytes - 1)) {
    ++*last;
    return end;
  }
  return out;
}

void replay(const uint8_t* at,
            Packing packing,
            const Rect& box,
            const Sink& sink) noexcept {
  const Rect shown = intersect(box, sink.window);
  if (is_empty(shown)) {
    return;
  }
  const Layout layout(packing, box);
  Job job = {sink, layout, Rows{at}, shown,
             layout.before + (shown.x0 - box.x0) * packing.channels};
  job.rows.skip(layout, shown.y0 - box.y0);
  job.draw();
}

}  // namespace inkcell::detail
