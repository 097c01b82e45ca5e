// A disk with a paged font of frames, made while it is read: 20,000 glyphs take
// no RAM.
#pragma once

#include "check.hpp"
#include "font_builder.hpp"
#include "inkcell/stored/paged.hpp"
#include "inkcell/version.hpp"
#include "outline_record.hpp"
#include "random.hpp"

namespace stored_disk {

using namespace inkcell;
using font_builder::put_u16;
using font_builder::put_u32;
namespace paged = format::paged;

constexpr uint32_t kBlock = 512;
constexpr uint32_t kFanOut = kBlock / paged::entry::kBytes;
constexpr uint32_t kSlots = 5;  // of a page, with glyph 0
constexpr uint32_t kOnPage = kSlots - 1;
constexpr uint32_t kFirst = 0x4e00;
constexpr uint16_t kAdvance = 1000;

// Section GRID: the baseline, and a top of 500. Then tables of one word: a head
// takes 9 bits, a height 8, gaps 10, widths 7.
constexpr uint8_t kGrid[] = {
    2,       0, 0,          100,      1,       0, 0,      0, 0,      0,
    0,       0, 500 & 0xff, 500 >> 8, 0,       1, 9 << 3, 0, 8 << 3, 0,
    10 << 3, 0, 7 << 3,     0,        10 << 3, 0, 7 << 3, 0};

constexpr uint32_t up(uint32_t dividend, uint32_t divisor) {
  return (dividend + divisor - 1) / divisor;
}

// The n-th character: a frame whose parts depend on its number.
inline size_t write_glyph(uint32_t n, Span<uint8_t> out, int16_t (&box)[4]) {
  using namespace outline_record;
  const auto top = static_cast<int16_t>(500 + n % 13 * 20);
  const auto side = static_cast<int16_t>(600 + n / 13 % 11 * 20);
  const auto hole = static_cast<int16_t>(200 + n % 7 * 20);
  const OutlinePoint points[] = {{start, 60, 0},      {corner, side, 0},
                                 {corner, side, top}, {corner, 60, top},
                                 {start, 160, 100},   {corner, 160, hole},
                                 {corner, 400, hole}, {corner, 400, 100}};
  set_box(box_of({points, 8}), 0, box);
  // A bar from the baseline on, in the first zone: 8, 2, 50.
  static constexpr uint8_t kHints[] = {8, 2 << 1, 50 << 1};
  BitWriter bits(out);
  put_outline({points, 8}, bits);
  return add_hints({kHints, 24}, bits.bits(), out);
}

// That of .notdef, without hints.
inline size_t write_notdef(Span<uint8_t> out) {
  using namespace outline_record;
  static constexpr uint8_t kHints[] = {0, 0};
  BitWriter bits(out);
  put_outline({kBar, 4}, bits);
  return add_hints({kHints, 9}, bits.bits(), out);
}

// Bits of a table, the first in the lowest of a byte.
inline void put_bits(uint8_t* at,
                     uint32_t bit,
                     uint32_t value,
                     uint32_t width) {
  for (; width != 0; --width, ++bit, value >>= 1) {
    at[bit / 8] = static_cast<uint8_t>(at[bit / 8] | (value & 1) << bit % 8);
  }
}

// A font of so many characters, with two zones and a hint for each glyph.
struct Disk {
  uint32_t characters = 20992;

  uint32_t reads = 0;
  uint32_t bytes = 0;
  bool kerns = false;  // the first eight characters, each with the next
  // Faults.
  uint32_t fails_from = UINT32_MAX;  // the number of the first read that fails
  bool is_short = false;             // half of it comes
  Random* noise = nullptr;           // changes bytes of each read
  uint32_t noise_from = 0;

  uint32_t pages() const { return up(characters, kOnPage); }
  uint32_t low_blocks() const { return up(pages(), kFanOut); }
  bool is_deep() const { return low_blocks() > 8; }
  uint32_t top_blocks() const {
    return is_deep() ? up(low_blocks(), kFanOut) : 0;
  }
  static constexpr uint32_t kKerning = 8;
  uint32_t kern_end() const { return kerns ? kSlots + kKerning : 0; }
  uint32_t first_page() const { return 1 + top_blocks() + low_blocks(); }

