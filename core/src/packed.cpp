#include "inkcell/packed.hpp"

#include "inkcell/format.hpp"
#include "packed_field.hpp"
#include "packed_stream.hpp"

namespace inkcell {
namespace {

namespace linked = format::linked;
namespace packed = format::packed;

using detail::BitStream;
using detail::kTables;
using detail::RecentFields;

void store_u16(uint8_t* at, uint32_t value) noexcept {
  auto* p = static_cast<uint8_t*>(__builtin_assume_aligned(at, 2));
  p[0] = static_cast<uint8_t>(value);
  p[1] = static_cast<uint8_t>(value >> 8);
}

// The square where a field is new.
struct Square {
  int32_t x_u;  // where the anchor would be if the way were 0
  int32_t y_u;
  uint32_t way;   // from there: 16 bits, of x and y by turns
  uint32_t log2;  // of its width
};

// Expands rows of tiles into a heap of 16-bit units that grows as it reads
// (docs/FORMAT.md, "The linked form").
class Expansion {
 public:
  Expansion(const PackedGlyph& glyph, Workspace workspace) noexcept
      : glyph_(glyph),
        heap_(workspace.data),
        room_(workspace.size / 2 < linked::kMaxUnits
                  ? static_cast<uint32_t>(workspace.size / 2)
                  : linked::kMaxUnits) {}

  uint32_t units() const noexcept { return units_; }

  Status rows(uint32_t first, uint32_t count) noexcept {
    if (count == 0) {
      return Status::ok;
    }
    uint32_t slot = take(glyph_.tiles_x * count);
    if (slot == kNoRoom) {
      return Status::buffer_small;
    }
    const uint8_t* const end = glyph_.record.end();
    const uint8_t* at = glyph_.record.data +
                        packed::streams_at(glyph_.tiles_y, glyph_.wide_rows);
    bits_ = BitStream({at, static_cast<size_t>(end - at)});
    INKCELL_TRY(shared_fields());
    at = bits_.position();
    for (uint32_t row = 0; row < first + count; ++row) {
      if (at == nullptr) {
        return Status::corrupt;
      }
      auto bytes = static_cast<size_t>(end - at);
      if (row + 1u < glyph_.tiles_y) {
        const uint32_t stated = row_bytes(row);
        if (stated > bytes) {
          return Status::corrupt;
        }
        bytes = stated;
      }
      if (row >= first) {
        bits_ = BitStream({at, bytes});
        INKCELL_TRY(tile_row(row, slot));
        slot += glyph_.tiles_x;
      }
      at += bytes;
    }
    return Status::ok;
  }

 private:
  static constexpr uint32_t kNoRoom = 0xffffffff;

  // The first of `count` new units of the heap.
  uint32_t take(uint32_t count) noexcept {
    const uint32_t first = units_;
    if (count > room_ - first) {
      return kNoRoom;
    }
    units_ = first + count;
    return first;
  }
  uint8_t* at(uint32_t unit) noexcept { return heap_ + 2 * unit; }

  uint32_t row_bytes(uint32_t row) const noexcept {
    const uint8_t* lengths = glyph_.record.data + packed::kRowLengths;
    return glyph_.wide_rows
               ? lengths[2 * row] | uint32_t{lengths[2 * row + 1]} << 8
               : lengths[row];
  }

  Status shared_fields() noexcept {
    const Square grid = {glyph_.x0_u + packed::kTileU / 2 * glyph_.tiles_x,
                         glyph_.y0_u + packed::kTileU / 2 * glyph_.tiles_y, 0,
                         packed::shared_log2(glyph_.tiles_x, glyph_.tiles_y)};
    shared_count_ =
        static_cast<uint16_t>(bits_.number(packed::kSharedCountBits));
    for (uint32_t i = 0; i < shared_count_; ++i) {
      const auto kind = static_cast<FieldKind>(bits_.number(2));
      uint32_t unit = 0;
      INKCELL_TRY(new_field(kind, grid, unit));
      shared_arcs_ |= static_cast<uint16_t>((unit >> 15) << i);
    }
    shared_end_ = static_cast<uint16_t>(units_);
    return Status::ok;
  }

