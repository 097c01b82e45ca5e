// A font in storage that is not mapped: SPI flash, an SD card, a file.
//
// inkcell-fontgen --paged 1024 makes such a font. A glyph takes at most three
// reads of a block, and none where the RAM that is lent still holds its blocks.
//
//   bool read(void* file, uint32_t offset, uint8_t* bytes, uint32_t count);
//
//   alignas(8) static uint8_t ram[StoredFont::ram_bytes(1024, 4)];
//   StoredFont stored;
//   INKCELL_TRY(StoredFont::open({read, &file}, ram, stored));
//   painter.text(stored.font(), style, origin, "...");
//
// font() is a Font like any other: for layout, as a fallback, with effects,
// fitting and a GlyphCache.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "inkcell/coding.hpp"
#include "inkcell/font.hpp"
#include "inkcell/span.hpp"
#include "inkcell/status.hpp"
#include "inkcell/storage.hpp"
#include "inkcell/stored/paged.hpp"

namespace inkcell {

/// Outlines, the coding of StoredFont::open without a name.
extern const Coding kStoredOutlineCoding;

/// Holds a pointer into the RAM that it was lent: as cheap to copy. The RAM and
/// the storage must outlive it and copies of its font. For one task at a time.
///
/// Bytes of the storage are untrusted, and may differ each time they are read:
/// each block is judged when it is read, and safe with any content. Where a
/// block cannot be read, or does not fit, .notdef is drawn, and status() says
/// why. .notdef is always in RAM.
class StoredFont {
 public:
  /// font() has no glyphs.
  constexpr StoredFont() noexcept = default;

  /// RAM for so many blocks, 1 at least. Blocks that were not used for the
  /// longest time make room for others: with 1 a glyph is up to three reads,
  /// with more of them the index and the glyphs of a line stay.
  static constexpr size_t ram_bytes(size_t block_bytes,
                                    size_t blocks) noexcept {
    return kStoreBytes + format::paged::kMaxResidentBytes +
           blocks * (block_bytes + kSlotBytes);
  }

  /// Opens a font. The data of `ram` is a multiple of 8.
  ///
  /// misaligned: `ram` is. buffer_small: it has no room for one block.
  /// read_failed: the storage. bad_magic: not a paged font; a font of another
  /// form is opened by Font::open(), in mapped memory. bad_version, corrupt,
  /// unsupported: as Font::open(). `out` is untouched unless the result is ok.
  static Status open(const Storage& storage,
                     Span<uint8_t> ram,
                     StoredFont& out) noexcept {
    return open(storage, ram, kStoredOutlineCoding, out);
  }
  /// The same of another coding: kStrikeCoding or kBitStrikeCoding of
  /// inkcell/strike/strike.hpp. unsupported: the font is of another one, or
  /// fonts of the coding are not stored.
  static Status open(const Storage& storage,
                     Span<uint8_t> ram,
                     const Coding& coding,
                     StoredFont& out) noexcept;

  /// The font. It differs from others in this: glyph_count() is that of a page
  /// at most, name() and record() are empty, glyphs are not prepared
  /// (PreparedGlyph) and have no fields, and verify() here is the one that
  /// counts. A pair of glyphs that may kern is one more block.
  const Font& font() const noexcept;

  /// Why the first block failed since open() or clear(): read_failed, or
  /// corrupt, if it does not fit. ok: none did.
  Status status() const noexcept;

  /// Forgets all blocks and the status: after another card was inserted, or to
  /// try again.
  void clear() noexcept;

  StoredStats stats() const noexcept;

  /// For ColourGlyphs::set_stored(), of a font made with --colour. A colour
  /// glyph is a read of a block for each of its layers, and up to four more,
  /// where the RAM does not hold them.
  StoredLayers layers() const noexcept;

  /// Reads the whole font and compares its checksum. corrupt: it differs.
  Status verify() noexcept;

 private:
  // What the store and a block's place in it take at most.
  static constexpr size_t kStoreBytes = 96 + 40 * sizeof(void*);
  static constexpr size_t kSlotBytes = 8;

  detail::StoredStore* store_ = nullptr;  // in the lent RAM
};

}  // namespace inkcell
