// Strikes for tests: written bit by bit, independently of the generator, and
// put into fonts that tests make.
//
//   StrikeWriter<1024> strikes;
//   strikes.begin(1);
//   strikes.add({12, 1, StrikeFit::both, 1, 2}, draw);
//   size = add_section({rom, sizeof rom}, size, format::section::kStrikes,
//                      strikes.bytes());
#pragma once

#include <stdint.h>

#include "font_builder.hpp"
#include "inkcell/format/rom.hpp"
#include "inkcell/span.hpp"

namespace strike_font {

using inkcell::Span;
using inkcell::format::StrikeFit;

/// A picture of values, 0 to 2^bits - 1, from the origin of its glyph.
struct Values {
  static constexpr int32_t kSide = 40;

  int32_t left = 0;
  int32_t top = 0;
  int32_t width = 0;
  int32_t height = 0;
  uint8_t at[kSide][kSide] = {};

  /// Leaves out empty rows and columns around the ink.
  void crop() {
    int32_t x0 = width, x1 = 0, y0 = height, y1 = 0;
    for (int32_t y = 0; y < height; ++y) {
      for (int32_t x = 0; x < width; ++x) {
        if (at[y][x] != 0) {
          x0 = x < x0 ? x : x0;
          x1 = x >= x1 ? x + 1 : x1;
          y0 = y < y0 ? y : y0;
          y1 = y + 1;
        }
      }
    }
    if (x1 == 0) {
      *this = {};
      return;
    }
    for (int32_t y = y0; y < y1; ++y) {
      for (int32_t x = x0; x < x1; ++x) {
        at[y - y0][x - x0] = at[y][x];
      }
    }
    left += x0;
    top += y0;
    width = x1 - x0;
    height = y1 - y0;
  }
};

/// What an entry says of a strike.
struct StrikeSpec {
  uint16_t px;
  uint8_t bits;
  StrikeFit fit;
  uint16_t first;
  uint16_t glyphs;
  uint16_t step = 0;  // [bytes, Q8.8]
  uint32_t guesses = 0xe4e4e400;
};

/// The bytes of a section, in RAM of its own.
template <size_t kBytes>
class StrikeWriter {
 public:
  /// For so many strikes.
  void begin(uint32_t strikes) {
    added_ = 0;
    size_ = inkcell::format::strikes::kBytes +
            strikes * inkcell::format::strike::kBytes;
    for (uint8_t& byte : bytes_) {
      byte = 0;
    }
    font_builder::put_u16(bytes_ + inkcell::format::strikes::kCount, strikes);
  }

  /// The next strike: draw(glyph, values) gives each picture.
  template <typename Draw>
  void add(const StrikeSpec& spec, const Draw& draw) {
    namespace at = inkcell::format::strike;
    constexpr uint8_t kBits[] = {9, 9, 8, 8, 18};
    constexpr uint32_t kRowBits = 52;
    constexpr int32_t kBase = -60;
    uint8_t* const entry =
        bytes_ + inkcell::format::strikes::kBytes + added_++ * at::kBytes;
    font_builder::put_u16(entry + at::kPx, spec.px);
    entry[at::kBits] = spec.bits;
    entry[at::kFit] = static_cast<uint8_t>(spec.fit);
    font_builder::put_u16(entry + at::kFirst, spec.first);
    font_builder::put_u16(entry + at::kGlyphs, spec.glyphs);
    for (uint32_t i = 0; i != at::kColumns; ++i) {
      entry[at::kColumnBits + i] = kBits[i];
    }
    entry[at::kLeftBase] = static_cast<uint8_t>(kBase);
    entry[at::kTopBase] = static_cast<uint8_t>(kBase);
    font_builder::put_u16(entry + at::kStep, spec.step);
    font_builder::put_u32(entry + at::kGuesses, spec.guesses);
    const uint32_t boxes = static_cast<uint32_t>(size_);
    font_builder::put_u32(entry + at::kBoxes, boxes);
    size_ += (kRowBits * (spec.glyphs + 1u) + 7) / 8;
    // So that offsets stay above 0 with any step.
    const auto base =
        static_cast<uint32_t>(size_) - ((spec.glyphs + 1u) * spec.step >> 8);
    font_builder::put_u32(entry + at::kPictures, base);
    for (uint32_t i = 0; i <= spec.glyphs; ++i) {
      static Values values;
      values = {};
      if (i != spec.glyphs) {
        draw(static_cast<uint16_t>(spec.first + i), values);
      }
      bit_ = 8 * boxes + kRowBits * i;
      put(static_cast<uint32_t>(values.left - kBase), kBits[0]);
      put(static_cast<uint32_t>(values.top - kBase), kBits[1]);
      put(static_cast<uint32_t>(values.width), kBits[2]);
      put(static_cast<uint32_t>(values.height), kBits[3]);
      put(static_cast<uint32_t>(size_) - base - (i * spec.step >> 8), kBits[4]);
      bit_ = 8 * static_cast<uint32_t>(size_);
      write(values, spec);
      size_ = (bit_ + 7) / 8;
    }
  }

