// Font::verify: everything that `open` leaves to the moment of reading.
#include "bytes.hpp"
#include "crc.hpp"
#include "inkcell/font.hpp"
#include "inkcell/format.hpp"

namespace inkcell {
namespace {

using detail::load_u16;
using detail::load_u32;

// Code points ascend without overlap, and every glyph exists.
bool cmap_fits(Span<const uint8_t> cmap, uint32_t glyph_count) noexcept {
  if (cmap.size % format::cmap::kBytes != 0) {
    return false;
  }
  uint32_t next = 0;
  for (size_t i = 0; i < cmap.size; i += format::cmap::kBytes) {
    const uint8_t* entry = cmap.data + i;
    const uint32_t first = load_u32(entry + format::cmap::kFirst);
    const uint32_t extra = load_u16(entry + format::cmap::kExtra);
    const uint32_t glyph = load_u16(entry + format::cmap::kFirstGlyph);
    if (first < next || first > 0x10ffff || glyph + extra >= glyph_count) {
      return false;
    }
    next = first + extra + 1;
  }
  return true;
}

bool classes_fit(const uint8_t* classes,
                 uint32_t glyph_count,
                 uint32_t class_bytes,
                 uint32_t class_count) noexcept {
  for (uint32_t i = 0; i < glyph_count; ++i) {
    const uint32_t found =
        class_bytes == 1 ? classes[i] : load_u16(classes + 2 * i);
    if (found > class_count) {
      return false;
    }
  }
  return true;
}

// The tree of one tile: every cell exists, nodes are numbered in the order in
// which one meets them (so that each has one parent and the tree is finite),
// and none divides a square of 1 u. `next_node` is the number that comes next.
bool tile_fits(const GlyphField& field,
               uint32_t tile,
               uint32_t& next_node) noexcept {
  const uint32_t tiles = uint32_t{field.tiles_x} * field.tiles_y;
  // References still to visit at each level: where, and how many.
  uint32_t at[format::glyph::kMaxTileLog2 + 1];
  uint8_t left[format::glyph::kMaxTileLog2 + 1];
  uint32_t level = 0;
  at[0] = tile;
  left[0] = 1;
  while (true) {
    if (left[level] == 0) {
      if (level == 0) {
        return true;
      }
      --level;
      continue;
    }
    const uint32_t reference = load_u16(field.references + 2 * at[level]);
    ++at[level];
    --left[level];
    if (reference >= format::glyph::kCellFlag) {
      const uint32_t cell = reference & ~uint32_t{format::glyph::kCellFlag};
      if (cell >= field.cell_count) {
        return false;
      }
    } else if (reference >= format::glyph::kFirstNode) {
      const uint32_t node = reference - format::glyph::kFirstNode;
      if (node != next_node || node >= field.node_count ||
          level == field.tile_log2) {
        return false;
      }
      ++next_node;
      ++level;
      at[level] = tiles + 4 * node;
      left[level] = 4;
    }
  }
}

bool field_fits(const GlyphField& field) noexcept {
  const uint32_t tiles = uint32_t{field.tiles_x} * field.tiles_y;
  uint32_t next_node = 0;
  for (uint32_t tile = 0; tile < tiles; ++tile) {
    if (!tile_fits(field, tile, next_node)) {
      return false;
    }
  }
  return next_node == field.node_count;
}

// Whether a glyph's offsets, `offset[0]` and `offset[1]`, frame a record.
bool offsets_fit(const uint8_t* offset,
                 size_t glyphs_size,
                 uint32_t glyph_count) noexcept {
  const uint32_t begin = load_u32(offset);
  const uint32_t end = load_u32(offset + 4);
  return begin % 4 == 0 && begin >= 4 * (glyph_count + 1) && begin <= end &&
         end <= glyphs_size;
}

}  // namespace

Status Font::verify() const noexcept {
  if (rom_.size == 0) {
    return Status::corrupt;
  }
  namespace header = format::header;
  const uint32_t header_bytes = load_u16(rom_.data + header::kHeaderBytes);
  if (header_bytes > rom_.size) {
    return Status::corrupt;
  }
  const uint32_t crc =
      detail::crc32(0, {rom_.data + header_bytes, rom_.size - header_bytes});
  if (crc != load_u32(rom_.data + header::kContentCrc) ||
      !cmap_fits(cmap_, glyph_count_)) {
    return Status::corrupt;
  }
  if (kerning_.size != 0) {
    const uint8_t* left = kerning_.data + format::kerning::kBytes;
    const uint8_t* right = left + uint32_t{glyph_count_} * class_bytes_;
    if (!classes_fit(left, glyph_count_, class_bytes_, left_classes_) ||
        !classes_fit(right, glyph_count_, class_bytes_, right_classes_)) {
      return Status::corrupt;
    }
  }
  for (uint32_t glyph = 0; glyph < glyph_count_; ++glyph) {
    if (!offsets_fit(glyphs_.data + 4 * glyph, glyphs_.size, glyph_count_)) {
      return Status::corrupt;
    }
    GlyphField opened;
    INKCELL_TRY(field(static_cast<uint16_t>(glyph), opened));
    if (!field_fits(opened)) {
      return Status::corrupt;
    }
  }
  return Status::ok;
}

}  // namespace inkcell
