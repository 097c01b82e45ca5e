// Reads each record as a device would, without outlines.
#include "verify/morph_verify.hpp"

#include "base/bit_table.hpp"
#include "base/bytes.hpp"
#include "inkcell/format/rom.hpp"
#include "outlines/record_bits.hpp"

namespace inkcell::detail {
namespace {

namespace morphs = format::morphs;

class Record {
 public:
  explicit Record(const Span<const uint8_t>& bytes) noexcept : bytes_(bytes) {}

  // `room`: for points of the pair.
  bool fits(uint32_t room) noexcept {
    width_ = take(morphs::kPointWidthBits);
    for (;;) {
      const uint32_t kind = take(morphs::kKindBits);
      if (kind == morphs::kEnd) {
        return true;
      }
      const uint32_t pieces = take(morphs::kPieceCountBits);
      const bool is_point[] = {kind == morphs::kSecondOnly,
                               kind == morphs::kFirstOnly};
      take_start(is_point[0]);
      take_start(is_point[1]);
      for (uint32_t i = 0; i < 2 * pieces; ++i) {
        if (!is_point[i % 2]) {
          take_move();
        }
      }
      const uint32_t points = 1 + 2 * pieces;
      if (points > room) {
        return false;
      }
      room -= points;
    }
  }

 private:
  // 0 beyond the end: records leave out the zeros at theirs.
  uint32_t take(uint32_t count) noexcept {
    const uint32_t value =
        bit_ >= 8 * bytes_.size ? 0 : bits_at(bytes_, bit_, count);
    bit_ += count;
    return value;
  }
  void take_stop() noexcept { bit_ += width_ + morphs::kEighthBits; }
  void take_start(bool is_point) noexcept {
    take_stop();
    if (is_point) {
      take_stop();
      bit_ += morphs::kBirthBits + morphs::kSwellBits;
    }
  }
  void take_move() noexcept {
    if (take(1) != 0 && take(1) != 0) {
      if (take(1) == 0) {
        bit_ += morphs::kEighthBits;
      } else {
        take_stop();
      }
    }
  }

  const Span<const uint8_t>& bytes_;
  uint32_t bit_ = 0;
  uint32_t width_ = 0;
};

}  // namespace

bool morphs_fit(const Span<const uint8_t>& section,
                uint32_t glyph_count) noexcept {
  if (section.size == 0) {
    return true;
  }
  if (section.size < morphs::kBytes) {
    return false;
  }
  const uint32_t count = load_u16(section.data + morphs::kPairs);
  const uint32_t glyph_bits = section.data[morphs::kGlyphBits];
  const uint32_t offset_bits = section.data[morphs::kOffsetBits];
  const uint32_t row_bits = 2 * glyph_bits + offset_bits;
  if (glyph_bits > morphs::kMaxGlyphBits ||
      offset_bits > format::bit_table::kMaxBits ||
      !bits_fit(section, morphs::kBytes, count * row_bits)) {
    return false;
  }
  const BitTable pairs = {&section, 8 * morphs::kBytes, row_bits};
  const uint32_t room = load_u16(section.data + morphs::kMaxPoints);
  uint32_t masters = load_u16(section.data + morphs::kMasters);
  masters = masters == 0 ? glyph_count : masters;
  const uint32_t begin = morphs::kBytes + (count * row_bits + 7) / 8;
  const auto size = static_cast<uint32_t>(section.size) - begin;
  uint32_t last_first = 0;
  uint32_t last_second = 0;
  uint32_t end = 0;
  for (uint32_t i = 0; i < count; ++i) {
    const uint32_t first = pairs.get(i, 0, glyph_bits);
    const uint32_t second = pairs.get(i, glyph_bits, glyph_bits);
    const uint32_t offset = pairs.get(i, 2 * glyph_bits, offset_bits);
    const uint32_t next =
        i + 1 == count ? size : pairs.get(i + 1, 2 * glyph_bits, offset_bits);
    if (first >= second || second >= glyph_count || offset < end ||
        offset >= next || next > size || first < last_first ||
        (i != 0 && first == last_first &&
         (second <= last_second || last_second >= masters)) ||
        first >= masters ||
        !Record({section.data + begin + offset, next - offset}).fits(room)) {
      return false;
    }
    last_first = first;
    last_second = second;
    end = offset;
  }
  return true;
}

}  // namespace inkcell::detail
