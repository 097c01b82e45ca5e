// Fonts in ROM: opened once in constant time, safe with any content.
#pragma once

#include <stdint.h>

#include "inkcell/coding.hpp"
#include "inkcell/span.hpp"
#include "inkcell/status.hpp"

namespace inkcell {

class Font;
class Style;
class TrueTypeFont;
struct GlyphMetrics;

namespace detail {
// What all outlines of a font share: sections CODE and GLYF.
struct OutlineCoding {
  const uint8_t* tables = nullptr;  // of 2^code_bits words, at an even address
  uint8_t code_bits = 0;            // of prefixes; 0: there are no outlines
  int8_t grid_shift = 0;            // grid units are 2^grid_shift font units
  uint16_t max_points = 0;          // of a glyph; no reader goes on beyond
  uint8_t last_table = 0;           // 0, 1, 3 or 7
};

// Finds glyphs of a font that is read in pages (inkcell/stored/), or in another
// format (inkcell/truetype/).
struct FontPages {
  // As Font::glyph_of(); read_failed: the storage.
  Status (*glyph_of)(const FontPages& pages,
                     uint32_t code_point,
                     uint16_t& glyph) noexcept;
  // The font that holds a glyph, which becomes its id there; null: there is no
  // such glyph. .notdef where the page cannot be read.
  const Font* (*page_of)(const FontPages& pages, uint32_t& glyph) noexcept;
  // As Font::kerning(); 0 where it cannot be read.
  int32_t (*kerning)(const FontPages& pages,
                     uint16_t left,
                     uint16_t right) noexcept;
  // As Font::advance() of a glyph that page_of() does not know, or with `out`
  // as Font::glyph_metrics(): negative if there is no such glyph.
  int32_t (*measure)(const FontPages& pages,
                     uint16_t glyph,
                     GlyphMetrics* out) noexcept;
};
class StoredStore;
class StrikeAlone;
}  // namespace detail

/// Measures of one glyph in font units (units_per_em to the em), y up, origin
/// on the baseline. The box is that of the ink; it is empty for a space.
struct GlyphMetrics {
  int32_t advance = 0;
  int16_t x_min = 0;  // left bearing
  int16_t y_min = 0;
  int16_t x_max = 0;
  int16_t y_max = 0;
};

/// The box of a glyph's ink. [u] By default all of the plane.
struct InkBox {
  static constexpr int16_t kFar = 16384;

  int16_t x0_u = -kFar;
  int16_t y0_u = -kFar;
  int16_t x1_u = kFar;
  int16_t y1_u = kFar;
};

/// Measures of the whole font in font units, y up: the descender is negative.
/// A line is ascender - descender + line_gap high.
struct FontMetrics {
  uint16_t units_per_em = 1000;
  int16_t ascender = 0;
  int16_t descender = 0;
  int16_t line_gap = 0;
  int16_t x_height = 0;
  int16_t cap_height = 0;
  int16_t x_min = 0;  // box of all ink
  int16_t y_min = 0;
  int16_t x_max = 0;
  int16_t y_max = 0;
};

/// What the font was generated for.
struct FontRange {
  uint16_t min_px = 0;  // [px/em]
  uint16_t max_px = 0;
  uint16_t band_u = 0;     // distances are good up to here; outlines: any
  uint8_t tolerance = 0;   // worst coverage error that was allowed [1/255]
  uint16_t max_cells = 0;  // of any glyph
  uint16_t max_nodes = 0;
  uint8_t max_depth = 0;  // steps from a tile to its smallest cell
};

/// A font in read-only memory. Holds a view, owns nothing: the bytes must
/// outlive it. Constant after `open`, so that any number of tasks and
/// interrupts may draw from it at once.
///
/// Font bytes are untrusted. `open` checks the header, the section directory
/// and the sizes of the tables that drawing needs, in time that does not depend
/// on the number of glyphs or cells. Everything else is checked where it is
/// read: whatever the bytes are, and even if they change later, no call reads
/// outside them, fails to end, or traps. Wrong bytes give a wrong picture.
class Font {
 public:
  /// A font without glyphs: every call answers no_glyph or zero.
  constexpr Font() noexcept = default;

  /// Opens the font that begins at `rom.data`, a multiple of 4. `rom` may be
  /// longer than the font.
  ///
  /// bad_magic, bad_version, misaligned, corrupt (header, directory or table
  /// sizes), unsupported (a section that this version cannot read, or another
  /// coding: fonts of fields need kFieldCoding of inkcell/field/draw.hpp, and
  /// fonts of the former coding `edges` must be generated anew). `out` is
  /// untouched unless the result is ok.
  static Status open(Span<const uint8_t> rom, Font& out) noexcept {
    return open(rom, kOutlineCoding, out);
  }
  /// The same of a font of another coding, which the caller names.
  static Status open(Span<const uint8_t> rom,
                     const Coding& coding,
                     Font& out) noexcept;

