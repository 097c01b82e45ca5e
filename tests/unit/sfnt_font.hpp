// A small TrueType file for tests, made without a heap.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "inkcell/span.hpp"

namespace sfnt_font {

using inkcell::Span;

struct Point {
  int32_t x;
  int32_t y;
  bool on;
  bool last = false;  // of its contour
};

struct Part {
  uint16_t glyph;
  int32_t dx;
  int32_t dy;
  int32_t matrix_q14[4] = {1 << 14, 0, 0, 1 << 14};  // xx, yx, xy, yy
};

struct Glyph {
  uint16_t advance = 600;
  Span<const Point> points = {};
  Span<const Part> parts = {};
};

struct Pair {
  uint16_t left;
  uint16_t right;
  int16_t value;
};

struct Options {
  int32_t cmap_format = 4;  // 0, 4, 6, 12
  bool is_long = true;      // loca
  bool has_kern = true;
  int32_t gpos_format = 0;  // 1: glyphs, 2: classes; 0: no GPOS
  bool is_extension = false;
  bool is_glyf_last = false;  // and ends without padding
};

/// Writes big-endian numbers.
class Writer {
 public:
  explicit Writer(Span<uint8_t> out) : out_(out) {}
  size_t at() const { return at_; }
  void u8(uint32_t value) {
    if (at_ < out_.size) {
      out_[at_] = static_cast<uint8_t>(value);
    }
    ++at_;
  }
  void u16(uint32_t value) {
    u8(value >> 8);
    u8(value);
  }
  void i16(int32_t value) { u16(static_cast<uint32_t>(value)); }
  void u32(uint32_t value) {
    u16(value >> 16);
    u16(value);
  }
  template <typename... Values>
  void u16s(Values... values) {
    (u16(static_cast<uint32_t>(values)), ...);
  }
  void zeros(size_t count) {
    for (; count != 0; --count) {
      u8(0);
    }
  }
  void pad(size_t unit) { zeros((unit - at_ % unit) % unit); }
  void set_u16(size_t at, uint32_t value) {
    const size_t end = at_;
    at_ = at;
    u16(value);
    at_ = end;
  }
  void set_u32(size_t at, uint32_t value) {
    set_u16(at, value >> 16);
    set_u16(at + 2, value);
  }

