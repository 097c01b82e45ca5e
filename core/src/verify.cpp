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

// Every reference names something that exists; a node's children come after it,
// so that the tree is finite, and it has a square left to divide.
bool field_fits(const GlyphField& field) noexcept {
  const uint32_t tiles = uint32_t{field.tiles_x} * field.tiles_y;
  const uint32_t count = tiles + 4u * field.node_count;
  for (uint32_t i = 0; i < count; ++i) {
    const uint32_t reference = load_u16(field.references + 2 * i);
    if (reference >= format::glyph::kCellFlag) {
      const uint32_t cell = reference & ~uint32_t{format::glyph::kCellFlag};
      if (cell >= field.cell_count) {
        return false;
      }
    } else if (reference >= format::glyph::kFirstNode) {
      const uint32_t node = reference - format::glyph::kFirstNode;
      if (node >= field.node_count) {
        return false;
      }
      if (i >= tiles && node <= (i - tiles) / 4) {
        return false;
      }
    }
  }
  return true;
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
    const uint8_t* offset = glyphs_.data + 4 * glyph;
    GlyphField opened;
    INKCELL_TRY(field(static_cast<uint16_t>(glyph), opened));
    const bool empty = load_u32(offset) == load_u32(offset + 4);
    if ((!empty && record(static_cast<uint16_t>(glyph)).size == 0) ||
        !field_fits(opened)) {
      return Status::corrupt;
    }
  }
  return Status::ok;
}

}  // namespace inkcell
