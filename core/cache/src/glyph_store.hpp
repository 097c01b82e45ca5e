// Which glyphs a cache holds, and where in its RAM they lie.
//
// The RAM: the store, slots (fonts with their styles), hints (where entries may
// be found), data (recorded rows, in the order of their entries), room, and
// entries, the first one last.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "inkcell/cache/glyph_cache.hpp"

namespace inkcell::detail {

// A glyph at a phase.
struct __attribute__((may_alias)) CachedGlyph {
  uint32_t key;    // see GlyphStore::find()
  uint32_t used;   // when
  uint16_t begin;  // of its data
  // Its pixels, from that of its origin.
  int16_t x0;
  int16_t y0;
  uint8_t width;
  uint8_t rows;
};

// A font and a style.
struct __attribute__((may_alias)) CachedStyle {
  Style style;
  const uint8_t* rom;
  uint32_t used;     // when, or 0: never
  uint8_t channels;  // of a pixel
};

class __attribute__((may_alias)) GlyphStore {
 public:
  // Empties `ram`, of at most 65,535 bytes, which holds the store.
  void open(Span<uint8_t> ram, const GlyphCacheOptions& options) noexcept;
  void clear() noexcept;

  const GlyphCacheOptions& options() const noexcept { return options_; }
  // From px, Q10, to phases.
  uint32_t phase_shift() const noexcept { return phase_shift_; }

  // The slot of a font and a style, which may have to take that of others.
  uint32_t slot_of(const Font& font,
                   const Style& style,
                   uint8_t channels) noexcept;

  // The entry of a key, which is used then; null: there is none. Keys are the
  // slot (4 bits), the phases down and across (6 bits each), and the glyph.
  const CachedGlyph* find(uint32_t key) noexcept;

  // Adds an entry without data. There must be room for it.
  void add(const CachedGlyph& glyph) noexcept;
  // The last entry, and bytes behind its data.
  const CachedGlyph& last() const noexcept { return entry(count_ - 1); }
  void add_bytes(size_t count) noexcept { data_size_ += count; }
  // Removes the entry that was drawn the longest time ago, but none of the last
  // `kept`. False: there is no other.
  bool evict(uint32_t kept) noexcept;

  // Where all data ends.
  uint8_t* data_end() const noexcept { return data_ + data_size_; }
  // Where the data of an entry begins.
  const uint8_t* begin_of(const CachedGlyph& glyph) const noexcept {
    return data_ + glyph.begin;
  }

  // Between data and entries, and that of an empty store. [bytes]
  int32_t room() const noexcept;
  int32_t capacity() const noexcept;

  // Counters, and what is held.
  GlyphCacheStats stats() const noexcept;
  void count_hit() noexcept { ++counted_.hits; }
  void count_drawn(bool is_kept) noexcept {
    ++(is_kept ? counted_.misses : counted_.bypasses);
  }

 private:
  CachedStyle* slots() const noexcept;
  CachedGlyph& entry(uint32_t index) const noexcept;
  void remove(uint32_t index) noexcept;

  uint16_t* hints_;
  uint8_t* data_;
  uint8_t* ram_end_;
  size_t data_size_;    // [bytes]
  uint32_t count_;      // of entries
  uint32_t hint_mask_;  // their number less 1
  uint32_t clock_;
  GlyphCacheOptions options_;
  uint8_t phase_shift_;
  GlyphCacheStats counted_;
};

}  // namespace inkcell::detail
