// Glyph records of cells of primitives, made by hand, and what they mean in
// double.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "font_builder.hpp"
#include "inkcell/field.hpp"
#include "inkcell/format/cell.hpp"
#include "inkcell/format/rom.hpp"
#include "random.hpp"

/// A record being put together. Fields are numbered arcs first, and references
/// as in the narrow form. The linked form has the same nodes in the same place.
struct FieldRecord {
  struct Field {
    int32_t nx;  // Q14
    int32_t ny;
    int32_t c;      // Q4 u
    int32_t along;  // Q4 u
    int32_t bend;   // 2^-19 / u
  };

  bool linked = false;
  uint8_t tile_log2 = 8;
  int16_t x0_u = 0;
  int16_t y0_u = 0;
  uint8_t tiles_x = 1;
  uint8_t tiles_y = 1;
  uint32_t node_count = 0;
  uint32_t arc_count = 0;
  uint32_t line_count = 0;
  uint32_t pair_count = 0;
  uint32_t triple_count = 0;
  Field fields[16] = {};
  uint16_t pairs[16][2] = {};
  uint16_t triples[16][4] = {};
  uint16_t references[64] = {};

  uint32_t reference_count() const {
    return uint32_t{tiles_x} * tiles_y + 4 * node_count;
  }
  uint16_t field_reference(uint32_t number) const {
    return static_cast<uint16_t>(inkcell::format::glyph::kFirstNode +
                                 node_count + number);
  }
  uint16_t pair_reference(uint32_t pair) const {
    return field_reference(arc_count + line_count + pair);
  }
  uint16_t triple_reference(uint32_t triple) const {
    return pair_reference(pair_count + triple);
  }

  /// What Cell::fields says of a field.
  uint16_t unit_of(uint32_t number) const {
    const uint32_t first = linked ? reference_count() : 0;
    const bool is_arc = number < arc_count;
    return static_cast<uint16_t>(
        first + 3 * number + 2 * (is_arc ? number : arc_count) +
        (is_arc ? inkcell::format::linked::kArcField : 0));
  }
  uint32_t number_of(uint16_t unit) const {
    uint32_t number = 0;
    while (number < arc_count + line_count && unit_of(number) != unit) {
      ++number;
    }
    return number;
  }

  uint32_t heap_units() const {
    return reference_count() + 5 * arc_count + 3 * line_count + 2 * pair_count +
           4 * triple_count;
  }
  size_t size() const {
    const uint32_t units =
        4 * triple_count + 2 * pair_count + reference_count();
    return linked ? 10 + 2 * heap_units()
                  : 18 + 10 * arc_count + 6 * line_count + units;
  }

  /// Writes size() bytes.
  void write(uint8_t* at) const {
    using font_builder::put_u16;
    at[0] = 2;
    at[1] = static_cast<uint8_t>(tile_log2 | (linked ? 0x80 : 0));
    put_u16(at + 2, static_cast<uint32_t>(x0_u));
    put_u16(at + 4, static_cast<uint32_t>(y0_u));
    at[6] = tiles_x;
    at[7] = tiles_y;
    if (linked) {
      put_u16(at + 8, heap_units());
      write_heap(at + 10);
      return;
    }
    const uint32_t counts[] = {node_count, arc_count, line_count, pair_count,
                               triple_count};
    at += 8;
    for (const uint32_t count : counts) {
      put_u16(at, count);
      at += 2;
    }
    at = put_fields(at);
    for (uint32_t i = 0; i < triple_count; ++i) {
      at = put_bytes(at, triples[i], 4);
    }
    for (uint32_t i = 0; i < pair_count; ++i) {
      at = put_bytes(at, pairs[i], 2);
    }
    put_bytes(at, references, reference_count());
  }

  /// Fills in everything: unit normals, edges within `spread_u` of the tiles'
  /// centre, curvature up to a radius of 100 u. Leaves and trees of all kinds.
  void make(Random& random, int32_t spread_u);

 private:
  uint8_t* put_fields(uint8_t* at) const {
    for (uint32_t i = 0; i < arc_count + line_count; ++i) {
      const Field& f = fields[i];
      const int32_t numbers[] = {f.nx, f.ny, f.c, f.along, f.bend};
      for (uint32_t j = 0; j < (i < arc_count ? 5u : 3u); ++j, at += 2) {
        font_builder::put_u16(at, static_cast<uint32_t>(numbers[j]));
      }
    }
    return at;
  }
  static uint8_t* put_bytes(uint8_t* at,
                            const uint16_t* units,
                            uint32_t count) {
    for (uint32_t i = 0; i < count; ++i) {
      *at++ = static_cast<uint8_t>(units[i]);
    }
    return at;
  }

