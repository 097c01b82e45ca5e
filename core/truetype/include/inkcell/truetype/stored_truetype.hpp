// A TrueType file in storage that is not mapped: an SD card, SPI flash, a file.
//
//   alignas(8) static uint8_t ram[StoredTrueType::ram_bytes(8)];
//   StoredTrueType stored;
//   INKCELL_TRY(StoredTrueType::open({read, &file}, ram, stored));
//   painter.text(stored.font(), Style(24_px), pen, "12:34");
//
// font() is that of TrueTypeFont (inkcell/truetype/truetype_font.hpp), and
// draws the same. With 8 blocks a glyph of Latin text is 1 to 3 reads of 512
// bytes, up to 9 where glyphs of ASCII lie far from each other in the file.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "inkcell/coding.hpp"
#include "inkcell/font.hpp"
#include "inkcell/span.hpp"
#include "inkcell/status.hpp"
#include "inkcell/storage.hpp"
#include "inkcell/truetype/truetype_font.hpp"

namespace inkcell {

struct StoredTrueTypeOptions {
  const Coding* coding = &kTrueTypeCoding;
  uint32_t face = 0;  // of a collection
  /// Room for the record of a glyph and its components: 2,048 bytes hold all
  /// of Latin in text faces.
  uint32_t record_bytes = 2048;
};

/// Holds a pointer into the RAM that it was lent: as cheap to copy. The RAM and
/// the storage must outlive it and copies of its font. For one task at a time.
///
/// `read` fills in as much as there is where the file ends, and tells true; it
/// is never asked for more than 511 bytes beyond the end of a table.
///
/// Bytes of the storage are untrusted, and may differ each time they are read.
/// Where they cannot be read they are 0: glyphs are absent then, or have no
/// ink, and status() says why.
class StoredTrueType {
 public:
  static constexpr size_t kBlockBytes = 512;

  /// font() has no glyphs.
  constexpr StoredTrueType() noexcept = default;

  /// RAM for so many blocks, 1 at least. Blocks that were not used for the
  /// longest time make room for others.
  static constexpr size_t ram_bytes(
      size_t blocks,
      size_t record_bytes = StoredTrueTypeOptions().record_bytes) noexcept {
    return kFileBytes + (record_bytes + 7) / 8 * 8 +
           blocks * (kBlockBytes + kSlotBytes);
  }

  /// Opens a file. The data of `ram` is a multiple of 8.
  ///
  /// misaligned: `ram` is. buffer_small: it has no room for one block.
  /// read_failed: the storage. Others: as TrueTypeFont::open(). `out` is
  /// untouched unless the result is ok.
  static Status open(const Storage& storage,
                     Span<uint8_t> ram,
                     StoredTrueType& out,
                     const StoredTrueTypeOptions& options = {}) noexcept;

  const Font& font() const noexcept;

  /// Why something failed first since open() or clear(). read_failed: the
  /// storage. buffer_small: a glyph needs more StoredTrueTypeOptions::
  /// record_bytes. ok: nothing did.
  Status status() const noexcept;

  /// Forgets all blocks and the status: after another card was inserted, or to
  /// try again.
  void clear() noexcept;

  StoredStats stats() const noexcept;

 private:
  // What is kept of the file, and a block's place.
  static constexpr size_t kFileBytes = 704 + 32 * sizeof(void*);
  static constexpr size_t kSlotBytes = 8;

  detail::StoredTrueTypeFile* file_ = nullptr;  // in the lent RAM
};

}  // namespace inkcell
