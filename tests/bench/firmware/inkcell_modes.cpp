// Inkcell with a font of fields or of outlines in every way that glyphs can
// look, one a mode; a font of outlines lacks the glyphs of modes that it cannot
// draw. kWorkspace bytes are lent to outlines.
// Those of a display with sub-pixels, and "plain_rgb888" to compare them with,
// draw into 24-bit pixels, all others into 8-bit coverage.
#include "inkcell/bilevel.hpp"
#include "inkcell/edge_contrast.hpp"
#include "inkcell/field/circle_samples.hpp"
#include "inkcell/fit.hpp"
#include "inkcell/lcd.hpp"
#include "inkcell/motion_blur.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/port/lcd.hpp"
#include "inkcell/prepared_glyph.hpp"
#include "inkcell/shadow.hpp"
#include "inkcell/stroke.hpp"
#include "inkcell_strips.hpp"

using namespace inkcell;

namespace {

// What styles point to: made anew for each size.
Fit fit;
Lcd lcd;
constexpr Stroke kStroke(kFilterText, Q6_10::from_int(1), StrokePlace::inner);
StrokeAndFill stroke_and_fill(kStroke);
CircleSamples circle_samples(kFilterText);
Supersample supersample;
constexpr EdgeContrast kContrast;
constexpr MotionBlur kBlur({Q26_6::from_int(3), {}});
Bilevel bilevel;

constexpr int32_t kColourBytes = 3;
static_assert(kColourBytes <= bench::kMaxPixelBytes, "strips hold them");
port::Rgb888Canvas colour_canvas;
constexpr size_t kWorkspace = 2560;
alignas(4) uint8_t workspace[kWorkspace];

// The filters of the modes that are one.
Filter filter;

bool is_coloured = false;

bool set_fit(Style& style, bool across) {
  FitOptions options;
  options.across = across;
  style.set_fit(fit);
  return Fit::make(bench::font, style, options, fit) == Status::ok;
}

template <typename Kind>
bool set(Style& style, const Kind& effect) {
  style.set_effect(effect);
  return true;
}

bool set_lcd(Style& style, SubPixels order) {
  is_coloured = true;
  port::set_sub_pixels(colour_canvas);
  lcd.order = order;
  return set(style, lcd);
}

bool set_adaptive(Style& style, Q6_10 radius, SampleRule rule) {
  if (bench::font.has_outlines() && rule == SampleRule::even) {
    supersample = Supersample(radius);
    return set(style, supersample);
  }
  circle_samples = CircleSamples(kFilterText, radius, rule);
  return set(style, circle_samples);
}

// The inner edge of an outline of 1 px: no font is too narrow for it.
bool set_bilevel(Style& style, uint8_t levels) {
  bilevel.levels = levels;
  return set(style, bilevel);
}

bool set_filter(Style& style, const Filter& made) {
  filter = made;
  style = Style(style.size(), filter);
  return true;
}

struct Mode {
  const char* name;
  bool (*set)(Style& style);
};

constexpr Mode kModes[] = {
    {"plain", [](Style&) { return true; }},
    {"fitted", [](Style& style) { return set_fit(style, false); }},
    {"fitted_stems", [](Style& style) { return set_fit(style, true); }},
    {"outline", [](Style& style) { return set(style, kStroke); }},
    {"outline_and_fill",
     [](Style& style) {
       stroke_and_fill.fill = &bench::sink;
       return set(style, stroke_and_fill);
     }},
    {"bold",
     [](Style& style) {
       return set_filter(style, with_weight(kFilterText, Q6_10::from_raw(256)));
     }},
    {"shadow_2_px",
     [](Style& style) {
       return set_filter(style, shadow_filter(Q6_10::from_int(2)));
     }},
    {"glow_4_px",
     [](Style& style) {
       return set_filter(style, glow_filter(Q6_10::from_int(4)));
     }},
    {"bilevel_1_bit", [](Style& style) { return set_bilevel(style, 2); }},
    {"bilevel_2_bits", [](Style& style) { return set_bilevel(style, 4); }},
    {"perceptual", [](Style& style) { return set(style, kContrast); }},
    {"motion_blur_3_px", [](Style& style) { return set(style, kBlur); }},
    {"adaptive_even",
     [](Style& style) {
       return set_adaptive(style, kSharpRadius, SampleRule::even);
     }},
    {"adaptive_area",
     [](Style& style) {
       style = Style(style.size(), kFilterArea);
       return set_adaptive(style, kSharpRadius, SampleRule::even);
     }},
    {"adaptive_paper",
     [](Style& style) {
       return set_adaptive(style, kPaperRadius, SampleRule::paper);
     }},
    {"plain_rgb888",
     [](Style&) {
       is_coloured = true;
       return true;
     }},
    {"lcd", [](Style& style) { return set_lcd(style, SubPixels::rgb); }},
    {"lcd_vertical",
     [](Style& style) { return set_lcd(style, SubPixels::rgb_vertical); }},
};

}  // namespace

bool engine_set_size(uint32_t px, const char* way) {
  bench::style = Style(Q26_6::from_int(static_cast<int32_t>(px)), kFilterText);
  for (const Mode& mode : kModes) {
    if (bench::equal(way, mode.name)) {
      is_coloured = false;
      return mode.set(bench::style);
    }
  }
  return false;
}

engine_answer engine_prepare(uint32_t code_point) {
  if (!bench::font.has_outlines()) {
    return bench::place_glyph(code_point);
  }
  uint16_t glyph = 0;
  PreparedGlyph prepared;
  if (bench::font.check(bench::style) != Status::ok ||
      bench::font.glyph_of(code_point, glyph) != Status::ok ||
      PreparedGlyph::make(bench::font, glyph, bench::style, {},
                          {workspace, kWorkspace}, prepared) != Status::ok) {
    return engine_lacks;
  }
  return bench::place(glyph, prepared.box());
}

// Outlines, decoded once for all strips.
template <typename DrawStrips>
void draw_prepared(uint16_t glyph, const DrawStrips& draw_strips) {
  PreparedGlyph prepared;
  if (PreparedGlyph::make(bench::font, glyph, bench::style, bench::origin,
                          {workspace, kWorkspace}, prepared) == Status::ok) {
    draw_strips([&prepared] { prepared.draw(bench::sink); });
  }
}

void engine_draw(uint32_t code_point) {
  uint16_t glyph = 0;
  if (bench::font.glyph_of(code_point, glyph) != Status::ok) {
    return;
  }
  const auto draw_strips = [](const auto& draw) {
    if (is_coloured) {
      bench::draw_strips(colour_canvas, kColourBytes, draw);
    } else {
      bench::draw_strips(draw);
    }
  };
  if (bench::font.has_outlines()) {
    draw_prepared(glyph, draw_strips);
    return;
  }
  draw_strips([glyph] {
    Painter(bench::sink).glyph(bench::font, bench::style, bench::origin, glyph);
  });
}

size_t engine_workspace() {
  return bench::font.has_outlines() ? kWorkspace : 0;
}