  // A field that does not exist is one that leaves the heap.
  uint32_t heap_field(uint32_t number) const {
    return number < arc_count + line_count ? unit_of(number) : 0x1fff;
  }
  uint32_t heap_reference(uint32_t reference) const {
    const uint32_t tiles = uint32_t{tiles_x} * tiles_y;
    if (reference < 2) {
      return reference;
    }
    uint32_t number = reference - 2;
    if (number < node_count) {
      return 1 << 13 | (tiles + 4 * number);
    }
    number -= node_count;
    if (number < arc_count + line_count) {
      return (number < arc_count ? 3u : 2u) << 13 | (unit_of(number) & 0x1fffu);
    }
    number -= arc_count + line_count;
    uint32_t unit = reference_count() + 5 * arc_count + 3 * line_count;
    if (number < pair_count) {
      const bool is_greatest = pairs[number][0] > pairs[number][1];
      return (is_greatest ? 5u : 4u) << 13 | (unit + 2 * number);
    }
    number -= pair_count;
    unit += 2 * pair_count;
    // One that does not exist leaves the heap.
    return 6u << 13 | (number < triple_count ? unit + 4 * number : 0x1fff);
  }
  void write_heap(uint8_t* at) const {
    using font_builder::put_u16;
    for (uint32_t i = 0; i < reference_count(); ++i, at += 2) {
      put_u16(at, heap_reference(references[i]));
    }
    at = put_fields(at);
    for (uint32_t i = 0; i < pair_count; ++i) {
      for (int j = 0; j < 2; ++j, at += 2) {
        put_u16(at, heap_field(pairs[i][j]));
      }
    }
    for (uint32_t i = 0; i < triple_count; ++i) {
      put_u16(at, triples[i][0]);
      for (int j = 1; j < 4; ++j) {
        put_u16(at + 2 * j, heap_field(triples[i][j]));
      }
      at += 8;
    }
  }
};

inline FieldRecord::Field random_field(Random& random,
                                       double x_u,
                                       double y_u,
                                       int32_t spread_u) {
  const double t = random.between(-1000, 1000) / 1000.0;
  const double turn = (random.next() & 1) != 0 ? 16384 : -16384;
  FieldRecord::Field field = {};
  field.nx = static_cast<int32_t>(turn * (1 - t * t) / (1 + t * t));
  field.ny = static_cast<int32_t>(turn * 2 * t / (1 + t * t));
  if ((random.next() & 1) != 0) {
    const int32_t nx = field.nx;
    field.nx = -field.ny;
    field.ny = nx;
  }
  const double nx = field.nx / 16384.0;
  const double ny = field.ny / 16384.0;
  field.c = static_cast<int32_t>(
      16 * (random.between(-spread_u, spread_u) - nx * x_u - ny * y_u));
  field.along = static_cast<int32_t>(
      16 * (random.between(-spread_u, spread_u) - nx * y_u + ny * x_u));
  // 1 / (2 x 100 u) is 2621 2^-19 / u.
  field.bend = random.between(-2621, 2621);
  return field;
}

