// Styles that tools make for displays: those of the device's canvases.
#include "look.hpp"

#include <gtest/gtest.h>

#include "display.hpp"
#include "inkcell/port/grey2.hpp"
#include "inkcell/port/mono_pages.hpp"
#include "rom_file.hpp"

namespace inkcell::tools {
namespace {

Style style_on(Display display, double px, double angle, const Font& font) {
  LookOptions options;
  suit_display(display, options);
  options.hint = "display";
  return Look(options, font, px, angle, Use::text).style();
}

TEST(Look, DrawsAsTheCanvasesOfFewLevels) {
  const RomFile file = load_rom(INKCELL_GOLDEN_FONT);
  const Font& font = file.font();
  const Style two = port::MonoPagesCanvas::style(12_px);
  ASSERT_TRUE(two.is_fitted());
  EXPECT_TRUE(is_same(style_on(Display::mono, 12, 0, font), two));
  EXPECT_TRUE(is_same(style_on(Display::mono_pages, 12, 0, font), two));
  EXPECT_TRUE(is_same(style_on(Display::grey2, 12, 0, font),
                      port::Grey2Canvas::style(12_px)));
  // Larger text and turned text stay as designed, and keep their thin strokes.
  EXPECT_FALSE(style_on(Display::mono, 40, 0, font).is_fitted());
  EXPECT_FALSE(style_on(Display::mono, 12, 30, font).is_fitted());
  EXPECT_EQ(style_on(Display::mono, 40, 0, font).effect(), two.effect());
  EXPECT_FALSE(style_on(Display::grey8, 12, 0, font).is_fitted());
  EXPECT_EQ(style_on(Display::grey8, 12, 0, font).effect(), nullptr);
}

}  // namespace
}  // namespace inkcell::tools
