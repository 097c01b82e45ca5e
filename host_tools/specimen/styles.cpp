// Sheets of styles.
#include "styles.hpp"

#include <stdexcept>
#include <string>

#include "canvas.hpp"
#include "inkcell/bilevel.hpp"
#include "inkcell/edge_contrast.hpp"
#include "inkcell/fit.hpp"
#include "inkcell/lcd.hpp"
#include "inkcell/motion_blur.hpp"
#include "inkcell/shadow.hpp"
#include "inkcell/stroke.hpp"
#include "sheet.hpp"

namespace inkcell::tools {
namespace {

constexpr uint32_t kWhite = 0xffffff;
constexpr uint32_t kBlack = 0x000000;
constexpr uint32_t kNight = 0x101828;
constexpr uint32_t kSand = 0xf4ead5;

Q6_10 to_q10(double px) {
  return Q6_10::from_raw(static_cast<int16_t>(px * 1024));
}

FilterSpec spec_of(double outside, double inside) {
  FilterSpec spec;
  spec.outside_px = to_q10(outside);
  spec.inside_px = to_q10(inside);
  return spec;
}

void check(const Font& font, double px, const Filter& filter) {
  const Q26_6 size = Q26_6::from_raw(static_cast<int32_t>(px * 64));
  if (check_reach(font.range(), size, filter) != Status::ok) {
    throw std::runtime_error(
        "the font's distances do not reach far enough for effects; say "
        "--band-px 2 --min-px 12");
  }
}

// A line of text in a sample.
struct Sample {
  const Font& font;
  std::string text;
  double px;
  double x;
  double y;

