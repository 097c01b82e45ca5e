// Reads records bit by bit, with the limits that docs/FORMAT.md states.
#include "outline_points.hpp"

#include <algorithm>
#include <cmath>

#include "bit_reader.hpp"
#include "bytes.hpp"
#include "inkcell/format/rom.hpp"

namespace inkcell::tools {
namespace {

// An entry of section CODE.
struct Code {
  int length;
  uint32_t kind;
  int x_bits;
  int y_bits;
  size_t table_change;
};

Code code_at(Span<const uint8_t> table, size_t index) {
  namespace word = format::outline;
  const uint32_t entry = read_u16(table.data + 2 * index);
  return {std::max(1, static_cast<int>(entry & word::kLengthMask)),
          entry >> word::kKindShift & word::kKindMask,
          static_cast<int>(entry >> word::kXBitsShift & word::kWidthMask),
          static_cast<int>(entry >> word::kYBitsShift & word::kWidthMask),
          entry >> word::kTableShift};
}

int code_bits(const Font& font) {
  return font.rom().data[format::header::kCodeBits];
}

// 1, 2, 4 or 8.
size_t table_count(Span<const uint8_t> table, int bits) {
  size_t count = 1;
  while (2 * count <= format::outline::kMaxTables &&
         (4 * count) << bits <= table.size) {
    count *= 2;
  }
  return count;
}

// The entries from `index` on that are one word: those that begin with its
// bits, or with one bit more if they tell a number.
size_t word_entries(Span<const uint8_t> table, int bits, size_t index) {
  const Code code = code_at(table, index);
  const size_t all = size_t{1} << std::max(bits - code.length, 0);
  const auto entry = [&table](size_t i) {
    return read_u16(table.data + 2 * i);
  };
  for (size_t i = 1; i < all; ++i) {
    if (entry(index + i) != entry(index)) {
      return all / 2;
    }
  }
  return index % all == 0 ? all : all / 2;
}

// The index of the word that entry `index` belongs to.
size_t word_number(Span<const uint8_t> table, int bits, size_t index) {
  size_t number = 0;
  for (size_t i = 0; i < index;) {
    i += std::max(word_entries(table, bits, i), size_t{1});
    number += i <= index ? 1 : 0;
  }
  return number;
}

void read_simple(const Font& font, uint16_t glyph, GlyphOutline& out) {
  const Span<const uint8_t> table = font.section(format::section::kCode);
  const int bits = code_bits(font);
  const double grid = grid_units(font);
  GlyphMetrics metrics;
  static_cast<void>(font.glyph_metrics(glyph, metrics));
  double x = std::floor(metrics.x_min / grid);
  double y = std::floor(metrics.y_min / grid);
  const size_t last_table = table_count(table, bits) - 1;
  size_t at_table = 0;
  BitReader record(font.record(glyph), 1);
  out.uses.resize(code_words(font).size());
  out.contours.emplace_back();
  for (int points = 0; points < max_points(font); ++points) {
    const size_t index = (at_table << bits) + record.peek(bits);
    const Code code = code_at(table, index);
    record.read(code.length);
    at_table ^= code.table_change & last_table;
    const size_t number = word_number(table, bits, index);
    if (number < out.uses.size()) {
      ++out.uses[number];
    }
    if (code.kind != format::outline::kEndOfContour) {
      x += record.read_signed(code.x_bits);
      y += record.read_signed(code.y_bits);
      out.contours.back().push_back(
          {x * grid, y * grid, static_cast<PointKind>(code.kind)});
      continue;
    }
    if (record.read(1) == 0) {
      return;
    }
    out.contours.emplace_back();
  }
}

bool is_composite(Span<const uint8_t> record) {
  return record.size > 0 && record.data[0] == format::composite::kType;
}

OutlineComponent read_component(BitReader& record) {
  constexpr double kQ14 = 16384;
  OutlineComponent component;
  component.glyph = static_cast<uint16_t>(record.read(16));
  const bool has_matrix = record.read(1) != 0;
  const auto width = static_cast<int>(record.read(4));
  component.dx = record.read_signed(width);
  component.dy = record.read_signed(width);
  if (has_matrix) {
    component.xx = record.read_signed(16) / kQ14;
    component.xy = record.read_signed(16) / kQ14;
    component.yx = record.read_signed(16) / kQ14;
    component.yy = record.read_signed(16) / kQ14;
  }
  return component;
}

void add_component(const Font& font,
                   const OutlineComponent& part,
                   GlyphOutline& out) {
  out.components.push_back(part);
  const Span<const uint8_t> record = font.record(part.glyph);
  if (record.size == 0 || is_composite(record)) {
    return;  // the format forbids composites of composites
  }
  GlyphOutline simple;
  read_simple(font, part.glyph, simple);
  for (OutlineContour& contour : simple.contours) {
    for (OutlinePoint& p : contour) {
      p = {part.xx * p.x + part.xy * p.y + part.dx,
           part.yx * p.x + part.yy * p.y + part.dy, p.kind};
    }
    out.contours.push_back(contour);
  }
}

}  // namespace

int GlyphOutline::points() const {
  size_t count = 0;
  for (const OutlineContour& contour : contours) {
    count += contour.size();
  }
  return static_cast<int>(count);
}

int GlyphOutline::points_of(PointKind kind) const {
  int count = 0;
  for (const OutlineContour& contour : contours) {
    count += static_cast<int>(std::count_if(
        contour.begin(), contour.end(),
        [kind](const OutlinePoint& point) { return point.kind == kind; }));
  }
  return count;
}

std::vector<CodeWord> code_words(const Font& font) {
  std::vector<CodeWord> words;
  if (!font.has_outlines()) {
    return words;
  }
  const Span<const uint8_t> table = font.section(format::section::kCode);
  const int bits = code_bits(font);
  const size_t tables = table_count(table, bits);
  for (size_t i = 0; i < tables << bits;) {
    const Code code = code_at(table, i);
    const size_t entries = std::max(word_entries(table, bits, i), size_t{1});
    CodeWord word;
    word.table = static_cast<int>(i >> bits);
    for (size_t bit = size_t{1} << bits >> 1; bit >= entries; bit >>= 1) {
      word.bits += (i & bit) != 0 ? '1' : '0';
    }
    word.is_end = code.kind == format::outline::kEndOfContour;
    word.kind =
        word.is_end ? PointKind::corner : static_cast<PointKind>(code.kind);
    word.x_bits = code.x_bits;
    word.y_bits = code.y_bits;
    word.next_table =
        static_cast<int>((i >> bits) ^ (code.table_change & (tables - 1)));
    words.push_back(word);
    i += entries;
  }
  return words;
}

double grid_units(const Font& font) {
  return std::ldexp(
      1.0, static_cast<int8_t>(font.rom().data[format::header::kGridShift]));
}

int max_points(const Font& font) {
  return static_cast<int>(
      read_u16(font.rom().data + format::header::kMaxPoints));
}

GlyphOutline glyph_outline(const Font& font, uint16_t glyph) {
  GlyphOutline outline;
  const Span<const uint8_t> record = font.record(glyph);
  if (!font.has_outlines() || record.size == 0) {
    return outline;
  }
  if (!is_composite(record)) {
    read_simple(font, glyph, outline);
    return outline;
  }
  BitReader bits(record, 8 * format::composite::kTypeBytes);
  do {
    add_component(font, read_component(bits), outline);
  } while (bits.read(1) != 0 && !bits.is_at_end());
  return outline;
}

const char* kind_name(PointKind kind) {
  return kind == PointKind::off_curve ? "off curve"
         : kind == PointKind::smooth  ? "smooth"
                                      : "corner";
}

}  // namespace inkcell::tools
