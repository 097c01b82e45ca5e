// Fonts of outlines made by hand: points to bits, with a code table of its own.
//
//   constexpr OutlinePoint kBar[] = {
//       {start, 200, 0}, {corner, 440, 0}, {corner, 440, 640}, ...};
//   const OutlineSource kGlyphs[] = {{625, {kBar, 4}}, ...};
//   const size_t size = build_outline_font({kGlyphs, n}, 0, 'A', out);
//
// Independent of the generator and of the reader but for format.hpp; nothing
// allocates.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "font_builder.hpp"
#include "inkcell/format/rom.hpp"
#include "inkcell/span.hpp"

namespace outline_record {

using inkcell::Span;

/// Kinds as in the code table; a contour goes from a `start` to the next.
enum Kind : uint8_t { off = 0, smooth = 1, corner = 2, start = 3 };

/// In grid units, y up. Filled areas lie to the left of contours. The closing
/// edge and points half-way between two off the curve are left out.
struct OutlinePoint {
  Kind kind;
  int16_t x;
  int16_t y;
};

/// Writes bits from the highest of a byte to its lowest; counts what does not
/// fit.
class BitWriter {
 public:
  explicit BitWriter(Span<uint8_t> out) : out_(out) {
    for (uint8_t& byte : out_) {
      byte = 0;
    }
  }
  void put(uint32_t value, uint32_t count) {
    for (uint32_t bit = count; bit-- != 0; ++at_) {
      if (at_ / 8 < out_.size && (value >> bit & 1) != 0) {
        out_[at_ / 8] |= static_cast<uint8_t>(0x80 >> at_ % 8);
      }
    }
  }
  size_t bytes() const { return (at_ + 7) / 8; }
  uint32_t bits() const { return at_; }

