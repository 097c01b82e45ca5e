// Pictures of labels: Inkcell's fonts beside LVGL's own, which lv_font_conv
// made from the same file, as LVGL draws them.
//
//   inkcell_lvgl_shots FOLDER   writes text.png, text_large.png, arc.png,
//   digit.png
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <vector>

#include "fonts/lv_sans.hpp"
#include "image.hpp"
#include "inkcell/lvgl/inkcell_lvgl.h"
#include "screen.hpp"

LV_FONT_DECLARE(lv_conv_14)
LV_FONT_DECLARE(lv_conv_28)

namespace {

using inkcell::tools::Image;

constexpr const char* kText = "Hamburgefonts AVA 0.9 \xc3\xa4";

struct Fonts {
  inkcell_lv_font_t plain[2];
  inkcell_lv_font_t fitted[2];
  inkcell_lv_fit_t fits[2];
};

void make(inkcell_lv_font_t& font, int32_t size_px) {
  if (inkcell_lv_font_init(&font, fonts::lv_sans, sizeof fonts::lv_sans,
                           size_px * 64) != LV_RESULT_OK) {
    throw std::runtime_error("the font does not open");
  }
}

Image picture_of(Screen& screen, int width, int height) {
  const std::vector<uint8_t>& pixels = screen.draw();
  Image image(width, height, 3);
  for (int i = 0; i < width * height; ++i) {
    const auto from = static_cast<size_t>(i) * 3;
    for (size_t channel = 0; channel < 3; ++channel) {
      image.pixels[from + channel] = pixels[from + 2 - channel];
    }
  }
  return image;
}

// From top to bottom at each size: lv_font_conv, plain, fitted.
Image draw_text() {
  static Fonts fonts;
  const lv_font_t* converted[2] = {&lv_conv_14, &lv_conv_28};
  constexpr int kWidth = 420;
  constexpr int kHeight = 170;
  Screen screen(kWidth, kHeight, LV_COLOR_FORMAT_RGB888, 16);
  int32_t y = 4;
  for (int i = 0; i < 2; ++i) {
    const int32_t size_px = 14 * (i + 1);
    make(fonts.plain[i], size_px);
    make(fonts.fitted[i], size_px);
    if (inkcell_lv_font_fit_heights(&fonts.fitted[i], &fonts.fits[i]) !=
        LV_RESULT_OK) {
      throw std::runtime_error("the hints are corrupt");
    }
    for (const lv_font_t* font :
         {converted[i], static_cast<const lv_font_t*>(&fonts.plain[i].lv),
          static_cast<const lv_font_t*>(&fonts.fitted[i].lv)}) {
      Look look;
      look.font = font;
      look.text = kText;
      look.x = 6;
      look.y = y;
      look.colour = 0x000000;
      look.background = 0xffffff;
      screen.add(look);
      y += size_px + size_px / 4 + 1;
    }
    y += 4;
  }
  return picture_of(screen, kWidth, kHeight);
}

Image draw_digit() {
  static inkcell_lv_font_t font;
  constexpr int kWidth = 320;
  constexpr int kHeight = 480;
  Screen screen(kWidth, kHeight, LV_COLOR_FORMAT_RGB888, 16);
  make(font, 512);
  inkcell_lv_font_set_direct(&font);
  Look look;
  look.font = &font.lv;
  look.text = "0";
  look.y = -60;
  screen.add(look);
  return picture_of(screen, kWidth, kHeight);
}

void add_arc(const lv_font_t& font, int32_t x) {
  lv_obj_t* const arc = lv_arclabel_create(lv_screen_active());
  lv_obj_set_pos(arc, x, 0);
  lv_obj_set_size(arc, 180, 180);
  lv_arclabel_set_radius(arc, 70);
  lv_arclabel_set_angle_start(arc, 160);
  lv_arclabel_set_angle_size(arc, 300);
  lv_arclabel_set_text(arc, "Text on an arc, 0123");
  lv_obj_set_style_text_font(arc, &font, 0);
  lv_obj_set_style_text_color(arc, lv_color_black(), 0);
}

void add_stroke(const lv_font_t& font) {
  lv_obj_t* const label = lv_label_create(lv_screen_active());
  lv_obj_set_pos(label, 360, 60);
  lv_obj_set_style_pad_all(label, 6, 0);
  lv_obj_set_style_text_letter_space(label, 3, 0);
  lv_label_set_text(label, "Stroke");
  lv_obj_set_style_text_font(label, &font, 0);
  lv_obj_set_style_text_color(label, lv_color_hex(0xffe060), 0);
  lv_obj_set_style_text_outline_stroke_width(label, 3, 0);
  lv_obj_set_style_text_outline_stroke_opa(label, LV_OPA_COVER, 0);
  lv_obj_set_style_text_outline_stroke_color(label, lv_color_hex(0x802010), 0);
}

// From the left: a direct font, LVGL's own of the same file, a stroke.
Image draw_arc() {
  static inkcell_lv_font_t small;
  static inkcell_lv_font_t large;
  constexpr int kWidth = 540;
  constexpr int kHeight = 136;
  Screen screen(kWidth, kHeight, LV_COLOR_FORMAT_RGB888, 16);
  lv_obj_set_style_bg_color(lv_screen_active(), lv_color_white(), 0);
  lv_obj_set_style_bg_opa(lv_screen_active(), LV_OPA_COVER, 0);
  make(small, 20);
  inkcell_lv_font_set_direct(&small);
  make(large, 48);
  inkcell_lv_font_set_direct(&large);
  inkcell_lv_font_set_outline_stroke(&large);
  std::ifstream file(INKCELL_FONT_FILE, std::ios::binary);
  const std::vector<char> ttf{std::istreambuf_iterator<char>(file), {}};
  const lv_font_t* const other =
      lv_tiny_ttf_create_data(ttf.data(), ttf.size(), 20);
  if (other == nullptr) {
    throw std::runtime_error("lv_tiny_ttf does not open " INKCELL_FONT_FILE);
  }
  add_arc(small.lv, 0);
  add_arc(*other, 180);
  add_stroke(large.lv);
  return picture_of(screen, kWidth, kHeight);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: inkcell_lvgl_shots FOLDER\n");
    return 2;
  }
  try {
    const std::filesystem::path folder = argv[1];
    const Image text = draw_text();
    write_image(folder / "text.png", text);
    write_image(folder / "text_large.png", enlarge(text, 3));
    write_image(folder / "arc.png", draw_arc());
    write_image(folder / "digit.png", draw_digit());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "inkcell_lvgl_shots: %s\n", error.what());
    return 1;
  }
  return 0;
}