  /// Empty if they do not fit.
  Span<const uint8_t> bytes() const {
    return {bytes_, size_ > kBytes ? 0 : size_};
  }

 private:
  void put(uint32_t value, uint32_t width) {
    for (uint32_t i = 0; i != width; ++i, ++bit_) {
      if (bit_ / 8 < kBytes && (value >> i & 1) != 0) {
        bytes_[bit_ / 8] =
            static_cast<uint8_t>(bytes_[bit_ / 8] | 1 << bit_ % 8);
      }
    }
  }

  void write(const Values& values, const StrikeSpec& spec) {
    const uint32_t full = (1u << spec.bits) - 1;
    for (int32_t y = 0; y < values.height; ++y) {
      bool is_same = y != 0;
      for (int32_t x = 0; x < values.width && is_same; ++x) {
        is_same = values.at[y][x] == values.at[y - 1][x];
      }
      if (y != 0) {
        put(is_same ? 1 : 0, 1);
      }
      uint32_t left = 0;
      for (int32_t x = 0; x < values.width && !is_same; ++x) {
        const uint32_t value = values.at[y][x];
        const uint32_t up = y == 0 ? 0 : values.at[y - 1][x];
        if (spec.bits == 1) {
          put(value, 1);
          continue;
        }
        const uint32_t context =
            4 * (left >> (spec.bits - 2)) + (up >> (spec.bits - 2));
        const uint32_t guesses[] = {0, full, up, left};
        if (guesses[spec.guesses >> 2 * context & 3] == value) {
          put(1, 1);
        } else {
          put(0, 1);
          put(value, spec.bits);
        }
        left = value;
      }
    }
  }

