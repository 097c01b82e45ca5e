#include "stored_store.hpp"

#include "base/bytes.hpp"
#include "base/crc.hpp"
#include "font/font_tables.hpp"
#include "inkcell/coding.hpp"
#include "inkcell/format/rom.hpp"
#include "inkcell/stored/paged.hpp"
#include "inkcell/version.hpp"
#include "rows/source.hpp"

namespace inkcell::detail {
namespace {

namespace paged = format::paged;
namespace entry = format::paged::entry;
namespace trailer = format::paged::trailer;

}  // namespace

Status StoredStore::open(const Storage& storage,
                         Span<uint8_t> ram,
                         const Coding& coding) noexcept {
  glyph_of = glyph_of_code;
  page_of = page_of_glyph;
  kerning = kerning_of;
  measure = measure_none;
  storage_ = storage;
  stats_ = {};
  clock_ = 0;
  status_ = Status::ok;
  INKCELL_TRY(
      read_header(static_cast<uint32_t>(ram.size - sizeof(StoredStore))));
  clear();
  return open_font(coding);
}

// Reads the resident bytes, and takes the numbers of their header. `ram_bytes`
// from there on, kMaxResidentBytes at least.
Status StoredStore::read_header(uint32_t ram_bytes) noexcept {
  const uint8_t* const at = resident();
  ++stats_.reads;
  stats_.bytes += paged::kMaxResidentBytes;
  if (!storage_.read(storage_.context, 0, resident(),
                     paged::kMaxResidentBytes)) {
    return Status::read_failed;
  }
  if (load_u32(at + paged::kMagicAt) != paged::kMagic) {
    return Status::bad_magic;
  }
  if (!reads_format(at[paged::kFormatMajor], at[paged::kFormatMinor])) {
    return Status::bad_version;
  }
  resident_bytes_ = load_u16(at + paged::kResidentBytes);
  block_bytes_ = load_u16(at + paged::kBlockBytes);
  font_offset_ = load_u16(at + paged::kFontOffset);
  glyph_end_ = load_u16(at + paged::kGlyphEnd);
  levels_ = at[paged::kLevels];
  roots_ = at[paged::kRoots];
  page_count_ = load_u16(at + paged::kPages);
  kern_end_ = load_u16(at + paged::kKernEnd);
  if (resident_bytes_ % 4 != 0 || resident_bytes_ > paged::kMaxResidentBytes ||
      block_bytes_ % paged::kMinBlockBytes != 0 || block_bytes_ == 0 ||
      block_bytes_ > paged::kMaxBlockBytes || font_offset_ % 4 != 0 ||
      font_offset_ > resident_bytes_ || levels_ > paged::kMaxLevels ||
      paged::kBytes + roots_ * entry::kBytes > font_offset_) {
    return Status::corrupt;
  }
  const uint32_t crc =
      crc32(crc32(0, {at, paged::kHeaderCrc}),
            {at + paged::kContentCrc, resident_bytes_ - paged::kContentCrc});
  if (crc != load_u32(at + paged::kHeaderCrc)) {
    return Status::corrupt;
  }
  const uint32_t fan_out = block_bytes_ / entry::kBytes;
  uint32_t top = page_count_;
  index_counts_[0] = index_counts_[1] = 0;
  for (uint32_t level = levels_; level != 0; --level) {
    top = (top + fan_out - 1) / fan_out;
    index_counts_[level - 1] = top;
  }
  if (top != roots_) {
    return Status::corrupt;
  }
  slot_count_ = (ram_bytes - resident_bytes_) /
                (block_bytes_ + static_cast<uint32_t>(sizeof(Slot)));
  stats_.blocks = slot_count_;
  return slot_count_ == 0 ? Status::buffer_small : Status::ok;
}

Status StoredStore::open_font(const Coding& coding) noexcept {
  // Others do not look for a glyph's page.
  if (coding.source->load != nullptr) {
    return Status::unsupported;
  }
  const size_t bytes = size_t{resident_bytes_} - font_offset_;
  font_ = Font();
  INKCELL_TRY(Font::open({resident() + font_offset_, bytes}, coding, font_));
  page_ = font_;
  font_.tables_[0] = {};  // look-up is by the index
  font_.pages_ = this;
  return Status::ok;
}

void StoredStore::clear() noexcept {
  for (uint32_t i = 0; i != slot_count_; ++i) {
    slots()[i] = {0, 0};
  }
  page_block_ = 0;
  status_ = Status::ok;
}

Status StoredStore::fail(Status why) noexcept {
  ++stats_.failures;
  if (status_ == Status::ok) {
    status_ = why;
  }
  return why;
}

bool StoredStore::read_block(uint32_t slot, uint32_t block) noexcept {
  Slot& to = slots()[slot];
  to.block = 0;
  ++stats_.reads;
  stats_.bytes += block_bytes_;
  if (!storage_.read(storage_.context, block * block_bytes_, bytes_of(slot),
                     block_bytes_)) {
    static_cast<void>(fail(Status::read_failed));
    return false;
  }
  to.block = block;
  return true;
}

// slot_count_: none.
uint32_t StoredStore::find_slot(uint32_t block) const noexcept {
  uint32_t i = 0;
  while (i != slot_count_ && slots()[i].block != block) {
    ++i;
  }
  return i;
}

// But for the window, if there are others.
uint32_t StoredStore::oldest_slot() const noexcept {
  uint32_t oldest = slot_count_ == 1 ? 0 : 1;
  for (uint32_t i = oldest + 1; i < slot_count_; ++i) {
    if (clock_ - slots()[i].used > clock_ - slots()[oldest].used) {
      oldest = i;
    }
  }
  return oldest;
}

const uint8_t* StoredStore::load_index(uint32_t block) noexcept {
  uint32_t slot = find_slot(block);
  if (slot == slot_count_) {
    slot = oldest_slot();
    if (!read_block(slot, block)) {
      return nullptr;
    }
  }
  slots()[slot].used = ++clock_;
  return bytes_of(slot);
}

// Brings a page into the window. What was there goes to the place of the page,
// or to that of the block that was not used for the longest time.
bool StoredStore::load_page(uint32_t block) noexcept {
  uint32_t slot = find_slot(block);
  if (slot != 0) {
    const bool is_held = slot != slot_count_;
    slot = is_held ? slot : oldest_slot();
    uint8_t* const window = bytes_of(0);
    uint8_t* const other = bytes_of(slot);
    for (uint32_t i = 0; i != block_bytes_ && slot != 0; ++i) {
      const uint8_t byte = window[i];
      window[i] = other[i];
      other[i] = byte;
    }
    const Slot moved = slots()[0];
    slots()[0] = slots()[slot];
    slots()[slot] = moved;
    page_block_ = 0;
    if (!is_held && !read_block(0, block)) {
      return false;
    }
  }
  slots()[0].used = ++clock_;
  return page_block_ == block || open_page();
}

// Whether the block in the window is a page: the checks of Font::open().
bool StoredStore::open_page() noexcept {
  const uint8_t* const bytes = bytes_of(0);
  const uint8_t* const end = bytes + block_bytes_ - trailer::kBytes;
  const uint32_t records = load_u16(end + trailer::kRecords);
  const uint32_t run_bytes = end[trailer::kRuns] * format::cmap::kBytes;
  const uint32_t size = block_bytes_ - trailer::kBytes;
  first_glyph_ = load_u16(end + trailer::kFirstGlyph);
  page_.glyph_count_ = end[trailer::kGlyphs];
  if (run_bytes <= size && records <= size - run_bytes &&
      first_glyph_ >= font_.glyph_count_ &&
      first_glyph_ + page_.glyph_count_ <= glyph_end_ + 1u) {
    page_.tables_[0] = {end - run_bytes, run_bytes};
    page_.tables_[1] = {bytes, records};
    page_.tables_[2] = {bytes + records, size - run_bytes - records};
    if (page_.fit_tables()) {
      page_block_ = slots()[0].block;
      return true;
    }
  }
  slots()[0].block = 0;
  static_cast<void>(fail(Status::corrupt));
  return false;
}

// Whether the page in a slot has a key, as far as its own numbers say.
bool StoredStore::slot_holds(uint32_t slot,
                             Key key,
                             uint32_t value) const noexcept {
  const uint32_t block = slots()[slot].block;
  if (block <= index_counts_[0] + index_counts_[1] || block > last_page()) {
    return false;
  }
  const uint8_t* const end = bytes_of(slot + 1) - trailer::kBytes;
  if (key == Key::glyph) {
    const uint32_t first = load_u16(end + trailer::kFirstGlyph);
    return value >= first && value - first + 1 < end[trailer::kGlyphs];
  }
  const uint32_t run_bytes = end[trailer::kRuns] * format::cmap::kBytes;
  if (run_bytes == 0 || run_bytes > block_bytes_ - trailer::kBytes) {
    return false;
  }
  const uint8_t* const last = end - format::cmap::kBytes;
  const uint32_t first = load_u32(end - run_bytes + format::cmap::kFirst);
  return value - first <= load_u32(last + format::cmap::kFirst) +
                              load_u16(last + format::cmap::kExtra) - first;
}

// The block that has the page with a key; 0: none, or the index failed.
// Wherever the entries lead, it is a block of the file: each step takes one of
// those that are counted.
uint32_t StoredStore::find_page(Key key, uint32_t value) noexcept {
  const uint32_t fan_out = block_bytes_ / entry::kBytes;
  const uint8_t* entries = resident() + paged::kBytes;
  uint32_t count = roots_;
  uint32_t index = 0;
  uint32_t base = 1;
  for (uint32_t level = 0;; ++level) {
    // Invariant: entries before `begin` are at most the value.
    uint32_t begin = 0;
    uint32_t end = count;
    while (begin < end) {
      const uint32_t middle = begin + (end - begin) / 2;
      const uint8_t* const at = entries + middle * entry::kBytes;
      const uint32_t found = key == Key::glyph
                                 ? load_u16(at + entry::kGlyph)
                                 : load_u16(at + entry::kCodeLow) |
                                       uint32_t{load_u16(at + entry::kCodeHigh)}
                                           << 16;
      if (found <= value) {
        begin = middle + 1;
      } else {
        end = middle;
      }
    }
    if (begin == 0) {
      return 0;
    }
    index += begin - 1;
    if (level == levels_) {
      return base + index;
    }
    entries = load_index(base + index);
    if (entries == nullptr) {
      return 0;
    }
    base += index_counts_[level];
    const uint32_t below =
        level + 1u == levels_ ? page_count_ : index_counts_[level + 1];
    index *= fan_out;
    count = below - index < fan_out ? below - index : fan_out;
  }
}

// False: there is none, or it cannot be read.
bool StoredStore::load_page_of(Key key, uint32_t value) noexcept {
  for (uint32_t i = 0; i != slot_count_; ++i) {
    if (slot_holds(i, key, value)) {
      return load_page(slots()[i].block);
    }
  }
  const uint32_t block = find_page(key, value);
  return block != 0 && load_page(block);
}

bool StoredStore::page_holds(uint32_t glyph) const noexcept {
  return has_page() && glyph - first_glyph_ + 1 < page_.glyph_count_ &&
         glyph >= first_glyph_;
}

Status StoredStore::glyph_of_code(const FontPages& pages,
                                  uint32_t code_point,
                                  uint16_t& glyph) noexcept {
  StoredStore& self = store_of(pages);
  uint16_t id = 0;
  const uint32_t failures = self.stats_.failures;
  if (!self.has_page() || self.page_.glyph_of(code_point, id) != Status::ok) {
    if (!self.load_page_of(Key::code_point, code_point)) {
      return failures == self.stats_.failures ? Status::no_glyph : self.status_;
    }
    if (self.page_.glyph_of(code_point, id) != Status::ok) {
      return Status::no_glyph;
    }
  }
  if (id == 0) {
    return Status::no_glyph;
  }
  glyph = static_cast<uint16_t>(self.first_glyph_ + id - 1);
  return Status::ok;
}

const Font* StoredStore::page_of_glyph(const FontPages& pages,
                                       uint32_t& glyph) noexcept {
  StoredStore& self = store_of(pages);
  if (glyph >= self.glyph_end_) {
    return nullptr;
  }
  if (!self.page_holds(glyph)) {
    const uint32_t failures = self.stats_.failures;
    if (!self.load_page_of(Key::glyph, glyph) || !self.page_holds(glyph)) {
      if (failures == self.stats_.failures) {
        static_cast<void>(self.fail(Status::corrupt));
      }
      glyph = 0;
      return &self.font_;
    }
  }
  glyph -= self.first_glyph_ - 1u;
  return &self.page_;
}

const Font* StoredStore::font_to_draw(const Font& font,
                                      uint32_t& glyph) noexcept {
  if (glyph >= font.glyph_count_ && font.pages_ != nullptr) {
    return page_of_glyph(*font.pages_, glyph);
  }
  return glyph == 0 ? &font : nullptr;
}

int32_t StoredStore::measure_none(const FontPages&,
                                  uint16_t,
                                  GlyphMetrics* out) noexcept {
  return out == nullptr ? 0 : -1;
}

// Few glyphs kern, and have the lowest ids: others need no read.
int32_t StoredStore::kerning_of(const FontPages& pages,
                                uint16_t left,
                                uint16_t right) noexcept {
  StoredStore& self = store_of(pages);
  const uint8_t* const block = left < self.kern_end_ && right < self.kern_end_
                                   ? self.load_index(self.last_page() + 1)
                                   : nullptr;
  if (block == nullptr) {
    return 0;
  }
  Font font;
  font.tables_[3] = {block, self.block_bytes_};
  font.glyph_count_ = self.kern_end_;
  return font.kerning(left, right);
}

uint32_t StoredStore::layers_bytes() const noexcept {
  const Span<const uint8_t> bytes = font_.section(format::section::kLayers);
  return bytes.size == paged::kLayersBytes ? load_u32(bytes.data) : 0;
}

Status StoredStore::verify() noexcept {
  const uint32_t layers = layers_bytes();
  const uint32_t last =
      before_layers() + (layers == 0 ? 0 : (layers + 2) / block_bytes_ + 1);
  const uint32_t slot = slot_count_ - 1;
  uint32_t crc = 0;
  for (uint32_t block = 1; block <= last; ++block) {
    if (!read_block(slot, block)) {
      return Status::read_failed;
    }
    crc = crc32(crc, {bytes_of(slot), block_bytes_});
  }
  slots()[slot].block = 0;
  return crc == load_u32(resident() + paged::kContentCrc)
             ? Status::ok
             : fail(Status::corrupt);
}

}  // namespace inkcell::detail
