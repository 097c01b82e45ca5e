// Inkcell with a font of edges in every way that glyphs can look, one a mode.
// Those of a display with sub-pixels, and "plain_rgb888" to compare them with,
// draw into 24-bit pixels, all others into 8-bit coverage.
#include "inkcell/adaptive.hpp"
#include "inkcell/crisp.hpp"
#include "inkcell/effects.hpp"
#include "inkcell/fit.hpp"
#include "inkcell/lcd.hpp"
#include "inkcell/motion_blur.hpp"
#include "inkcell/perception.hpp"
#include "inkcell/port/lcd.hpp"
#include "inkcell_strips.hpp"

using namespace inkcell;

namespace {

// What brushes point to: made anew for each size.
Fit fit;
LcdStyle lcd;
Outline edges;
OutlineAndFill outline_and_fill;
Adaptive adaptive;
Perception perception;
MotionBlur blur;
CrispStyle crisp;

struct ColourTarget : port::Rgb888Target {};
constexpr int32_t kColourBytes = 3;
static_assert(kColourBytes <= bench::kMaxPixelBytes, "strips hold them");
ColourTarget colour_target;
bool is_coloured = false;

Status make_sink(ColourTarget& target, Sink& out) {
  return port::make_lcd_sink(target, out);
}

bool set_fit(Brush& brush, bool stems) {
  FitOptions options;
  options.stems = stems;
  brush.set_fitter(fit_glyph, &fit);
  return Fit::make(bench::font, brush, options, fit) == Status::ok;
}

bool set_lcd(Brush& brush, SubPixels order) {
  is_coloured = true;
  lcd.order = order;
  brush.set_painter(paint_lcd, &lcd, kLcdReach);
  return true;
}

bool set_adaptive(Brush& brush, Q6_10 radius, SampleRule rule) {
  adaptive = make_adaptive(kFilterText, radius, rule);
  brush.set_painter(paint_adaptive, &adaptive, kAdaptiveReach);
  return true;
}

// The inner edge of an outline of 1 px: no font is too narrow for it.
void make_edges() {
  edges = make_outline(kFilterText, Q6_10::from_raw(1024), OutlinePlace::inner);
}

bool set_motion_blur(Brush& brush) {
  const Point way = {Q26_6::from_int(3), {}};
  const Status status = make_motion_blur(kFilterText, way, blur);
  brush.set_painter(paint_motion_blur, &blur, blur.reach_px);
  return status == Status::ok;
}

bool set_crisp(Brush& brush, uint8_t levels) {
  crisp.levels = levels;
  brush.set_painter(paint_crisp, &crisp, kCrispReach);
  return true;
}

struct Mode {
  const char* name;
  bool (*set)(Brush& brush);
};

constexpr Mode kModes[] = {
    {"plain", [](Brush&) { return true; }},
    {"fitted", [](Brush& brush) { return set_fit(brush, false); }},
    {"fitted_stems", [](Brush& brush) { return set_fit(brush, true); }},
    {"outline",
     [](Brush& brush) {
       make_edges();
       brush.set_painter(paint_outline, &edges.inner);
       return true;
     }},
    {"outline_and_fill",
     [](Brush& brush) {
       make_edges();
       outline_and_fill = {&edges.inner, &bench::sink};
       brush.set_painter(paint_outline_and_fill, &outline_and_fill);
       return true;
     }},
    {"crisp_1_bit", [](Brush& brush) { return set_crisp(brush, 2); }},
    {"crisp_2_bits", [](Brush& brush) { return set_crisp(brush, 4); }},
    {"perceptual",
     [](Brush& brush) {
       brush.set_painter(paint_perceptual, &perception, kPerceptionReach);
       return true;
     }},
    {"motion_blur_3_px", set_motion_blur},
    {"adaptive_even",
     [](Brush& brush) {
       return set_adaptive(brush, kSharpRadius, SampleRule::even);
     }},
    {"adaptive_paper",
     [](Brush& brush) {
       return set_adaptive(brush, kPaperRadius, SampleRule::paper);
     }},
    {"plain_rgb888",
     [](Brush&) {
       is_coloured = true;
       return true;
     }},
    {"lcd", [](Brush& brush) { return set_lcd(brush, SubPixels::rgb); }},
    {"lcd_vertical",
     [](Brush& brush) { return set_lcd(brush, SubPixels::rgb_vertical); }},
};

}  // namespace

bool engine_set_size(uint32_t px, const char* way) {
  if (Brush::make(Q26_6::from_int(static_cast<int32_t>(px)), kFilterText,
                  bench::brush) != Status::ok) {
    return false;
  }
  for (const Mode& mode : kModes) {
    if (bench::equal(way, mode.name)) {
      is_coloured = false;
      return mode.set(bench::brush);
    }
  }
  return false;
}

engine_answer engine_prepare(uint32_t code_point) {
  return bench::place_glyph(code_point);
}

void engine_draw(uint32_t code_point) {
  uint16_t glyph = 0;
  if (bench::font.glyph_of(code_point, glyph) != Status::ok) {
    return;
  }
  const auto draw = [glyph] {
    draw_glyph(bench::font, glyph, bench::brush, bench::origin, bench::sink);
  };
  if (is_coloured) {
    bench::draw_strips(colour_target, kColourBytes, draw);
  } else {
    bench::draw_strips(draw);
  }
}

size_t engine_workspace() {
  return 0;
}