 private:
  Span<uint8_t> out_;
  size_t at_ = 0;
};

// The sample: 1,000 units to the em; glyphs are squares, so that pixels of 10
// to the em hold all or nothing, and rings.
inline constexpr Point kBox[] = {
    {100, 0, true}, {100, 700, true}, {500, 700, true}, {500, 0, true, true}};
// A ring: a square with a hole that runs the other way round.
inline constexpr Point kRing[] = {{0, 0, true},     {0, 600, true},
                                  {600, 600, true}, {600, 0, true, true},
                                  {200, 200, true}, {400, 200, true},
                                  {400, 400, true}, {200, 400, true, true}};
// Two squares over each other.
inline constexpr Point kPile[] = {{0, 0, true},     {0, 400, true},
                                  {400, 400, true}, {400, 0, true, true},
                                  {200, 200, true}, {200, 600, true},
                                  {600, 600, true}, {600, 200, true, true}};
// A square of the wrong direction.
inline constexpr Point kReversed[] = {
    {0, 0, true}, {400, 0, true}, {400, 400, true}, {0, 400, true, true}};
// A round contour without points on it, and one that ends with a curve.
inline constexpr Point kRound[] = {
    {0, 0, false}, {0, 800, false}, {800, 800, false}, {800, 0, false, true}};
inline constexpr Point kHalfRound[] = {
    {400, 0, false}, {0, 0, true}, {0, 400, true}, {400, 400, false, true}};

inline constexpr Part kMoved[] = {{4, 100, 200}, {5, 0, 0}};
inline constexpr Part kHalved[] = {{3, 0, 0, {1 << 13, 0, 0, 1 << 13}},
                                   {2, 300, 0, {0, 1 << 14, -(1 << 14), 0}}};
inline constexpr Part kNested[] = {{9, 100, 0}};
inline constexpr Part kDeeper[] = {{10, 0, 100}, {2, 0, 0}};
inline constexpr Part kDeepest[] = {{11, 0, 0}, {5, 100, 100}};
inline constexpr Part kEndless[] = {{13, 1, 1}, {13, 2, 2}};

inline constexpr Glyph kGlyphs[] = {
    {500, kBox},          // 0: .notdef
    {300},                // 1: space
    {600, kBox},          // 2: A
    {700, kRing},         // 3: B
    {700, kPile},         // 4: C
    {500, kReversed},     // 5: D
    {800, kRound},        // 6: E
    {500, kHalfRound},    // 7: F
    {700, {}, kMoved},    // 8: G
    {700, {}, kHalved},   // 9: H
    {700, {}, kNested},   // 10: I
    {700, {}, kDeeper},   // 11: J
    {700, {}, kDeepest},  // 12: K
    {700, {}, kEndless},  // 13: L, made of itself
};
inline constexpr uint32_t kGlyphCount = sizeof kGlyphs / sizeof kGlyphs[0];

// 'A' + i is glyph 2 + i; of one more code point beyond 16 bits in format 12.
inline constexpr uint32_t kLetters = kGlyphCount - 2;

inline constexpr Pair kPairs[] = {{2, 3, -40}, {2, 4, -70}, {3, 2, 25}};
inline constexpr uint32_t kPairCount = sizeof kPairs / sizeof kPairs[0];

inline uint32_t tag_of(const char* text) {
  uint32_t tag = 0;
  for (int32_t i = 0; i != 4; ++i) {
    tag = tag << 8 | static_cast<uint8_t>(text[i]);
  }
  return tag;
}

inline void write_box(Writer& out, Span<const Point> points) {
  Point low = points[0];
  Point high = points[0];
  for (const Point& at : points) {
    low.x = at.x < low.x ? at.x : low.x;
    low.y = at.y < low.y ? at.y : low.y;
    high.x = at.x > high.x ? at.x : high.x;
    high.y = at.y > high.y ? at.y : high.y;
  }
  out.u16s(low.x, low.y, high.x, high.y);
}

// A step of a coordinate: its flags, as those of x, and its bytes.
struct Step {
  int32_t by;
  bool is_short() const { return by != 0 && by > -256 && by < 256; }
  uint32_t flags() const {
    return is_short() ? 2u | (by > 0 ? 16u : 0u) : by == 0 ? 16u : 0u;
  }
  void write(Writer& out) const {
    if (is_short()) {
      out.u8(static_cast<uint32_t>(by < 0 ? -by : by));
    } else if (by != 0) {
      out.i16(by);
    }
  }
};

inline void write_simple(Writer& out, Span<const Point> points) {
  uint32_t contours = 0;
  for (const Point& at : points) {
    contours += at.last ? 1 : 0;
  }
  out.u16(contours);
  write_box(out, points);
  for (size_t i = 0; i < points.size; ++i) {
    if (points[i].last) {
      out.u16(static_cast<uint32_t>(i));
    }
  }
  out.u16(3);  // instructions
  out.zeros(3);
  const auto step = [&points](size_t i, bool is_x) {
    const Point before = i == 0 ? Point{0, 0, true} : points[i - 1];
    return is_x ? Step{points[i].x - before.x} : Step{points[i].y - before.y};
  };
  const auto flag_of = [&](size_t i) {
    return (points[i].on ? 1u : 0u) | step(i, true).flags() |
           step(i, false).flags() << 1;
  };
  for (size_t i = 0; i < points.size;) {
    uint32_t repeats = 0;
    while (i + repeats + 1 < points.size &&
           flag_of(i + repeats + 1) == flag_of(i)) {
      ++repeats;
    }
    out.u8(flag_of(i) | (repeats != 0 ? 8u : 0u));
    if (repeats != 0) {
      out.u8(repeats);
    }
    i += repeats + 1;
  }
  constexpr bool kAxes[] = {true, false};
  for (const bool is_x : kAxes) {
    for (size_t i = 0; i < points.size; ++i) {
      step(i, is_x).write(out);
    }
  }
}

inline void write_composite(Writer& out, Span<const Part> parts) {
  out.i16(-1);
  out.u16s(-100, -100, 900, 900);
  for (size_t i = 0; i < parts.size; ++i) {
    const Part& part = parts[i];
    const int32_t(&m)[4] = part.matrix_q14;
    const bool is_word =
        part.dx < -128 || part.dx > 127 || part.dy < -128 || part.dy > 127;
    const bool has_matrix = m[1] != 0 || m[2] != 0;
    const bool has_scale = !has_matrix && m[0] != 1 << 14;
    out.u16(2u | (is_word ? 1u : 0u) | (has_scale ? 8u : 0u) |
            (has_matrix ? 128u : 0u) | (i + 1 != parts.size ? 32u : 0u));
    out.u16(part.glyph);
    if (is_word) {
      out.u16s(part.dx, part.dy);
    } else {
      out.u8(static_cast<uint32_t>(part.dx));
      out.u8(static_cast<uint32_t>(part.dy));
    }
    if (has_matrix) {
      out.u16s(m[0], m[1], m[2], m[3]);
    } else if (has_scale) {
      out.i16(m[0]);
    }
  }
}

inline void write_cmap(Writer& out, int32_t format) {
  const size_t begin = out.at();
  out.u16s(0, 1, format == 0 ? 1 : 3, format == 12 ? 10 : format == 0 ? 0 : 1);
  out.u32(12);
  out.u16(static_cast<uint32_t>(format));
  if (format == 0) {
    out.u16s(262, 0);
    for (uint32_t code = 0; code < 256; ++code) {
      out.u8(code == ' '                            ? 1
             : code >= 'A' && code - 'A' < kLetters ? code - 'A' + 2
                                                    : 0);
    }
  } else if (format == 6) {
    out.u16s(10 + 2 * kLetters, 0, 'A', kLetters);
    for (uint32_t i = 0; i < kLetters; ++i) {
      out.u16(2 + i);
    }
  } else if (format == 4) {
    // The letters by delta but for the last two, which are by array.
    const uint32_t split = 'A' + kLetters - 2;
    out.u16s(16 + 8 * 4 + 2 * 2, 0, 8, 8, 2, 0);
    out.u16s(' ', split - 1, split + 1, 0xffff, 0);
    out.u16s(' ', 'A', split, 0xffff);
    out.u16s(1 - ' ', 2 - 'A', 0, 1);
    out.u16s(0, 0, 4, 0);
    out.u16s(kGlyphCount - 2, kGlyphCount - 1);
  } else {
    out.u16(0);
    out.u32(16 + 12 * 3);
    out.u32(0);
    out.u32(3);
    const uint32_t groups[][3] = {
        {' ', ' ', 1}, {'A', 'A' + kLetters - 1, 2}, {0x1f600, 0x1f601, 6}};
    for (const auto& group : groups) {
      for (const uint32_t value : group) {
        out.u32(value);
      }
    }
  }
  static_cast<void>(begin);
}

inline void write_kern(Writer& out) {
  out.u16s(0, 1, 0, 14 + 6 * kPairCount, 1, kPairCount, 0, 0, 0);
  for (const Pair& pair : kPairs) {
    out.u16s(pair.left, pair.right, pair.value);
  }
}

// GPOS with a lookup of pairs for feature kern, by glyphs or by classes; values
// are twice those of `kern`.
inline void write_gpos(Writer& out, const Options& options) {
  out.u16s(1, 0, 10, 30, 44);
  // Script list: one script with a default language system.
  out.u16(1);
  out.u32(tag_of("latn"));
  out.u16s(8, 4, 0);          // script: default language, others
  out.u16s(0, 0xffff, 1, 0);  // lookups order, required, features
  // Feature list at 30.
  out.u16(1);
  out.u32(tag_of("kern"));
  out.u16s(8, 0, 1, 0);
  // Lookup list at 44: one lookup of one subtable.
  out.u16s(1, 4, options.is_extension ? 9 : 2, 0, 1, 8);
  if (options.is_extension) {
    out.u16s(1, 2);
    out.u32(8);
  }
  if (options.gpos_format == 1) {
    // Coverage behind the header and two sets.
    out.u16s(1, 32, 4, 0, 2, 14, 24);
    out.u16(2);  // of glyph 2
    for (uint32_t i = 0; i != 2; ++i) {
      out.u16s(kPairs[i].right, 2 * kPairs[i].value);
    }
    out.u16(1);  // of glyph 3
    out.u16s(kPairs[2].right, 2 * kPairs[2].value, 0);
    out.u16s(1, 2, 2, 3);
  } else {
    // Left classes: 2 is 1, 3 is 2, all else 0; right ones: 2 is 1, 3 is 2, 4
    // is 3. Two values a record: yAdvance must be passed over.
    const int32_t values[3][4] = {
        {0, 0, 0, 0},
        {0, 0, 2 * kPairs[0].value, 2 * kPairs[1].value},
        {0, 2 * kPairs[2].value, 0, 0}};
    out.u16s(2, 64, 5, 0, 74, 84, 3, 4);
    for (const auto& row : values) {
      for (const int32_t value : row) {
        out.u16s(7, value);
      }
    }
    out.u16s(2, 1, 2, 13, 0);                   // coverage by a range
    out.u16s(1, 2, 2, 1, 2);                    // classes by an array
    out.u16s(2, 3, 2, 2, 1, 3, 3, 2, 4, 4, 3);  // and by ranges
  }
}

/// Returns the bytes that it takes; more than `bytes` has: nothing is complete.
inline size_t build(Span<uint8_t> bytes, const Options& options) {
  Writer out(bytes);
  constexpr uint32_t kTables = 10;
  out.u32(0x10000);
  out.u16s(kTables, 0, 0, 0);
  size_t entry = out.at();
  out.zeros(16 * kTables);
  size_t begin = 0;
  const auto begin_table = [&](const char* tag) {
    out.pad(4);
    begin = out.at();
    out.set_u32(entry, tag_of(tag));
    out.set_u32(entry + 8, static_cast<uint32_t>(begin));
  };
  const auto end_table = [&] {
    out.set_u32(entry + 12, static_cast<uint32_t>(out.at() - begin));
    entry += 16;
  };
  size_t offsets[kGlyphCount + 1] = {};
  const auto write_glyf = [&] {
    begin_table("glyf");
    for (uint32_t i = 0; i != kGlyphCount; ++i) {
      const Glyph& glyph = kGlyphs[i];
      offsets[i] = out.at() - begin;
      if (glyph.points.size != 0) {
        write_simple(out, glyph.points);
      } else if (glyph.parts.size != 0) {
        write_composite(out, glyph.parts);
      }
      if (!options.is_glyf_last || i + 1 != kGlyphCount) {
        out.pad(2);
      }
    }
    offsets[kGlyphCount] = out.at() - begin;
    end_table();
  };
  if (!options.is_glyf_last) {
    write_glyf();
  }
  begin_table("head");
  out.zeros(18);
  out.u16(1000);
  out.zeros(16);
  out.u16s(-100, -100, 900, 900, 0, 6, 2, options.is_long ? 1 : 0, 0);
  end_table();
  begin_table("maxp");
  out.u32(0x10000);
  out.u16(kGlyphCount);
  out.zeros(26);
  end_table();
  // The last two glyphs share an advance.
  begin_table("hhea");
  out.u32(0x10000);
  out.u16s(800, -200, 90);
  out.zeros(24);
  out.u16(kGlyphCount - 1);
  end_table();
  begin_table("hmtx");
  for (uint32_t i = 0; i != kGlyphCount; ++i) {
    const Glyph& glyph = kGlyphs[i];
    if (i + 1 != kGlyphCount) {
      out.u16(glyph.advance);
    }
    out.i16(glyph.parts.size != 0    ? -100
            : glyph.points.size != 0 ? (glyph.points.data == kBox ? 100 : 0)
                                     : 0);
  }
  end_table();
  begin_table("OS/2");
  out.u16(2);
  out.zeros(66);
  out.u16s(750, -250, 0, 800, 200);
  out.zeros(8);
  out.u16s(480, 700, 0, 0x20, 1);
  end_table();
  begin_table("cmap");
  write_cmap(out, options.cmap_format);
  end_table();
  if (options.has_kern) {
    begin_table("kern");
    write_kern(out);
    end_table();
  }
  if (options.gpos_format != 0) {
    begin_table("GPOS");
    write_gpos(out, options);
    end_table();
  }
  const auto write_loca = [&] {
    begin_table("loca");
    for (const size_t offset : offsets) {
      if (options.is_long) {
        out.u32(static_cast<uint32_t>(offset));
      } else {
        out.u16(static_cast<uint32_t>(offset / 2));
      }
    }
    end_table();
  };
  if (options.is_glyf_last) {
    // Room for it, then once more with offsets.
    const Writer before = out;
    const size_t entry_before = entry;
    write_loca();
    write_glyf();
    const Writer after = out;
    const size_t entry_after = entry;
    out = before;
    entry = entry_before;
    write_loca();
    out = after;
    entry = entry_after;
  } else {
    write_loca();
    out.pad(4);
  }
  return out.at();
}

}  // namespace sfnt_font
