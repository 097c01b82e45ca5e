// Text of every script, shaped by HarfBuzz, which the program brings.
//
//   static TextGlyph room[256];  // the longest line
//   static HarfBuzzShaper shaper(room);
//   box.options.set_bidi(bidi);
//   box.options.set_shaper(shaper);
//
// For fonts made with --keep-layout, which keep GSUB, GPOS and GDEF as they
// are. HarfBuzz takes some 170 KB of code of a Cortex-M4, and memory from
// malloc().
#pragma once

#include <hb.h>
#include <stdint.h>

#include "inkcell/font.hpp"
#include "inkcell/span.hpp"
#include "inkcell/word_shaper.hpp"

namespace inkcell {

namespace detail {
// Section LAYT; without data: the font has none.
struct KeptLayout {
  Span<const uint8_t> bytes;
  const Font* font = nullptr;
};
}  // namespace detail

/// Shapes the lines of text boxes and labels, as TextShaper does, with the
/// whole of HarfBuzz. One for each task that lays out text. Not copied: it owns
/// the objects of HarfBuzz for the font that it shaped last.
class HarfBuzzShaper : public WordShaper {
 public:
  /// `room`: a glyph for each character of the longest line, and some more
  /// where fonts take letters apart; at least 2. What is longer is shaped in
  /// parts.
  explicit HarfBuzzShaper(Span<TextGlyph> room) noexcept;
  ~HarfBuzzShaper();
  HarfBuzzShaper(const HarfBuzzShaper&) = delete;
  HarfBuzzShaper& operator=(const HarfBuzzShaper&) = delete;

  /// Chooses forms of a language by its tag of BCP 47, such as "ur" or "bn-BD".
  /// null: those of no language, as at first.
  void set_language(const char* tag) noexcept;

 private:
  static bool open_font(WordShaper& shaper, const Font& font) noexcept;
  static uint32_t shape_part(WordShaper& shaper,
                             const Text& text,
                             uint32_t begin,
                             uint32_t end,
                             bool is_right_to_left) noexcept;
  bool fill(uint32_t begin) noexcept;

  Span<TextGlyph> room_;
  detail::KeptLayout kept_;
  hb_buffer_t* buffer_;
  hb_font_t* font_ = nullptr;
  hb_language_t language_ = HB_LANGUAGE_INVALID;
};

}  // namespace inkcell
