// TrueType files through the interface for C: the same pixels as in C++.
#include "inkcell/c/truetype.h"

#include "check.hpp"
#include "inkcell/inkcell.h"
#include "inkcell/painter.hpp"
#include "inkcell/port/a8.hpp"
#include "inkcell/truetype/plain_truetype.hpp"
#include "inkcell/truetype/truetype_font.hpp"
#include "sfnt_font.hpp"

namespace {

using namespace inkcell;

constexpr int32_t kWidth = 96;
constexpr int32_t kHeight = 24;

uint8_t file[2048];
alignas(4) uint8_t pixels[kWidth * kHeight];
uint8_t wanted[kWidth * kHeight];

void draw(const Font& font) {
  __builtin_memset(wanted, 0, sizeof wanted);
  const port::A8Canvas canvas(
      {{wanted, sizeof wanted}, 0, 0, kWidth, kHeight, kWidth});
  Painter(canvas).text(font, Style(20_px), {2, 20}, "ACB G");
}

void draw_in_c(const inkcell_font_t& font, const inkcell_style_t& style) {
  __builtin_memset(pixels, 0, sizeof pixels);
  inkcell_a8_target_t target = {};
  target.strip.pixels = pixels;
  target.strip.size = sizeof pixels;
  target.strip.width = kWidth;
  target.strip.height = kHeight;
  target.strip.stride = kWidth;
  inkcell_sink_t sink;
  CHECK_EQ(inkcell_a8_sink(&target, &sink), INKCELL_OK);
  inkcell_painter_t painter = {};
  painter.sink = &sink;
  inkcell_draw_text(&painter, &font, "ACB G", 5, &style, 2 * 64, 20 * 64);
}

int32_t count_full() {
  int32_t count = 0;
  for (const uint8_t pixel : pixels) {
    count += pixel == 255 ? 1 : 0;
  }
  return count;
}

TEST(files_are_drawn_from_c) {
  const Span<const uint8_t> bytes = {file, sfnt_font::build(file, {})};
  CHECK(bytes.size <= sizeof file);
  const struct {
    inkcell_status_t (*open)(
        const void*, size_t, uint32_t, inkcell_truetype_t*, inkcell_font_t*);
    const Coding& coding;
    inkcell_status_t distances;
  } kinds[] = {{inkcell_truetype_open, kTrueTypeCoding, INKCELL_UNSUPPORTED},
               {inkcell_truetype_open_plain, kPlainTrueTypeCoding, INKCELL_OK}};
  for (const auto& kind : kinds) {
    inkcell_truetype_t room;
    inkcell_font_t font;
    CHECK_EQ(kind.open(bytes.data, bytes.size, 0, &room, &font), INKCELL_OK);
    inkcell_style_t style;
    CHECK_EQ(inkcell_style_make(20 * 64, &inkcell_filter_text, &style),
             INKCELL_OK);
    CHECK_EQ(inkcell_font_check(&font, &style), kind.distances);
    CHECK_EQ(inkcell_style_make(20 * 64, &inkcell_filter_area, &style),
             INKCELL_OK);
    CHECK_EQ(inkcell_font_check(&font, &style), INKCELL_OK);
    TrueTypeFont same;
    CHECK_EQ(same.open(bytes, kind.coding), Status::ok);
    draw_in_c(font, style);
    draw(same.font());
    CHECK_EQ(__builtin_memcmp(pixels, wanted, sizeof pixels), 0);
    CHECK(count_full() > 200);
    // Why not; and what is left then draws nothing.
    CHECK_EQ(kind.open(bytes.data, bytes.size, 1, &room, &font),
             INKCELL_NO_GLYPH);
    draw_in_c(font, style);
    CHECK_EQ(count_full(), 0);
    CHECK_EQ(kind.open(pixels, sizeof pixels, 0, &room, &font),
             INKCELL_BAD_MAGIC);
  }
}

// A file of so many bytes, in storage.
bool read(void* context, uint32_t offset, uint8_t* bytes, uint32_t count) {
  const size_t size = *static_cast<const size_t*>(context);
  for (uint32_t i = 0; i != count && offset + i < size; ++i) {
    bytes[i] = file[offset + i];
  }
  return offset < size;
}

TEST(stored_files_are_drawn_from_c) {
  alignas(8) static uint8_t lent[INKCELL_STORED_TRUETYPE_BYTES(2, 512)];
  size_t size = sfnt_font::build(file, {});
  const inkcell_storage_t card = {read, &size};
  inkcell_stored_truetype_options_t options = {0, 512};
  inkcell_stored_truetype_t stored;
  inkcell_font_t font;
  CHECK_EQ(inkcell_stored_truetype_open(&card, &options, lent, sizeof lent,
                                        &stored, &font),
           INKCELL_OK);
  inkcell_style_t style;
  CHECK_EQ(inkcell_style_make(20 * 64, &inkcell_filter_area, &style),
           INKCELL_OK);
  draw_in_c(font, style);
  TrueTypeFont same;
  CHECK_EQ(same.open({file, size}), Status::ok);
  draw(same.font());
  CHECK_EQ(__builtin_memcmp(pixels, wanted, sizeof pixels), 0);
  CHECK(count_full() > 200);
  inkcell_stored_stats_t stats;
  inkcell_stored_truetype_stats(&stored, &stats);
  CHECK_EQ(stats.blocks, 2u);
  CHECK(stats.reads != 0);
  // The card is taken out.
  const size_t all = size;
  size = 0;
  inkcell_stored_truetype_clear(&stored);
  draw_in_c(font, style);
  CHECK_EQ(count_full(), 0);
  CHECK_EQ(inkcell_stored_truetype_status(&stored), INKCELL_READ_FAILED);
  CHECK_EQ(inkcell_stored_truetype_open(&card, nullptr, lent, sizeof lent,
                                        &stored, &font),
           INKCELL_BUFFER_SMALL);
  size = all;
  options.face = 1;
  CHECK_EQ(inkcell_stored_truetype_open(&card, &options, lent, sizeof lent,
                                        &stored, &font),
           INKCELL_NO_GLYPH);
  draw_in_c(font, style);
  CHECK_EQ(count_full(), 0);
}

}  // namespace