inline void FieldRecord::make(Random& random, int32_t spread_u) {
  const int32_t side_u = 1 << tile_log2;
  arc_count = random.below(5);
  line_count = 1 + random.below(5);
  pair_count = random.below(5);
  triple_count = random.below(9);
  const uint32_t field_count = arc_count + line_count;
  for (uint32_t i = 0; i < field_count; ++i) {
    fields[i] = random_field(random, x0_u + tiles_x * side_u / 2.0,
                             y0_u + tiles_y * side_u / 2.0, spread_u);
  }
  for (uint32_t i = 0; i < pair_count; ++i) {
    for (uint16_t& number : pairs[i]) {
      number = static_cast<uint16_t>(random.below(field_count));
    }
  }
  for (uint32_t i = 0; i < triple_count; ++i) {
    triples[i][0] = static_cast<uint16_t>(i % 4);
    for (uint32_t j = 1; j < 4; ++j) {
      triples[i][j] = static_cast<uint16_t>(random.below(field_count));
    }
  }
  // Node n + 1 is a child of node n, so that trees are deep.
  const uint32_t tiles = uint32_t{tiles_x} * tiles_y;
  node_count = tile_log2 < 5 ? 0 : random.below(5);
  const uint32_t leaves = field_count + pair_count + triple_count;
  for (uint32_t i = 0; i < reference_count(); ++i) {
    const uint32_t leaf = random.below(leaves + 2);
    references[i] = static_cast<uint16_t>(leaf < leaves ? field_reference(leaf)
                                                        : leaf - leaves);
  }
  for (uint32_t node = 0; node < node_count; ++node) {
    const uint32_t place = node == 0 ? random.below(tiles)
                                     : tiles + 4 * (node - 1) + random.below(4);
    references[place] =
        static_cast<uint16_t>(inkcell::format::glyph::kFirstNode + node);
  }
}

namespace field_equation {

inline double root(double value) {
  double result = value > 1 ? value : 1;
  for (int i = 0; i < 60; ++i) {
    result = (result + value / result) / 2;
  }
  return result;
}

/// A field at a point.
struct Value {
  double f;
  double gx;
  double gy;
};

inline Value value(const FieldRecord::Field& field,
                   bool is_arc,
                   double x_u,
                   double y_u) {
  const double nx = field.nx / 16384.0;
  const double ny = field.ny / 16384.0;
  Value at = {nx * x_u + ny * y_u + field.c / 16.0, nx, ny};
  if (is_arc) {
    const double w = nx * y_u - ny * x_u + field.along / 16.0;
    const double k = field.bend / 524288.0;
    at.f += k * w * w;
    at.gx -= 2 * k * w * ny;
    at.gy += 2 * k * w * nx;
  }
  return at;
}

inline Value negated(const Value& a) {
  return {-a.f, -a.gx, -a.gy};
}

/// The lesser of two, rounded at their vertex; there the gradient is that of
/// the distance from it.
inline Value least(const Value& a, const Value& b) {
  const Value& lesser = a.f < b.f ? a : b;
  const double c = a.gx * b.gx + a.gy * b.gy;
  const double to_a = a.f - c * b.f;
  const double to_b = b.f - c * a.f;
  if (lesser.f >= 0 || to_a > 0 || to_b > 0 || 1 - c * c < 0.022) {
    return lesser;
  }
  const double part = to_b / root(1 - c * c);
  const double length = root(a.f * a.f + part * part);
  return {-length, -(to_a * a.gx + to_b * b.gx), -(to_a * a.gy + to_b * b.gy)};
}

/// What an operator makes of the values of one to three fields.
inline Value combined(const Value (&fields)[3], uint32_t count, uint32_t op) {
  Value v[3] = {};
  for (uint32_t i = 0; i < count; ++i) {
    v[i] = op % 2 != 0 && count > 1 ? negated(fields[i]) : fields[i];
  }
  if (count == 1) {
    return v[0];
  }
  Value result = {};
  if (count == 2) {
    result = least(v[0], v[1]);
  } else if (op >= 2) {
    // The outer vertex is that of the plain fields.
    const Value inner = negated(least(negated(v[1]), negated(v[2])));
    Value outer = v[1].f >= v[2].f ? v[1] : v[2];
    outer.f = inner.f;
    result = least(v[0], outer);
    if (result.f == inner.f) {
      result = inner;
    }
  } else {
    uint32_t greatest = v[0].f > v[1].f ? 0 : 1;
    greatest = v[2].f > v[greatest].f ? 2 : greatest;
    result = least(v[greatest == 0 ? 1 : 0], v[greatest == 2 ? 1 : 2]);
  }
  return op % 2 != 0 ? negated(result) : result;
}

/// What a cell of primitives says at a point.
inline Value cell(const FieldRecord& record,
                  const inkcell::Cell& cell,
                  double x_u,
                  double y_u) {
  Value v[3] = {};
  for (uint32_t i = 0; i < cell.field_count; ++i) {
    const uint32_t number = record.number_of(cell.fields[i]);
    v[i] = value(record.fields[number], number < record.arc_count, x_u, y_u);
  }
  return combined(v, cell.field_count, static_cast<uint32_t>(cell.op));
}

}  // namespace field_equation