  /// Reads the whole font: its checksum, every table and every outline; for
  /// cells there is verify_fields() (inkcell/field/verify.hpp).
  /// Never needed for safety; for a factory test or after an update. Time is
  /// proportional to the font's size. corrupt: something does not fit.
  Status verify() const noexcept;

  /// Whether a style draws glyphs of this font: the one place that refuses it.
  /// unsupported: the style's effect does not take this font, and nothing would
  /// show. Outlines take neither splats nor circle samples; fields do, but not
  /// with a style that stretches.
  Status check(const Style& style) const noexcept;

  uint16_t glyph_count() const noexcept { return glyph_count_; }
  FontMetrics metrics() const noexcept;
  FontRange range() const noexcept;
  /// Whether glyphs are outlines, and not fields.
  bool has_outlines() const noexcept { return coding_.code_bits != 0; }
  const detail::OutlineCoding& outline_coding() const noexcept {
    return coding_;
  }
  uint16_t units_per_em() const noexcept { return units_per_em_; }
  /// What paints glyphs; null before open().
  const detail::Source* source() const noexcept { return source_; }

  /// The glyph of a code point. no_glyph: the font has none; `glyph` is then 0,
  /// which is .notdef. Binary search: two steps more for four times the ranges,
  /// 8 for a font of 128.
  Status glyph_of(uint32_t code_point, uint16_t& glyph) const noexcept;

  /// The same for drawing: .notdef where the font has no glyph.
  uint16_t glyph_or_notdef(uint32_t code_point) const noexcept {
    uint16_t glyph = 0;
    static_cast<void>(glyph_of(code_point, glyph));
    return glyph;
  }

  /// no_glyph: there is no glyph of this id; `out` is untouched.
  Status glyph_metrics(uint16_t glyph, GlyphMetrics& out) const noexcept;

  /// GlyphMetrics::advance alone, in a third of the time; 0 if there is no such
  /// glyph.
  int32_t advance(uint16_t glyph) const noexcept;

  /// The box of a glyph's ink, up to 2 u wider on each side, 1 u where the em
  /// is a power of 2; all of the plane if there is no such glyph.
  InkBox ink_box(uint16_t glyph) const noexcept;

  /// The kerning of a pair: add it to the advance of `left` if `right` follows.
  /// 0 if the font has none for the pair. [font units] Three binary searches,
  /// about 16 steps for ASCII.
  int32_t kerning(uint16_t left, uint16_t right) const noexcept;

  /// The glyph's record as it lies in the font, for tools. Empty if the glyph
  /// has no ink, does not exist, or its offsets do not fit.
  Span<const uint8_t> record(uint16_t glyph) const noexcept;

  /// The font that holds a glyph, which becomes its id there: this font, or a
  /// page of a stored one, in RAM until another glyph is asked for. Null: there
  /// is no such glyph.
  const Font* page_of(uint32_t& glyph) const noexcept {
    if (glyph < glyph_count_) {
      return this;
    }
    return pages_ != nullptr ? pages_->page_of(*pages_, glyph) : nullptr;
  }

  /// The font's name, UTF-8, not terminated; empty if it has none.
  Span<const char> name() const noexcept;

  /// The bytes of the font, without what followed it in `rom`.
  Span<const uint8_t> rom() const noexcept { return rom_; }

  /// Where section GLYF lies, for what draws glyphs.
  const Span<const uint8_t>& glyph_table() const noexcept { return tables_[2]; }

  /// The bytes of the section `tag` (format::section); empty if absent.
  Span<const uint8_t> section(uint32_t tag) const noexcept;

 private:
  friend class detail::StoredStore;
  friend class detail::StrikeAlone;
  friend class TrueTypeFont;

  class MetricsRow;

  Status open_tables(uint32_t sections) noexcept;
  bool open_code(const Span<const uint8_t>& code) noexcept;
  bool fit_tables() noexcept;
  uint32_t find_run(uint32_t code_point) const noexcept;
  uint32_t find_on_page(uint32_t code_point) const noexcept;
  bool find_row(uint32_t glyph, MetricsRow& row) const noexcept;
  const Span<const uint8_t>& cmap_table() const noexcept { return tables_[0]; }
  const Span<const uint8_t>& metrics_table() const noexcept {
    return tables_[1];
  }
  const Span<const uint8_t>& kerning_table() const noexcept {
    return tables_[3];
  }

  static constexpr uint32_t kTables = 4;

  Span<const uint8_t> rom_;
  Span<const uint8_t> tables_[kTables];
  const detail::Source* source_ = nullptr;
  const detail::FontPages* pages_ = nullptr;  // of a stored font
  detail::OutlineCoding coding_;
  uint16_t glyph_count_ = 0;
  uint16_t units_per_em_ = 1000;
  uint16_t metrics_row_bits_ = 0;
  // Last: the smallest cores reach fewer places of numbers of 16 bits.
  Span<const uint8_t> code_pages_;
};

}  // namespace inkcell
