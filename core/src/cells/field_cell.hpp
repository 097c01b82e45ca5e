// Cells of primitives: planes and bent planes, combined by least and greatest.
//
// All is computed in px of some size, in 32 bits modulo 2^32. A field's two
// products may wrap; their sum is right again because within a cell distances
// and w stay within +-512 u and k w^2 within +-256 u, which is no more in px,
// and k w within +-2.
// Bytes that break this give wrong numbers, never undefined ones.
#pragma once

#include <stdint.h>

#include "base/bytes.hpp"
#include "inkcell/field.hpp"
#include "inkcell/format/cell.hpp"
#include "inkcell/format/rom.hpp"

namespace inkcell {
namespace detail {

// What turns the numbers of a record into px.
struct FieldScale {
  uint32_t size_q8;  // px to the em
  int32_t bend_q14;  // 2^(bend_shift - 5) over the px to the em: 1 to 2
  // 5 and the log2 of the first power of two, in px, that holds an em.
  int32_t bend_shift;
};

// An em of 1024 px, where a px is a u.
inline constexpr FieldScale kScaleOfUnits = {1024 << 8, 1 << 14, 15};

// A distance that no rounding leaves alone.
inline constexpr int32_t kNoReach = INT32_MAX;

// Products and sums that may wrap.
inline uint32_t times(int32_t a, uint32_t b) noexcept {
  return static_cast<uint32_t>(a) * b;
}
inline int32_t wrapped(uint32_t value) noexcept {
  return static_cast<int32_t>(value);
}

// -value if `sign` is -1, value if it is 0; may wrap.
inline int32_t with_sign(int32_t value, int32_t sign) noexcept {
  return wrapped(static_cast<uint32_t>(value ^ sign) -
                 static_cast<uint32_t>(sign));
}

// Where a pixel lies in the glyph. [px, Q8]
struct PixelPlace {
  uint32_t x_q8;
  uint32_t y_q8;
};

// One field at one point.
struct FieldTerm {
  uint32_t plane_q22;  // n.p + c [px]
  int32_t bend;        // k, 0 for a line; see slope_q15
  uint32_t along_q22;  // w, with half of what is cut off later; not of lines
  int16_t nx_q14;
  int16_t ny_q14;

  int32_t along_q8() const noexcept { return wrapped(along_q22) >> 14; }

  // k w, half the slope along the field that the bend adds.
  //
  // k is K 2^-19 / u and w is along_q8 2^-8 px, so that k w = K along_q8 2^-17
  // / size. `bend` is K 2^(bend_shift - 2) / size: K in Q3, divided by the size
  // but for a power of two.
  int32_t slope_q15(int32_t bend_shift) const noexcept {
    return wrapped(times(bend, static_cast<uint32_t>(along_q8()))) >>
           bend_shift;
  }

  // The field's value. [px]
  int32_t value_q22(int32_t bend_shift) const noexcept {
    if (bend == 0) {
      return wrapped(plane_q22);
    }
    const uint32_t along = static_cast<uint32_t>(along_q8());
    const int32_t sag_q23 = wrapped(times(slope_q15(bend_shift), along));
    return wrapped(plane_q22 + static_cast<uint32_t>(sag_q23 >> 1));
  }

