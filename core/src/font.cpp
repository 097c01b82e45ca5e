#include "inkcell/font.hpp"

#include "bytes.hpp"
#include "crc.hpp"
#include "inkcell/format.hpp"
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

bool known_section(uint32_t tag) noexcept {
  return tag == section::kCmap || tag == section::kMetrics ||
         tag == section::kKerning || tag == section::kGlyphs ||
         tag == section::kName;
}

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
  const bool readable =
      at[header::kCellKind] ==
          static_cast<uint8_t>(format::CellKind::samples) &&
      at[header::kCoding] == static_cast<uint8_t>(format::Coding::direct);
  if (!readable) {
    return Status::unsupported;
  }
  out = read;
  return Status::ok;
}

// Where the section of a directory entry lies; `ok` is false if it leaves the
// font or is misaligned.
struct Section {
  Span<const uint8_t> bytes;
  bool ok;
};

Section section_of(Span<const uint8_t> rom, const uint8_t* entry) noexcept {
  const uint32_t offset = load_u32(entry + section::kOffset);
  const uint32_t size = load_u32(entry + section::kSize);
  if (offset % 4 != 0 || offset > rom.size || size > rom.size - offset) {
    return {{}, false};
  }
  return {{rom.data + offset, size}, true};
}

// Every section lies within the font, and none is needed that is not known.
Status check_directory(Span<const uint8_t> rom, uint32_t sections) noexcept {
  const uint8_t* entry = rom.data + header::kBytes;
  for (uint32_t i = 0; i < sections; ++i, entry += section::kBytes) {
    if (!section_of(rom, entry).ok) {
      return Status::corrupt;
    }
    const uint32_t flags = load_u32(entry + section::kFlags);
    if ((flags & section::kMustUnderstand) != 0 &&
        !known_section(load_u32(entry + section::kTag))) {
      return Status::unsupported;
    }
  }
  return Status::ok;
}

}  // namespace

Status Font::open(Span<const uint8_t> rom, Font& out) noexcept {
  Header read;
  INKCELL_TRY(read_header(rom, read));
  Font font;
  font.rom_ = {rom.data, read.total_bytes};
  INKCELL_TRY(check_directory(font.rom_, read.sections));
  INKCELL_TRY(font.open_tables());
  INKCELL_TRY(font.open_kerning());
  out = font;
  return Status::ok;
}

Status Font::open_tables() noexcept {
  glyph_count_ = load_u16(rom_.data + header::kGlyphCount);
  units_per_em_ = load_u16(rom_.data + header::kUnitsPerEm);
  if (glyph_count_ == 0 || units_per_em_ < 16 || units_per_em_ > 16384) {
    return Status::corrupt;
  }
  cmap_ = section(section::kCmap);
  metrics_ = section(section::kMetrics);
  glyphs_ = section(section::kGlyphs);
  if (metrics_.size < format::metrics::kBytes * uint32_t{glyph_count_} ||
      glyphs_.size < 4 * (uint32_t{glyph_count_} + 1)) {
    return Status::corrupt;
  }
  return Status::ok;
}

Status Font::open_kerning() noexcept {
  namespace kerning = format::kerning;
  kerning_ = section(section::kKerning);
  if (kerning_.size == 0) {
    return Status::ok;
  }
  if (kerning_.size < kerning::kBytes) {
    return Status::corrupt;
  }
  left_classes_ = load_u16(kerning_.data + kerning::kLeftClasses);
  right_classes_ = load_u16(kerning_.data + kerning::kRightClasses);
  class_bytes_ = left_classes_ <= 255 && right_classes_ <= 255 ? 1 : 2;
  const uint64_t needed = kerning::kBytes +
                          uint64_t{2} * glyph_count_ * class_bytes_ +
                          uint64_t{2} * left_classes_ * right_classes_;
  return needed > kerning_.size ? Status::corrupt : Status::ok;
}