  void write(const Style& style, uint32_t colour, Image& image) const {
    write_text(font, text, style, x, y, colour, image);
  }
  void write(const Filter& filter,
             uint32_t colour,
             Image& image,
             double right = 0,
             double down = 0) const {
    write_text(font, text, make_style(px, 0, filter), x + right, y + down,
               colour, image);
  }
};

}  // namespace

Image draw_filters(const Font& font) {
  const Sample sample = {font, "Sphinx of quartz, 1958", 14, 4, 15};
  Sheet sheet(font, sample.px, {180, 20, 3, 0, 180});
  const auto add = [&](const char* label, const Filter& filter,
                       bool dark = false) {
    sheet.add(label, dark ? kBlack : kWhite, [&](Image& image) {
      sample.write(filter, dark ? kWhite : kBlack, image);
    });
  };
  add("text: -0.5 to 0.5 px", kFilterText);
  add("motion: -0.6 to 0.625 px", kFilterMotion);
  add("paper_display: -0.75 to 0.75 px, exponent 1.1", kFilterPaperDisplay);
  add("paper_body: -0.5 to 0.625 px, exponent 1.1", kFilterPaperBody);
  FilterSpec spec = spec_of(-0.75, 0.75);
  spec.profile = FilterProfile::gaussian;
  add("gaussian: -0.75 to 0.75 px", make_filter(spec));
  spec.profile = FilterProfile::sigmoid;
  add("sigmoid: -0.75 to 0.75 px", make_filter(spec));
  add("weight -0.15 px", with_weight(kFilterText, to_q10(-0.15)));
  add("weight +0.15 px", with_weight(kFilterText, to_q10(0.15)));
  add("weight +0.3 px", with_weight(kFilterText, to_q10(0.3)));
  add("light on dark, gamma 1", kFilterText, true);
  spec = spec_of(-0.5, 0.5);
  spec.gamma.raw = 461;
  add("light on dark, gamma 1.8", make_filter(spec), true);
  spec.polarity = Polarity::dark_on_light;
  add("dark on light, gamma 1.8", make_filter(spec));
  spec = spec_of(-0.5, 0.5);
  spec.contrast.raw = 410;
  add("contrast 1.6", make_filter(spec));
  return sheet.finish();
}

Image draw_lcd(const Font& font) {
  const Sample sample = {font, "Sphinx of quartz, 1958", 13, 4, 14.3};
  Sheet sheet(font, sample.px, {180, 19, 3, 0, 180});
  const auto add = [&](const char* label, const Lcd* lcd, uint32_t ground,
                       uint32_t colour) {
    sheet.add(label, ground, [&](Image& image) {
      Style style = make_style(sample.px, 0, kFilterText);
      if (lcd != nullptr) {
        style.set_effect(*lcd);
      }
      sample.write(style, colour, image);
    });
  };
  Lcd lcd;
  add("grey", nullptr, kWhite, kBlack);
  add("rgb", &lcd, kWhite, kBlack);
  lcd.order = SubPixels::bgr;
  add("bgr", &lcd, kWhite, kBlack);
  lcd.order = SubPixels::rgb_vertical;
  add("rgb, horizontal stripes", &lcd, kWhite, kBlack);
  lcd.order = SubPixels::rgb;
  lcd.colour = 128;
  add("rgb, half of the colour", &lcd, kWhite, kBlack);
  lcd.colour = 255;
  add("rgb, light on dark", &lcd, kBlack, kWhite);
  add("rgb, in colour", &lcd, kNight, 0xffc060);
  return sheet.finish();
}

Image draw_effects(const Font& font) {
  constexpr double kPx = 32;
  const Sample sample = {font, "Effects", kPx, 8, 34};
  Sheet sheet(font, kPx, {136, 46, 2, 0, 136, 2});
  const auto add_outline = [&](const char* label, StrokePlace place,
                               double width) {
    const Stroke stroke(kFilterText, to_q10(width), place);
    check(font, kPx, stroke.outer);
    check(font, kPx, stroke.inner);
    sheet.add(label, kWhite, [&](Image& image) {
      Style style = make_style(kPx, 0, kFilterText);
      style.set_effect(stroke);
      sample.write(style, kBlack, image);
    });
  };
  add_outline("outline 1 px, inner", StrokePlace::inner, 1);
  add_outline("outline 1 px, centred", StrokePlace::centred, 1);
  add_outline("outline 1.5 px, outer", StrokePlace::outer, 1.5);
  const Stroke two(kFilterText, to_q10(2), StrokePlace::outer);
  sheet.add("outline and fill in one pass", kNight, [&](Image& image) {
    const port::Rgb888Canvas fill = canvas_of(image, 0xffd070);
    const StrokeAndFill both(two, &fill);
    Style style = make_style(kPx, 0, kFilterText);
    style.set_effect(both);
    sample.write(style, 0xb02030, image);
  });
  const Filter shadow = shadow_filter(to_q10(2.5));
  check(font, kPx, shadow);
  sheet.add("shadow, soft by 2.5 px, 2 px down and to the right", kSand,
            [&](Image& image) {
              sample.write(shadow, 0xa09880, image, 2, 2);
              sample.write(kFilterText, 0x203050, image);
            });
  const Filter glow = glow_filter(to_q10(4));
  check(font, kPx, glow);
  sheet.add("glow of 4 px", kNight, [&](Image& image) {
    sample.write(glow, 0x2080ff, image);
    sample.write(kFilterText, 0xe8f4ff, image);
  });
  return sheet.finish();
}

Image draw_fitting(const Font& font) {
  constexpr double kPx = 9;
  if (!font.has_outlines()) {
    throw std::runtime_error(
        "--fitting moves points of outlines: make the font by "
        "inkcell-fontgen --coding outline");
  }
  const Sample sample = {font, "Eggs, ham & 38 buns", kPx, 4.3, 13.4};
  Sheet sheet(font, kPx, {128, 18, 6, 3, 92});
  // `options` may be null.
  const auto add = [&](const char* label, const FitOptions* options,
                       bool is_bilevel) {
    sheet.add(label, kWhite, [&](Image& image) {
      Style style = make_style(kPx, 0, kFilterText);
      Fit fit;
      Bilevel bilevel;
      if (options != nullptr) {
        if (Fit::make(font, style, *options, fit) != Status::ok) {
          throw std::runtime_error("the font's hints are broken");
        }
        style.set_fit(fit);
        bilevel.threshold_px = fit.bilevel_weight();
      }
      if (is_bilevel) {
        style.set_effect(bilevel);
      }
      sample.write(style, kBlack, image);
    });
  };
  FitOptions options;
  add("as designed", nullptr, false);
  add("heights fitted", &options, false);
  options.across = true;
  add("stems and advances, too", &options, false);
  add("1 bit, as designed", nullptr, true);
  options.levels = 2;
  add("1 bit, fitted", &options, true);
  return sheet.finish();
}

Image draw_contrast(const Font& font) {
  constexpr double kPx = 12;
  const Sample sample = {font, "Hamburg at noon", kPx, 4.3, 13.4};
  Sheet sheet(font, kPx, {128, 18, 6, 3, 92});
  const auto add = [&](const char* label, const EdgeContrast& edge_contrast) {
    sheet.add(label, kWhite, [&](Image& image) {
      Style style = make_style(kPx, 0, kFilterText);
      style.set_effect(edge_contrast);
      sample.write(style, kBlack, image);
    });
  };
  const EdgeContrast all;
  add("as designed", EdgeContrast(0, 0));
  add("left and lower edges darker", EdgeContrast(all.edge, 0));
  add("thin strokes darker", EdgeContrast(0, all.thin));
  add("both", all);
  return sheet.finish();
}

Image draw_maps(const Font& font) {
  constexpr double kPx = 24;
  Sheet sheet(font, kPx, {112, 50, 5, 0, 112});
  // The axes of the glyphs [em], and the origin [px].
  struct Map {
    const char* label;
    double x_right;
    double x_up;
    double y_right;
    double y_up;
    double x;
    double y;
  };
  const Map maps[] = {
      {"upright", 1, 0, 0, 1, 6, 34},
      {"leaning by 1/5", 1, 0, 0.2, 1, 6, 34},
      {"narrow: 0.7 of the width", 0.7, 0, 0, 1, 6, 34},
      {"wide: 1.2 of the width", 1.2, 0, 0, 1, 6, 34},
      {"mirrored", -1, 0, 0, 1, 90, 34},
      {"turned by 10 degrees", 0.9848, 0.1736, -0.1736, 0.9848, 8, 40}};
  for (const Map& map : maps) {
    const auto px = [](double em) {
      return Q16_16::from_raw(static_cast<int32_t>(em * kPx * 65536));
    };
    const Style style(
        {px(map.x_right), px(map.x_up), px(map.y_right), px(map.y_up)},
        kFilterText);
    sheet.add(map.label, kWhite, [&](Image& image) {
      write_text(font, "Sphinx", style, map.x, map.y, kBlack, image);
    });
  }
  return sheet.finish();
}

Image draw_motion(const Font& font) {
  constexpr double kPx = 24;
  const Sample sample = {font, "Sphinx 1958", kPx, 8, 26};
  Sheet sheet(font, kPx, {160, 36, 4, 0, 160});
  const auto add = [&](const char* label, double right, double down) {
    const MotionBlur blur(make_point(right, down));
    sheet.add(label, kWhite, [&](Image& image) {
      Style style = make_style(kPx, 0, kFilterText);
      style.set_effect(blur);
      sample.write(style, kBlack, image);
    });
  };
  add("at rest", 0, 0);
  add("1.5 px to the right", 1.5, 0);
  add("6 px to the right", 6, 0);
  add("3 px down", 0, 3);
  add("4 px to the right and 4 px up", 4, -4);
  return sheet.finish();
}

Image draw_levels(const Font& font) {
  const Sample sample = {font, "Sphinx of quartz, 1958", 11, 4, 12.4};
  Sheet sheet(font, sample.px, {152, 17, 4, 0, 152});
  const auto add = [&](const char* label, const Bilevel* bilevel,
                       uint8_t threshold) {
    sheet.add(label, kWhite, [&](Image& image) {
      Style style = make_style(sample.px, 0, kFilterText);
      if (bilevel != nullptr) {
        style.set_effect(*bilevel);
      }
      sample.write(style, kBlack, image);
      for (uint8_t& level : image.pixels) {
        level =
            bilevel == nullptr ? (level <= 255 - threshold ? 0 : 255) : level;
      }
    });
  };
  Bilevel bilevel;
  add("1 bit, threshold alone", nullptr, 128);
  add("1 bit, bilevel", &bilevel, 0);
  bilevel.threshold_px = to_q10(-0.15);
  add("1 bit, bilevel, bolder by 0.15 px", &bilevel, 0);
  bilevel = Bilevel(4);
  add("2 bits, bilevel", &bilevel, 0);
  return sheet.finish();
}

}  // namespace inkcell::tools
