#include "fonts.hpp"

// GOLDEN_FONTS, a string, is the folder of the .bin files: CMake sets it.
#define GOLDEN_FONT(name)                   \
  asm(".pushsection .rodata." #name         \
      ", \"a\"\n"                           \
      ".balign 4\n"                         \
      ".globl golden_" #name                \
      "\n"                                  \
      "golden_" #name                       \
      ":\n"                                 \
      ".incbin \"" GOLDEN_FONTS "/" #name   \
      ".bin\"\n"                            \
      ".globl golden_" #name                \
      "_end\n"                              \
      "golden_" #name                       \
      "_end:\n"                             \
      ".popsection\n");                     \
  extern "C" const uint8_t golden_##name[]; \
  extern "C" const uint8_t golden_##name##_end[]

GOLDEN_FONT(dejavu_sans_field);
GOLDEN_FONT(dejavu_sans_outline);
GOLDEN_FONT(dejavu_serif_outline);
GOLDEN_FONT(roboto_outline);
GOLDEN_FONT(noto_sans_cjk_outline);

namespace golden {

inkcell::Span<const uint8_t> font_bytes(FontId id) {
  struct Ends {
    const uint8_t* begin;
    const uint8_t* end;
  };
  static constexpr Ends kFonts[kFontCount] = {
      {golden_dejavu_sans_field, golden_dejavu_sans_field_end},
      {golden_dejavu_sans_outline, golden_dejavu_sans_outline_end},
      {golden_dejavu_serif_outline, golden_dejavu_serif_outline_end},
      {golden_roboto_outline, golden_roboto_outline_end},
      {golden_noto_sans_cjk_outline, golden_noto_sans_cjk_outline_end}};
  const Ends& font = kFonts[static_cast<int>(id)];
  return {font.begin, static_cast<size_t>(font.end - font.begin)};
}

}  // namespace golden
