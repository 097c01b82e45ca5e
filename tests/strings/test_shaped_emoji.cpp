// Emoji among letters: which run they are of. fonts.shaped_emoji shapes all of
// Unicode's.
#include <fonts/shaped_emoji.hpp>

#include "check.hpp"
#include "inkcell/shaping/shaping.hpp"

namespace {

using namespace inkcell;

// Runs of a text, as "2:6 " for bytes, and the glyphs that show something.
struct Runs {
  size_t ends[8] = {};
  size_t shown[8] = {};
  size_t count = 0;
};

Runs runs_of(const Shaping& shaping, const Text& text) {
  Runs runs;
  ScriptRun run = shaping.first_run(text, 0, text.size);
  do {
    TextGlyph room[32];
    Span<TextGlyph> glyphs(room);
    CHECK_OK(shaping.shape(text, run, glyphs));
    for (size_t i = 0; i < glyphs.size; ++i) {
      runs.shown[runs.count] += room[i].advance != 0 ? 1 : 0;
    }
    runs.ends[runs.count++] = run.end;
  } while (runs.count < 8 && shaping.next_run(text, text.size, run));
  return runs;
}

TEST(a_key_takes_its_digit_from_the_word) {
  Font font;
  Shaping shaping;
  CHECK_OK(Font::open(fonts::shaped_emoji, font));
  CHECK_OK(Shaping::open(font, shaping));
  const Runs keys = runs_of(shaping, "ab1\xef\xb8\x8f\xe2\x83\xa3");
  CHECK_EQ(keys.count, size_t{2});
  CHECK_EQ(keys.ends[0], size_t{2});
  CHECK_EQ(keys.shown[0], size_t{2});
  CHECK_EQ(keys.shown[1], size_t{1});
  const Runs first = runs_of(shaping, "1\xe2\x83\xa3z");
  CHECK_EQ(first.count, size_t{2});
  CHECK_EQ(first.ends[0], size_t{4});
  CHECK_EQ(first.shown[0], size_t{1});
}

// Two letters are a flag, and a third begins another one.
TEST(letters_of_flags_are_two_each) {
  Font font;
  Shaping shaping;
  CHECK_OK(Font::open(fonts::shaped_emoji, font));
  CHECK_OK(Shaping::open(font, shaping));
  const Text text(
      "\xf0\x9f\x87\xa6\xf0\x9f\x87\xa8\xf0\x9f\x87\xa6\xf0\x9f\x87\xa8"
      "\xf0\x9f\x87\xa6");
  TextGlyph room[8];
  Span<TextGlyph> glyphs(room);
  CHECK_OK(shaping.shape(text, shaping.first_run(text, 0, text.size), glyphs));
  CHECK_EQ(glyphs.size, size_t{3});
  CHECK_EQ(uint32_t{room[1].cluster}, 2u);
  CHECK_EQ(uint32_t{room[2].cluster}, 4u);
  CHECK_EQ(room[0].glyph, room[1].glyph);
}

}  // namespace
