// From code points to glyphs.
#include "base/bytes.hpp"
#include "inkcell/font.hpp"
#include "inkcell/format/rom.hpp"

namespace inkcell {

using detail::load_u16;
using detail::load_u32;

// The number of a code point's glyph by CMAP, glyph_count_ or more: none.
inline uint32_t Font::find_run(uint32_t code_point) const noexcept {
  namespace cmap = format::cmap;
  // Invariant: an entry that holds the code point has an index below `end`,
  // and all entries below `begin` start at or before it.
  uint32_t begin = 0;
  uint32_t end = static_cast<uint32_t>(cmap_table().size) / cmap::kBytes;
  while (begin < end) {
    const uint32_t middle = begin + (end - begin) / 2;
    if (load_u32(cmap_table().data + middle * cmap::kBytes + cmap::kFirst) <=
        code_point) {
      begin = middle + 1;
    } else {
      end = middle;
    }
  }
  if (begin != 0) {
    const uint8_t* entry = cmap_table().data + (begin - 1) * cmap::kBytes;
    const uint32_t step = code_point - load_u32(entry + cmap::kFirst);
    if (step <= load_u16(entry + cmap::kExtra)) {
      return load_u16(entry + cmap::kFirstGlyph) + step;
    }
  }
  return UINT32_MAX;
}

// The same by CPAG.
inline uint32_t Font::find_on_page(uint32_t code_point) const noexcept {
  namespace pages = format::code_pages;
  const Span<const uint8_t>& table = code_pages_;
  if (table.size < pages::kBytes) {
    return UINT32_MAX;
  }
  const uint32_t count = load_u16(table.data + pages::kPages);
  const uint32_t page =
      (code_point >> 8) - load_u16(table.data + pages::kFirstPage);
  if (page >= count || pages::kBytes + 2 * (count + 1) > table.size) {
    return UINT32_MAX;
  }
  const uint8_t* const starts = table.data + pages::kBytes + 2 * page;
  const uint32_t end = load_u16(starts + 2);
  for (uint32_t i = load_u16(starts); i < end && i < table.size; ++i) {
    if (table.data[i] == (code_point & 255)) {
      return (load_u16(table.data + pages::kGlyphBase) + i) & 0xffff;
    }
  }
  return UINT32_MAX;
}

Status Font::glyph_of(uint32_t code_point, uint16_t& glyph) const noexcept {
  uint32_t id = find_run(code_point);
  if (id >= glyph_count_) {
    id = find_on_page(code_point);
    if (id >= glyph_count_) {
      glyph = 0;
      return pages_ != nullptr ? pages_->glyph_of(*pages_, code_point, glyph)
                               : Status::no_glyph;
    }
  }
  glyph = static_cast<uint16_t>(id);
  return Status::ok;
}

}  // namespace inkcell