  // The list as every row of tiles finds it.
  void recall_shared_fields() noexcept {
    recent_.clear();
    uint32_t end = shared_end_;
    for (uint32_t i = shared_count_; i-- > 0;) {
      const bool is_arc = (shared_arcs_ >> i & 1) != 0;
      end -= is_arc ? linked::kArcUnits : linked::kLineUnits;
      recent_.insert(end | (is_arc ? linked::kArcField : 0), 0);
    }
  }

  // The references of the tiles go to the heap from `slot` on.
  Status tile_row(uint32_t row, uint32_t slot) noexcept {
    recall_shared_fields();
    int32_t x_u = glyph_.x0_u;
    const int32_t y_u =
        glyph_.y0_u + packed::kTileU * static_cast<int32_t>(row);
    for (uint32_t i = 0; i < glyph_.tiles_x; ++i) {
      INKCELL_TRY(tile_tree(x_u, y_u, slot + i));
      x_u += packed::kTileU;
    }
    return Status::ok;
  }

  // The squares of one tile, in the order of the stream. Not part of its
  // callers, so that what it keeps in registers stays there.
  //
  // Invariant: slots[log2] is where the reference of the next square goes, and
  // slots[i] of all i above that of the square of 2^i u around it. Every turn
  // of the loop fills in one reference, or makes four, or ends it: the heap
  // bounds what any bytes can cost.
  __attribute__((noinline)) Status tile_tree(int32_t x_u,
                                             int32_t y_u,
                                             uint32_t slot) noexcept {
    BitStream bits = bits_;
    uint16_t slots[packed::kTileLog2 + 1];
    uint32_t log2 = packed::kTileLog2;
    uint32_t way = 0;
    slots[log2] = static_cast<uint16_t>(slot);
    while (true) {
      const uint32_t level = packed::kTileLog2 - log2;
      constexpr uint32_t kDeepest = packed_codes::kNodeContexts - 1;
      const uint32_t symbol =
          bits.symbol(kTables.node[level < kDeepest ? level : kDeepest],
                      packed_codes::kNodeMaxBits);
      if (symbol == packed::kSplit) {
        const uint32_t node = take(linked::kNodeUnits);
        if (log2 == 0 || node == kNoRoom) {
          return log2 == 0 ? Status::corrupt : Status::buffer_small;
        }
        store_u16(at(slots[log2]), linked::reference(linked::kNode, node));
        --log2;
        slots[log2] = static_cast<uint16_t>(node);
        continue;
      }
      // Outside and inside are numbered like the references.
      uint32_t reference = symbol - packed::kOutside;
      if (symbol >= packed::kSingle) {
        const auto half = static_cast<int32_t>((1u << log2) >> 1);
        INKCELL_TRY(
            leaf(bits, symbol, {x_u + half, y_u + half, way, log2}, reference));
      }
      store_u16(at(slots[log2]), reference);
      // To the next square: the highest bits that change say how far up.
      way += 1u << 2 * log2;
      while (((way >> 2 * log2) & 3) == 0) {
        ++log2;
      }
      if (log2 == packed::kTileLog2) {
        bits_ = bits;
        return Status::ok;
      }
      ++slots[log2];
    }
  }

  Status leaf(BitStream& bits,
              uint32_t symbol,
              const Square& square,
              uint32_t& reference) noexcept {
    const uint32_t count = symbol >= packed::kMin3   ? 3
                           : symbol >= packed::kMin2 ? 2
                                                     : 1;
    INKCELL_TRY(
        fields_to_front(bits, count, symbol >= packed::kMinMax, square));
    if (count == 1) {
      const uint32_t unit = recent_[0];
      reference = linked::reference(linked::kLine + (unit >> 15),
                                    unit & linked::kOffsetMask);
      return Status::ok;
    }
    const uint32_t block =
        take(count == 2 ? linked::kPairUnits : linked::kTripleUnits);
    if (block == kNoRoom) {
      return Status::buffer_small;
    }
    uint8_t* to = at(block);
    uint32_t tag = linked::kMinPair + symbol - packed::kMin2;
    if (count == 3) {
      tag = linked::kTriple;
      store_u16(to, symbol - packed::kMin3);
      to += 2;
    }
    for (uint32_t i = 0; i < count; ++i, to += 2) {
      store_u16(to, recent_[i]);
    }
    reference = linked::reference(tag, block);
    return Status::ok;
  }

