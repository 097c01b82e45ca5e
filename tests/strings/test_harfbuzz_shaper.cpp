// Scripts that Inkcell does not shape itself: the adapter's glyphs are those of
// HarfBuzz on the font file.
#include "inkcell/port/harfbuzz_shaper.hpp"

#include <map>
#include <string>

#include <fonts/kept_bengali.hpp>
#include <fonts/kept_khmer.hpp>
#include <fonts/kept_tamil.hpp>

#include "check.hpp"
#include "inkcell/layout/text_box.hpp"
#include "inkcell/port/a8.hpp"

namespace {

using namespace inkcell;

struct Case {
  const char* file;
  Span<const uint8_t> rom;
  const char* words;
};

const Case kCases[] = {
    {"NotoSansBengali-Regular.ttf", fonts::kept_bengali,
     "\u09ac\u09be\u0982\u09b2\u09be \u09b6\u09cd\u09b0\u09c0 "
     "\u0995\u09cd\u09b7\u09c7\u09a4\u09cd\u09b0 "
     "\u09aa\u09cd\u09b0\u09b6\u09cd\u09a8 \u0995\u09cb "
     "\u0995\u09cc\u09b0\u09cd\u09ae \u09ac\u09dc \u09af\u09be\u09df"},
    {"NotoSansTamil-Regular.ttf", fonts::kept_tamil,
     "\u0ba4\u0bae\u0bbf\u0bb4\u0bcd \u0bb8\u0bcd\u0bb0\u0bc0 "
     "\u0b95\u0bca\u0bae\u0bcd\u0baa\u0bc1 \u0b95\u0bcb "
     "\u0b95\u0bcc \u0b95\u0bcd\u0bb7"},
    {"NotoSansKhmer-Regular.ttf", fonts::kept_khmer,
     "\u1797\u17b6\u179f\u17b6\u1781\u17d2\u1798\u17c2\u179a "
     "\u1780\u17d2\u179a\u17bb\u1784 \u17a2\u17ca\u17be\u17c7 "
     "\u1780\u17c4\u17c7 \u179f\u17d2\u178f\u17d2\u179a\u17b8"}};

Text text_of(const char* words) {
  size_t size = 0;
  while (words[size] != 0) {
    ++size;
  }
  return {words, size};
}

// The glyphs of HarfBuzz on the file itself.
hb_buffer_t* shaped(const Case& one) {
  const std::string path = std::string(NOTO_FOLDER) + one.file;
  hb_blob_t* blob = hb_blob_create_from_file(path.c_str());
  hb_face_t* face = hb_face_create(blob, 0);
  hb_font_t* font = hb_font_create(face);
  hb_buffer_t* buffer = hb_buffer_create();
  hb_buffer_add_utf8(buffer, one.words, -1, 0, -1);
  hb_buffer_guess_segment_properties(buffer);
  hb_buffer_set_language(buffer, HB_LANGUAGE_INVALID);
  hb_shape(font, buffer, nullptr, 0);
  hb_font_destroy(font);
  hb_face_destroy(face);
  hb_blob_destroy(blob);
  return buffer;
}

TEST(is_harfbuzz_on_the_file) {
  for (const Case& one : kCases) {
    Font font;
    CHECK_OK(Font::open(one.rom, font));
    TextGlyph room[128];
    HarfBuzzShaper shaper(room);
    CHECK(shaper.open(shaper, font));
    const Text text = text_of(one.words);
    const auto size = static_cast<uint32_t>(text.size);
    CHECK_EQ(shaper.shape(shaper, text, 0, size, false), size);
    hb_buffer_t* buffer = shaped(one);
    unsigned count = 0;
    const hb_glyph_info_t* infos = hb_buffer_get_glyph_infos(buffer, &count);
    const hb_glyph_position_t* places =
        hb_buffer_get_glyph_positions(buffer, &count);
    CHECK_EQ(shaper.glyphs.size, size_t{count});
    std::map<uint16_t, hb_codepoint_t> names;
    for (unsigned i = 0; i < count && i < shaper.glyphs.size; ++i) {
      const TextGlyph& glyph = shaper.glyphs[i];
      CHECK(glyph.glyph != 0);
      CHECK_EQ(names.emplace(glyph.glyph, infos[i].codepoint).first->second,
               infos[i].codepoint);
      CHECK_EQ(uint32_t{glyph.cluster}, infos[i].cluster);
      CHECK_EQ(int32_t{glyph.advance}, places[i].x_advance);
      CHECK_EQ(int32_t{glyph.x}, places[i].x_offset);
      CHECK_EQ(int32_t{glyph.y}, places[i].y_offset);
    }
    hb_buffer_destroy(buffer);
  }
}

// Text of other scripts, rooms that are too small and any bytes.
TEST(takes_any_text_and_room) {
  Font font;
  CHECK_OK(Font::open(fonts::kept_khmer, font));
  TextGlyph room[2];
  HarfBuzzShaper shaper(room);
  CHECK(shaper.open(shaper, font));
  const Text text("ab \xff\u1780\u17d2\u179a\u17bb\u1784 \u0627", 23);
  uint32_t begin = 0;
  while (begin < text.size) {
    const uint32_t end = shaper.shape(shaper, text, begin,
                                      static_cast<uint32_t>(text.size), true);
    CHECK(end > begin);
    CHECK(shaper.glyphs.size <= 2);
    begin = end > begin ? end : static_cast<uint32_t>(text.size);
  }
}

// The vowel is drawn on the left of its letter.
TEST(boxes_draw_what_it_shapes) {
  constexpr int32_t kWidth = 60;
  constexpr int32_t kHeight = 40;
  static uint8_t pixels[2][kWidth * kHeight];
  Font font;
  CHECK_OK(Font::open(fonts::kept_bengali, font));
  const Style style(20_px);
  TextBox box(font, style, {0, 0, kWidth, kHeight});
  for (auto& page : pixels) {
    port::A8Canvas canvas{Strip{page, 0, 0, kWidth, kHeight, kWidth}};
    box.draw("\u0995\u09bf", Painter(canvas));
    static TextGlyph room[256];          // the longest line
    static HarfBuzzShaper shaper(room);  // <inkcell/port/harfbuzz_shaper.hpp>
    box.options.set_shaper(shaper);
  }
  bool differs = false;
  for (int32_t i = 0; i < kWidth * kHeight; ++i) {
    differs = differs || pixels[0][i] != pixels[1][i];
  }
  CHECK(differs);
}

}  // namespace