  // The same field this far to the right.
  FieldTerm moved(uint32_t way_q8) const noexcept {
    FieldTerm term = *this;
    term.plane_q22 += times(nx_q14, way_q8);
    term.along_q22 -= times(ny_q14, way_q8);
    return term;
  }
};

// All fields of a cell at one point.
struct FieldTerms {
  FieldTerm term[3];
  uint8_t count;
  Csg op;
};

// A field at a point, in px from the glyph's origin, y up, given where its
// record lies.
inline void set_up_term(FieldTerm& term,
                        const uint8_t* at,
                        bool is_arc,
                        uint32_t x_q8,
                        uint32_t y_q8,
                        const FieldScale& scale) noexcept {
  namespace edges = format::edges;
  const int16_t nx = load_i16(at + edges::kNormalX);
  const int16_t ny = load_i16(at + edges::kNormalY);
  term.nx_q14 = nx;
  term.ny_q14 = ny;
  term.plane_q22 = times(nx, x_q8) + times(ny, y_q8) +
                   times(load_i16(at + edges::kOffset), scale.size_q8);
  term.along_q22 = 0;
  term.bend = 0;
  if (is_arc) {
    term.along_q22 = times(nx, y_q8) - times(ny, x_q8) + (1 << 13) +
                     times(load_i16(at + edges::kAlong), scale.size_q8);
    term.bend =
        (load_i16(at + edges::kBend) * scale.bend_q14 + (1 << 10)) >> 11;
  }
}

// The same of a field of a cell.
inline void set_up_term(FieldTerm& term,
                        const GlyphField& field,
                        uint32_t unit,
                        uint32_t x_q8,
                        uint32_t y_q8,
                        const FieldScale& scale) noexcept {
  namespace linked = format::linked;
  set_up_term(term, field.cells + 2 * (unit & linked::kOffsetMask),
              (unit & linked::kArcField) != 0, x_q8, y_q8, scale);
}

inline void set_up_terms(FieldTerms& terms,
                         const GlyphField& field,
                         const Cell& cell,
                         uint32_t x_q8,
                         uint32_t y_q8,
                         const FieldScale& scale) noexcept {
  terms.count = cell.field_count;
  terms.op = cell.op;
  for (uint32_t i = 0; i < cell.field_count; ++i) {
    set_up_term(terms.term[i], field, cell.fields[i], x_q8, y_q8, scale);
  }
}

// Where field `number` of a narrow record lies, as Cell::fields has it.
inline uint32_t unit_of(const GlyphField& field, uint32_t number) noexcept {
  namespace linked = format::linked;
  if (number < field.arc_count) {
    return linked::kArcUnits * number | linked::kArcField;
  }
  return linked::kLineUnits * number +
         (linked::kArcUnits - linked::kLineUnits) * field.arc_count;
}

// Fills in the fields that a reference behind those of nodes stands for, as
// find_narrow_leaf finds them, as `name` has their numbers, and their operator.
// How many they are: none, if it names what does not exist.
template <typename Out, typename Name>
__attribute__((always_inline)) inline uint32_t read_narrow_leaf(
    const GlyphField& field,
    uint32_t reference,
    const Name& name,
    Out* out,
    Csg& op) noexcept {
  namespace edges = format::edges;
  const uint32_t field_count = uint32_t{field.arc_count} + field.line_count;
  uint32_t leaf = reference - format::glyph::kFirstNode - field.node_count;
  op = Csg::intersection;
  if (leaf < field_count) {
    out[0] = name(leaf);
    return 1;
  }
  leaf -= field_count;
  // Behind the pairs come the references; before them, the triples.
  const uint8_t* at = field.references - edges::kPairUnits * field.pair_count;
  if (leaf < field.pair_count) {
    // Everything is read once: flash may change between check and use.
    at += edges::kPairUnits * leaf;
    const uint32_t f0 = at[0];
    const uint32_t f1 = at[1];
    if (__builtin_expect(f0 >= field_count || f1 >= field_count, 0)) {
      return 0;
    }
    out[0] = name(f0);
    out[1] = name(f1);
    op = f0 > f1 ? Csg::union_ : Csg::intersection;
    return __builtin_expect(f0 == f1, 0) ? 1 : 2;
  }
  // Triples end where pairs begin. Less than none is left of a leaf that is
  // one, and not more than there are, as it is behind all pairs.
  const int32_t triple =
      wrapped(leaf) - (int32_t{field.pair_count} + field.triple_count);
  if (__builtin_expect(triple >= 0, 0)) {
    return 0;
  }
  at += static_cast<int32_t>(edges::kTripleUnits) * triple;
  const uint8_t code = at[0];
  const uint32_t f0 = at[1];
  const uint32_t f1 = at[2];
  const uint32_t f2 = at[3];
  if (__builtin_expect(
          code > static_cast<uint8_t>(Csg::union_of_intersection) ||
              f0 >= field_count || f1 >= field_count || f2 >= field_count,
          0)) {
    return 0;
  }
  op = static_cast<Csg>(code);
  out[0] = name(f0);
  out[1] = name(f1);
  out[2] = name(f2);
  return 3;
}

// The same with fields as Cell::fields has them.
inline uint32_t read_narrow_leaf(const GlyphField& field,
                                 uint32_t reference,
                                 uint16_t* out,
                                 Csg& op) noexcept {
  return read_narrow_leaf(
      field, reference,
      [&field](uint32_t number) {
        return static_cast<uint16_t>(unit_of(field, number));
      },
      out, op);
}

// A leaf of a tile's tree: outside where the tree has none.
struct Leaf {
  uint32_t reference;
  uint32_t size_log2;

