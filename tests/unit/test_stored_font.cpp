// Fonts in storage that is not mapped.
#include "inkcell/stored/stored_font.hpp"

#include "check.hpp"
#include "font_builder.hpp"
#include "inkcell/cache/glyph_cache.hpp"
#include "inkcell/fit.hpp"
#include "inkcell/layout/layout.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/prepared_glyph.hpp"
#include "inkcell/stored/paged.hpp"
#include "inkcell/stroke.hpp"
#include "outline_record.hpp"
#include "picture.hpp"
#include "pixels.hpp"
#include "random.hpp"
#include "stored_disk.hpp"

namespace {

using namespace inkcell;
using namespace stored_disk;

constexpr size_t kMostBlocks = 20;
alignas(8) uint8_t ram[StoredFont::ram_bytes(kBlock, kMostBlocks)];

StoredFont open_disk(Disk& disk, size_t blocks) {
  StoredFont stored;
  CHECK_OK(StoredFont::open({Disk::read, &disk},
                            {ram, StoredFont::ram_bytes(kBlock, blocks)},
                            stored));
  return stored;
}

constexpr int32_t kWidth = 96;
constexpr int32_t kHeight = 40;

// Pictures are larger than the stack of boards.
using Page = Picture<kWidth, kHeight, Overlap::greatest>;
Page picture_a;
Page picture_b;

constexpr bool kBoth[] = {false, true};
constexpr int32_t kSizes[] = {9, 14, 24};
constexpr size_t kBlockCounts[] = {1, 2, 3, 6, kMostBlocks};

constexpr Point kPen = {3, 30};

void draw_glyph(const Font& font,
                const Style& style,
                uint16_t glyph,
                Page& out) {
  out.clear();
  Painter(out.sink()).glyph(font, style, kPen, glyph);
}

// U+4E00 + n, as three bytes.
void put_character(uint32_t n, char* at) {
  const uint32_t code_point = kFirst + n;
  at[0] = static_cast<char>(0xe0 | code_point >> 12);
  at[1] = static_cast<char>(0x80 | (code_point >> 6 & 0x3f));
  at[2] = static_cast<char>(0x80 | (code_point & 0x3f));
}

// The first characters in a font in memory, with the same hints.
constexpr uint32_t kMapped = 9;
alignas(8) uint8_t mapped_rom[1024];

Font mapped_font() {
  using namespace outline_record;
  static font_builder::GlyphSpec specs[kMapped + 1];
  static uint8_t records[kMapped + 1][64];
  static uint8_t code[2 << kCodeBits];
  write_code(code);
  for (uint32_t i = 0; i <= kMapped; ++i) {
    font_builder::GlyphSpec& spec = specs[i];
    spec = {};
    spec.advance = i == 0 ? 600 : kAdvance;
    size_t size = 0;
    if (i == 0) {
      size = write_notdef(records[i]);
      set_box(box_of({kBar, 4}), 0, spec.box);
    } else {
      size = write_glyph(i - 1, records[i], spec.box);
    }
    spec.bytes = {records[i], size};
  }
  const font_builder::CmapEntry cmap[] = {{kFirst, kMapped - 1, 1}};
  font_builder::FontSpec spec;
  spec.units_per_em = 1024;
  spec.cmap = {cmap, 1};
  spec.hints = kGrid;
  spec.glyphs = {specs, kMapped + 1};
  spec.outlines = {{code, sizeof code}, kCodeBits, 0, 20};
  const size_t size = font_builder::build_font(spec, mapped_rom);
  Font font;
  CHECK_OK(Font::open({mapped_rom, size}, font));
  return font;
}

void compare(const Font& mapped,
             const Style& mapped_style,
             const Font& stored,
             const Style& stored_style) {
  for (uint32_t i = 0; i < kMapped; ++i) {
    const uint32_t n = (i * 5 + 3) % kMapped;  // from page to page
    uint16_t from = 0;
    uint16_t to = 0;
    CHECK_OK(mapped.glyph_of(kFirst + n, from));
    CHECK_OK(stored.glyph_of(kFirst + n, to));
    draw_glyph(mapped, mapped_style, from, picture_a);
    draw_glyph(stored, stored_style, to, picture_b);
    CHECK(picture_a.ink() != 0);
    CHECK(picture_a == picture_b);
    const Rect a = Painter().glyph_box(mapped, mapped_style, kPen, from);
    const Rect b = Painter().glyph_box(stored, stored_style, kPen, to);
    CHECK(is_same(a, b));
  }
}

}  // namespace

