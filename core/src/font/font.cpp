#include "inkcell/font.hpp"

#include "base/bit_table.hpp"
#include "base/bytes.hpp"
#include "base/crc.hpp"
#include "font/font_tables.hpp"
#include "font/metrics_row.hpp"
#include "inkcell/format/rom.hpp"
#include "inkcell/version.hpp"

namespace inkcell {
namespace {

namespace header = format::header;
namespace section = format::section;

using detail::load_i16;
using detail::load_u16;
using detail::load_u32;

// More sections than any minor of this major will have.
constexpr uint32_t kMaxSections = 32;

// The sections that are known: first those that a font keeps, in its order,
// then CODE.
constexpr uint32_t kKnownTags[] = {
    section::kCmap,      section::kMetrics, section::kGlyphs, section::kKerning,
    section::kCodePages, section::kCode,    section::kName};
constexpr uint32_t kKnown = sizeof kKnownTags / sizeof kKnownTags[0];

// What the rest of `open` needs of a header that it has checked. Read once:
// flash that changes meanwhile must not come between check and use.
struct Header {
  uint32_t sections = 0;
  uint32_t total_bytes = 0;
};

Status read_header(Span<const uint8_t> rom, Header& out) noexcept {
  if (rom.size < header::kBytes) {
    return Status::bad_magic;
  }
  if (reinterpret_cast<uintptr_t>(rom.data) % format::kAlignment != 0) {
    return Status::misaligned;
  }
  const uint8_t* at = rom.data;
  if (load_u32(at + header::kMagic) != format::kMagic) {
    return Status::bad_magic;
  }
  if (!reads_format(at[header::kFormatMajor], at[header::kFormatMinor])) {
    return Status::bad_version;
  }
  const Header read = {load_u16(at + header::kSectionCount),
                       load_u32(at + header::kTotalBytes)};
  const uint32_t header_bytes =
      header::kBytes + read.sections * section::kBytes;
  if (read.sections > kMaxSections ||
      header_bytes != load_u16(at + header::kHeaderBytes) ||
      read.total_bytes < header_bytes || read.total_bytes > rom.size) {
    return Status::corrupt;
  }
  uint32_t crc = detail::crc32(0, {at, header::kHeaderCrc});
  crc = detail::crc32(
      crc, {at + header::kContentCrc, header_bytes - header::kContentCrc});
  if (crc != load_u32(at + header::kHeaderCrc)) {
    return Status::corrupt;
  }
  out = read;
  return Status::ok;
}

// Where the section of a directory entry lies. False if it leaves the font, is
// misaligned, or begins at 0, where nothing lies before it: hints are read from
// up to 3 bytes before a record.
bool find_section(Span<const uint8_t> rom,
                  const uint8_t* entry,
                  Span<const uint8_t>& out) noexcept {
  const uint32_t offset =
      load_u32(entry + section::kOffset) & ~section::kMustUnderstand;
  const uint32_t size = load_u32(entry + section::kSize);
  if ((offset & ~section::kOffsetMask) != 0 || offset - 1 >= rom.size ||
      size > rom.size - offset) {
    return false;
  }
  out = {rom.data + offset, size};
  return true;
}

}  // namespace

// What outlines are read with is kept: it was checked.
inline bool Font::open_code(const Span<const uint8_t>& code) noexcept {
  namespace outline = format::outline;
  const uint8_t* at = rom_.data;
  if (at[header::kCoding] != static_cast<uint8_t>(format::Coding::outline)) {
    return true;
  }
  const uint32_t code_bits = at[header::kCodeBits];
  const uint8_t grid_shift = at[header::kGridShift];
  if (code_bits == 0 || code_bits > outline::kMaxCodeBits ||
      units_per_em_ < outline::kLeastUnitsPerEm ||
      code.size < size_t{2} << code_bits ||
      static_cast<uint8_t>(grid_shift - outline::kMinGridShift) >
          outline::kMaxGridShift - outline::kMinGridShift) {
    return false;
  }
  uint32_t last_table = 0;
  while (last_table != outline::kMaxTables - 1 &&
         code.size >> (code_bits + 2) > last_table) {
    last_table = 2 * last_table + 1;
  }
  coding_ = {code.data, static_cast<uint8_t>(code_bits),
             static_cast<int8_t>(grid_shift), load_u16(at + header::kMaxPoints),
             static_cast<uint8_t>(last_table)};
  return true;
}

inline Status Font::open_tables(uint32_t sections) noexcept {
  const uint8_t* entry = rom_.data + header::kBytes;
  Span<const uint8_t> code;
  for (; sections != 0; --sections, entry += section::kBytes) {
    Span<const uint8_t> bytes;
    if (!find_section(rom_, entry, bytes)) {
      return Status::corrupt;
    }
    const uint32_t tag = load_u32(entry + section::kTag);
    uint32_t known = 0;
    while (known < kKnown && kKnownTags[known] != tag) {
      ++known;
    }
    if (known == kKnown &&
        (load_u32(entry + section::kOffset) & section::kMustUnderstand) != 0) {
      return Status::unsupported;
    }
    // If two have the same tag the first one counts.
    Span<const uint8_t>& table = known < kTables    ? tables_[known]
                                 : known == kTables ? code_pages_
                                                    : code;
    if (known <= kTables + 1 && table.data == nullptr) {
      table = bytes;
    }
  }
  glyph_count_ = load_u16(rom_.data + header::kGlyphCount);
  units_per_em_ = load_u16(rom_.data + header::kUnitsPerEm);
  constexpr uint32_t kLeastEm = header::kLeastUnitsPerEm;
  if (units_per_em_ - kLeastEm > header::kMostUnitsPerEm - kLeastEm ||
      !fit_tables()) {
    return Status::corrupt;
  }
  return open_code(code) ? Status::ok : Status::corrupt;
}

Status Font::open(Span<const uint8_t> rom,
                  const Coding& coding,
                  Font& out) noexcept {
  Header read;
  INKCELL_TRY(read_header(rom, read));
  Font font;
  if (rom.data[header::kCoding] != coding.number) {
    return Status::unsupported;
  }
  font.source_ = coding.source;
  font.rom_ = {rom.data, read.total_bytes};
  INKCELL_TRY(font.open_tables(read.sections));
  out = font;
  return Status::ok;
}

Span<const uint8_t> Font::section(uint32_t tag) const noexcept {
  Span<const uint8_t> bytes;
  if (rom_.size == 0) {
    return bytes;
  }
  const uint32_t sections = load_u16(rom_.data + header::kSectionCount);
  const uint8_t* entry = rom_.data + header::kBytes;
  const uint8_t* const end = rom_.data + rom_.size;
  for (uint32_t i = 0; i < sections; ++i, entry += section::kBytes) {
    if (static_cast<size_t>(end - entry) < section::kBytes) {
      break;
    }
    if (load_u32(entry + section::kTag) == tag) {
      static_cast<void>(find_section(rom_, entry, bytes));
      break;
    }
  }
  return bytes;
}

FontMetrics Font::metrics() const noexcept {
  FontMetrics metrics;
  if (rom_.size == 0) {
    return metrics;
  }
  const uint8_t* at = rom_.data;
  metrics.units_per_em = units_per_em_;
  metrics.ascender = load_i16(at + header::kAscender);
  metrics.descender = load_i16(at + header::kDescender);
  metrics.line_gap = load_i16(at + header::kLineGap);
  metrics.x_height = load_i16(at + header::kXHeight);
  metrics.cap_height = load_i16(at + header::kCapHeight);
  metrics.x_min = load_i16(at + header::kXMin);
  metrics.y_min = load_i16(at + header::kYMin);
  metrics.x_max = load_i16(at + header::kXMax);
  metrics.y_max = load_i16(at + header::kYMax);
  return metrics;
}

FontRange Font::range() const noexcept {
  FontRange range;
  if (rom_.size == 0) {
    return range;
  }
  const uint8_t* at = rom_.data;
  range.min_px = load_u16(at + header::kMinPx);
  range.max_px = load_u16(at + header::kMaxPx);
  range.band_u = has_outlines() ? UINT16_MAX : load_u16(at + header::kBand);
  range.tolerance = at[header::kTolerance];
  range.max_cells = load_u16(at + header::kMaxCells);
  range.max_nodes = load_u16(at + header::kMaxNodes);
  range.max_depth = at[header::kMaxDepth];
  return range;
}

// False: there is no such glyph.
bool Font::find_row(uint32_t glyph, MetricsRow& row) const noexcept {
  const Font* const font = page_of(glyph);
  if (font == nullptr) {
    return false;
  }
  row.set(font->metrics_table(), font->metrics_row_bits_, glyph);
  return true;
}

Status Font::glyph_metrics(uint16_t glyph, GlyphMetrics& out) const noexcept {
  MetricsRow row;
  if (!find_row(glyph, row)) {
    return pages_ != nullptr && pages_->measure(*pages_, glyph, &out) >= 0
               ? Status::ok
               : Status::no_glyph;
  }
  uint16_t columns[format::metrics::kColumns];
#if !defined(__OPTIMIZE_SIZE__)
#  pragma GCC unroll 5
#endif
  for (uint32_t i = 0; i < format::metrics::kColumns; ++i) {
    columns[i] = row.take(i);
  }
  out.advance = columns[0];
  out.x_min = static_cast<int16_t>(columns[1]);
  out.y_min = static_cast<int16_t>(columns[2]);
  out.x_max = static_cast<int16_t>(columns[3]);
  out.y_max = static_cast<int16_t>(columns[4]);
  return Status::ok;
}

int32_t Font::advance(uint16_t glyph) const noexcept {
  MetricsRow row;
  if (find_row(glyph, row)) {
    return row.advance();
  }
  return pages_ != nullptr ? pages_->measure(*pages_, glyph, nullptr) : 0;
}

InkBox Font::ink_box(uint16_t glyph) const noexcept {
  MetricsRow row;
  // Products of smaller ems pass 31 bits.
  if (units_per_em_ < 256 || !find_row(glyph, row)) {
    return {};
  }
  const auto u_per_unit_q14 =
      static_cast<int32_t>((uint32_t{1024} << 14) / units_per_em_);
  row.skip_advance();
  // The quotient is too small by less than one, or exact.
  const int32_t rest = (units_per_em_ & (units_per_em_ - 1)) != 0 ? 1 : 0;
  int16_t sides[4];
#if !defined(__OPTIMIZE_SIZE__)
#  pragma GCC unroll 4
#endif
  for (uint32_t i = 0; i < 4; ++i) {
    const int32_t units = static_cast<int16_t>(row.take(i + 1));
    // Outwards. At most 2^31 below 0, and less above.
    const bool is_high = i >= 2;
    int32_t u_q14 = units * u_per_unit_q14;
    if (is_high != (units < 0)) {
      u_q14 += units * rest;
    }
    const int32_t u = (u_q14 + (is_high ? (1 << 14) - 1 : 0)) >> 14;
    constexpr int32_t kFar = InkBox::kFar;
    sides[i] = static_cast<int16_t>(u > kFar ? kFar : (u < -kFar ? -kFar : u));
  }
  return {sides[0], sides[1], sides[2], sides[3]};
}

Span<const uint8_t> Font::record(uint16_t glyph) const noexcept {
  namespace at = format::glyphs;
  if (glyph >= glyph_count_) {
    return {};
  }
  const Span<const uint8_t>& bytes = glyph_table();
  const uint32_t width = bytes.data[at::kOffsetBits];
  // So much and no more, whatever the byte: no shift is too long.
  const uint32_t unit_log2 = bytes.data[at::kUnitLog2] & at::kMaxUnitLog2;
  const uint32_t bit = 8 * at::kBytes + width * glyph;
  const uint32_t begin = detail::read_bits(bytes, bit, width) << unit_log2;
  const uint32_t end = detail::read_bits(bytes, bit + width, width)
                       << unit_log2;
  if (begin > end || end > bytes.size) {
    return {};
  }
  return {bytes.data + begin, end - begin};
}

Span<const char> Font::name() const noexcept {
  const Span<const uint8_t> bytes = section(section::kName);
  return {reinterpret_cast<const char*>(bytes.data), bytes.size};
}

}  // namespace inkcell
