#include "inkcell/packed.hpp"

#include "inkcell/format.hpp"
#include "options.hpp"
#include "packed_field.hpp"
#include "packed_rows.hpp"
#include "packed_stream.hpp"
#include "packed_tables.hpp"

namespace inkcell {
namespace {

namespace linked = format::linked;
namespace packed = format::packed;

using detail::BitStream;
using detail::kFieldTables;
using detail::kNodeTables;
using detail::RecentFields;
using detail::SharedFields;

void store_u16(uint8_t* at, uint32_t value) noexcept {
  auto* p = static_cast<uint8_t*>(__builtin_assume_aligned(at, 2));
  p[0] = static_cast<uint8_t>(value);
  p[1] = static_cast<uint8_t>(value >> 8);
}

// Expands rows of tiles into a heap of 16-bit units that grows as it reads
// (docs/FORMAT.md, "The linked form").
class Expansion {
 public:
  Expansion(const PackedGlyph& glyph,
            Workspace workspace,
            SharedFields& shared) noexcept
      : glyph_(glyph),
        shared_(shared),
        heap_(workspace.data),
        room_(workspace.size / 2 < linked::kMaxUnits
                  ? static_cast<uint32_t>(workspace.size / 2)
                  : linked::kMaxUnits) {}

  uint32_t units() const noexcept { return units_; }