  void put_entry(uint32_t page, uint8_t* at) const {
    const uint32_t code_point = kFirst + page * kOnPage;
    put_u16(at, kSlots + page * kOnPage);
    put_u16(at + 2, code_point & 0xffff);
    put_u16(at + 4, code_point >> 16);
  }

  // Counts glyphs of the page that exist.
  void write_page(uint32_t page, uint8_t* out) const {
    const uint32_t first = page * kOnPage;
    const uint32_t left = characters - first;
    const uint32_t count = left < kOnPage ? left : kOnPage;
    uint8_t* const table = out;
    put_u16(table, kAdvance);
    for (uint32_t i = 1; i < 5; ++i) {
      table[12 + i] = 16;
    }
    const uint32_t records = 17 + 8 * (count + 1);
    uint8_t* const glyphs = out + records;
    glyphs[0] = 9;  // bits of an offset
    uint32_t end = 2 + up((count + 2) * 9, 8);
    put_bits(glyphs + 2, 0, end, 9);
    put_bits(glyphs + 2, 9, end, 9);
    for (uint32_t i = 0; i < count; ++i) {
      int16_t box[4];
      end += static_cast<uint32_t>(
          write_glyph(first + i, {glyphs + end, 60}, box));
      put_bits(glyphs + 2, (i + 2) * 9, end, 9);
      for (uint32_t side = 0; side < 4; ++side) {
        put_bits(table + 17, (i + 1) * 64 + side * 16,
                 static_cast<uint16_t>(box[side]), 16);
      }
    }
    uint8_t* const trailer = out + kBlock - paged::trailer::kBytes;
    put_u32(trailer - 8, kFirst + first);
    put_u16(trailer - 4, count - 1);
    put_u16(trailer - 2, 1);
    put_u16(trailer, kSlots + first);
    trailer[2] = static_cast<uint8_t>(count + 1);
    trailer[3] = 1;
    put_u16(trailer + 6, records);
    CHECK(records + end <= kBlock - 16);
  }

  void write_resident(uint8_t* out) const;

  // KERN, each glyph in classes of its own: a pair in each row, of the class of
  // the next glyph.
  static void write_kerning(uint8_t* out) {
    put_u32(out, kKerning - 1);
    put_u16(out + 4, kKerning);
    put_u16(out + 6, kKerning - 1);
    put_u16(out + 8, kKerning);
    put_u16(out + 10, static_cast<uint16_t>(-100));
    const uint8_t widths[] = {8, 8, 8, 8, 8};
    uint8_t* at = out + 12;
    for (const uint8_t width : widths) {
      *at++ = width;
    }
    at = out + format::kerning::kBytes;
    for (uint32_t i = 0; i < kKerning; ++i) {
      *at++ = static_cast<uint8_t>(kSlots + i);
      *at++ = static_cast<uint8_t>(i + 1 == kKerning ? 0 : i + 1);
      *at++ = static_cast<uint8_t>(i + 1);
    }
    for (uint32_t i = 0; i < kKerning; ++i) {
      *at++ = static_cast<uint8_t>(i);
    }
    for (uint32_t i = 0; i + 1 < kKerning; ++i) {
      *at++ = static_cast<uint8_t>(i + 2);
      *at++ = static_cast<uint8_t>(i);
    }
  }

  void write_block(uint32_t block, uint8_t* out) const {
    for (uint32_t i = 0; i < kBlock; ++i) {
      out[i] = 0;
    }
    if (block == 0) {
      write_resident(out);
    } else if (block == first_page() + pages()) {
      write_kerning(out);
    } else if (block >= first_page()) {
      write_page(block - first_page(), out);
    } else {
      const bool is_top = block <= top_blocks();
      const uint32_t step = is_top ? kFanOut : 1;
      uint32_t entry = (block - 1 - (is_top ? 0 : top_blocks())) * kFanOut;
      for (uint32_t i = 0; i < kFanOut && entry * step < pages();
           ++i, ++entry) {
        put_entry(entry * step, out + i * paged::entry::kBytes);
      }
    }
  }

