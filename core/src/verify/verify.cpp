// Font::verify: everything that `open` leaves to the moment of reading.
#include "base/bit_table.hpp"
#include "base/bytes.hpp"
#include "base/crc.hpp"
#include "font/kerning.hpp"
#include "inkcell/font.hpp"
#include "inkcell/format/rom.hpp"
#include "inkcell/grid_hints.hpp"
#include "outlines/outline_glyph.hpp"
#include "outlines/record_bits.hpp"
#include "verify/morph_verify.hpp"

namespace inkcell {
namespace {

using namespace detail;
namespace word = format::outline;

// Code points ascend without overlap, and every glyph exists.
bool cmap_fits(Span<const uint8_t> cmap, uint32_t glyph_count) noexcept {
  if (cmap.size % format::cmap::kBytes != 0) {
    return false;
  }
  uint32_t next = 0;
  for (size_t i = 0; i < cmap.size; i += format::cmap::kBytes) {
    const uint8_t* entry = cmap.data + i;
    const uint32_t first = load_u32(entry + format::cmap::kFirst);
    const uint32_t extra = load_u16(entry + format::cmap::kExtra);
    const uint32_t glyph = load_u16(entry + format::cmap::kFirstGlyph);
    if (first < next || first > 0x10ffff || glyph + extra >= glyph_count) {
      return false;
    }
    next = first + extra + 1;
  }
  return true;
}

// Pages ascend as their code points do, and every glyph exists.
bool code_pages_fit(Span<const uint8_t> section,
                    uint32_t glyph_count) noexcept {
  namespace pages = format::code_pages;
  if (section.size == 0) {
    return true;
  }
  if (section.size < pages::kBytes) {
    return false;
  }
  const uint32_t count = load_u16(section.data + pages::kPages);
  const uint32_t header_bytes = pages::kBytes + 2 * (count + 1);
  if (count == 0 || header_bytes > section.size ||
      load_u16(section.data + pages::kFirstPage) + count > 0x1100) {
    return false;
  }
  const uint8_t* const starts = section.data + pages::kBytes;
  const uint32_t last_glyph = (load_u16(section.data + pages::kGlyphBase) +
                               static_cast<uint32_t>(section.size) - 1) &
                              0xffff;
  uint32_t begin = load_u16(starts);
  if (begin != header_bytes || load_u16(starts + 2 * count) != section.size ||
      last_glyph >= glyph_count || last_glyph + begin + 1 < section.size) {
    return false;
  }
  for (uint32_t i = 1; i <= count; ++i) {
    const uint32_t end = load_u16(starts + 2 * i);
    if (end < begin || end > section.size) {
      return false;
    }
    for (uint32_t k = begin + 1; k < end; ++k) {
      if (section[k] <= section[k - 1]) {
        return false;
      }
    }
    begin = end;
  }
  return true;
}

bool widths_fit(const uint8_t* widths, uint32_t count, uint32_t most) noexcept {
  for (uint32_t i = 0; i < count; ++i) {
    if (widths[i] > most) {
      return false;
    }
  }
  return true;
}

// Glyphs and pairs ascend, every class exists, and the rows cover the pairs.
class KerningCheck {
 public:
  bool fits(Span<const uint8_t> section, uint32_t glyph_count) noexcept {
    namespace kerning = format::kerning;
    if (!kerning_.open(section) ||
        !widths_fit(section.data + kerning::kGlyphBits, 4, kerning::kMaxBits) ||
        section[kerning::kStartBits] > format::bit_table::kMaxBits) {
      return false;
    }
    right_classes_ = load_u16(section.data + kerning::kRightClasses);
    return rows_fit() && members_fit(glyph_count);
  }

 private:
  bool rows_fit() const noexcept {
    uint32_t next = 0;
    for (uint32_t row = 0; row < kerning_.left_classes; ++row) {
      const uint32_t begin = kerning_.row_start(row);
      const uint32_t end = kerning_.row_start(row + 1);
      if (begin != next || begin > end || end > kerning_.pair_count ||
          !pairs_fit(begin, end)) {
        return false;
      }
      next = end;
    }
    return kerning_.row_start(0) == 0 && next == kerning_.pair_count;
  }

  bool pairs_fit(uint32_t begin, uint32_t end) const noexcept {
    uint32_t next = 1;
    for (uint32_t i = begin; i < end; ++i) {
      const uint32_t right = kerning_.pairs.get(i, 0, kerning_.right_bits);
      if (right < next || right > right_classes_) {
        return false;
      }
      next = right + 1;
    }
    return true;
  }