  // The child of the square that holds a point, in u from the grid's corner;
  // it becomes the square. Each step spends one bit of the coordinates, so that
  // loops of them end.
  uint32_t descend(uint32_t x, uint32_t y) noexcept {
    --size_log2;
    return ((y >> size_log2) & 1) * 2 + ((x >> size_log2) & 1);
  }
};

// The heap of linked fields: what its references and units name. Nothing, if
// it leaves the heap.
class LinkedHeap {
 public:
  explicit LinkedHeap(const GlyphField& field) noexcept
      : data_(field.cells), units_(field.heap_units) {}

  bool holds(uint32_t unit, uint32_t count) const noexcept {
    return unit + count <= units_;
  }
  // `unit` must exist.
  uint32_t at(uint32_t unit) const noexcept {
    return load_u16(data_ + 2 * unit);
  }

  static uint32_t tag(uint32_t reference) noexcept {
    return reference >> format::linked::kOffsetBits;
  }
  static uint32_t offset(uint32_t reference) noexcept {
    return reference & format::linked::kOffsetMask;
  }

  bool is_node(uint32_t reference) const noexcept {
    namespace linked = format::linked;
    return tag(reference) == linked::kNode &&
           holds(offset(reference), linked::kNodeUnits);
  }
  bool is_field(uint32_t unit) const noexcept {
    namespace linked = format::linked;
    // Seldom is it one of the last units.
    return holds(offset(unit), linked::kArcUnits) ||
           ((unit & linked::kArcField) == 0 &&
            holds(offset(unit), linked::kLineUnits));
  }
  // find_narrow_leaf in this heap.
  __attribute__((always_inline)) Leaf find_leaf(uint32_t tile,
                                                uint32_t tile_log2,
                                                uint32_t x,
                                                uint32_t y) const noexcept {
    namespace linked = format::linked;
    Leaf leaf = {format::glyph::kOutside, tile_log2};
    if (tile < units_) {
      leaf.reference = at(tile);
      // Their tag is the least, so that one comparison tells nodes.
      uint32_t node = leaf.reference - linked::reference(linked::kNode, 0);
      while (node <= linked::kOffsetMask && holds(node, linked::kNodeUnits)) {
        if (leaf.size_log2 == 0) {
          return {format::glyph::kOutside, 0};
        }
        leaf.reference = at(node + leaf.descend(x, y));
        node = leaf.reference - linked::reference(linked::kNode, 0);
      }
    }
    return leaf;
  }

  // read_narrow_leaf for a reference of this heap: `name` takes a field's unit.
  template <typename Out, typename Name>
  __attribute__((always_inline)) uint32_t read_leaf(uint32_t reference,
                                                    const Name& name,
                                                    Out* out,
                                                    Csg& op) const noexcept {
    namespace linked = format::linked;
    const uint32_t kind = tag(reference);
    uint32_t from = offset(reference);
    op = Csg::intersection;
    if (kind == linked::kLine) {
      out[0] = name(from);
      return holds(from, linked::kLineUnits) ? 1 : 0;
    }
    if (kind == linked::kArc) {
      out[0] = name(from | linked::kArcField);
      return holds(from, linked::kArcUnits) ? 1 : 0;
    }
    uint32_t count = 2;
    if (kind == linked::kTriple) {
      if (!holds(from, linked::kTripleUnits)) {
        return 0;
      }
      const uint32_t number = at(from++);
      if (number > static_cast<uint32_t>(Csg::union_of_intersection)) {
        return 0;
      }
      op = static_cast<Csg>(number);
      count = 3;
    } else if ((kind != linked::kMinPair && kind != linked::kMaxPair) ||
               !holds(from, linked::kPairUnits)) {
      return 0;
    }
    const uint8_t* unit_at = data_ + 2 * from;
    for (uint32_t i = 0; i < count; ++i, unit_at += 2) {
      const uint32_t unit = load_u16(unit_at);
      if (!is_field(unit)) {
        return 0;
      }
      out[i] = name(unit & (linked::kArcField | linked::kOffsetMask));
    }
    if (count == 2 && out[0] == out[1]) {
      return 1;  // a pair of one field is that field
    }
    if (kind == linked::kMaxPair) {
      op = Csg::union_;
    }
    return count;
  }

