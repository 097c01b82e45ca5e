#include "glyph_store.hpp"

namespace inkcell::detail {
namespace {

// One hint for as many bytes.
constexpr size_t kBytesPerHint = 64;

}  // namespace

void GlyphStore::open(Span<uint8_t> ram,
                      const GlyphCacheOptions& options) noexcept {
  ram_end_ = ram.data + (ram.size & ~size_t{3});
  clock_ = 0;
  options_ = options;
  phase_shift_ = 10;
  for (uint32_t phases = options.phases; phases != 1; phases /= 2) {
    --phase_shift_;
  }
  uint32_t hints = 1;
  while (hints * 2 * kBytesPerHint <= ram.size) {
    hints *= 2;
  }
  hint_mask_ = hints - 1;
  hints_ = reinterpret_cast<uint16_t*>(slots() + options.styles);
  data_ = reinterpret_cast<uint8_t*>(hints_ + hints);
  counted_ = {};
  counted_.capacity = static_cast<uint32_t>(ram.size);
  clear();
}

void GlyphStore::clear() noexcept {
  for (uint32_t i = 0; i < options_.styles; ++i) {
    slots()[i].used = 0;
  }
  for (uint32_t i = 0; i <= hint_mask_; ++i) {
    hints_[i] = 0;
  }
  count_ = 0;
  data_size_ = 0;
}

CachedStyle* GlyphStore::slots() const noexcept {
  return reinterpret_cast<CachedStyle*>(const_cast<GlyphStore*>(this) + 1);
}

CachedGlyph& GlyphStore::entry(uint32_t index) const noexcept {
  return reinterpret_cast<CachedGlyph*>(
      ram_end_)[-1 - static_cast<int32_t>(index)];
}

int32_t GlyphStore::capacity() const noexcept {
  return static_cast<int32_t>(ram_end_ - data_);
}

int32_t GlyphStore::room() const noexcept {
  return capacity() -
         static_cast<int32_t>(data_size_ + count_ * sizeof(CachedGlyph));
}

GlyphCacheStats GlyphStore::stats() const noexcept {
  GlyphCacheStats stats = counted_;
  stats.glyphs = count_;
  stats.bytes = stats.capacity - static_cast<uint32_t>(room());
  return stats;
}

void GlyphStore::add(const CachedGlyph& glyph) noexcept {
  ++count_;
  CachedGlyph& added = entry(count_ - 1);
  added = glyph;
  added.used = clock_;
  added.begin = static_cast<uint16_t>(data_size_);
}

void GlyphStore::remove(uint32_t index) noexcept {
  const size_t begin = entry(index).begin;
  const size_t end = index + 1 == count_ ? data_size_ : entry(index + 1).begin;
  const size_t size = end - begin;
  __builtin_memmove(data_ + begin, data_ + end, data_size_ - end);
  data_size_ -= size;
  --count_;
  for (uint32_t i = index; i != count_; ++i) {
    entry(i) = entry(i + 1);
    entry(i).begin = static_cast<uint16_t>(entry(i).begin - size);
  }
  ++counted_.evictions;
}

bool GlyphStore::evict(uint32_t kept) noexcept {
  if (count_ <= kept) {
    return false;
  }
  uint32_t oldest = 0;
  for (uint32_t i = 1; i + kept < count_; ++i) {
    if (clock_ - entry(i).used > clock_ - entry(oldest).used) {
      oldest = i;
    }
  }
  remove(oldest);
  return true;
}

uint32_t GlyphStore::slot_of(const Font& font,
                             const Style& style,
                             uint8_t channels) noexcept {
  ++clock_;
  const uint8_t* const rom = font.rom().data;
  uint32_t oldest = 0;
  for (uint32_t i = 0; i < options_.styles; ++i) {
    CachedStyle& slot = slots()[i];
    if (slot.used != 0 && slot.rom == rom && slot.channels == channels &&
        is_same(slot.style, style)) {
      slot.used = clock_;
      return i;
    }
    // One that was never used is the oldest.
    const uint32_t oldest_used = slots()[oldest].used;
    if (oldest_used != 0 &&
        (slot.used == 0 || clock_ - slot.used > clock_ - oldest_used)) {
      oldest = i;
    }
  }
  for (uint32_t i = count_; i != 0; --i) {
    if (entry(i - 1).key >> 28 == oldest) {
      remove(i - 1);
    }
  }
  slots()[oldest] = {style, rom, clock_, channels};
  return oldest;
}

const CachedGlyph* GlyphStore::find(uint32_t key) noexcept {
  const uint32_t hashed = key ^ key >> 8 ^ key >> 18;
  uint16_t& hint = hints_[hashed & hint_mask_];
  if (hint >= count_ || entry(hint).key != key) {
    uint32_t i = 0;
    while (i != count_ && entry(i).key != key) {
      ++i;
    }
    if (i == count_) {
      return nullptr;
    }
    hint = static_cast<uint16_t>(i);
  }
  CachedGlyph& found = entry(hint);
  found.used = ++clock_;
  return &found;
}

}  // namespace inkcell::detail
