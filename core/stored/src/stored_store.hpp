// The blocks of a stored font that are in RAM, and its pages as fonts.
//
// The RAM: the store, the resident bytes, the blocks, their slots. The first
// block is the window: a page is copied there to be drawn, because the hints of
// the resident font end where its own begin.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "inkcell/stored/stored_font.hpp"

namespace inkcell::detail {

class __attribute__((may_alias)) StoredStore : public FontPages {
 public:
  // Fills in a store that lies at the beginning of `ram`.
  Status open(const Storage& storage,
              Span<uint8_t> ram,
              const Coding& coding) noexcept;
  void clear() noexcept;
  Status verify() noexcept;

  const Font& font() const noexcept { return font_; }
  Status status() const noexcept { return status_; }
  StoredStats stats() const noexcept { return stats_; }
  // Of section COLR, behind the pairs; and a word of it (StoredLayers).
  uint32_t layers_bytes() const noexcept;
  static uint32_t layers_word(const Font& font, uint32_t at) noexcept;

  // The font and the id there that draw a glyph of `font`, which is font() or a
  // copy of it; null: there is no such glyph.
  static const Font* font_to_draw(const Font& font, uint32_t& glyph) noexcept;

 private:
  struct __attribute__((may_alias)) Slot {
    uint32_t block;  // 0: none; the resident bytes are block 0 of the file
    uint32_t used;   // when
  };
  enum class Key : bool { glyph, code_point };

  // In the caller's RAM, which is not constant.
  static StoredStore& store_of(const FontPages& pages) noexcept {
    return const_cast<StoredStore&>(static_cast<const StoredStore&>(pages));
  }
  static Status glyph_of_code(const FontPages& pages,
                              uint32_t code_point,
                              uint16_t& glyph) noexcept;
  static const Font* page_of_glyph(const FontPages& pages,
                                   uint32_t& glyph) noexcept;
  static int32_t kerning_of(const FontPages& pages,
                            uint16_t left,
                            uint16_t right) noexcept;
  static int32_t measure_none(const FontPages& pages,
                              uint16_t glyph,
                              GlyphMetrics* out) noexcept;

  Status read_header(uint32_t ram_bytes) noexcept;
  Status open_font(const Coding& coding) noexcept;
  Status fail(Status why) noexcept;
  bool read_block(uint32_t slot, uint32_t block) noexcept;
  uint32_t find_slot(uint32_t block) const noexcept;
  uint32_t oldest_slot() const noexcept;
  const uint8_t* load_index(uint32_t block) noexcept;
  bool load_page(uint32_t block) noexcept;
  bool open_page() noexcept;
  uint32_t find_page(Key key, uint32_t value) noexcept;
  bool slot_holds(uint32_t slot, Key key, uint32_t value) const noexcept;
  bool load_page_of(Key key, uint32_t value) noexcept;
  bool has_page() const noexcept {
    return page_block_ != 0 && slots()[0].block == page_block_;
  }
  bool page_holds(uint32_t glyph) const noexcept;
  uint32_t last_page() const noexcept {
    return index_counts_[0] + index_counts_[1] + page_count_;
  }
  uint32_t before_layers() const noexcept {
    return last_page() + (kern_end_ != 0 ? 1 : 0);
  }

  uint8_t* resident() const noexcept {
    return reinterpret_cast<uint8_t*>(const_cast<StoredStore*>(this) + 1);
  }
  uint8_t* bytes_of(uint32_t slot) const noexcept {
    return resident() + resident_bytes_ + slot * block_bytes_;
  }
  Slot* slots() const noexcept {
    return reinterpret_cast<Slot*>(bytes_of(slot_count_));
  }

  Storage storage_;
  Font font_;  // resident: .notdef, and the hooks of paged fonts
  Font page_;  // in the window
  StoredStats stats_;
  uint32_t clock_;
  uint32_t page_block_;       // that page_ is of; 0: none
  uint32_t index_counts_[2];  // blocks of the index from the root to the pages
  uint32_t slot_count_;
  uint16_t page_count_;   // of the file
  uint16_t first_glyph_;  // of page_
  uint16_t glyph_end_;    // one more than the last id
  uint16_t kern_end_;     // the same of the last one that kerns
  uint16_t resident_bytes_;
  uint16_t font_offset_;
  uint16_t block_bytes_;
  uint8_t levels_;
  uint8_t roots_;
  Status status_;
};

}  // namespace inkcell::detail