 private:
  const uint8_t* data_;
  uint32_t units_;
};

// The leaf of tile `tile` that holds a point, in u from the grid's corner.
inline Leaf find_narrow_leaf(const GlyphField& field,
                             uint32_t tile,
                             uint32_t x,
                             uint32_t y) noexcept {
  const uint8_t* const nodes =
      field.references + static_cast<uint32_t>(field.tiles_x) * field.tiles_y;
  uint32_t reference = field.references[tile];
  int32_t size_log2 = field.tile_log2;
  uint32_t node = reference - format::glyph::kFirstNode;
  while (node < field.node_count) {
    // Each step spends one bit of the coordinates, so that the loop ends.
    if (--size_log2 < 0) {
      return {format::glyph::kOutside, 0};
    }
    const uint8_t* const row = nodes + 4 * node + ((y >> size_log2) & 1) * 2;
    reference = row[(x >> size_log2) & 1];
    node = reference - format::glyph::kFirstNode;
  }
  return {reference, static_cast<uint32_t>(size_log2)};
}

// read_narrow_leaf for the linked form.
uint32_t read_linked_leaf(const GlyphField& field,
                          uint32_t reference,
                          uint16_t* out,
                          Csg& op) noexcept;

// The cell of primitives that holds a point in the grid.
Cell locate_fields(const GlyphField& field, int32_t x_u, int32_t y_u) noexcept;

struct Vector {
  int32_t x;
  int32_t y;
};

// The normal of a field, given where its record lies. [Q14]
inline Vector normal_of(const uint8_t* record) noexcept {
  return {load_i16(record + format::edges::kNormalX),
          load_i16(record + format::edges::kNormalY)};
}

// The gradient of a bent field: n + 2 k w (-ny, nx), given half the slope that
// the bend adds in Q15, which is all of it in Q14. [Q14]
inline Vector bent(Vector normal_q14, int32_t slope_q15) noexcept {
  const auto slope = static_cast<uint32_t>(slope_q15);
  return {normal_q14.x - (wrapped(times(normal_q14.y, slope)) >> 14),
          normal_q14.y + (wrapped(times(normal_q14.x, slope)) >> 14)};
}

// The gradient of a field at a point, as set_up_term has them. [Q14]
inline Vector gradient_q14(const FieldTerm& term, int32_t bend_shift) noexcept {
  const Vector normal_q14 = {term.nx_q14, term.ny_q14};
  return term.bend == 0 ? normal_q14
                        : bent(normal_q14, term.slope_q15(bend_shift));
}

// Of the angle between two gradients.
inline int32_t cosine_q14(const Vector& g_q14, const Vector& h_q14) noexcept {
  return wrapped(times(g_q14.x, static_cast<uint32_t>(h_q14.x)) +
                 times(g_q14.y, static_cast<uint32_t>(h_q14.y)) + (1 << 13)) >>
         14;
}

// The lesser of two values, below 0, as it is rounded at the vertex of the two
// fields between whose gradients this cosine is; the greater one is not farther
// from 0. [px, Q22]
int32_t rounded_q22(int32_t lesser_q22,
                    int32_t greater_q22,
                    int32_t c_q14) noexcept;

// The cell's distance, with vertices rounded where that changes a result
// between -reach_q22 and reach_q22. [px, Q22]
int32_t combine_q22(const FieldTerms& terms,
                    int32_t bend_shift,
                    int32_t reach_q22) noexcept;

// The gradient of that distance, of unit length.
Gradient combined_gradient(const FieldTerms& terms,
                           int32_t bend_shift) noexcept;

}  // namespace detail
}  // namespace inkcell