  static bool read(void* context,
                   uint32_t offset,
                   uint8_t* bytes,
                   uint32_t count) {
    Disk& self = *static_cast<Disk*>(context);
    CHECK_EQ(offset % kBlock, 0u);
    CHECK_EQ(count, kBlock);
    CHECK(offset / kBlock <
          self.first_page() + self.pages() + (self.kerns ? 1u : 0u));
    self.bytes += count;
    const bool fails = self.reads >= self.fails_from;
    ++self.reads;
    if (fails && !self.is_short) {
      return false;
    }
    alignas(4) static uint8_t block[kBlock];
    self.write_block(offset / kBlock, block);
    for (uint32_t i = 0; i < (fails ? count / 2 : count); ++i) {
      bytes[i] = block[i];
    }
    if (self.noise != nullptr && self.reads > self.noise_from) {
      for (uint32_t i = self.noise->below(30); i != 0; --i) {
        bytes[self.noise->below(count)] =
            static_cast<uint8_t>(self.noise->below(256));
      }
      // Where pages say what they hold.
      if (self.noise->below(2) == 0) {
        bytes[count - 1 - self.noise->below(16)] =
            static_cast<uint8_t>(self.noise->below(256));
      }
    }
    return !fails;
  }
};

inline void Disk::write_resident(uint8_t* out) const {
  using namespace outline_record;
  uint8_t record[32];
  uint8_t code[2 << kCodeBits];
  write_code(code);
  static font_builder::GlyphSpec specs[kSlots];
  int16_t box[4];
  set_box(box_of({kBar, 4}), 0, box);
  for (font_builder::GlyphSpec& spec : specs) {
    spec = {};
    spec.advance = 600;
    for (uint32_t i = 0; i < 4; ++i) {
      spec.box[i] = box[i];
    }
  }
  specs[0].bytes = {record, write_notdef(record)};
  font_builder::FontSpec spec;
  spec.units_per_em = 1024;
  spec.hints = kGrid;
  spec.glyphs = {specs, kSlots};
  spec.outlines = {{code, sizeof code}, kCodeBits, 0, 20};
  static uint8_t font[512];
  const size_t size = font_builder::build_font(spec, font);
  CHECK(size != 0);
  const uint32_t roots = is_deep() ? top_blocks() : low_blocks();
  uint32_t offset = (paged::kBytes + roots * paged::entry::kBytes + 3) & ~3u;
  for (uint32_t i = 0; i < roots; ++i) {
    put_entry(i * kFanOut * (is_deep() ? kFanOut : 1),
              out + paged::kBytes + i * paged::entry::kBytes);
  }
  CHECK(offset + size <= 512);
  for (size_t i = 0; i < size; ++i) {
    out[offset + i] = font[i];
  }
  put_u32(out, paged::kMagic);
  out[paged::kFormatMinor] = kFormatMinor;
  out[paged::kFormatMajor] = kFormatMajor;
  put_u16(out + paged::kResidentBytes, static_cast<uint32_t>(offset + size));
  put_u16(out + paged::kBlockBytes, kBlock);
  put_u16(out + paged::kFontOffset, offset);
  put_u16(out + paged::kGlyphEnd, kSlots + characters);
  out[paged::kLevels] = is_deep() ? 2 : 1;
  out[paged::kRoots] = static_cast<uint8_t>(roots);
  put_u16(out + paged::kPages, pages());
  put_u16(out + paged::kKernEnd, kern_end());
  const uint32_t crc = font_builder::crc32(
      font_builder::crc32(0, {out, paged::kHeaderCrc}),
      {out + paged::kContentCrc, offset + size - paged::kContentCrc});
  put_u32(out + paged::kHeaderCrc, crc);
}

}  // namespace stored_disk
