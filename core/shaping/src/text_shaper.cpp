#include "inkcell/shaping/text_shaper.hpp"

#include "inkcell/format/rom.hpp"

namespace inkcell {
namespace {

// Clusters are byte offsets of 16 bits there, a character up to 4 of them.
constexpr size_t kMostCharacters = 65535 / 4;

uint32_t most_of(size_t glyphs) noexcept {
  const size_t most = glyphs < kMostCharacters ? glyphs : kMostCharacters;
  return most == 0 ? 1 : static_cast<uint32_t>(most);
}

// Makes clusters, which count characters, count bytes of the run.
void count_bytes(const Text& text,
                 const ScriptRun& run,
                 Span<TextGlyph> glyphs) noexcept {
  Text rest(text.data + run.begin, run.end - run.begin);
  uint32_t number = 0;
  for (size_t i = 0; i < glyphs.size; ++i) {
    TextGlyph& glyph = glyphs[run.is_right_to_left ? glyphs.size - 1 - i : i];
    for (; number < glyph.cluster && rest.size != 0; ++number) {
      static_cast<void>(next_code_point(rest));
    }
    glyph.cluster = static_cast<uint16_t>(run.end - run.begin - rest.size);
  }
}

}  // namespace

TextShaper::TextShaper(Span<TextGlyph> room) noexcept
    : WordShaper(open_font, shape_part, most_of(room.size)), room_(room) {}

bool TextShaper::open_font(WordShaper& shaper, const Font& font) noexcept {
  auto& own = static_cast<TextShaper&>(shaper);
  const Span<const uint8_t> section = font.section(format::section::kShaping);
  if (own.font_ != &font || own.tables_ != section.data) {
    own.font_ = &font;
    own.tables_ = section.data;
    if (Shaping::open(font, own.shaping_) != Status::ok) {
      own.tables_ = nullptr;
      return false;
    }
    own.parts_at_spaces = own.shaping_.parts_at_spaces();
  }
  return section.data != nullptr;
}

uint32_t TextShaper::shape_part(WordShaper& shaper,
                                const Text& text,
                                uint32_t begin,
                                uint32_t end,
                                bool is_right_to_left) noexcept {
  auto& own = static_cast<TextShaper&>(shaper);
  ScriptRun run = own.shaping_.first_run(text, begin, end);
  run.is_right_to_left = is_right_to_left;
  shaper.glyphs = {};
  shaper.is_cut = false;
  while (run.program != ScriptRun::kNoProgram) {
    Span<TextGlyph> glyphs = own.room_;
    const Status status = own.shaping_.shape(text, run, glyphs);
    if (status == Status::ok) {
      count_bytes(text, run, glyphs);
      shaper.glyphs = {glyphs.data, glyphs.size};
      shaper.joins = own.shaping_.joins(run);
      break;
    }
    const Text half =
        cut({text.data + begin, run.end - begin}, (run.end - begin) / 2);
    if (status != Status::buffer_small || half.size == 0) {
      break;
    }
    run.end = begin + half.size;
    shaper.is_cut = true;
  }
  return static_cast<uint32_t>(run.end);
}

}  // namespace inkcell
