// Texts of several scripts, fonts that shape them, and a page to draw on.
#pragma once

#include <fonts/shaped_dejavu.hpp>
#include <fonts/shaped_deva.hpp>
#include <fonts/shaped_hebrew.hpp>
#include <fonts/shaped_latin.hpp>
#include <fonts/shaped_naskh.hpp>
#include <fonts/shaped_thai.hpp>

#include "check.hpp"
#include "inkcell/layout/text_box.hpp"
#include "inkcell/port/a8.hpp"
#include "inkcell/shaping/devanagari.hpp"
#include "inkcell/shaping/text_shaper.hpp"

namespace inkcell::test {

constexpr int32_t kWidth = 320;
constexpr int32_t kHeight = 200;

constexpr const char* kArabic =
    "السلام عليكم (123) مرحبا، لا إله [عالم] 45.6% نهاية. "
    "الكِتَابُ «مُحَمَّدٌ» ١٢٣ كلمةٌ طويلة\tثم سطر\n"
    "(12) نص ثانٍ بلا وقف";
constexpr const char* kHebrew =
    "שלום (12) [עולם] 3.5% בְּרֵאשִׁ֖ית הַשָּׁמַיִם, ב־2026 "
    "ועוד קצת מילים";
constexpr const char* kThai =
    "สวัสดีครับ น้ำ ปี่ ที่นี่ (12) กตัญญู ฐานญาติ ผู้ใหญ่ "
    "3.5% ปั๊ม";
constexpr const char* kLatin =
    "office fjord AVATAR To Tie\u0302\u0301ng Vie\u0323\u0302t, A\u0300 (12) "
    "[Trươ\u0300ng] 45.6% u\u031b\u0303 waffle";
constexpr const char* kHindi =
    "हिन्दी (१२) स्थिति [कर्म] क्षत्रिय विद्यार्थी श्रृंखला, "
    "राष्ट्रीय द्वितीय ड़ेढ़ गया।";
constexpr const char* kMixed =
    "Hello السلام عليكم, price (45.6) is عشرة [5] office. "
    "שלום A\u0301 world ١٢٣ end";

struct Case {
  Span<const uint8_t> rom;
  const char* text;
  bool parts_at_spaces;
};
inline const Case kCases[] = {{fonts::shaped_naskh, kArabic, true},
                              {fonts::shaped_dejavu, kArabic, false},
                              {fonts::shaped_hebrew, kHebrew, true},
                              {fonts::shaped_thai, kThai, true},
                              {fonts::shaped_latin, kLatin, true},
                              {fonts::shaped_deva, kHindi, true},
                              {fonts::shaped_dejavu, kLatin, false},
                              {fonts::shaped_dejavu, kMixed, false}};

struct Page {
  uint8_t pixels[kWidth * kHeight] = {};
  port::A8Canvas canvas{Strip{pixels, 0, 0, kWidth, kHeight, kWidth}};

  int32_t differences(const Page& other) const {
    int32_t count = 0;
    for (int32_t i = 0; i < kWidth * kHeight; ++i) {
      count += pixels[i] != other.pixels[i] ? 1 : 0;
    }
    return count;
  }
  int32_t ink() const {
    int32_t count = 0;
    for (const uint8_t pixel : pixels) {
      count += pixel != 0 ? 1 : 0;
    }
    return count;
  }
};

inline Font open(Span<const uint8_t> rom) {
  Font font;
  CHECK_OK(Font::open(rom, font));
  return font;
}

struct Shaped {
  explicit Shaped(Span<const uint8_t> rom) : font(open(rom)) {
    CHECK_OK(Shaping::open(font, kDevanagari, shaping));
  }
  TextBox box(const Rect& rect) {
    TextBox box(font, style, rect);
    box.options.set_bidi(bidi);
    box.options.set_shaper(shaper);
    return box;
  }

  Font font;
  Style style = Style(17_px);
  Shaping shaping;
  TextGlyph room[256];
  TextShaper shaper{room, kDevanagari};
  uint16_t cells[512];
  Bidi bidi{cells};
};

}  // namespace inkcell::test