TEST(a_glyph_takes_three_reads_and_one_block) {
  Disk disk;
  const StoredFont stored = open_disk(disk, 1);
  CHECK_EQ(stored.stats().blocks, 1u);
  const Font& font = stored.font();
  const Style style(20_px);
  uint32_t most = 0;
  for (uint32_t n = 0; n < disk.characters; n += 997) {
    const uint32_t before = disk.reads;
    uint16_t glyph = 0;
    GlyphMetrics metrics;
    CHECK_OK(font.glyph_of(kFirst + n, glyph));
    CHECK_EQ(glyph, kSlots + n);
    CHECK_OK(font.glyph_metrics(glyph, metrics));
    CHECK_EQ(metrics.y_max, static_cast<int32_t>(500 + n % 13 * 20));
    CHECK_EQ(font.advance(glyph), int32_t{kAdvance});
    draw_glyph(font, style, glyph, picture_a);
    CHECK(picture_a.ink() != 0);
    most = disk.reads - before > most ? disk.reads - before : most;
  }
  CHECK_EQ(most, 3u);
  CHECK_OK(stored.status());
  CHECK_EQ(stored.stats().reads, disk.reads);
  CHECK_EQ(stored.stats().bytes, disk.bytes);
  // Neither before nor behind them, nor in a page that is not full.
  uint16_t glyph = 1;
  CHECK_EQ(font.glyph_of(kFirst - 1, glyph), Status::no_glyph);
  CHECK_EQ(font.glyph_of(kFirst + disk.characters, glyph), Status::no_glyph);
  CHECK_EQ(font.glyph_of('A', glyph), Status::no_glyph);
  CHECK_EQ(glyph, 0);
  CHECK_EQ(font.advance(static_cast<uint16_t>(kSlots + disk.characters)), 0);
  CHECK_EQ(font.advance(0), 600);
  CHECK_OK(stored.status());
}

TEST(glyphs_are_found_in_any_order) {
  Disk disk;
  const StoredFont stored = open_disk(disk, 6);
  const Font& font = stored.font();
  for (uint32_t i = 0; i < 60; ++i) {
    // From page to page, down and up.
    const uint32_t n = 1000 + (i % 2 == 0 ? 60 - i : i);
    uint16_t glyph = 0;
    GlyphMetrics metrics;
    CHECK_OK(font.glyph_metrics(static_cast<uint16_t>(kSlots + n), metrics));
    CHECK_EQ(metrics.y_max, static_cast<int32_t>(500 + n % 13 * 20));
    CHECK_OK(font.glyph_of(kFirst + n + 4, glyph));
    CHECK_EQ(glyph, kSlots + n + 4);
  }
  CHECK_OK(stored.status());
}

TEST(pictures_are_those_of_a_mapped_font) {
  Disk disk;
  disk.characters = kMapped;
  const Font mapped = mapped_font();
  for (const size_t blocks : kBlockCounts) {
    const StoredFont stored = open_disk(disk, blocks);
    const Font& font = stored.font();
    bool is_fitted = false;  // some picture is another with hints
    for (const int32_t px : kSizes) {
      Style style(Q26_6::from_int(px), kFilterText);
      compare(mapped, style, font, style);
      const Stroke stroke(kFilterText, Q6_10::from_int(1));
      Style stroked(Q26_6::from_int(px), kFilterText);
      stroked.set_effect(stroke);
      compare(mapped, stroked, font, stroked);
      for (const bool across : kBoth) {
        FitOptions options;
        options.across = across;
        Fit mapped_fit;
        Fit stored_fit;
        CHECK_OK(Fit::make(mapped, style, options, mapped_fit));
        CHECK_OK(Fit::make(font, style, options, stored_fit));
        Style fitted = style;
        Style also_fitted = style;
        fitted.set_fit(mapped_fit);
        also_fitted.set_fit(stored_fit);
        compare(mapped, fitted, font, also_fitted);
        draw_glyph(mapped, fitted, 1, picture_a);
        draw_glyph(mapped, style, 1, picture_b);
        is_fitted = is_fitted || !(picture_a == picture_b);
        if (across) {
          CHECK_EQ(kGridFit.advance_px(font, also_fitted, kSlots + 7),
                   kGridFit.advance_px(mapped, fitted, 1 + 7));
        }
      }
    }
    CHECK(is_fitted);
    CHECK_OK(stored.status());
  }
}

