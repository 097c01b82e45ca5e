// Small ROM fonts made in a buffer: what the unit tests draw and break.
//
// Independent of the generator, and of the reader but for format.hpp. Nothing
// here allocates, so that it runs on a board with 16 KB.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "inkcell/format/rom.hpp"
#include "inkcell/span.hpp"

namespace font_builder {

using inkcell::Span;

void put_u16(uint8_t* at, uint32_t value);
void put_u32(uint8_t* at, uint32_t value);
uint32_t get_u16(const uint8_t* at);
uint32_t get_u32(const uint8_t* at);

/// CRC-32, reflected 0xedb88320, bit by bit.
uint32_t crc32(uint32_t crc, Span<const uint8_t> bytes);

/// Makes both checksums of a font right again, as far as its header still says
/// where they belong. False if it does not.
bool repair_checksums(Span<uint8_t> font);

/// The signed distance of a shape at a point, positive inside. [u, Q6]
using Shape = int32_t (*)(int32_t x_u, int32_t y_u);

/// A disc about (384, 384) with radius 300.
int32_t disc(int32_t x_u, int32_t y_u);
/// The same centre, from 140 to 260 away.
int32_t ring(int32_t x_u, int32_t y_u);
/// The rectangle 200..440 x 0..640, whose sides lie on no cell border.
int32_t bar(int32_t x_u, int32_t y_u);

/// A glyph record being put together.
struct Record {
  static constexpr uint32_t kMaxReferences = 288;
  static constexpr uint32_t kMaxCells = 128;

  uint8_t tile_log2 = 8;
  int16_t x0_u = -128;
  int16_t y0_u = -128;
  uint8_t tiles_x = 4;
  uint8_t tiles_y = 4;
  uint32_t reference_count = 16;  // tiles, then four a node
  uint32_t cell_count = 0;
  uint16_t references[kMaxReferences] = {};
  uint8_t cells[kMaxCells][inkcell::format::samples::kBytes] = {};

  /// Makes it as it was at the beginning.
  void reset();
  uint32_t node_count() const {
    return (reference_count - uint32_t{tiles_x} * tiles_y) / 4;
  }
  /// Four children outside; returns the reference to it.
  uint16_t add_node();
  /// Where child `child` of the node is kept.
  uint16_t& child(uint16_t node, uint32_t child);
  /// A cell of nine distances (d1 to d9, d5 the centre) in Q6 u.
  uint16_t add_cell(const int32_t (&distances_q6)[9], uint32_t size_log2);
  /// A cell as it is: centre and eight offsets.
  uint16_t add_raw_cell(int32_t centre_q6, const int8_t (&offsets)[8]);

  /// Fills the tiles with a shape in cells of 64 u, saturated 48 u away from
  /// the edge.
  void fill(Shape shape);

  size_t size() const;
  /// Writes size() bytes.
  void write(uint8_t* at) const;

 private:
  uint16_t square(Shape shape, int32_t x_u, int32_t y_u, uint32_t log2);
};

struct CmapEntry {
  uint32_t first;
  uint16_t extra;
  uint16_t first_glyph;
};

struct GlyphSpec {
  uint16_t advance;
  int16_t box[4];  // x_min, y_min, x_max, y_max
  Shape shape;     // null: no ink, unless there is a record
  const Record* record;
  Span<const uint8_t> bytes = {};  // a record as it is
};

struct KerningSpec {
  uint16_t left_classes = 0;  // 0: no kerning section
  uint16_t right_classes = 0;
  Span<const uint16_t> left;  // class of each glyph
  Span<const uint16_t> right;
  Span<const int16_t> values;
};

/// How outlines are read; see outline_record.hpp. No code: fields.
struct OutlineSpec {
  Span<const uint8_t> code;  // CODE as it is
  uint8_t code_bits = 0;
  int8_t grid_shift = 0;
  uint16_t max_points = 0;
};

struct FontSpec {
  uint16_t units_per_em = 1000;
  Span<const CmapEntry> cmap;
  Span<const GlyphSpec> glyphs;
  KerningSpec kerning;
  OutlineSpec outlines;
  Span<const uint8_t> code_pages;  // CPAG as it is; empty: none
  Span<const uint8_t> hints;       // GRID, likewise
  Span<const uint8_t> morphs;      // MORP, likewise
  const char* name = "";
  uint32_t extra_section = 0;  // tag of an empty section; 0: none
  uint32_t extra_flags = 0;
};

/// Writes the font into `out`; the bytes of the font, 0 if it does not fit.
size_t build_font(const FontSpec& spec, Span<uint8_t> out);

/// The usual font: .notdef (bar), space, A (disc), B (ring), C (bar), and
/// U+1F600 as B; 1000 units to the em; kerning A B -100, B A -50, B C 25.
inline constexpr size_t kSampleFontBytes = 5120;
size_t build_sample_font(Span<uint8_t> out);

}  // namespace font_builder
