// TrueType files in storage: the same as in memory, and what happens where
// storage fails.
#include "inkcell/truetype/stored_truetype.hpp"

#include "check.hpp"
#include "inkcell/cache/glyph_cache.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/port/a8.hpp"
#include "inkcell/text.hpp"
#include "inkcell/truetype/plain_truetype.hpp"
#include "inkcell/truetype/truetype_font.hpp"
#include "sfnt_font.hpp"

namespace {

using namespace inkcell;
using sfnt_font::Options;

constexpr int32_t kWidth = 40;
constexpr int32_t kHeight = 24;
constexpr uint32_t kBlock = StoredTrueType::kBlockBytes;

uint8_t file[2048];
alignas(8) uint8_t lent[StoredTrueType::ram_bytes(4)];
alignas(8) uint8_t ram[2560];
uint8_t drawn[kWidth * kHeight];
uint8_t expected[kWidth * kHeight];

// A file that ends within a block.
struct Card {
  uint32_t size = 0;
  uint32_t reads = 0;
  uint32_t fails_from = UINT32_MAX;  // the number of the first read that fails

  static bool read(void* context,
                   uint32_t offset,
                   uint8_t* bytes,
                   uint32_t count) {
    Card& self = *static_cast<Card*>(context);
    CHECK_EQ(offset % kBlock, 0u);
    CHECK_EQ(count, kBlock);
    const bool works = self.reads++ < self.fails_from && offset < self.size;
    for (uint32_t i = 0; i != count && works && offset + i < self.size; ++i) {
      bytes[i] = file[offset + i];
    }
    return works;
  }
};

Card build(const Options& options) {
  Card card;
  card.size = static_cast<uint32_t>(sfnt_font::build(file, options));
  CHECK(card.size <= sizeof file);
  return card;
}

Status open(Card& card,
            size_t blocks,
            StoredTrueType& out,
            const StoredTrueTypeOptions& options = {}) {
  const size_t bytes = StoredTrueType::ram_bytes(blocks, options.record_bytes);
  CHECK(bytes <= sizeof lent);
  return StoredTrueType::open({Card::read, &card}, {lent, bytes}, out, options);
}

template <typename Draw>
void draw_strips(uint8_t (&out)[kWidth * kHeight],
                 int32_t rows,
                 Workspace workspace,
                 const Draw& draw) {
  __builtin_memset(out, 0, sizeof out);
  for (int32_t y = 0; y < kHeight; y += rows) {
    const int32_t height = y + rows > kHeight ? kHeight - y : rows;
    const port::A8Canvas canvas(
        {{out + y * kWidth, static_cast<size_t>(height * kWidth)},
         0,
         y,
         kWidth,
         height,
         kWidth});
    draw(Painter(canvas, workspace));
  }
}

bool are_equal() {
  return __builtin_memcmp(drawn, expected, sizeof drawn) == 0;
}

int32_t count_drawn() {
  int32_t count = 0;
  for (const uint8_t value : drawn) {
    count += value != 0 ? 1 : 0;
  }
  return count;
}

// All letters, at places between pixels.
void draw_all(const Font& font, const Painter& painter) {
  for (uint16_t glyph = 0; glyph < sfnt_font::kGlyphCount; ++glyph) {
    painter.glyph(font, Style(13_px),
                  {Q26_6::from_raw(4 * 64 + 37 * glyph), 16_px}, glyph);
  }
}

// Look-ups, metrics and kerning.
void check_numbers(const Font& font, const Font& same) {
  for (uint32_t code = 0; code < 300; ++code) {
    uint16_t glyph = 7;
    uint16_t wanted = 7;
    CHECK_EQ(font.glyph_of(code, glyph), same.glyph_of(code, wanted));
    CHECK_EQ(glyph, wanted);
  }
  CHECK_EQ(font.glyph_or_notdef(0x1f601), same.glyph_or_notdef(0x1f601));
  const FontMetrics all = font.metrics();
  const FontMetrics wanted = same.metrics();
  CHECK_EQ(all.ascender, wanted.ascender);
  CHECK_EQ(all.x_height, wanted.x_height);
  CHECK_EQ(all.y_max, wanted.y_max);
  for (uint16_t i = 0; i <= sfnt_font::kGlyphCount; ++i) {
    GlyphMetrics box;
    GlyphMetrics box_wanted;
    CHECK_EQ(font.glyph_metrics(i, box), same.glyph_metrics(i, box_wanted));
    CHECK_EQ(box.advance, box_wanted.advance);
    CHECK_EQ(box.x_min, box_wanted.x_min);
    CHECK_EQ(box.y_max, box_wanted.y_max);
    for (uint16_t right = 0; right < 6; ++right) {
      CHECK_EQ(font.kerning(i, right), same.kerning(i, right));
    }
  }
}

TEST(stored_files_are_those_in_memory) {
  int32_t number = 0;
  for (const int32_t format : each_of({0, 4, 6, 12})) {
    Options options;
    options.cmap_format = format;
    options.is_long = number % 2 == 0;
    options.gpos_format = number % 3;
    options.is_extension = number == 2;
    options.is_glyf_last = number == 3;
    Card card = build(options);
    const Coding& coding = number == 1 ? kPlainTrueTypeCoding : kTrueTypeCoding;
    ++number;
    TrueTypeFont same;
    CHECK_EQ(same.open({file, card.size}, coding), Status::ok);
    for (const size_t blocks : each_of<size_t>({1, 2, 4})) {
      StoredTrueTypeOptions wanted;
      wanted.coding = &coding;
      StoredTrueType stored;
      CHECK_EQ(open(card, blocks, stored, wanted), Status::ok);
      CHECK_EQ(stored.stats().blocks, blocks);
      check_numbers(stored.font(), same.font());
      draw_strips(
          expected, kHeight, Workspace(ram),
          [&](const Painter& painter) { draw_all(same.font(), painter); });
      for (const int32_t bytes : each_of({0, 900, 2560})) {
        for (const int32_t rows : each_of<int32_t>({5, kHeight})) {
          draw_strips(drawn, rows, {ram, static_cast<size_t>(bytes)},
                      [&](const Painter& painter) {
                        draw_all(stored.font(), painter);
                      });
          CHECK(are_equal());
        }
      }
      CHECK_EQ(stored.status(), Status::ok);
      CHECK_EQ(stored.stats().failures, 0u);
    }
  }
}

TEST(blocks_that_are_there_are_not_read) {
  Card card = build({});
  StoredTrueType stored;
  CHECK_EQ(open(card, 4, stored), Status::ok);
  const auto draw = [&stored](const Painter& painter) {
    painter.text(stored.font(), Style(10_px), {2_px, 16_px}, "ABGA");
  };
  draw_strips(drawn, kHeight, Workspace(ram), draw);
  const uint32_t reads = card.reads;
  CHECK_EQ(stored.stats().reads, reads);
  CHECK_EQ(stored.stats().bytes, reads * kBlock);
  CHECK(reads <= (card.size + kBlock - 1) / kBlock);
  CHECK(count_drawn() > 50);
  draw_strips(drawn, kHeight, Workspace(ram), draw);
  CHECK_EQ(card.reads, reads);
  // Each strip draws each glyph, whose record stays.
  CHECK_EQ(open(card, 1, stored), Status::ok);
  uint16_t glyph = stored.font().glyph_or_notdef('H');
  draw_strips(drawn, kHeight, Workspace(ram), [&](const Painter& painter) {
    painter.glyph(stored.font(), Style(10_px), {2_px, 16_px}, glyph);
  });
  stored.clear();
  draw_strips(drawn, 1, Workspace(ram), [&](const Painter& painter) {
    painter.glyph(stored.font(), Style(10_px), {2_px, 16_px}, glyph);
  });
  CHECK(count_drawn() > 20);
}

TEST(failing_storage_is_told) {
  Card card = build({});
  StoredTrueType stored;
  CHECK_EQ(open(card, 1, stored), Status::ok);
  const auto draw = [&stored](const Painter& painter) {
    draw_all(stored.font(), painter);
  };
  draw_strips(expected, kHeight, Workspace(ram), draw);
  stored.clear();
  card.reads = 0;
  draw_strips(drawn, kHeight, Workspace(ram), draw);
  CHECK(are_equal());
  const uint32_t all = card.reads;
  for (uint32_t first = 0; first < all; ++first) {
    stored.clear();
    card.reads = 0;
    card.fails_from = first;
    draw_strips(drawn, kHeight, Workspace(ram), draw);
    CHECK_EQ(stored.status(), Status::read_failed);
    CHECK(stored.stats().failures != 0);
    CHECK_EQ(
        stored.font().kerning(2, 3) == 0 || stored.font().kerning(2, 3) == -40,
        true);
    uint16_t glyph = 7;
    CHECK(stored.font().glyph_of('B', glyph) != Status::no_glyph);
    // What was found meanwhile is right once storage answers.
    card.fails_from = UINT32_MAX;
    draw_strips(drawn, kHeight, Workspace(ram), draw);
    CHECK(are_equal());
    CHECK_EQ(stored.font().kerning(2, 3), -40);
    CHECK_EQ(stored.font().glyph_of('B', glyph), Status::ok);
    CHECK_EQ(glyph, 3);
    CHECK_EQ(stored.status(), Status::read_failed);
  }
  stored.clear();
  CHECK_EQ(stored.status(), Status::ok);
  // Whatever read fails as the file is opened.
  card.reads = 0;
  CHECK_EQ(open(card, 1, stored), Status::ok);
  const uint32_t opening = card.reads;
  for (uint32_t first = 0; first < opening; ++first) {
    card.reads = 0;
    card.fails_from = first;
    StoredTrueType other;
    CHECK_EQ(open(card, 1, other), Status::read_failed);
    CHECK_EQ(other.font().glyph_or_notdef('B'), 0);
  }
}

TEST(records_need_room) {
  Card card = build({});
  StoredTrueType stored;
  StoredTrueTypeOptions options;
  options.record_bytes = 40;
  CHECK_EQ(open(card, 2, stored, options), Status::ok);
  const auto draw = [&stored](char letter) {
    draw_strips(drawn, kHeight, Workspace(ram), [&](const Painter& painter) {
      painter.text(stored.font(), Style(10_px), {4_px, 16_px}, {&letter, 1});
    });
    return count_drawn();
  };
  CHECK(draw('A') > 20);
  CHECK_EQ(stored.status(), Status::ok);
  CHECK_EQ(draw('B'), 0);  // two contours
  CHECK_EQ(stored.status(), Status::buffer_small);
  CHECK(draw('A') > 20);
}

TEST(stored_text_is_cached) {
  Card card = build({});
  StoredTrueType stored;
  CHECK_EQ(open(card, 2, stored), Status::ok);
  alignas(8) static uint8_t cache_ram[4096];
  GlyphCache cache;
  CHECK(GlyphCache::make({cache_ram, sizeof cache_ram}, {}, cache) ==
        Status::ok);
  for (int32_t i = 0; i < 2; ++i) {
    draw_strips(drawn, kHeight, Workspace(ram), [&](const Painter& painter) {
      painter.with(cache).text(stored.font(), Style(10_px), {4_px, 16_px},
                               "AB");
    });
    CHECK(count_drawn() > 40);
  }
  CHECK(cache.stats().hits >= 2);
}

TEST(what_is_not_stored_is_refused) {
  const StoredTrueType closed;
  CHECK_EQ(closed.font().glyph_or_notdef('A'), 0);
  CHECK_EQ(closed.status(), Status::ok);
  CHECK_EQ(closed.stats().blocks, 0u);
  Card card = build({});
  StoredTrueType stored;
  const Storage storage = {Card::read, &card};
  const size_t least = StoredTrueType::ram_bytes(1);
  CHECK_EQ(StoredTrueType::open(storage, {lent + 4, least}, stored),
           Status::misaligned);
  CHECK_EQ(StoredTrueType::open(storage, {lent, 100}, stored),
           Status::buffer_small);
  CHECK_EQ(StoredTrueType::open(storage, {lent, least - kBlock}, stored),
           Status::buffer_small);
  StoredTrueTypeOptions options;
  options.record_bytes = UINT32_MAX;
  CHECK_EQ(StoredTrueType::open(storage, {lent, sizeof lent}, stored, options),
           Status::buffer_small);
  options = {};
  options.face = 1;
  CHECK_EQ(open(card, 1, stored, options), Status::no_glyph);
  file[0] = 7;
  CHECK_EQ(open(card, 1, stored), Status::bad_magic);
  file[0] = 0;
  file[5] = 2;  // tables
  CHECK_EQ(open(card, 1, stored), Status::corrupt);
  card.size = 0;
  CHECK_EQ(open(card, 1, stored), Status::read_failed);
  CHECK_EQ(stored.font().glyph_or_notdef('A'), 0);
}

}  // namespace