TEST(caches_layouts_and_fallbacks_take_stored_fonts) {
  char text[3 * 8 + 1] = {};
  for (uint32_t i = 0; i < 8; ++i) {
    put_character(i * 3 % kMapped, text + 3 * i);
  }
  Disk disk;
  disk.characters = kMapped;
  const Font mapped = mapped_font();
  const StoredFont stored = open_disk(disk, 2);
  const Font copy = stored.font();
  const Style style(12_px);
  alignas(8) static uint8_t cached[2048];
  for (const bool is_cached : kBoth) {
    for (const bool is_fallback : kBoth) {
      const Font none;
      for (int which = 0; which < 2; ++which) {
        Page& picture = which == 0 ? picture_a : picture_b;
        picture.clear();
        const Sink sink = picture.sink();
        const Font& font = which == 0 ? mapped : copy;
        GlyphCache cache;
        CHECK_OK(GlyphCache::make(cached, {}, cache));
        const Painter painter(sink, {}, is_cached ? &cache : nullptr);
        const Face face = {&font, &style};
        LayoutOptions options(is_fallback ? none : font, style);
        if (is_fallback) {
          options.fallback = {&face, 1};
        }
        TextLine line;
        Point at = {2, 12};
        while (next_line(options, {}, text, 60_px, line)) {
          PositionedGlyph room[16];
          Span<const PositionedGlyph> glyphs;
          CHECK_OK(lay_out(options, {}, text, line, 60_px, room, glyphs));
          painter.glyphs(options.face, options.fallback, at, glyphs);
          at.y.raw += 14 * 64;
        }
        if (is_cached) {
          CHECK(cache.stats().misses != 0);
        }
      }
      CHECK(picture_a.ink() != 0);
      CHECK(picture_a == picture_b);
    }
  }
  // What needs a font in mapped memory says so.
  PreparedGlyph prepared;
  alignas(8) static uint8_t work[1024];
  CHECK_EQ(PreparedGlyph::make(copy, kSlots, style, kPen, {work, sizeof work},
                               prepared),
           Status::no_glyph);
}

// Prints what a page of Chinese costs.
TEST(a_page_of_text_is_read_once) {
  constexpr uint32_t kCharacters = 96;
  char text[3 * kCharacters + 1] = {};
  Random random(7);
  for (uint32_t i = 0; i < kCharacters; ++i) {
    put_character(random.below(3755) * 5, text + 3 * i);
  }
  uint32_t least = UINT32_MAX;
  for (const size_t blocks : kBlockCounts) {
    Disk disk;
    const StoredFont stored = open_disk(disk, blocks);
    const uint32_t before = disk.reads;
    const Style style(12_px);
    picture_a.clear();
    const Sink sink = picture_a.sink();
    const LayoutOptions options(stored.font(), style);
    const Text page(text, sizeof text - 1);
    TextLine line;
    while (next_line(options, {}, page, Q26_6::from_int(kWidth), line)) {
      PositionedGlyph room[16];
      Span<const PositionedGlyph> glyphs;
      CHECK_OK(lay_out(options, {}, page, line, Q26_6::from_int(kWidth), room,
                       glyphs));
      Painter(sink).glyphs(stored.font(), style, kPen, glyphs);
    }
    CHECK_OK(stored.status());
    CHECK(disk.reads - before <= least);  // more RAM, fewer reads
    least = disk.reads - before;
    check::write("96 hanzi of 20992, blocks in RAM: ");
    check::write_number(static_cast<int64_t>(blocks));
    check::write(", reads: ");
    check::write_number(disk.reads - before);
    check::write(", bytes: ");
    check::write_number((disk.reads - before) * kBlock);
    check::write("\n");
  }
  CHECK(least <= 3 * kCharacters);
}

