// Strings of char8_t, as C++20 has them, are texts.
#include "check.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/value_label.hpp"
#include "outline_record.hpp"

namespace {

using namespace inkcell;

alignas(4) uint8_t font_bytes[outline_record::kSampleFontBytes];

bool reads(Text text, const char* expected) {
  const Text wanted = expected;
  return text.size == wanted.size &&
         __builtin_memcmp(text.data, wanted.data, wanted.size) == 0;
}

}  // namespace

TEST(strings_of_char8_are_texts) {
  static_assert(__cplusplus > 201703L);
  CHECK(reads(u8"21.5 \u00b0C",
              "21.5 \xc2\xb0"
              "C"));
  CHECK(reads(u8"", ""));
  Font font;
  const size_t size = outline_record::build_sample_font(font_bytes);
  CHECK_OK(Font::open({font_bytes, size}, font));
  const Style style(20_px);
  const Rect box = Painter().box(font, style, {5, 30}, u8"AD");
  CHECK(box.x1 > box.x0);
  CHECK_EQ(box.x1, Painter().box(font, style, {5, 30}, "AD").x1);
  ValueLabel value(font, style, {5, 30});
  CHECK_EQ(value.set(u8"AD", {}).x1, box.x1);
}