  uint8_t bytes_[kBytes];
  size_t size_;
  uint32_t added_;
  uint32_t bit_;
};

/// Adds a section to a font of `size` bytes, or gives a section that it has
/// other bytes. Returns the size; 0 if there is no room, or no section.
inline size_t add_section(Span<uint8_t> rom,
                          size_t size,
                          uint32_t tag,
                          Span<const uint8_t> section) {
  namespace header = inkcell::format::header;
  namespace entry = inkcell::format::section;
  using font_builder::get_u16;
  using font_builder::get_u32;
  using font_builder::put_u16;
  using font_builder::put_u32;
  uint8_t* const at = rom.data;
  const uint32_t sections = get_u16(at + header::kSectionCount);
  uint8_t* own = at + header::kBytes;
  uint8_t* const end = own + sections * entry::kBytes;
  while (own != end && get_u32(own + entry::kTag) != tag) {
    own += entry::kBytes;
  }
  size = (size + 3) & ~size_t{3};
  if (section.size == 0 || size + entry::kBytes + section.size + 3 > rom.size) {
    return 0;
  }
  if (own == end) {
    __builtin_memmove(end + entry::kBytes, end,
                      size - static_cast<size_t>(end - at));
    for (uint8_t* old = at + header::kBytes; old != end; old += entry::kBytes) {
      put_u32(old + entry::kOffset,
              get_u32(old + entry::kOffset) + entry::kBytes);
    }
    size += entry::kBytes;
    put_u16(at + header::kSectionCount, sections + 1);
    put_u16(at + header::kHeaderBytes,
            header::kBytes + (sections + 1) * entry::kBytes);
    put_u32(own + entry::kTag, tag);
    put_u32(own + entry::kOffset, 0);
  }
  const uint32_t flags = get_u32(own + entry::kOffset) & entry::kMustUnderstand;
  put_u32(own + entry::kOffset, static_cast<uint32_t>(size) | flags);
  put_u32(own + entry::kSize, static_cast<uint32_t>(section.size));
  __builtin_memcpy(at + size, section.data, section.size);
  const size_t padded = (section.size + 3) & ~size_t{3};
  __builtin_memset(at + size + section.size, 0, padded - section.size);
  size += padded;
  put_u32(at + header::kTotalBytes, static_cast<uint32_t>(size));
  font_builder::repair_checksums({at, size});
  return size;
}

/// Where a section begins.
inline uint8_t* find_section(Span<uint8_t> font, uint32_t tag) {
  namespace header = inkcell::format::header;
  namespace entry = inkcell::format::section;
  const uint8_t* at = font.data + header::kBytes;
  while (font_builder::get_u32(at + entry::kTag) != tag) {
    at += entry::kBytes;
  }
  return font.data +
         (font_builder::get_u32(at + entry::kOffset) & ~entry::kMustUnderstand);
}

/// Where METR, as build_font() writes it, has the box of a glyph.
inline uint8_t* box_of(Span<uint8_t> font, uint32_t glyph) {
  return find_section(font, inkcell::format::section::kMetrics) +
         inkcell::format::metrics::kBytes + 10 * glyph + 2;
}

/// Says that a font has strikes alone, of one size.
inline void set_coding(Span<uint8_t> font, uint32_t px) {
  namespace header = inkcell::format::header;
  uint8_t* const at = font.data;
  at[header::kCoding] = static_cast<uint8_t>(inkcell::format::Coding::strike);
  at[header::kGridShift] = 0;
  at[header::kCodeBits] = 0;
  font_builder::put_u16(at + header::kMaxPoints, 0);
  font_builder::put_u16(at + header::kMinPx, px);
  font_builder::put_u16(at + header::kMaxPx, px);
  if (font_builder::get_u16(at + header::kUnitsPerEm) != 2 * px) {
    font_builder::put_u16(at + header::kUnitsPerEm, px);
  }
  font_builder::repair_checksums(font);
}

/// Moves the boxes of a strike of add(), the one in `section`, to `boxes`, ten
/// bytes a glyph in METR.
inline void move_boxes(uint8_t* section, uint8_t* boxes, int32_t units) {
  namespace at = inkcell::format::strike;
  uint8_t* const entry = section + inkcell::format::strikes::kBytes;
  uint8_t* const table = section + font_builder::get_u32(entry + at::kBoxes);
  const uint32_t glyphs = font_builder::get_u16(entry + at::kGlyphs);
  const auto base = static_cast<int8_t>(entry[at::kLeftBase]);
  uint32_t from = 0;
  uint32_t to = 0;
  const auto take = [&](uint32_t width) {
    uint32_t value = 0;
    for (uint32_t i = 0; i != width; ++i, ++from) {
      value |= (uint32_t{table[from / 8]} >> from % 8 & 1) << i;
    }
    return static_cast<int32_t>(value);
  };
  for (uint32_t glyph = 0; glyph <= glyphs; ++glyph) {
    int32_t row[at::kColumns];
    for (uint32_t i = 0; i != at::kColumns; ++i) {
      row[i] = take(entry[at::kColumnBits + i]);
    }
    const int32_t left = base + row[0];
    const int32_t top = base + row[1];
    const int32_t sides[] = {left, -top - row[3], left + row[2], -top};
    for (uint32_t i = 0; i != 4 && glyph != glyphs; ++i) {
      font_builder::put_u16(
          boxes + 10 * glyph + 2 * i,
          static_cast<uint32_t>(row[2] == 0 ? 0 : sides[i] * units) & 0xffff);
    }
    for (uint32_t i = 0; i != entry[at::kColumnBits + 4]; ++i, ++to) {
      const auto bit = static_cast<uint8_t>(1 << to % 8);
      table[to / 8] = static_cast<uint8_t>(
          (row[4] >> i & 1) != 0 ? table[to / 8] | bit : table[to / 8] & ~bit);
    }
  }
  __builtin_memset(entry + at::kColumnBits, 0, 4);
  entry[at::kLeftBase] = entry[at::kTopBase] = 0;
}

/// Makes a font of build_font() with a strike one of that strike alone.
inline void set_alone(Span<uint8_t> font, uint32_t px) {
  set_coding(font, px);
  const uint32_t em =
      font_builder::get_u16(font.data + inkcell::format::header::kUnitsPerEm);
  move_boxes(find_section(font, inkcell::format::section::kGlyphs),
             box_of(font, 0), static_cast<int32_t>(em / px));
  font_builder::repair_checksums(font);
}

}  // namespace strike_font