// docs/BUILD.md: one for each glyph and one of the index that finds it, and
// the block above those.
TEST(a_line_is_read_once_with_blocks_for_glyphs_and_index) {
  constexpr uint32_t kMostGlyphs = 9;
  for (uint32_t count = 1; count <= kMostGlyphs; ++count) {
    char text[3 * kMostGlyphs + 3] = {};  // GCC 12 counts one more
    for (uint32_t i = 0; i < count; ++i) {
      put_character(2000 * i, text + 3 * i);  // each far from the others
    }
    Disk disk;
    const uint32_t blocks = count + count + 1;
    const StoredFont stored = open_disk(disk, blocks);
    const uint32_t before = disk.reads;
    const Style style(12_px);
    const Sink sink = picture_a.sink();
    Painter(sink).text(stored.font(), style, kPen, Text(text, 3 * count));
    CHECK_EQ(disk.reads - before, blocks);
    Painter(sink).text(stored.font(), style, kPen, Text(text, 3 * count));
    CHECK_EQ(disk.reads - before, blocks);
    CHECK_OK(stored.status());
  }
}

TEST(pairs_kern_by_one_block_more) {
  for (const size_t blocks : kBlockCounts) {
    Disk disk;
    disk.kerns = true;
    StoredFont stored = open_disk(disk, blocks);
    const Font& font = stored.font();
    uint16_t glyphs[Disk::kKerning + 2];
    for (uint32_t i = 0; i < Disk::kKerning + 2; ++i) {
      CHECK_OK(font.glyph_of(kFirst + i, glyphs[i]));
    }
    const uint32_t before = disk.reads;
    for (uint32_t left = 0; left < Disk::kKerning; ++left) {
      for (uint32_t right = 0; right < Disk::kKerning; ++right) {
        const int32_t expected =
            right == left + 1 ? static_cast<int32_t>(left) - 100 : 0;
        CHECK_EQ(font.kerning(glyphs[left], glyphs[right]), expected);
      }
    }
    CHECK_EQ(disk.reads - before, 1u);
    // These do not kern, which needs no read.
    stored.clear();
    CHECK_EQ(font.kerning(glyphs[0], glyphs[Disk::kKerning]), 0);
    CHECK_EQ(font.kerning(glyphs[Disk::kKerning + 1], glyphs[0]), 0);
    CHECK_EQ(font.kerning(0, 60000), 0);
    CHECK_EQ(disk.reads - before, 1u);
    // A block of pairs is no page, whatever its bytes are.
    CHECK_EQ(font.kerning(glyphs[1], glyphs[2]), -99);
    uint16_t glyph = 0;
    for (uint32_t n = 0; n < 40; ++n) {
      CHECK_OK(font.glyph_of(kFirst + n, glyph));
      CHECK_EQ(font.advance(glyph), int32_t{kAdvance});
      CHECK_EQ(font.kerning(glyphs[2], glyphs[3]), -98);
    }
    CHECK_OK(stored.status());
    disk.fails_from = disk.reads;
    stored.clear();
    CHECK_EQ(font.kerning(glyphs[1], glyphs[2]), 0);
    CHECK_EQ(stored.status(), Status::read_failed);
  }
}

TEST(reads_that_fail_give_notdef) {
  const Style style(20_px);
  for (const bool is_short : kBoth) {
    for (uint32_t good = 1; good < 4; ++good) {
      Disk disk;
      StoredFont stored = open_disk(disk, 2);
      const Font& font = stored.font();
      uint16_t glyph = 0;
      CHECK_OK(font.glyph_of(kFirst + 700, glyph));
      stored.clear();
      disk.fails_from = disk.reads + good - 1;
      disk.is_short = is_short;
      draw_glyph(font, style, glyph, picture_a);
      CHECK_EQ(stored.status(), Status::read_failed);
      CHECK(stored.stats().failures != 0);
      draw_glyph(font, style, 0, picture_b);
      CHECK(picture_a.ink() != 0);
      CHECK(picture_a == picture_b);
      CHECK_EQ(font.advance(glyph), 600);
      uint16_t found = 1;
      CHECK_EQ(font.glyph_of(kFirst + 9000, found), Status::read_failed);
      CHECK_EQ(found, 0);
      // The card works again.
      disk.fails_from = UINT32_MAX;
      stored.clear();
      CHECK_OK(stored.status());
      CHECK_OK(font.glyph_of(kFirst + 700, found));
      CHECK_EQ(found, glyph);
      CHECK_EQ(font.advance(glyph), int32_t{kAdvance});
    }
  }
}

