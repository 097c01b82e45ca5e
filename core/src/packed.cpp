#include "inkcell/packed.hpp"

#include "inkcell/format.hpp"
#include "packed_stream.hpp"

namespace inkcell {
namespace {

namespace linked = format::linked;
namespace packed = format::packed;

using detail::BitStream;
using detail::kTables;
using detail::RecentFields;

// Every second of the 16 bits.
uint32_t even_bits(uint32_t bits) noexcept {
  bits &= 0x5555;
  bits = (bits | bits >> 1) & 0x3333;
  bits = (bits | bits >> 2) & 0x0f0f;
  return (bits | bits >> 4) & 0xff;
}

// A square of the quadtree.
struct Square {
  int32_t x0_u;  // of its tile
  int32_t y0_u;
  uint32_t way;  // to its corner: bits of x and y, by turns
  uint32_t log2;
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
    if (take(glyph_.tiles_x * count) == kNoRoom) {
      return Status::buffer_small;
    }
    const uint8_t* data = glyph_.record.data;
    const auto size = static_cast<uint32_t>(glyph_.record.size);
    uint32_t at = packed::streams_at(glyph_.tiles_y, glyph_.wide_rows);
    INKCELL_TRY(shared_fields({data + at, size - at}, at));
    uint32_t slot = 0;
    for (uint32_t row = 0; row < first + count; ++row) {
      uint32_t end = size;
      if (row + 1u < glyph_.tiles_y) {
        end = at + row_bytes(row);
      }
      if (at > size || end > size) {
        return Status::corrupt;
      }
      if (row >= first) {
        INKCELL_TRY(tile_row(BitStream(data + at, end - at), row, slot));
        slot += glyph_.tiles_x;
      }
      at = end;
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
  void put(uint32_t unit, uint32_t value) noexcept {
    auto* at =
        static_cast<uint8_t*>(__builtin_assume_aligned(heap_ + 2 * unit, 2));
    at[0] = static_cast<uint8_t>(value);
    at[1] = static_cast<uint8_t>(value >> 8);
  }

  uint32_t row_bytes(uint32_t row) const noexcept {
    const uint8_t* lengths = glyph_.record.data + packed::kRowLengths;
    return glyph_.wide_rows
               ? lengths[2 * row] | uint32_t{lengths[2 * row + 1]} << 8
               : lengths[row];
  }

  // Advances `at` to the end of the stream.
  Status shared_fields(Span<const uint8_t> bytes, uint32_t& at) noexcept {
    BitStream bits(bytes.data, static_cast<uint32_t>(bytes.size));
    const uint32_t log2 = packed::shared_log2(glyph_.tiles_x, glyph_.tiles_y);
    const int32_t x = glyph_.x0_u + packed::kTileU / 2 * glyph_.tiles_x;
    const int32_t y = glyph_.y0_u + packed::kTileU / 2 * glyph_.tiles_y;
    shared_count_ = bits.number(packed::kSharedCountBits);
    for (uint32_t i = 0; i < shared_count_; ++i) {
      const auto kind = static_cast<FieldKind>(bits.number(2));
      uint32_t unit = 0;
      INKCELL_TRY(new_field(bits, kind, log2, x, y, unit));
      shared_arcs_ |= (unit >> 15) << i;
    }
    shared_end_ = units_;
    at += bits.used();
    return Status::ok;
  }

  // The list as every row of tiles finds it.
  void recall_shared_fields() noexcept {
    recent_.clear();
    uint32_t end = shared_end_;
    for (uint32_t i = shared_count_; i-- > 0;) {
      const bool is_arc = (shared_arcs_ >> i & 1) != 0;
      end -= is_arc ? linked::kArcUnits : linked::kLineUnits;
      recent_.insert(end | (is_arc ? linked::kArcField : 0));
    }
  }

  Status tile_row(BitStream bits, uint32_t row, uint32_t slot) noexcept {
    recall_shared_fields();
    Square tile;
    tile.x0_u = glyph_.x0_u;
    tile.y0_u = glyph_.y0_u + packed::kTileU * static_cast<int32_t>(row);
    for (uint32_t i = 0; i < glyph_.tiles_x; ++i) {
      INKCELL_TRY(tile_tree(bits, tile, slot + i));
      tile.x0_u += packed::kTileU;
    }
    return Status::ok;
  }

  // One tile, its squares in the order of the stream; `slot` is the unit of its
  // reference.
  //
  // Invariant: slots[log2] is the unit where the reference of the square goes,
  // and slots[i] of all i above that of the square of 2^i u around it. Every
  // turn of the loop fills in one reference, or makes four, or ends it.
  Status tile_tree(BitStream& bits, Square& square, uint32_t slot) noexcept {
    uint16_t slots[packed::kTileLog2 + 1];
    uint32_t log2 = packed::kTileLog2;
    uint32_t way = 0;
    slots[log2] = static_cast<uint16_t>(slot);
    while (true) {
      const uint32_t level = packed::kTileLog2 - log2;
      const uint8_t* table = kTables.node[level < 6 ? level : 6];
      const uint32_t symbol = bits.symbol(table, packed_codes::kNodeMaxBits);
      if (symbol == packed::kSplit) {
        if (log2 == 0) {
          return Status::corrupt;
        }
        const uint32_t node = take(linked::kNodeUnits);
        if (node == kNoRoom) {
          return Status::buffer_small;
        }
        put(slots[log2], linked::reference(linked::kNode, node));
        --log2;
        slots[log2] = static_cast<uint16_t>(node);
        continue;
      }
      // Outside and inside are numbered like the references.
      uint32_t reference = symbol - packed::kOutside;
      if (symbol >= packed::kSingle) {
        square.way = way;
        square.log2 = log2;
        INKCELL_TRY(leaf(bits, symbol, square, reference));
      }
      put(slots[log2], reference);
      // To the next square: the highest bits that change say how far up.
      way += 1u << 2 * log2;
      while (log2 < packed::kTileLog2 && ((way >> 2 * log2) & 3) == 0) {
        ++log2;
      }
      if (log2 == packed::kTileLog2) {
        return Status::ok;
      }
      ++slots[log2];
    }
  }

  Status leaf(BitStream& bits,
              uint32_t symbol,
              const Square& square,
              uint32_t& reference) noexcept {
    const bool is_nested = symbol >= packed::kMinMax;
    const uint32_t count = symbol >= packed::kMin3     ? 3
                           : symbol == packed::kSingle ? 1
                                                       : 2;
    uint16_t units[3];
    uint32_t new_fields = 0;  // a bit for each
    uint32_t least_rank = 0;
    uint32_t after_new = 0;
    for (uint32_t i = 0; i < count; ++i) {
      const bool is_first = i == 0 || (is_nested && i == 1);
      if (is_first) {
        least_rank = 0;
        after_new = 0;
      }
      const uint32_t kind = bits.symbol(kTables.kind[2 * i + after_new],
                                        packed_codes::kKindMaxBits);
      uint32_t unit = 0;
      if (kind == packed::kReuse) {
        const uint32_t rank =
            least_rank + bits.symbol(kTables.rank[is_first ? 0 : 1],
                                     packed_codes::kRankMaxBits);
        if (rank >= recent_.size()) {
          return Status::corrupt;
        }
        unit = recent_[rank];
        least_rank = rank + 1;
      } else {
        const uint32_t half = (1u << square.log2) >> 1;
        INKCELL_TRY(new_field(
            bits, static_cast<FieldKind>(kind - packed::kNew), square.log2,
            square.x0_u + static_cast<int32_t>(even_bits(square.way) + half),
            square.y0_u +
                static_cast<int32_t>(even_bits(square.way >> 1) + half),
            unit));
        new_fields |= 1u << i;
        after_new = 1;
      }
      units[i] = static_cast<uint16_t>(unit);
    }
    for (uint32_t i = count; i-- > 0;) {
      if ((new_fields >> i & 1) != 0) {
        recent_.insert(units[i]);
      } else {
        recent_.move_to_front(units[i]);
      }
    }
    recent_.trim();
    if (count == 1) {
      const uint32_t is_arc = units[0] >> 15;
      reference = linked::reference(linked::kLine + is_arc,
                                    units[0] & linked::kOffsetMask);
      return Status::ok;
    }
    const uint32_t block =
        take(count == 2 ? linked::kPairUnits : linked::kTripleUnits);
    if (block == kNoRoom) {
      return Status::buffer_small;
    }
    uint32_t at = block;
    if (count == 3) {
      put(at++, symbol - packed::kMin3);
      reference = linked::reference(linked::kTriple, block);
    } else {
      reference =
          linked::reference(linked::kMinPair + symbol - packed::kMin2, block);
    }
    for (uint32_t i = 0; i < count; ++i) {
      put(at++, units[i]);
    }
    return Status::ok;
  }

  // Reads a field, adds it to the heap, and says where it is.
  Status new_field(BitStream& bits,
                   FieldKind kind,
                   uint32_t log2,
                   int32_t x_u,
                   int32_t y_u,
                   uint32_t& unit) noexcept {
    FieldCode code;
    code.kind = kind;
    const uint32_t d0_bits = glyph_.coding.d0_bits(log2);
    code.d0 = static_cast<int32_t>(bits.number(d0_bits)) -
              static_cast<int32_t>((1u << d0_bits) >> 1);
    code.angle =
        bits.number(has_angle(kind) ? glyph_.coding.angle_bits(log2) : 2);
    if (is_bent(kind)) {
      uint32_t high = 0;
      while (bits.number(1) != 0) {
        if (++high > packed::kMaxUnary) {
          return Status::corrupt;
        }
      }
      const uint32_t low_bits = glyph_.coding.bend_bits(log2);
      const auto size =
          static_cast<int32_t>((high << low_bits | bits.number(low_bits)) + 1);
      code.bend = bits.number(1) != 0 ? -size : size;
    }
    const FieldNumbers field =
        expand_field(code, glyph_.coding, log2, x_u, y_u);
    const uint32_t at =
        take(field.bend != 0 ? linked::kArcUnits : linked::kLineUnits);
    if (at == kNoRoom) {
      return Status::buffer_small;
    }
    put(at, static_cast<uint16_t>(field.nx_q14));
    put(at + 1, static_cast<uint16_t>(field.ny_q14));
    put(at + 2, static_cast<uint16_t>(field.c_q4));
    unit = at;
    if (field.bend != 0) {
      put(at + 3, static_cast<uint16_t>(field.along_q4));
      put(at + 4, static_cast<uint16_t>(field.bend));
      unit |= linked::kArcField;
    }
    return Status::ok;
  }

  const PackedGlyph& glyph_;
  uint8_t* heap_;
  uint32_t room_;       // [units]
  uint32_t units_ = 0;  // that are taken
  uint32_t shared_count_ = 0;
  uint32_t shared_arcs_ = 0;  // a bit for each
  uint32_t shared_end_ = 0;   // the first unit behind them
  RecentFields recent_;
};

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
  return open(
      record,
      PackedCoding::read(font.rom().data + format::header::kQuantisation), out);
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
  Expansion expansion(glyph, workspace);
  INKCELL_TRY(expansion.rows(first_row, row_count));
  GlyphField field = glyph.grid(first_row, row_count);
  field.references = workspace.data;
  field.cells = workspace.data;
  field.heap_units = static_cast<uint16_t>(expansion.units());
  out = field;
  return Status::ok;
}

}  // namespace inkcell
