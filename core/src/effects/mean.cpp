#include "effects/mean.hpp"

#include "base/words.hpp"
#include "rows/source.hpp"

namespace inkcell::detail {
namespace {

// Each word of four pixels has two words of sums: of pixels 0 and 2 and of 1
// and 3, each in 16 bits. 255 times 256 is the most.
constexpr uint32_t kHalves = 0x00800080;

}  // namespace

Mean::Mean(GlyphBand& band) noexcept : band_(band) {
  const Band& rows = static_cast<const GlyphJob&>(band).band;
  clear_pixels(band.memory(), 2 * rows.rows * rows.stride);
}

void Mean::add(uint32_t share) noexcept {
  const Band& band = static_cast<const GlyphJob&>(band_).band;
  band_.cover();
  const uint8_t* at = band.bytes;
  uint8_t* sum = band_.memory();
  for (const uint8_t* const end = at + band.rows * band.stride; at != end;
       at += 4, sum += 8) {
    const uint32_t word = load_pixels(at);
    if (word != 0) {
      store_pixels(sum, load_pixels(sum) + (word & kEvenBytes) * share);
      store_pixels(sum + 4,
                   load_pixels(sum + 4) + (word >> 8 & kEvenBytes) * share);
    }
  }
}

void Mean::emit() const noexcept {
  const Band& band = static_cast<const GlyphJob&>(band_).band;
  const uint8_t* sum = band_.memory();
  uint8_t* at = band.bytes;
  for (uint8_t* const end = at + band.rows * band.stride; at != end;
       at += 4, sum += 8) {
    store_pixels(at, ((load_pixels(sum) + kHalves) >> 8 & kEvenBytes) |
                         ((load_pixels(sum + 4) + kHalves) & ~kEvenBytes));
  }
  band_.emit();
}

}  // namespace inkcell::detail