  bool members_fit(uint32_t glyph_count) const noexcept {
    uint32_t next = 0;
    for (uint32_t i = 0; i < kerning_.member_count; ++i) {
      const uint32_t glyph = kerning_.members.get(i, 0, kerning_.glyph_bits);
      if (glyph < next || glyph >= glyph_count ||
          kerning_.left_class(i) > kerning_.left_classes ||
          kerning_.right_class(i) > right_classes_) {
        return false;
      }
      next = glyph + 1;
    }
    return true;
  }

  Kerning kerning_;
  uint32_t right_classes_ = 0;
};

bool metrics_fit(Span<const uint8_t> section, uint32_t glyph_count) noexcept {
  namespace metrics = format::metrics;
  const uint32_t advances = load_u16(section.data + metrics::kAdvances);
  return advances <= glyph_count &&
         widths_fit(section.data + metrics::kColumnBits, metrics::kColumns,
                    metrics::kMaxBits);
}

// Records lie one after the other behind the offsets.
// Fonts of strikes alone have none.
bool has_records(Span<const uint8_t> section) noexcept {
  return section[format::glyphs::kOffsetBits] != 0;
}

bool offsets_fit(Span<const uint8_t> section, uint32_t glyph_count) noexcept {
  namespace glyphs = format::glyphs;
  const uint32_t width = section[glyphs::kOffsetBits];
  const uint32_t unit_log2 = section[glyphs::kUnitLog2];
  if (width > format::bit_table::kMaxBits || unit_log2 > glyphs::kMaxUnitLog2) {
    return false;
  }
  const BitTable offsets = {&section, 8 * glyphs::kBytes, width};
  size_t least = glyphs::kBytes + (width * (glyph_count + 1) + 7) / 8;
  for (uint32_t i = 0; i <= glyph_count; ++i) {
    const uint32_t offset = offsets.get(i, 0, width) << unit_log2;
    if (offset < least || offset > section.size) {
      return false;
    }
    least = offset;
  }
  return true;
}

uint32_t code_entry(const OutlineCoding& coding, uint32_t i) noexcept {
  return load_u16(coding.tables + 2 * i);
}

uint32_t kind_of_word(uint32_t code) noexcept {
  return code >> word::kKindShift & word::kKindMask;
}
uint32_t width_of(uint32_t code) noexcept {
  return (code >> word::kXBitsShift & word::kWidthMask) +
         (code >> word::kYBitsShift & word::kWidthMask);
}

bool is_mirrored(const int32_t* matrix_q14) noexcept {
  return int64_t{matrix_q14[0]} * matrix_q14[3] <=
         int64_t{matrix_q14[1]} * matrix_q14[2];
}

// Points of a simple outline, ends of contours included; more than max_points
// if it does not end. `bit` is set to where it ends.
uint32_t count_points(Span<const uint8_t> record,
                      const OutlineCoding& coding,
                      uint32_t& bit) noexcept {
  bit = 1;
  uint32_t table = 0;
  bool is_start = true;
  for (uint32_t points = 1; points <= coding.max_points; ++points) {
    const uint32_t code =
        code_entry(coding, (table << coding.code_bits) +
                               bits_at(record, bit, coding.code_bits));
    table ^= code >> word::kTableShift & coding.last_table;
    bit += (code & word::kLengthMask) + width_of(code);
    if (kind_of_word(code) != word::kEndOfContour) {
      if (is_start && kind_of_word(code) != kCorner) {
        break;
      }
      is_start = false;
      continue;
    }
    if (is_start) {
      break;  // a contour without points
    }
    is_start = true;
    if (bits_at(record, bit++, 1) == 0) {
      return points;
    }
  }
  return uint32_t{coding.max_points} + 1;
}

// Whether the code words make sense (docs/FORMAT.md, rule 16).
bool code_fits(const OutlineCoding& coding) noexcept {
  const uint32_t count = (coding.last_table + 1u) << coding.code_bits;
  for (uint32_t i = 0; i < count; ++i) {
    const uint32_t code = code_entry(coding, i);
    const uint32_t length = code & word::kLengthMask;
    if (length == 0 || length > coding.code_bits ||
        code >> word::kTableShift > coding.last_table ||
        (kind_of_word(code) == word::kEndOfContour && width_of(code) != 0)) {
      return false;
    }
    // All that begin with the word are in a row; with numbers the first bit of
    // them may tell words of the same bits apart.
    const uint32_t after = coding.code_bits - length;
    const uint32_t same =
        1u << (after != 0 && width_of(code) != 0 ? after - 1 : after);
    if ((i & (same - 1)) != 0 && code_entry(coding, i - 1) != code) {
      return false;
    }
  }
  return true;
}

// Whether the record of an outline or a composite does (rules 17 and 18), and
// the bits before its hints, in a composite no more than that. Every code word
// of `coding` must.
bool outline_fits(const Font& font,
                  Span<const uint8_t> record,
                  const OutlineCoding& coding,
                  uint32_t& bits) noexcept {
  if (record.data[0] != format::composite::kType) {
    return count_points(record, coding, bits) <= coding.max_points;
  }
  bits = 8 * format::composite::kTypeBytes;
  ComponentReader components;
  components.begin();
  Component component;
  uint32_t points = 0;
  while (components.next(record, component)) {
    const Span<const uint8_t> part = font.record(component.glyph);
    if (!is_outline(part) || part.data[0] == format::composite::kType ||
        (component.has_matrix && is_mirrored(component.matrix_q14()))) {
      return false;
    }
    uint32_t end;
    points += count_points(part, coding, end);
  }
  return points != 0 && points <= coding.max_points;
}

// All entries that begin with a word are equal.
bool hint_words_fit(const uint8_t* words, uint32_t code_bits) noexcept {
  namespace grid = format::grid;
  const uint32_t count = grid::kTables << code_bits;
  for (uint32_t i = 0; i < count; ++i) {
    const uint32_t entry = load_u16(words + 2 * i);
    const uint32_t length = entry & grid::kLengthMask;
    const uint32_t table = i >> code_bits << code_bits;
    const uint32_t first = table | (i & ((1u << length) - 1));
    if (length > code_bits || load_u16(words + 2 * first) != entry) {
      return false;
    }
  }
  return true;
}

// Opens the hints of a font, which may have none.
bool open_hints(const Font& font, GridHints& hints) noexcept {
  namespace grid = format::grid;
  if (GridHints::open(font, hints) != Status::ok) {
    return false;
  }
  if (hints.empty()) {
    return true;
  }
  const uint8_t* const section = font.section(format::section::kGrid).data;
  return (hints.x_zone() < hints.zone_count() ||
          hints.x_zone() == grid::kNoZone) &&
         hint_words_fit(
             section + grid::kBytes + grid::kZoneBytes * hints.zone_count(),
             section[grid::kCodeBits]);
}

// The hints of a glyph ascend, name zones that exist, and end where the outline
// does, whose bits are `outline_bits`: no byte lies between them.
bool hints_fit(const GridHints& hints,
               const Span<const uint8_t>& record,
               uint32_t outline_bits) noexcept {
  if (hints.empty()) {
    return true;
  }
  GlyphHints read(hints, record);
  int32_t last_u = INT32_MIN;
  for (uint32_t i = 0; i < read.y_count(); ++i) {
    const YHint hint = read.next_y();
    if (hint.low_u < last_u ||
        (hint.zone != YHint::kNoZone && hint.zone >= hints.zone_count())) {
      return false;
    }
    last_u = hint.low_u;
  }
  last_u = INT32_MIN;
  for (uint32_t i = 0; i < read.x_count(); ++i) {
    const XHint hint = read.next_x();
    if (hint.left_u <= last_u) {
      return false;
    }
    last_u = hint.right_u;
  }
  const size_t bytes = (outline_bits + read.bits() + 7) / 8;
  return bytes == record.size ||
         (bytes < record.size && record.data[0] == format::composite::kType);
}

}  // namespace

Status Font::verify() const noexcept {
  if (rom_.size == 0) {
    return Status::corrupt;
  }
  namespace header = format::header;
  const uint32_t header_bytes = load_u16(rom_.data + header::kHeaderBytes);
  if (header_bytes > rom_.size) {
    return Status::corrupt;
  }
  const uint32_t crc =
      crc32(0, {rom_.data + header_bytes, rom_.size - header_bytes});
  if (crc != load_u32(rom_.data + header::kContentCrc) ||
      !cmap_fits(cmap_table(), glyph_count_) ||
      !code_pages_fit(code_pages_, glyph_count_) ||
      !metrics_fit(metrics_table(), glyph_count_) ||
      (kerning_table().size != 0 &&
       !KerningCheck().fits(kerning_table(), glyph_count_)) ||
      (has_records(glyph_table()) &&
       !offsets_fit(glyph_table(), glyph_count_)) ||
      !morphs_fit(section(format::section::kMorphs), glyph_count_)) {
    return Status::corrupt;
  }
  const bool has_code = has_outlines();
  if (has_code && !code_fits(coding_)) {
    return Status::corrupt;
  }
  GridHints hints;
  if (has_code && !open_hints(*this, hints)) {
    return Status::corrupt;
  }
  for (uint32_t glyph = 0; has_code && glyph < glyph_count_; ++glyph) {
    const Span<const uint8_t> bytes = record(static_cast<uint16_t>(glyph));
    uint32_t bits = 0;
    if (bytes.size != 0 &&
        (!is_outline(bytes) || !outline_fits(*this, bytes, coding_, bits) ||
         !hints_fit(hints, bytes, bits))) {
      return Status::corrupt;
    }
  }
  return Status::ok;
}

}  // namespace inkcell
