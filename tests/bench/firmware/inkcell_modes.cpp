// Inkcell with a font of edges or of outlines in every way that glyphs can
// look, one a mode; a font of outlines lacks the glyphs of modes that it cannot
// draw. kWorkspace bytes are lent to outlines.
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
#include "inkcell/prepared_glyph.hpp"
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
constexpr size_t kWorkspace = 2560;
alignas(4) uint8_t workspace[kWorkspace];

// The filters of the modes that are one.
Filter filter;

bool is_coloured = false;

Status make_sink(ColourTarget& target, Sink& out) {
  return port::make_lcd_sink(target, out);
}

bool set_fit(Brush& brush, bool across) {
  FitOptions options;
  options.across = across;
  brush.set_fitter(&kGridFit, &fit);
  return Fit::make(bench::font, brush, options, fit) == Status::ok;
}

bool set_lcd(Brush& brush, SubPixels order) {
  is_coloured = true;
  lcd.order = order;
  brush.set_painter(lcd_painter(lcd));
  return true;
}

bool set_adaptive(Brush& brush, Q6_10 radius, SampleRule rule) {
  adaptive = make_adaptive(kFilterText, radius, rule);
  brush.set_painter(adaptive_painter(adaptive));
  return true;
}

// The inner edge of an outline of 1 px: no font is too narrow for it.
void make_edges() {
  edges = make_outline(kFilterText, Q6_10::from_raw(1024), OutlinePlace::inner);
}

bool set_motion_blur(Brush& brush) {
  const Point way = {Q26_6::from_int(3), {}};
  const Status status = make_motion_blur(kFilterText, way, blur);
  brush.set_painter(motion_blur_painter(blur));
  return status == Status::ok;
}

bool set_crisp(Brush& brush, uint8_t levels) {
  crisp.levels = levels;
  brush.set_painter(crisp_painter(crisp));
  return true;
}

bool set_filter(Brush& brush, const Filter& made) {
  filter = made;
  return Brush::make(brush.size(), filter, brush) == Status::ok;
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
       brush.set_painter(outline_painter(edges.inner));
       return true;
     }},
    {"outline_and_fill",
     [](Brush& brush) {
       make_edges();
       outline_and_fill = {&edges.inner, &bench::sink};
       brush.set_painter(outline_and_fill_painter(outline_and_fill));
       return true;
     }},
    {"bold",
     [](Brush& brush) {
       return set_filter(brush, with_weight(kFilterText, Q6_10::from_raw(256)));
     }},
    {"shadow_2_px",
     [](Brush& brush) {
       return set_filter(brush, shadow_filter(Q6_10::from_int(2)));
     }},
    {"glow_4_px",
     [](Brush& brush) {
       return set_filter(brush, glow_filter(Q6_10::from_int(4)));
     }},
    {"crisp_1_bit", [](Brush& brush) { return set_crisp(brush, 2); }},
    {"crisp_2_bits", [](Brush& brush) { return set_crisp(brush, 4); }},
    {"perceptual",
     [](Brush& brush) {
       brush.set_painter(perception_painter(perception));
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
  if (!bench::font.has_outlines()) {
    return bench::place_glyph(code_point);
  }
  uint16_t glyph = 0;
  PreparedGlyph prepared;
  if (check_painter(bench::font, bench::brush) != Status::ok ||
      bench::font.glyph_of(code_point, glyph) != Status::ok ||
      PreparedGlyph::make(bench::font, glyph, bench::brush, {},
                          {workspace, kWorkspace}, prepared) != Status::ok) {
    return engine_lacks;
  }
  return bench::place(glyph, prepared.box());
}

// Outlines, decoded once for all strips.
template <typename DrawStrips>
void draw_prepared(uint16_t glyph, const DrawStrips& draw_strips) {
  PreparedGlyph prepared;
  if (PreparedGlyph::make(bench::font, glyph, bench::brush, bench::origin,
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
      bench::draw_strips(colour_target, kColourBytes, draw);
    } else {
      bench::draw_strips(draw);
    }
  };
  if (bench::font.has_outlines()) {
    draw_prepared(glyph, draw_strips);
    return;
  }
  draw_strips([glyph] {
    draw_glyph(bench::font, glyph, bench::brush, bench::origin, bench::sink);
  });
}

size_t engine_workspace() {
  return bench::font.has_outlines() ? kWorkspace : 0;
}