Span<const uint8_t> Font::section(uint32_t tag) const noexcept {
  if (rom_.size == 0) {
    return {};
  }
  const uint32_t sections = load_u16(rom_.data + header::kSectionCount);
  const uint8_t* entry = rom_.data + header::kBytes;
  const uint8_t* const end = rom_.data + rom_.size;
  for (uint32_t i = 0; i < sections; ++i, entry += section::kBytes) {
    if (static_cast<size_t>(end - entry) < section::kBytes) {
      break;
    }
    if (load_u32(entry + section::kTag) == tag) {
      return section_of(rom_, entry).bytes;
    }
  }
  return {};
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
  range.band_u = load_u16(at + header::kBand);
  range.tolerance = at[header::kTolerance];
  range.max_cells = load_u16(at + header::kMaxCells);
  range.max_nodes = load_u16(at + header::kMaxNodes);
  range.max_depth = at[header::kMaxDepth];
  return range;
}

Status Font::glyph_of(uint32_t code_point, uint16_t& glyph) const noexcept {
  namespace cmap = format::cmap;
  glyph = 0;
  // Invariant: an entry that holds the code point has an index below `end`,
  // and all entries below `begin` start at or before it.
  uint32_t begin = 0;
  uint32_t end = static_cast<uint32_t>(cmap_.size) / cmap::kBytes;
  while (begin < end) {
    const uint32_t middle = begin + (end - begin) / 2;
    if (load_u32(cmap_.data + middle * cmap::kBytes + cmap::kFirst) <=
        code_point) {
      begin = middle + 1;
    } else {
      end = middle;
    }
  }
  if (begin == 0) {
    return Status::no_glyph;
  }
  const uint8_t* entry = cmap_.data + (begin - 1) * cmap::kBytes;
  const uint32_t step = code_point - load_u32(entry + cmap::kFirst);
  if (step > load_u16(entry + cmap::kExtra)) {
    return Status::no_glyph;
  }
  const uint32_t id = load_u16(entry + cmap::kFirstGlyph) + step;
  if (id >= glyph_count_) {
    return Status::no_glyph;
  }
  glyph = static_cast<uint16_t>(id);
  return Status::ok;
}

Status Font::glyph_metrics(uint16_t glyph, GlyphMetrics& out) const noexcept {
  namespace metrics = format::metrics;
  if (glyph >= glyph_count_) {
    return Status::no_glyph;
  }
  const uint8_t* at = metrics_.data + metrics::kBytes * uint32_t{glyph};
  out.advance = load_u16(at + metrics::kAdvance);
  out.x_min = load_i16(at + metrics::kXMin);
  out.y_min = load_i16(at + metrics::kYMin);
  out.x_max = load_i16(at + metrics::kXMax);
  out.y_max = load_i16(at + metrics::kYMax);
  return Status::ok;
}

uint32_t Font::kerning_class(uint32_t position) const noexcept {
  const uint8_t* classes = kerning_.data + format::kerning::kBytes;
  return class_bytes_ == 1 ? classes[position]
                           : load_u16(classes + 2 * position);
}

int32_t Font::kerning(uint16_t left, uint16_t right) const noexcept {
  if (kerning_.size == 0 || left >= glyph_count_ || right >= glyph_count_) {
    return 0;
  }
  const uint32_t row = kerning_class(left);
  const uint32_t column = kerning_class(uint32_t{glyph_count_} + right);
  if (row == 0 || column == 0 || row > left_classes_ ||
      column > right_classes_) {
    return 0;
  }
  const uint32_t values =
      format::kerning::kBytes + 2 * uint32_t{glyph_count_} * class_bytes_;
  return load_i16(kerning_.data + values +
                  2 * ((row - 1) * right_classes_ + column - 1));
}

Span<const uint8_t> Font::record(uint16_t glyph) const noexcept {
  if (glyph >= glyph_count_) {
    return {};
  }
  const uint8_t* at = glyphs_.data + 4 * uint32_t{glyph};
  const uint32_t begin = load_u32(at);
  const uint32_t end = load_u32(at + 4);
  if (begin % 4 != 0 || begin > end || end > glyphs_.size) {
    return {};
  }
  return {glyphs_.data + begin, end - begin};
}

Status Font::field(uint16_t glyph, GlyphField& out) const noexcept {
  if (glyph >= glyph_count_) {
    return Status::no_glyph;
  }
  const Span<const uint8_t> bytes = record(glyph);
  if (bytes.size == 0) {
    out = GlyphField{};
    return Status::ok;
  }
  return GlyphField::open(bytes, out);
}

Span<const char> Font::name() const noexcept {
  const Span<const uint8_t> bytes = section(section::kName);
  return {reinterpret_cast<const char*>(bytes.data), bytes.size};
}

}  // namespace inkcell