TEST(bytes_that_change_are_safe) {
  Random random(11);
  Disk disk;
  uint32_t drawn = 0;
  for (uint32_t round = 0; round < 300; ++round) {
    disk.noise = nullptr;
    disk.kerns = round % 2 != 0;
    const StoredFont stored = open_disk(disk, 1 + round % 3);
    const Font& font = stored.font();
    disk.noise = &random;
    disk.noise_from = disk.reads + random.below(4);
    Style style(Q26_6::from_int(8 + static_cast<int32_t>(random.below(16))));
    Fit fit;
    CHECK_OK(Fit::make(font, style, {}, fit));
    style.set_fit(fit);
    for (uint32_t i = 0; i < 5; ++i) {
      uint16_t glyph = 0;
      static_cast<void>(
          font.glyph_of(kFirst + random.below(disk.characters), glyph));
      draw_glyph(font, style, glyph, picture_a);
      glyph = static_cast<uint16_t>(random.below(65536));
      static_cast<void>(font.advance(glyph));
      static_cast<void>(font.kerning(
          static_cast<uint16_t>(kSlots + random.below(Disk::kKerning)),
          static_cast<uint16_t>(kSlots + random.below(Disk::kKerning))));
      draw_glyph(font, style, glyph, picture_a);
      drawn += picture_a.ink() != 0 ? 1u : 0u;
    }
  }
  CHECK(drawn > 100);
}

TEST(open_says_why_not) {
  Disk disk;
  StoredFont stored;
  const Storage storage = {Disk::read, &disk};
  const size_t bytes = StoredFont::ram_bytes(kBlock, 1);
  CHECK_EQ(StoredFont::open(storage, {ram + 4, bytes}, stored),
           Status::misaligned);
  CHECK_EQ(StoredFont::open(storage, {ram, 512}, stored), Status::buffer_small);
  disk.fails_from = 0;
  CHECK_EQ(StoredFont::open(storage, {ram, bytes}, stored),
           Status::read_failed);
  uint16_t glyph = 1;
  CHECK_EQ(stored.font().glyph_of('A', glyph), Status::no_glyph);
  CHECK_OK(stored.status());
  disk.fails_from = UINT32_MAX;
  // Each byte of the resident part counts.
  alignas(8) static uint8_t block[kBlock];
  const auto read = [](void* context, uint32_t, uint8_t* to, uint32_t count) {
    for (uint32_t i = 0; i < count; ++i) {
      to[i] = static_cast<uint8_t*>(context)[i];
    }
    return true;
  };
  disk.write_block(0, block);
  const uint32_t resident =
      block[paged::kResidentBytes] | block[paged::kResidentBytes + 1] * 256u;
  CHECK(resident <= 512);
  for (uint32_t at = 0; at < resident; ++at) {
    block[at] ^= 0x10;
    CHECK(StoredFont::open({read, block}, {ram, bytes}, stored) != Status::ok);
    block[at] ^= 0x10;
  }
  CHECK_OK(StoredFont::open({read, block}, {ram, bytes}, stored));
  put_u32(block, format::kMagic);
  CHECK_EQ(StoredFont::open({read, block}, {ram, bytes}, stored),
           Status::bad_magic);
}

TEST(verify_reads_all) {
  Disk disk;
  disk.characters = 40;
  StoredFont stored = open_disk(disk, 2);
  // The disk states no checksum of its content.
  const uint32_t before = disk.reads;
  CHECK_EQ(stored.verify(), Status::corrupt);
  CHECK_EQ(disk.reads - before, 1u + 10);
  uint16_t glyph = 0;
  CHECK_OK(stored.font().glyph_of(kFirst + 39, glyph));
}