 private:
  Span<uint8_t> out_;
  uint32_t at_ = 0;
};

/// A code word, left-aligned in kCodeBits.
struct Word {
  uint8_t bits;
  uint8_t length;
  uint8_t kind;  // 3: end of the contour
  uint8_t x_bits;
  uint8_t y_bits;
};

inline constexpr uint32_t kCodeBits = 4;

/// Narrow steps first: of several words the first that holds a step is taken.
inline constexpr Word kWords[] = {{0x0, 2, 2, 8, 8},   {0x4, 3, 0, 8, 8},
                                  {0x6, 3, 1, 8, 8},   {0x8, 3, 3, 0, 0},
                                  {0xa, 4, 2, 13, 0},  {0xb, 4, 2, 0, 13},
                                  {0xc, 4, 0, 13, 13}, {0xd, 4, 1, 13, 13},
                                  {0xe, 4, 2, 13, 13}, {0xf, 4, 2, 15, 15}};
inline constexpr const Word& kEndWord = kWords[3];

inline void write_code(uint8_t (&out)[2 << kCodeBits]) {
  namespace word = inkcell::format::outline;
  for (const Word& w : kWords) {
    const uint32_t entry = w.length | uint32_t{w.kind} << word::kKindShift |
                           uint32_t{w.x_bits} << word::kXBitsShift |
                           uint32_t{w.y_bits} << word::kYBitsShift;
    for (uint32_t i = 0; i < 1u << (kCodeBits - w.length); ++i) {
      font_builder::put_u16(out + 2 * (w.bits + i), entry);
    }
  }
}

/// Whether a step is held by so many bits of two's complement.
inline bool holds(uint32_t bits, int32_t step) {
  const int32_t limit = bits == 0 ? 0 : 1 << (bits - 1);
  return bits == 0 ? step == 0 : step >= -limit && step < limit;
}

inline void put_step(Kind kind, int32_t dx, int32_t dy, BitWriter& out) {
  for (const Word& word : kWords) {
    if (word.kind == (kind == start ? corner : kind) && &word != &kEndWord &&
        holds(word.x_bits, dx) && holds(word.y_bits, dy)) {
      out.put(uint32_t{word.bits} >> (kCodeBits - word.length), word.length);
      out.put(static_cast<uint32_t>(dx), word.x_bits);
      out.put(static_cast<uint32_t>(dy), word.y_bits);
      return;
    }
  }
}

/// In grid units: of all points, also of those off the curve.
struct PointBox {
  int32_t x_min;
  int32_t y_min;
  int32_t x_max;
  int32_t y_max;
};

inline PointBox box_of(Span<const OutlinePoint> points) {
  if (points.size == 0) {
    return {0, 0, 0, 0};
  }
  PointBox box = {INT16_MAX, INT16_MAX, INT16_MIN, INT16_MIN};
  for (const OutlinePoint& at : points) {
    box.x_min = at.x < box.x_min ? at.x : box.x_min;
    box.y_min = at.y < box.y_min ? at.y : box.y_min;
    box.x_max = at.x > box.x_max ? at.x : box.x_max;
    box.y_max = at.y > box.y_max ? at.y : box.y_max;
  }
  return box;
}

/// Points of a record as the header counts them: one more a contour.
inline uint32_t count_of(Span<const OutlinePoint> points) {
  uint32_t count = 0;
  for (const OutlinePoint& at : points) {
    count += at.kind == start ? 2 : 1;
  }
  return count;
}

/// Writes the record of an outline that begins at the lower left corner of its
/// box.
inline void put_outline(Span<const OutlinePoint> points, BitWriter& bits) {
  if (points.size == 0) {
    return;
  }
  const PointBox box = box_of(points);
  int32_t x = box.x_min;
  int32_t y = box.y_min;
  bits.put(1, 1);
  for (size_t i = 0; i < points.size; ++i) {
    const OutlinePoint& at = points[i];
    if (at.kind == start && i != 0) {
      bits.put(uint32_t{kEndWord.bits} >> (kCodeBits - kEndWord.length),
               kEndWord.length);
      bits.put(1, 1);
    }
    put_step(at.kind, at.x - x, at.y - y, bits);
    x = at.x;
    y = at.y;
  }
  bits.put(uint32_t{kEndWord.bits} >> (kCodeBits - kEndWord.length),
           kEndWord.length);
  bits.put(0, 1);
}

/// The record's bytes, also if there is no room.
inline size_t write_outline(Span<const OutlinePoint> points,
                            Span<uint8_t> out) {
  BitWriter bits(out);
  put_outline(points, bits);
  return bits.bytes();
}

/// A part of a composite glyph. [font units; matrix Q14: x' = xx x + xy y + dx]
struct Component {
  uint16_t glyph;
  int16_t dx;
  int16_t dy;
  bool has_matrix = false;
  int16_t matrix[4] = {};  // xx, xy, yx, yy
};

inline void put_composite(Span<const Component> components, BitWriter& bits) {
  bits.put(inkcell::format::composite::kType, 8);
  for (size_t i = 0; i < components.size; ++i) {
    const Component& part = components[i];
    bits.put(part.glyph, 16);
    bits.put(part.has_matrix ? 1 : 0, 1);
    bits.put(15, 4);
    bits.put(static_cast<uint32_t>(part.dx), 15);
    bits.put(static_cast<uint32_t>(part.dy), 15);
    if (part.has_matrix) {
      for (const int16_t entry : part.matrix) {
        bits.put(static_cast<uint32_t>(entry), 16);
      }
    }
    bits.put(i + 1 < components.size ? 1 : 0, 1);
  }
}

inline size_t write_composite(Span<const Component> components,
                              Span<uint8_t> out) {
  BitWriter bits(out);
  put_composite(components, bits);
  return bits.bytes();
}

/// The hints of a glyph; the first bit is the lowest of the first byte.
struct HintBits {
  const uint8_t* bytes;
  uint32_t count;
};

/// Section GRID, and the hints of glyphs from glyph 0 on.
struct Hints {
  Span<const uint8_t> section = {};
  Span<const HintBits> glyphs = {};
};

/// Puts hints at the end of a record of `record_bits` bits, whose bytes are
/// `out` and zeros. The bytes of both.
inline size_t add_hints(const HintBits& hints,
                        uint32_t record_bits,
                        Span<uint8_t> out) {
  const size_t size = (record_bits + hints.count + 7) / 8;
  for (size_t i = 0; i < (hints.count + 7) / 8 && size <= out.size; ++i) {
    out[size - 1 - i] |= hints.bytes[i];
  }
  return size;
}

/// A glyph to be made. Points, or components and the box around them.
struct OutlineSource {
  uint16_t advance = 0;  // [font units]
  Span<const OutlinePoint> points = {};
  Span<const Component> components = {};
  int16_t box[4] = {};  // of components
};

/// Font units around grid units.
inline void set_box(const PointBox& box,
                    int32_t grid_shift,
                    int16_t (&out)[4]) {
  const int32_t sides[] = {box.x_min, box.y_min, -box.x_max, -box.y_max};
  for (uint32_t i = 0; i < 4; ++i) {
    const int32_t side = grid_shift >= 0 ? sides[i] * (1 << grid_shift)
                                         : sides[i] >> -grid_shift;
    out[i] = static_cast<int16_t>(i < 2 ? side : -side);
  }
}

inline constexpr size_t kMaxGlyphs = 16;
inline constexpr size_t kMaxRecordBytes = 2048;  // of all glyphs

/// A font of 1024 units to the em. Glyph 0 is .notdef; `first` is the code
/// point of glyph 1, and others follow. The bytes of the font, 0 if it does not
/// fit.
inline size_t build_outline_font(Span<const OutlineSource> glyphs,
                                 int8_t grid_shift,
                                 uint32_t first,
                                 Span<uint8_t> out,
                                 const Hints& hints = {},
                                 Span<const uint8_t> morphs = {}) {
  static uint8_t records[kMaxRecordBytes];
  static font_builder::GlyphSpec specs[kMaxGlyphs];
  static uint8_t code[2 << kCodeBits];
  if (glyphs.size < 2 || glyphs.size > kMaxGlyphs) {
    return 0;
  }
  size_t used = 0;
  uint32_t most = 0;
  for (size_t i = 0; i < glyphs.size; ++i) {
    const OutlineSource& glyph = glyphs[i];
    font_builder::GlyphSpec& spec = specs[i];
    const Span<uint8_t> room = {records + used, kMaxRecordBytes - used};
    BitWriter bits(room);
    spec = {};
    spec.advance = glyph.advance;
    if (glyph.components.size != 0) {
      put_composite(glyph.components, bits);
      for (uint32_t side = 0; side < 4; ++side) {
        spec.box[side] = glyph.box[side];
      }
    } else {
      put_outline(glyph.points, bits);
      set_box(box_of(glyph.points), grid_shift, spec.box);
    }
    size_t size = bits.bytes();
    if (size != 0 && i < hints.glyphs.size) {
      size = add_hints(hints.glyphs[i], bits.bits(), room);
    }
    if (size > room.size) {
      return 0;
    }
    spec.bytes = {room.data, size};
    used += size;
    uint32_t count = count_of(glyph.points);
    for (const Component& part : glyph.components) {
      count +=
          part.glyph < glyphs.size ? count_of(glyphs[part.glyph].points) : 0;
    }
    most = count > most ? count : most;
  }
  write_code(code);
  const font_builder::CmapEntry cmap[] = {
      {first, static_cast<uint16_t>(glyphs.size - 2), 1}};
  font_builder::FontSpec spec;
  spec.units_per_em = 1024;
  spec.cmap = {cmap, 1};
  spec.hints = hints.section;
  spec.morphs = morphs;
  spec.glyphs = {specs, glyphs.size};
  spec.outlines = {
      {code, sizeof(code)}, kCodeBits, grid_shift, static_cast<uint16_t>(most)};
  return font_builder::build_font(spec, out);
}

// The glyphs of the font below, in 1/1024 em.
inline constexpr OutlinePoint kBar[] = {
    {start, 200, 0}, {corner, 440, 0}, {corner, 440, 640}, {corner, 200, 640}};
/// A disc about (384, 384) with radius 300, within 2/1024 em.
inline constexpr OutlinePoint kDisc[] = {
    {start, 684, 384}, {off, 684, 508}, {off, 596, 596}, {off, 508, 684},
    {off, 260, 684},   {off, 172, 596}, {off, 84, 508},  {off, 84, 260},
    {off, 172, 172},   {off, 260, 84},  {off, 508, 84},  {off, 596, 172},
    {off, 684, 260}};
/// The letter L, a stem and a foot of 96.
inline constexpr OutlinePoint kEll[] = {{start, 100, 0},    {corner, 560, 0},
                                        {corner, 560, 96},  {corner, 196, 96},
                                        {corner, 196, 740}, {corner, 100, 740}};
/// A square with a square hole, and a hairline of 12 that leans beside it.
inline constexpr OutlinePoint kFrame[] = {
    {start, 60, 60},    {corner, 460, 60},  {corner, 460, 460},
    {corner, 60, 460},  {start, 160, 160},  {corner, 160, 360},
    {corner, 360, 360}, {corner, 360, 160}, {start, 540, 0},
    {corner, 552, 0},   {corner, 812, 700}, {corner, 800, 700}};
/// A leaf: two curves and two corners.
inline constexpr OutlinePoint kLeaf[] = {
    {start, 80, 80}, {off, 640, 40}, {corner, 700, 700}, {off, 100, 660}};

/// .notdef (bar), A disc, B bar, C L, D frame, E leaf, F (the disc and half
/// the leaf, turned), G without ink.
inline constexpr size_t kSampleFontBytes = 1024;

inline size_t build_sample_font(Span<uint8_t> out, const Hints& hints = {}) {
  static constexpr Component kParts[] = {
      {1, 0, 0}, {5, 1100, 300, true, {0, -8192, 8192, 0}}};
  static const OutlineSource kGlyphs[] = {
      {600, {kBar, 4}},
      {768, {kDisc, 13}},
      {600, {kBar, 4}},
      {600, {kEll, 6}},
      {860, {kFrame, 12}},
      {768, {kLeaf, 4}},
      {1300, {}, {kParts, 2}, {84, 84, 1060, 684}},
      {300}};
  return build_outline_font({kGlyphs, 8}, 0, 'A', out, hints);
}

}  // namespace outline_record