  Status rows(uint32_t first, uint32_t count) noexcept {
    if (count == 0) {
      return Status::ok;
    }
    const uint8_t* const end = glyph_.record.end();
    const uint8_t* at = glyph_.record.data +
                        packed::streams_at(glyph_.tiles_y, glyph_.wide_rows);
    if (shared_.rows != count) {
      INKCELL_TRY(shared_fields({at, static_cast<size_t>(end - at)}, count));
    }
    at += shared_.bytes;
    units_ = shared_.units;
    uint32_t slot = 0;
    for (uint32_t row = 0; row < first + count; ++row) {
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
  // Squares of new fields; and the widths of their numbers, in one number.
  static constexpr uint32_t kSizes = packed::shared_log2(15, 15) + 1;
  static constexpr uint32_t kAngleShift = 5;
  static constexpr uint32_t kBendShift = 10;
  static constexpr uint32_t kKnown = 1 << 15;

  // What is above all units.
  static constexpr uint32_t kCorrupt = 0x10000;
  static constexpr uint32_t kNoRoom = 0x10001;

  static Status failure(uint32_t unit) noexcept {
    return unit == kNoRoom ? Status::buffer_small : Status::corrupt;
  }

  // Adds `count` units to the heap, if there is room.
  bool take(uint32_t count) noexcept {
    const uint32_t end = units_ + count;
    if (end > room_) {
      return false;
    }
    units_ = end;
    return true;
  }
  uint8_t* at(uint32_t unit) noexcept { return heap_ + 2 * unit; }

  uint32_t row_bytes(uint32_t row) const noexcept {
    const uint8_t* lengths = glyph_.record.data + packed::kRowLengths;
    return glyph_.wide_rows
               ? lengths[2 * row] | uint32_t{lengths[2 * row + 1]} << 8
               : lengths[row];
  }

  Status shared_fields(Span<const uint8_t> bytes, uint32_t rows) noexcept {
    shared_.rows = 0;
    if (!take(glyph_.tiles_x * rows)) {
      return Status::buffer_small;
    }
    const uint32_t log2 = packed::shared_log2(glyph_.tiles_x, glyph_.tiles_y);
    x_u_ = glyph_.x0_u + packed::kTileU / 2 * glyph_.tiles_x;
    y_u_ = glyph_.y0_u + packed::kTileU / 2 * glyph_.tiles_y;
    bits_ = BitStream(bytes);
    const uint32_t count = bits_.number(packed::kSharedCountBits);
    uint32_t arcs = 0;
    for (uint32_t i = 0; i < count; ++i) {
      const uint32_t kind = bits_.number(2);
      const uint32_t unit = new_field(kind, log2, 0);
      if (unit >= kCorrupt) {
        return failure(unit);
      }
      arcs |= (unit >> 15) << i;
    }
    const ptrdiff_t left = bits_.left();
    if (left < 0) {
      return Status::corrupt;
    }
    shared_.bytes =
        static_cast<uint32_t>(bytes.size) - static_cast<uint32_t>(left);
    shared_.units = static_cast<uint16_t>(units_);
    shared_.arcs = static_cast<uint16_t>(arcs);
    shared_.count = static_cast<uint8_t>(count);
    shared_.rows = static_cast<uint8_t>(rows);
    return Status::ok;
  }

  // The list as every row of tiles finds it.
  void recall_shared_fields(uint32_t unit) noexcept {
    const uint32_t count = shared_.count;
    uint16_t* const fields = recent_.reset(count);
    uint32_t arcs = shared_.arcs;
    for (uint32_t i = 0; i < count; ++i) {
      if ((arcs & 1) != 0) {
        fields[i] = static_cast<uint16_t>(unit | linked::kArcField);
        unit += linked::kArcUnits;
      } else {
        fields[i] = static_cast<uint16_t>(unit);
        unit += linked::kLineUnits;
      }
      arcs >>= 1;
    }
  }

  // The references of the tiles go to the heap from `slot` on.
  Status tile_row(uint32_t row, uint32_t slot) noexcept {
    recall_shared_fields(glyph_.tiles_x * uint32_t{shared_.rows});
    x_u_ = glyph_.x0_u;
    y_u_ = glyph_.y0_u + packed::kTileU * static_cast<int32_t>(row);
    for (uint32_t i = 0; i < glyph_.tiles_x; ++i) {
      INKCELL_TRY(tile_tree(slot + i));
      x_u_ += packed::kTileU;
    }
    return Status::ok;
  }

  // The squares of one tile, in the order of the stream. Not part of its
  // callers, so that what it keeps in registers stays there.
  //
  // Invariant: `slot` is where the reference of the next square goes, `path`
  // has the two bits of each step from the tile to it, and slots[i] is the slot
  // of the divided square of 2^i u around it. Every turn of the loop fills in
  // one reference, or makes four, or ends it: the heap bounds what any bytes
  // can cost.
  __attribute__((noinline)) Status tile_tree(uint32_t slot) noexcept {
    BitStream bits = bits_;
    uint16_t slots[packed::kTileLog2 + 1];
    uint32_t log2 = packed::kTileLog2;
    uint32_t path = 0;
    static_assert(packed_codes::kNodeMaxBits + detail::kFieldBits <= 16,
                  "bits for a node and a field");
    while (true) {
      bits.fill();
      const uint32_t entry = kNodeTables.of[log2][bits.peek(detail::kNodeBits)];
      bits.drop(entry & 15);
      uint32_t symbol = entry >> 4;
      if (symbol < detail::kOneField) {
        if (symbol == detail::kDivided) {
          const uint32_t node = units_;
          if (log2 == 0) {
            return Status::corrupt;
          }
          if (!take(linked::kNodeUnits)) {
            return Status::buffer_small;
          }
          store_u16(at(slot), linked::reference(linked::kNode, node));
          slots[log2] = static_cast<uint16_t>(slot);
          slot = node;
          path <<= 2;
          --log2;
          continue;
        }
        if (symbol == detail::kLongNode) {
          symbol = long_node(bits, log2);
        }
      }
      uint32_t reference = symbol - detail::kEmpty;
      if (symbol >= detail::kOneField) {
        INKCELL_TRY(cell(bits, symbol, log2, path, reference));
      }
      store_u16(at(slot), reference);
      for (++path; (path & 3) == 0; path >>= 2) {
        ++log2;
        slot = slots[log2];
      }
      if (log2 == packed::kTileLog2) {
        bits_ = bits;
        return Status::ok;
      }
      ++slot;
    }
  }

  // Reads the fields of a cell, brings them to the front of the list, and makes
  // the reference to them. What a node's symbol left of 16 bits is available.
  //
  // Fields that were in the list come by ascending rank, so that one that is
  // moved does not change the place of the next. If the operator nests, those
  // behind the first are a group of their own: ranks count from the start
  // again, behind the first field, and pass the hole that it left if it was in
  // the list.
  Status cell(BitStream& bits,
              uint32_t symbol,
              uint32_t log2,
              uint32_t path,
              uint32_t& reference) noexcept {
    const uint32_t count = symbol >> detail::kOperatorBits;
    recent_.trim();
    uint32_t next = recent_.begin();  // where ranks count from
    uint32_t hole = recent_.end();
    uint32_t context = 0;
    // Written out, so that places and contexts are constants, unless code
    // shall be small.
#pragma GCC unroll(detail::kFastRows ? 3 : 1)
    for (uint32_t i = 0; i < 3;) {
      const uint32_t entry =
          kFieldTables.of[context][bits.peek(detail::kFieldBits)];
      bits.drop(entry & 7);
      uint32_t rank = entry >> 3;
      if (rank == detail::kLongRank) {
        rank = long_rank(bits, detail::rank_context(context));
      }
      context = 2 * i + 2;
      if (rank > detail::kLongRank) {
        bits_ = bits;
        const uint32_t unit =
            new_field(rank - detail::kNewField, log2, path << 2 | 3);
        if (unit >= kCorrupt) {
          return failure(unit);
        }
        bits = bits_;
        recent_.insert(unit, i);
        ++context;
        next = recent_.end();
      } else {
        uint32_t at = next + rank;
        next = at + 1;
        if (at >= hole) {
          if (at == hole || at > recent_.end()) {
            return Status::corrupt;
          }
          --at;
        }
        recent_.move(at, i);
      }
      if (++i == count) {
        break;
      }
      if (symbol >= detail::kNested && i == 1) {
        hole = next;
        next = recent_.begin() + 1;
        context = detail::kSecondGroup;
      }
      bits.fill();
    }
    const uint16_t* const fields = recent_.front();
    const uint32_t block = units_;
    uint8_t* to = at(block);
    if (count == 1) {
      const uint32_t unit = fields[0];
      reference = linked::reference(linked::kLine + (unit >> 15),
                                    unit & linked::kOffsetMask);
    } else if (count == 2) {
      if (!take(linked::kPairUnits)) {
        return Status::buffer_small;
      }
      store_u16(to, fields[0]);
      store_u16(to + 2, fields[1]);
      reference = linked::reference(
          linked::kMinPair + symbol - detail::kTwoFields, block);
    } else {
      if (!take(linked::kTripleUnits)) {
        return Status::buffer_small;
      }
      store_u16(to, symbol & (detail::kOneField - 1));
      store_u16(to + 2, fields[0]);
      store_u16(to + 4, fields[1]);
      store_u16(to + 6, fields[2]);
      reference = linked::reference(linked::kTriple, block);
    }
    return Status::ok;
  }

  static uint32_t long_node(BitStream& bits, uint32_t log2) noexcept {
    const uint32_t entry =
        kNodeTables.long_node[log2][bits.peek(packed_codes::kNodeMaxBits) -
                                    detail::kFirstLongNode];
    bits.drop(entry & 15);
    return entry >> 4;
  }
  static uint32_t long_rank(BitStream& bits, uint32_t context) noexcept {
    bits.fill();
    const uint32_t entry =
        kFieldTables.long_rank[context][bits.peek(packed_codes::kRankMaxBits) -
                                        detail::kFirstLongRank];
    bits.drop(entry & 15);
    return entry >> 4;
  }

  // Reads a field, adds it to the heap, and says where it is; or kNoRoom or
  // kCorrupt. `path` leads from the tile to the anchor, a step farther than to
  // the square. Not part of the tree, whose registers it needs.
  __attribute__((noinline)) uint32_t new_field(uint32_t kind_bits,
                                               uint32_t log2,
                                               uint32_t path) noexcept {
    const PackedCoding& coding = glyph_.coding;
    const auto kind = static_cast<FieldKind>(kind_bits);
    BitStream bits = bits_;
    if (widths_[log2] == 0) {
      widths_[log2] = static_cast<uint16_t>(
          coding.d0_bits(log2) | coding.angle_bits(log2) << kAngleShift |
          coding.bend_bits(log2) << kBendShift | kKnown);
    }
    const uint32_t widths = widths_[log2];
    const uint32_t d0_bits = widths & 31;
    const int32_t d0 = static_cast<int32_t>(bits.number(d0_bits)) -
                       static_cast<int32_t>((1u << d0_bits) >> 1);
    const uint32_t angle_bits =
        has_angle(kind) ? widths >> kAngleShift & 31 : 2;
    const uint32_t turn = bits.number(angle_bits) << (16 - angle_bits);
    int32_t bend = 0;
    if (is_bent(kind)) {
      uint32_t high = 0;
      for (bits.fill(); bits.peek(1) != 0; bits.drop(1)) {
        ++high;
        if (high > packed::kMaxUnary) {
          return kCorrupt;
        }
      }
      bits.drop(1);
      // The sign is behind the lower bits.
      const uint32_t low_bits = widths >> kBendShift & 15;
      const uint32_t low = bits.number(low_bits + 1);
      bend = static_cast<int32_t>((high << low_bits | low >> 1) + 1);
      bend = (low & 1) != 0 ? -bend : bend;
    }
    bits_ = bits;
    const uint32_t unit = units_;
    if (!take(linked::kLineUnits)) {
      return kNoRoom;
    }
    // The bits of y to the upper half, then all next to each other.
    uint32_t way = path << 2 * log2 >> 2;
    way = (way & 0x5555) | (way & 0xaaaa) << 15;
    way = (way | way >> 1) & 0x33333333;
    way = (way | way >> 2) & 0x0f0f0f0f;
    way |= way >> 4;
    const detail::Anchor anchor = {
        x_u_ + static_cast<int32_t>(way & 0xff),
        y_u_ + static_cast<int32_t>(way >> 16 & 0xff)};
    const detail::Normal n = detail::normal_of(turn);
    uint8_t* const to = at(unit);
    namespace fields = format::fields;
    store_u16(to + fields::kNormalX, static_cast<uint16_t>(n.x));
    store_u16(to + fields::kNormalY, static_cast<uint16_t>(n.y));
    store_u16(to + fields::kOffset,
              static_cast<uint16_t>(detail::offset_q4(d0, coding, n, anchor)));
    if (bend == 0) {
      return unit;
    }
    const int32_t curvature = detail::curvature(bend, coding, log2);
    if (curvature == 0) {
      return unit;
    }
    if (!take(linked::kArcUnits - linked::kLineUnits)) {
      return kNoRoom;
    }
    store_u16(to + fields::kAlong,
              static_cast<uint16_t>(detail::along_q4(n, anchor)));
    store_u16(to + fields::kBend, static_cast<uint16_t>(curvature));
    return unit | linked::kArcField;
  }

  RecentFields recent_;
  const PackedGlyph& glyph_;
  SharedFields& shared_;
  uint8_t* heap_;
  uint32_t room_;       // [units]
  uint32_t units_ = 0;  // that are taken
  BitStream bits_;
  int32_t x_u_ = 0;  // lower left corner of the tile
  int32_t y_u_ = 0;
  uint16_t widths_[kSizes] = {};  // by log2 of the square; 0: not known yet
};

// Not inline: the caller's frame holds a view of the result.
__attribute__((noinline)) Status expand_heap(const PackedGlyph& glyph,
                                             uint32_t first_row,
                                             uint32_t row_count,
                                             Workspace workspace,
                                             SharedFields& shared,
                                             uint16_t& heap_units) noexcept {
  Expansion expansion(glyph, workspace, shared);
  INKCELL_TRY(expansion.rows(first_row, row_count));
  heap_units = static_cast<uint16_t>(expansion.units());
  return Status::ok;
}

}  // namespace

namespace {

// PackedGlyph::open, into a glyph that is as it was constructed, but for its
// coding.
Status read_packed_record(Span<const uint8_t> record,
                          PackedGlyph& glyph) noexcept {
  constexpr int32_t kLimit = format::fields::kGridLimit;
  if (record.size < packed::kRowLengths) {
    return Status::corrupt;
  }
  const uint8_t* at = record.data;
  if (INKCELL_PACKED == 0 ||
      (at[packed::kType] & ~packed::kWideRows) != packed::kTypePacked) {
    return Status::unsupported;
  }
  glyph.record = record;
  glyph.wide_rows = (at[packed::kType] & packed::kWideRows) != 0;
  glyph.tiles_x = at[packed::kTiles] & 15;
  glyph.tiles_y = at[packed::kTiles] >> 4;
  glyph.x0_u = packed::i12(at[packed::kX0Y0] | at[packed::kX0Y0 + 1] << 8);
  glyph.y0_u =
      packed::i12(at[packed::kX0Y0 + 1] >> 4 | at[packed::kX0Y0 + 2] << 4);
  return glyph.tiles_x == 0 || glyph.tiles_y == 0 || glyph.x0_u < -kLimit ||
                 glyph.y0_u < -kLimit ||
                 glyph.x0_u + packed::kTileU * glyph.tiles_x > kLimit ||
                 glyph.y0_u + packed::kTileU * glyph.tiles_y > kLimit ||
                 packed::streams_at(glyph.tiles_y, glyph.wide_rows) >
                     record.size
             ? Status::corrupt
             : Status::ok;
}

}  // namespace

Status PackedGlyph::open(Span<const uint8_t> record,
                         const PackedCoding& coding,
                         PackedGlyph& out) noexcept {
  PackedGlyph glyph;
  glyph.coding = coding;
  INKCELL_TRY(read_packed_record(record, glyph));
  out = glyph;
  return Status::ok;
}

Status detail::read_packed(const Font& font,
                           uint16_t glyph,
                           PackedGlyph& out) noexcept {
  if (glyph >= font.glyph_count()) {
    return Status::no_glyph;
  }
  const Span<const uint8_t> record = font.record(glyph);
  if (record.size != 0) {
    out.coding =
        PackedCoding::read(font.rom().data + format::header::kQuantisation);
    INKCELL_TRY(read_packed_record(record, out));
    out.ink = font.ink_box(glyph);
    out.glyph = glyph;
  }
  return Status::ok;
}

Status PackedGlyph::open(const Font& font,
                         uint16_t glyph,
                         PackedGlyph& out) noexcept {
  PackedGlyph read;
  INKCELL_TRY(detail::read_packed(font, glyph, read));
  out = read;
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

Status detail::expand_rows(const PackedGlyph& glyph,
                           uint32_t first_row,
                           uint32_t row_count,
                           Workspace workspace,
                           SharedFields& shared,
                           GlyphField& out) noexcept {
  if (INKCELL_PACKED == 0) {
    return Status::unsupported;
  }
  if (first_row > glyph.tiles_y || row_count > glyph.tiles_y - first_row ||
      reinterpret_cast<uintptr_t>(workspace.data) % 2 != 0) {
    return Status::bad_argument;
  }
  uint16_t heap_units = 0;
  INKCELL_TRY(
      expand_heap(glyph, first_row, row_count, workspace, shared, heap_units));
  out = glyph.grid(first_row, row_count);
  out.references = workspace.data;
  out.cells = workspace.data;
  out.heap_units = heap_units;
  return Status::ok;
}

Status expand(const PackedGlyph& glyph,
              uint32_t first_row,
              uint32_t row_count,
              Workspace workspace,
              GlyphField& out) noexcept {
  detail::SharedFields shared;
  return detail::expand_rows(glyph, first_row, row_count, workspace, shared,
                             out);
}

}  // namespace inkcell
