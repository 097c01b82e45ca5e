#include "inkcell/truetype/stored_truetype.hpp"

#include "face.hpp"
#include "file_blocks.hpp"

namespace inkcell {
namespace detail {

// At the beginning of the lent RAM. Behind it are records of the glyph that is
// drawn, each with its number and its size before it, and blocks of the file.
class __attribute__((may_alias, aligned(8))) StoredTrueTypeFile
    : public TrueTypeTables<StoredTable> {
 public:
  // As StoredTrueType::open(), of what lies at the beginning of `ram`.
  Status open(const Storage& storage,
              Span<uint8_t> ram,
              const StoredTrueTypeOptions& options) noexcept;

  const Font& font() const noexcept { return font_; }
  FileBlocks& blocks() noexcept { return blocks_; }
  void clear() noexcept;

 private:
  // Before a record, of 16 bits each.
  static constexpr uint32_t kHeadBytes = 4;

  // In the caller's RAM, which is not constant.
  static StoredTrueTypeFile& file_of(const FontPages& pages) noexcept {
    return const_cast<StoredTrueTypeFile&>(
        static_cast<const StoredTrueTypeFile&>(pages));
  }
  static Status glyph_of_code(const FontPages& pages,
                              uint32_t code,
                              uint16_t& glyph) noexcept;
  static int32_t kern_pair(const FontPages& pages,
                           uint16_t left,
                           uint16_t right) noexcept;
  static int32_t measure_glyph(const FontPages& pages,
                               uint16_t glyph,
                               GlyphMetrics* out) noexcept;
  static Table record_of(const TrueTypeFace& face,
                         uint32_t glyph,
                         int32_t* left_bearing) noexcept;

  // Where the record of a glyph is, behind its head; 0: not there.
  uint32_t find_kept(uint32_t glyph) const noexcept;
  Table load_record(uint32_t glyph, bool is_component) noexcept;
  bool is_composite(uint32_t at) const noexcept {
    return i16_at(records, at + kRecordContours) < 0;
  }

  Font font_;
  CodeRun run_;           // that was found last
  uint32_t record_ends_;  // of the records that are there
  FileBlocks blocks_;
};

namespace {

// No code point is in it.
constexpr CodeRun kNoRun = {UINT32_MAX, UINT32_MAX, 0, 0};

// Not inline: their parts of the stack do not add up.
__attribute__((noinline)) Status read_directory(
    FileBlocks& blocks, uint32_t face, Directory<StoredTable>& out) noexcept {
  return out.read({&blocks, 0, UINT32_MAX}, face);
}
__attribute__((noinline)) void take_directory(
    const Directory<StoredTable>& directory, StoredTrueTypeFile& out) noexcept {
  take_tables(directory, out);
}

constexpr uint32_t rounded_up(uint32_t bytes) noexcept {
  return (bytes + 7) & ~7u;
}

}  // namespace

Status StoredTrueTypeFile::open(const Storage& storage,
                                Span<uint8_t> ram,
                                const StoredTrueTypeOptions& options) noexcept {
  const uint32_t record_bytes = rounded_up(options.record_bytes);
  const size_t room = ram.size - sizeof(StoredTrueTypeFile);
  if (ram.size < sizeof(StoredTrueTypeFile) || room < record_bytes ||
      record_bytes < options.record_bytes) {
    return Status::buffer_small;
  }
  uint8_t* const behind = ram.data + sizeof(StoredTrueTypeFile);
  if (!blocks_.begin(storage, {behind + record_bytes, room - record_bytes})) {
    return Status::buffer_small;
  }
  Directory<StoredTable> directory;
  const Status read = read_directory(blocks_, options.face, directory);
  if (blocks_.status() != Status::ok) {
    return blocks_.status();
  }
  INKCELL_TRY(read);
  using Tables = TrueTypeTables<StoredTable>;
  __builtin_memset(static_cast<void*>(static_cast<Tables*>(this)), 0,
                   sizeof(Tables));
  static_cast<FontPages&>(*this) = {glyph_of_code, no_page_of, kern_pair,
                                    measure_glyph};
  record = record_of;
  records = {behind, record_bytes};
  record_ends_ = 0;
  run_ = kNoRun;
  take_directory(directory, *this);
  font_ = Font();
  TrueTypeFont::make_font(*this, directory.units_per_em(), *options.coding,
                          font_);
  return blocks_.status();
}

void StoredTrueTypeFile::clear() noexcept {
  blocks_.clear();
  record_ends_ = 0;
  run_ = kNoRun;
}

Status StoredTrueTypeFile::glyph_of_code(const FontPages& pages,
                                         uint32_t code,
                                         uint16_t& glyph) noexcept {
  StoredTrueTypeFile& self = file_of(pages);
  const uint32_t failures = self.blocks_.stats().failures;
  CodeRun run = self.run_;
  glyph = 0;
  if ((code - run.first <= run.last - run.first ||
       find_run_of(self, code, run)) &&
      take_glyph(self, run, code, glyph) == Status::ok) {
    if (failures == self.blocks_.stats().failures) {
      self.run_ = run;
    }
    return Status::ok;
  }
  return failures == self.blocks_.stats().failures ? Status::no_glyph
                                                   : self.blocks_.status();
}

int32_t StoredTrueTypeFile::kern_pair(const FontPages& pages,
                                      uint16_t left,
                                      uint16_t right) noexcept {
  return pair_kerning(file_of(pages), left, right);
}

int32_t StoredTrueTypeFile::measure_glyph(const FontPages& pages,
                                          uint16_t glyph,
                                          GlyphMetrics* out) noexcept {
  return measure_in(file_of(pages), glyph, out);
}

uint32_t StoredTrueTypeFile::find_kept(uint32_t glyph) const noexcept {
  for (uint32_t at = 0; at != record_ends_;) {
    const uint32_t found = u16_at(records, at);
    at += kHeadBytes;
    if (found == glyph) {
      return at;
    }
    at += u16_at(records, at - 2);
  }
  return 0;
}

Table StoredTrueTypeFile::record_of(const TrueTypeFace& face,
                                    uint32_t glyph,
                                    int32_t* left_bearing) noexcept {
  StoredTrueTypeFile& self = file_of(face);
  const uint32_t at = self.find_kept(glyph);
  const bool is_component = left_bearing == nullptr;
  if (!is_component) {
    *left_bearing = left_bearing_in(self, glyph);
  }
  // Another's component may be a composite itself.
  if (at != 0 && (is_component || at == kHeadBytes || !self.is_composite(at))) {
    return {self.records.data + at, u16_at(self.records, at - 2)};
  }
  return self.load_record(glyph, is_component);
}

// Records of simple glyphs stay until there is no room for the next one. Those
// of a composite and its components are alone, so that there is room for all.
Table StoredTrueTypeFile::load_record(uint32_t glyph,
                                      bool is_component) noexcept {
  const StoredTable found = record_in(*this, glyph);
  if (found.size == 0) {
    return {};
  }
  const uint32_t bytes = kHeadBytes + found.size;
  uint32_t at = record_ends_;
  if (!is_component &&
      (is_composite(kHeadBytes) || i16_at(found, kRecordContours) < 0 ||
       records.size - at < bytes)) {
    at = 0;
  }
  record_ends_ = at;
  if (found.size > UINT16_MAX || records.size - at < bytes) {
    blocks_.fail(Status::buffer_small);
    return {};
  }
  auto* const to = const_cast<uint8_t*>(records.data + at);
  if (!blocks_.copy(found.begin, found.size, to + kHeadBytes)) {
    return {};
  }
  const uint32_t head[] = {glyph >> 8, glyph, found.size >> 8, found.size};
  for (uint32_t i = 0; i != kHeadBytes; ++i) {
    to[i] = static_cast<uint8_t>(head[i]);
  }
  record_ends_ = at + bytes;
  return {to + kHeadBytes, found.size};
}

}  // namespace detail

namespace {

constexpr Font kNoFontStored;

}  // namespace

Status StoredTrueType::open(const Storage& storage,
                            Span<uint8_t> ram,
                            StoredTrueType& out,
                            const StoredTrueTypeOptions& options) noexcept {
  using detail::StoredTrueTypeFile;
  static_assert(sizeof(StoredTrueTypeFile) <= kFileBytes, "see ram_bytes()");
  static_assert(sizeof(detail::FileBlocks::Slot) == kSlotBytes &&
                detail::FileBlocks::kBlockBytes == kBlockBytes);
  if (reinterpret_cast<uintptr_t>(ram.data) % 8 != 0) {
    return Status::misaligned;
  }
  auto* const file = reinterpret_cast<StoredTrueTypeFile*>(ram.data);
  INKCELL_TRY(file->open(storage, ram, options));
  out.file_ = file;
  return Status::ok;
}

const Font& StoredTrueType::font() const noexcept {
  return file_ == nullptr ? kNoFontStored : file_->font();
}

Status StoredTrueType::status() const noexcept {
  return file_ == nullptr ? Status::ok : file_->blocks().status();
}

void StoredTrueType::clear() noexcept {
  if (file_ != nullptr) {
    file_->clear();
  }
}

StoredStats StoredTrueType::stats() const noexcept {
  return file_ == nullptr ? StoredStats{} : file_->blocks().stats();
}

}  // namespace inkcell
