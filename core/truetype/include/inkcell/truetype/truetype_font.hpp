// A TrueType file as a font, in flash or RAM: without the generator.
//
//   TrueTypeFont sans;
//   INKCELL_TRY(sans.open({bytes, size}));
//   painter.text(sans.font(), Style(24_px), pen, "12:34");
//
// font() is a Font like any other: for text, layout, labels, boxes, caches, as
// a fallback. Outlines are those of the file, with kerning of `kern` format 0
// and of GPOS pairs. There are no hints: a style that is fitted (fit.hpp)
// moves heights only, the baseline, the x-height and that of capitals. Of a
// variable font the default instance is drawn. Fonts with outlines of CFF
// (.otf) are refused: inkcell-fontgen reads them.
//
// Contours of most files overlap, and no flag tells. So only exact areas are
// drawn, by kFilterArea and effects on it, in rows of 16 bits, which saturate:
// Font::check() answers `unsupported` to all else. plain_truetype.hpp draws any
// style of files without overlaps.
#pragma once

#include <stdint.h>

#include "inkcell/coding.hpp"
#include "inkcell/font.hpp"
#include "inkcell/format/rom.hpp"
#include "inkcell/span.hpp"
#include "inkcell/status.hpp"

namespace inkcell {

/// For TrueTypeFont::open(): any TrueType file.
extern const Coding kTrueTypeCoding;

namespace detail {
// What drawing needs of a file, wherever its bytes are.
struct TrueTypeFace : FontPages {
  // The record of a glyph in `records`; empty for a space, and where something
  // does not fit. With `left_bearing` the glyph is drawn next, without it it is
  // a component of that.
  Span<const uint8_t> (*record)(const TrueTypeFace& face,
                                uint32_t glyph,
                                int32_t* left_bearing) noexcept = nullptr;
  Span<const uint8_t> records;
  uint16_t glyphs = 0;
  uint16_t advances = 0;  // pairs in hmtx
  uint8_t cmap_format = 0;
  bool is_long = false;  // loca
  // A header as those of fonts in ROM, for Font::metrics().
  alignas(format::kAlignment) uint8_t header[format::header::kBytes] = {};

  constexpr TrueTypeFace() noexcept : FontPages() {}
};

// With the tables of a file. Bytes are big endian.
template <typename Bytes>
struct TrueTypeTables : TrueTypeFace {
  using AnyTable = Bytes;

  Bytes glyf;
  Bytes loca;
  Bytes hmtx;
  Bytes cmap;  // the subtable in use
  Bytes kern;  // likewise; empty if GPOS kerns
  Bytes gpos;
};
using MappedTrueType = TrueTypeTables<Span<const uint8_t>>;
class StoredTrueTypeFile;
}  // namespace detail

/// Views the file, owns nothing: the bytes must outlive it. font() and copies
/// of it point into it, so that it stays where it is. Constant after open(), so
/// that any number of tasks and interrupts may draw from it at once.
///
/// Bytes are untrusted, as those of Font are: whatever they are, and even if
/// they change, no call reads outside of them, fails to end, or traps. A glyph
/// has at most 8,192 points and 64 components, four deep.
class TrueTypeFont {
 public:
  /// font() has no glyphs.
  constexpr TrueTypeFont() noexcept = default;
  TrueTypeFont(const TrueTypeFont&) = delete;
  TrueTypeFont& operator=(const TrueTypeFont&) = delete;

  /// Opens a file, at any address; of a collection (.ttc) the face of this
  /// number. Takes time for the directory alone.
  ///
  /// bad_magic: not a TrueType file. unsupported: its outlines are not
  /// TrueType's. corrupt: a table that drawing needs is absent, or does not
  /// fit. no_glyph: there is no such face. Then nothing changes.
  Status open(Span<const uint8_t> file,
              const Coding& coding = kTrueTypeCoding,
              uint32_t face = 0) noexcept;

  /// The font. It differs from others in this: Font::glyph_count() is 0,
  /// record(), section(), name() and rom() are those of no file, ink_box() is
  /// all of the plane, and verify() answers `corrupt`. The box of a glyph is
  /// what the file says, and clips it.
  const Font& font() const noexcept { return font_; }

  uint16_t glyph_count() const noexcept { return face_.glyphs; }

  /// The face of font(), or of a copy of it.
  static const detail::TrueTypeFace& face_of(const Font& font) noexcept;

 private:
  friend class detail::StoredTrueTypeFile;

  static void make_font(const detail::TrueTypeFace& face,
                        uint32_t units_per_em,
                        const Coding& coding,
                        Font& out) noexcept;

  detail::MappedTrueType face_;
  Font font_;
};

}  // namespace inkcell