  // Reads the fields of a leaf, and brings them to the front of the list. Those
  // that were there come by ascending rank, so that one that is moved does not
  // change the place of the next; if the operator nests, those behind the first
  // are a group of their own, and count from the start again.
  Status fields_to_front(BitStream& bits,
                         uint32_t count,
                         bool is_nested,
                         const Square& square) noexcept {
    const uint32_t known = recent_.size();
    uint32_t least_rank = 0;
    uint32_t after_new = 0;
    uint32_t is_later = 0;
    int32_t first_rank = -1;  // of the other group, if there is one
    for (uint32_t i = 0; i < count; ++i) {
      const uint32_t kind = bits.symbol(kTables.kind[2 * i + after_new],
                                        packed_codes::kKindMaxBits);
      uint32_t rank = known;
      if (kind == packed::kReuse) {
        rank = least_rank +
               bits.symbol(kTables.rank[is_later], packed_codes::kRankMaxBits);
        const auto signed_rank = static_cast<int32_t>(rank);
        if (rank >= known || signed_rank == first_rank) {
          return Status::corrupt;
        }
        recent_.move(signed_rank < first_rank ? rank + 1 : rank, i);
        least_rank = rank + 1;
      } else {
        uint32_t unit = 0;
        bits_ = bits;
        INKCELL_TRY(new_field(static_cast<FieldKind>(kind - packed::kNew),
                              square, unit));
        bits = bits_;
        recent_.insert(unit, i);
        after_new = 1;
      }
      is_later = 1;
      if (is_nested && i == 0) {
        first_rank = static_cast<int32_t>(rank);
        least_rank = 0;
        after_new = 0;
        is_later = 0;
      }
    }
    recent_.trim();
    return Status::ok;
  }

  // Reads a field, adds it to the heap, and says where it is.
  Status new_field(FieldKind kind,
                   const Square& square,
                   uint32_t& unit) noexcept {
    const PackedCoding& coding = glyph_.coding;
    BitStream bits = bits_;
    FieldCode code;
    code.kind = kind;
    const uint32_t d0_bits = coding.d0_bits(square.log2);
    code.d0 = static_cast<int32_t>(bits.number(d0_bits)) -
              static_cast<int32_t>((1u << d0_bits) >> 1);
    code.angle =
        bits.number(has_angle(kind) ? coding.angle_bits(square.log2) : 2);
    if (is_bent(kind)) {
      const uint32_t high = bits.ones();
      if (high > packed::kMaxUnary) {
        return Status::corrupt;
      }
      // The sign is behind the lower bits.
      const uint32_t low_bits = coding.bend_bits(square.log2);
      const uint32_t low = bits.number(low_bits + 1);
      const auto size = static_cast<int32_t>((high << low_bits | low >> 1) + 1);
      code.bend = (low & 1) != 0 ? -size : size;
    }
    bits_ = bits;
    // The bits of y to the upper half, then all next to each other.
    uint32_t way = (square.way & 0x5555) | (square.way & 0xaaaa) << 15;
    way = (way | way >> 1) & 0x33333333;
    way = (way | way >> 2) & 0x0f0f0f0f;
    way |= way >> 4;
    const FieldNumbers field = detail::field_numbers(
        code, coding, square.log2,
        square.x_u + static_cast<int32_t>(way & 0xff),
        square.y_u + static_cast<int32_t>(way >> 16 & 0xff));
    unit = take(field.bend != 0 ? linked::kArcUnits : linked::kLineUnits);
    if (unit == kNoRoom) {
      return Status::buffer_small;
    }
    uint8_t* to = at(unit);
    namespace fields = format::fields;
    store_u16(to + fields::kNormalX, static_cast<uint16_t>(field.nx_q14));
    store_u16(to + fields::kNormalY, static_cast<uint16_t>(field.ny_q14));
    store_u16(to + fields::kOffset, static_cast<uint16_t>(field.c_q4));
    if (field.bend != 0) {
      store_u16(to + fields::kAlong, static_cast<uint16_t>(field.along_q4));
      store_u16(to + fields::kBend, static_cast<uint16_t>(field.bend));
      unit |= linked::kArcField;
    }
    return Status::ok;
  }

