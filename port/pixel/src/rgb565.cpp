// The sink for RGB565.
#include "inkcell/port/rgb565.hpp"

#include "painted.hpp"
#include "run.hpp"
#include "word.hpp"

namespace inkcell::port {
namespace {

using detail::Run;

// A pixel repeated in a word, one copy of each channel kept, with five free
// bits above each. All three channels blend in one word without carries between
// them.
//
//     31   26    21 20    15    11 10      4      0
//     |   green   |   0  |  red  |    0   | blue  |
constexpr uint32_t kChannels = 0x07e0f81f;
constexpr uint32_t kHalves = 0x02008010;  // 16 in each

constexpr uint32_t spread(uint32_t pixel) noexcept {
  return (pixel | pixel << 16) & kChannels;
}

// Coverage in 32nds, rounded to nearest; 255 gives 32.
constexpr uint32_t share_of(uint32_t coverage) noexcept {
  return (coverage + 4) >> 3;
}

// Blends a spread colour over a pixel; each channel is rounded to nearest.
constexpr uint32_t blend565(uint32_t share,
                            uint32_t colour,
                            uint32_t background) noexcept {
  const uint32_t old = spread(background);
  // Differences may borrow from other channels; the sum restores them.
  const uint32_t sum = (colour - old) * share + kHalves + (old << 5);
  const uint32_t result = sum >> 5 & kChannels;
  return (result | result >> 16) & 0xffff;
}

inline void blend_half(uint8_t* pixel,
                       uint32_t coverage,
                       uint32_t colour) noexcept {
  const uint32_t share = share_of(coverage);
  if (share != 0) {
    detail::store_half(pixel,
                       blend565(share, colour, detail::load_half(pixel)));
  }
}

inline void blend_four(uint8_t* pixel,
                       const uint8_t* coverage,
                       uint32_t colour) noexcept {
  blend_half(pixel, coverage[0], colour);
  blend_half(pixel + 2, coverage[1], colour);
  blend_half(pixel + 4, coverage[2], colour);
  blend_half(pixel + 6, coverage[3], colour);
}

// For pixels at even addresses, low byte first. Eight at a time: on Cortex-M3
// each takes 13 instructions and an eighth of the loop's five.
void blend_halves(uint8_t* pixel,
                  const uint8_t* coverage,
                  int32_t count,
                  uint32_t colour) noexcept {
  for (; (count & 7) != 0; --count) {
    blend_half(pixel, *coverage++, colour);
    pixel += 2;
  }
  for (const uint8_t* const end = coverage + count; coverage != end;) {
    blend_four(pixel, coverage, colour);
    blend_four(pixel + 8, coverage + 4, colour);
    coverage += 8;
    pixel += 16;
  }
}

// For pixels at any address.
void blend_bytes(uint8_t* pixel,
                 const uint8_t* coverage,
                 int32_t count,
                 uint32_t colour,
                 ByteOrder order) noexcept {
  const int low = order == ByteOrder::low_first ? 0 : 1;
  for (uint8_t* const end = pixel + 2 * count; pixel != end; pixel += 2) {
    const uint32_t share = share_of(*coverage++);
    if (share != 0) {
      const uint32_t old = pixel[low] | static_cast<uint32_t>(pixel[low ^ 1])
                                            << 8;
      const uint32_t result = blend565(share, colour, old);
      pixel[low] = static_cast<uint8_t>(result);
      pixel[low ^ 1] = static_cast<uint8_t>(result >> 8);
    }
  }
}

// Whether pixels are half-words in the byte order of the core.
inline bool are_halves(const detail::Rgb565Pixels& pixels,
                       const uint8_t* pixel) noexcept {
  return detail::kLittleEndian && pixels.strip.order == ByteOrder::low_first &&
         (reinterpret_cast<uintptr_t>(pixel) & 1) == 0;
}

// Four pixels of a spread colour.
inline void store_four(uint8_t* pixel, uint32_t colour) noexcept {
  const uint32_t solid = (colour | colour >> 16) & 0xffff;
  detail::store_half(pixel, solid);
  detail::store_half(pixel + 2, solid);
  detail::store_half(pixel + 4, solid);
  detail::store_half(pixel + 6, solid);
}

// A row of a block; words of coverage begin where x is a multiple of 4.
void blend_words(uint8_t* pixel,
                 const uint8_t* coverage,
                 int32_t count,
                 uint32_t colour) noexcept {
  const uint8_t* const end = coverage + count;
  while (coverage != end) {
    if ((reinterpret_cast<uintptr_t>(coverage) & 3) != 0 ||
        end - coverage < 4) {
      blend_half(pixel, *coverage++, colour);
      pixel += 2;
      continue;
    }
    const uint32_t word = detail::load_word(coverage);
    if (word == ~0u) {
      store_four(pixel, colour);
    } else if (word != 0) {
      for (int32_t i = 0; i != 4; ++i) {
        blend_half(pixel + 2 * i, coverage[i], colour);
      }
    }
    coverage += 4;
    pixel += 8;
  }
}

void blend_block(void* context, const CoverageBlock& given) noexcept {
  const auto& pixels = *static_cast<const detail::Rgb565Pixels*>(context);
  CoverageBlock block = given;
  if (!detail::clip(pixels.strip, block)) {
    return;
  }
  const uint32_t colour = spread(pixels.colour);
  const int32_t count = block.pixels.x1 - block.pixels.x0;
  for (int32_t y = block.pixels.y0; y != block.pixels.y1; ++y) {
    uint8_t* const pixel = detail::row_at(pixels.strip, y - pixels.strip.y0) +
                           2 * (block.pixels.x0 - pixels.strip.x0);
    if (are_halves(pixels, pixel)) {
      blend_words(pixel, block.coverage, count, colour);
    } else {
      blend_bytes(pixel, block.coverage, count, colour, pixels.strip.order);
    }
    block.coverage += block.stride;
  }
}

// Four half-words.
__attribute__((noinline)) void put_four(uint8_t* pixel,
                                        uint32_t coverage,
                                        uint32_t colour) noexcept {
  if (coverage == ~0u) {
    store_four(pixel, colour);
    return;
  }
  for (; coverage != 0; coverage >>= 8) {
    blend_half(pixel, coverage & 255, colour);
    pixel += 2;
  }
}

bool blend_painted(void* context,
                   const CoverageBlock& block,
                   Painted bytes) noexcept {
  const auto& pixels = *static_cast<const detail::Rgb565Pixels*>(context);
  const Strip& strip = pixels.strip;
  if (!are_halves(pixels, strip.pixels.data) || (strip.stride & 1) != 0) {
    return false;
  }
  const uint32_t colour = spread(pixels.colour);
  return detail::put_painted<2>(
      strip, block, bytes, [colour](uint8_t* pixel, uint32_t word) noexcept {
        put_four(pixel, word, colour);
      });
}

void cover(const detail::Rgb565Pixels& pixels,
           const Run& run,
           const uint8_t* coverage) noexcept {
  const uint32_t colour = spread(pixels.colour);
  uint8_t* const pixel = detail::row_at(pixels.strip, run.y) + 2 * run.x;
  if (are_halves(pixels, pixel)) {
    blend_halves(pixel, coverage, run.count, colour);
  } else {
    blend_bytes(pixel, coverage, run.count, colour, pixels.strip.order);
  }
}

// Fills [pixel, end), two pixels a word where addresses permit. The low half of
// `colour` is the byte at the lower address.
void fill(uint8_t* pixel, uint8_t* end, uint16_t colour) noexcept {
  const uint32_t first = colour & 0xff;
  const uint32_t second = colour >> 8;
  const uint32_t pair = detail::word_of(first, second, first, second);
  const bool even = (reinterpret_cast<uintptr_t>(pixel) & 1) == 0;
  while (pixel != end) {
    if (even && (reinterpret_cast<uintptr_t>(pixel) & 2) == 0) {
      for (; end - pixel >= 16; pixel += 16) {
        detail::store_word(pixel, pair);
        detail::store_word(pixel + 4, pair);
        detail::store_word(pixel + 8, pair);
        detail::store_word(pixel + 12, pair);
      }
      for (; end - pixel >= 4; pixel += 4) {
        detail::store_word(pixel, pair);
      }
      if (pixel == end) {
        return;
      }
    }
    pixel[0] = static_cast<uint8_t>(first);
    pixel[1] = static_cast<uint8_t>(second);
    pixel += 2;
  }
}

void fill_run(const detail::Rgb565Pixels& pixels, const Run& run) noexcept {
  uint8_t* pixel = detail::row_at(pixels.strip, run.y) + 2 * run.x;
  fill(pixel, pixel + 2 * run.count,
       pixels.strip.order == ByteOrder::low_first
           ? pixels.colour
           : static_cast<uint16_t>(pixels.colour << 8 | pixels.colour >> 8));
}

int32_t pixels_of(uint32_t piece) noexcept {
  return static_cast<int32_t>(piece >> 2);
}

// Words of a piece of so many pixels, without its first one.
int32_t words_of(uint32_t piece) noexcept {
  const int32_t count = pixels_of(piece);
  switch (piece & 3) {
    case ColourPicture::clear:
      return 0;
    case ColourPicture::solid:
      return 1;
    case ColourPicture::opaque:
      return count;
    default:
      return count + (count + 1) / 2;
  }
}

inline void fill_halves(uint8_t* pixel, uint8_t* end, uint32_t half) noexcept {
  const uint32_t pair = half | half << 16;
  for (; detail::kAnyAddress && end - pixel >= 8; pixel += 8) {
    detail::store_any_word(pixel, pair);
    detail::store_any_word(pixel + 4, pair);
  }
  for (; pixel != end; pixel += 2) {
    detail::store_half(pixel, half);
  }
}

inline void copy_halves(const uint16_t* at,
                        uint8_t* pixel,
                        uint8_t* end) noexcept {
  const auto* from = reinterpret_cast<const uint8_t*>(at);
  for (; detail::kAnyAddress && end - pixel >= 8; pixel += 8) {
    detail::store_any_word(pixel, detail::load_any_word(from));
    detail::store_any_word(pixel + 4, detail::load_any_word(from + 4));
    from += 8;
  }
  for (; pixel != end; pixel += 2) {
    detail::store_half(pixel, detail::load_half(from));
    from += 2;
  }
}

static_assert(ColourPicture::clear == 0 && ColourPicture::solid == 1 &&
                  ColourPicture::opaque == 2 && ColourPicture::mixed == 3,
              "put_pieces() tests bits");

// Pixels whose coverage, in bytes, follows them. Returns what follows that.
inline const uint16_t* mix_halves(const uint16_t* at,
                                  const uint16_t* bytes,
                                  uint8_t* pixel,
                                  uint8_t* end) noexcept {
  const auto* coverage = reinterpret_cast<const uint8_t*>(bytes);
  bytes += (end - pixel + 2) / 4;
  for (; pixel != end; pixel += 2) {
    detail::store_half(pixel, blend565(share_of(*coverage++), spread(*at++),
                                       detail::load_half(pixel)));
  }
  return bytes;
}

// Draws a row of pieces from `pixel` on, where pixels are half-words. Returns
// what follows the row. Not inline: its loops have all registers.
__attribute__((noinline)) const uint16_t* put_pieces(const uint16_t* at,
                                                     uint8_t* pixel,
                                                     int32_t width) noexcept {
  for (uint8_t* const end = pixel + 2 * width; pixel != end;) {
    const uint32_t piece = *at++;
    uint8_t* const piece_end = pixel + 2 * pixels_of(piece);
    // Two tests find a kind, where a switch takes three.
    const bool is_plain = (piece & 1) == 0;
    if ((piece & 2) == 0) {
      if (!is_plain) {
        fill_halves(pixel, piece_end, *at++);
      }
    } else if (is_plain) {
      copy_halves(at, pixel, piece_end);
      at += pixels_of(piece);
    } else {
      const uint16_t* coverage = at + pixels_of(piece);
      at = mix_halves(at, coverage, pixel, piece_end);
    }
    pixel = piece_end;
  }
  return at;
}

// The same of the columns from x0, at `pixel`, up to x1; any pixels, any
// machine.
void put_columns(const uint16_t* at,
                 uint8_t* pixel,
                 int32_t x0,
                 int32_t x1,
                 ByteOrder order) noexcept {
  for (int32_t x = 0; x < x1;) {
    const uint32_t piece = *at++;
    const int32_t count = pixels_of(piece);
    const uint32_t kind = piece & 3;
    for (int32_t i = 0; i != count && kind != ColourPicture::clear; ++i) {
      if (x + i >= x0 && x + i < x1) {
        const uint32_t colour = at[kind == ColourPicture::solid ? 0 : i];
        const auto coverage = static_cast<uint8_t>(
            kind == ColourPicture::mixed ? at[count + i / 2] >> 8 * (i & 1)
                                         : 255);
        blend_bytes(pixel + 2 * (x + i - x0), &coverage, 1, spread(colour),
                    order);
      }
    }
    at += words_of(piece);
    x += count;
  }
}

}  // namespace

void detail::put_picture(void* to,
                         const ColourPicture& picture,
                         const Rect& window) noexcept {
  const auto& pixels = *static_cast<const detail::Rgb565Pixels*>(to);
  const Strip& strip = pixels.strip;
  const Rect& box = picture.box;
  const Rect shown = intersect(intersect(box, window), strip.rect());
  if (is_empty(shown)) {
    return;
  }
  const int32_t width = box.x1 - box.x0;
  const bool is_fast = shown.x0 == box.x0 && shown.x1 == box.x1 &&
                       are_halves(pixels, strip.pixels.data) &&
                       (strip.stride & 1) == 0;
  const uint16_t* at = picture.pieces;
  for (int32_t y = box.y0; y != shown.y1; ++y) {
    if (y >= shown.y0) {
      uint8_t* const pixel =
          detail::row_at(strip, y - strip.y0) + 2 * (shown.x0 - strip.x0);
      if (is_fast) {
        at = put_pieces(at, pixel, width);
        continue;
      }
      put_columns(at, pixel, shown.x0 - box.x0, shown.x1 - box.x0, strip.order);
    }
    for (int32_t x = 0; x != width; at += 1 + words_of(*at)) {
      x += pixels_of(*at);
    }
  }
}

const detail::SinkKind detail::Rgb565Pixels::kKind = {
    detail::coverage_of<detail::Rgb565Pixels, cover>,
    detail::solid_of<detail::Rgb565Pixels, fill_run>, blend_block,
    detail::kTakesPainted ? blend_painted : nullptr,
    layout_of(PixelFormat::rgb565)};

}  // namespace inkcell::port