  const PackedGlyph& glyph_;
  uint8_t* heap_;
  uint32_t room_;       // [units]
  uint32_t units_ = 0;  // that are taken
  BitStream bits_;
  uint16_t shared_count_ = 0;
  uint16_t shared_arcs_ = 0;  // a bit for each
  uint16_t shared_end_ = 0;   // the first unit behind them
  RecentFields recent_;
};

// Not inline: the caller's frame holds a view of the result.
__attribute__((noinline)) Status expand_rows(const PackedGlyph& glyph,
                                             uint32_t first_row,
                                             uint32_t row_count,
                                             Workspace workspace,
                                             uint16_t& heap_units) noexcept {
  Expansion expansion(glyph, workspace);
  INKCELL_TRY(expansion.rows(first_row, row_count));
  heap_units = static_cast<uint16_t>(expansion.units());
  return Status::ok;
}

}  // namespace

Status PackedGlyph::open(Span<const uint8_t> record,
                         const PackedCoding& coding,
                         PackedGlyph& out) noexcept {
  constexpr int32_t kLimit = format::fields::kGridLimit;
  if (record.size < packed::kRowLengths) {
    return Status::corrupt;
  }
  const uint8_t* at = record.data;
  if (INKCELL_PACKED == 0 ||
      (at[packed::kType] & ~packed::kWideRows) != packed::kTypePacked) {
    return Status::unsupported;
  }
  PackedGlyph glyph;
  glyph.record = record;
  glyph.coding = coding;
  glyph.wide_rows = (at[packed::kType] & packed::kWideRows) != 0;
  glyph.tiles_x = at[packed::kTiles] & 15;
  glyph.tiles_y = at[packed::kTiles] >> 4;
  glyph.x0_u = packed::i12(at[packed::kX0Y0] | at[packed::kX0Y0 + 1] << 8);
  glyph.y0_u =
      packed::i12(at[packed::kX0Y0 + 1] >> 4 | at[packed::kX0Y0 + 2] << 4);
  if (glyph.tiles_x == 0 || glyph.tiles_y == 0 || glyph.x0_u < -kLimit ||
      glyph.y0_u < -kLimit ||
      glyph.x0_u + packed::kTileU * glyph.tiles_x > kLimit ||
      glyph.y0_u + packed::kTileU * glyph.tiles_y > kLimit ||
      packed::streams_at(glyph.tiles_y, glyph.wide_rows) > record.size) {
    return Status::corrupt;
  }
  out = glyph;
  return Status::ok;
}

Status PackedGlyph::open(const Font& font,
                         uint16_t glyph,
                         PackedGlyph& out) noexcept {
  if (glyph >= font.glyph_count()) {
    return Status::no_glyph;
  }
  const Span<const uint8_t> record = font.record(glyph);
  if (record.size == 0) {
    out = PackedGlyph{};
    return Status::ok;
  }
  INKCELL_TRY(
      open(record,
           PackedCoding::read(font.rom().data + format::header::kQuantisation),
           out));
  out.ink = font.ink_box(glyph);
  out.glyph = glyph;
  return Status::ok;
}

GlyphField PackedGlyph::grid(uint32_t first_row,
                             uint32_t row_count) const noexcept {
  GlyphField field;
  field.kind = GlyphField::Kind::linked_fields;
  field.tile_log2 = packed::kTileLog2;
  field.x0_u = x0_u;
  field.y0_u = static_cast<int16_t>(y0_u + packed::kTileU *
                                               static_cast<int32_t>(first_row));
  field.tiles_x = tiles_x;
  field.tiles_y = static_cast<uint8_t>(row_count);
  field.ink = ink;
  field.glyph = glyph;
  return field;
}

Status expand(const PackedGlyph& glyph,
              uint32_t first_row,
              uint32_t row_count,
              Workspace workspace,
              GlyphField& out) noexcept {
  if (INKCELL_PACKED == 0) {
    return Status::unsupported;
  }
  if (first_row > glyph.tiles_y || row_count > glyph.tiles_y - first_row ||
      reinterpret_cast<uintptr_t>(workspace.data) % 2 != 0) {
    return Status::bad_argument;
  }
  uint16_t heap_units = 0;
  INKCELL_TRY(expand_rows(glyph, first_row, row_count, workspace, heap_units));
  out = glyph.grid(first_row, row_count);
  out.references = workspace.data;
  out.cells = workspace.data;
  out.heap_units = heap_units;
  return Status::ok;
}

}  // namespace inkcell
