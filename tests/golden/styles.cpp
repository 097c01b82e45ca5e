#include "styles.hpp"

#include "inkcell/bilevel.hpp"
#include "inkcell/edge_contrast.hpp"
#include "inkcell/field/circle_samples.hpp"
#include "inkcell/field/draw.hpp"
#include "inkcell/field/splat.hpp"
#include "inkcell/fit.hpp"
#include "inkcell/lcd.hpp"
#include "inkcell/motion_blur.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/shadow.hpp"
#include "inkcell/stroke.hpp"
#include "inkcell/supersample.hpp"

namespace golden {
namespace {

using namespace inkcell;

struct Line {
  FontId font;
  const char* text;
  int32_t size_q6;
  int32_t x_q6;
  int32_t y_q6;
};

constexpr FitOptions kHeights;
constexpr FitOptions kAcross = {true};
constexpr FitOptions kTwoLevels = {true, 2};

// `options` may be null: not fitted.
bool draw_line(const Line& line,
               const Style& style,
               const FitOptions* options,
               const Sink& sink) {
  Font font;
  Fit fit;
  if (open_any_font(font_bytes(line.font), font) != Status::ok) {
    return false;
  }
  Style own = style;
  if (options != nullptr) {
    if (Fit::make(font, style, *options, fit) != Status::ok) {
      return false;
    }
    own.set_fit(fit);
  }
  const Point origin = {Q26_6::from_raw(line.x_q6), Q26_6::from_raw(line.y_q6)};
  Painter(sink).text(font, own, origin, line.text);
  return true;
}

Style style_of(const Line& line, const Filter& filter) {
  return Style(Q26_6::from_raw(line.size_q6), filter);
}

// `effect` may be null. Not inline, so that there is one style at a time on the
// stack.
__attribute__((noinline)) bool draw_painted(const Line& line,
                                            const Filter& filter,
                                            const Effect* effect,
                                            const FitOptions* fit,
                                            const Sink& sink) {
  Style style = style_of(line, filter);
  if (effect != nullptr) {
    style.set_effect(*effect);
  }
  return draw_line(line, style, fit, sink);
}

bool draw_plain(const Line& line,
                const Filter& filter,
                const FitOptions* fit,
                const Sink& sink) {
  return draw_painted(line, filter, nullptr, fit, sink);
}

bool draw_fitted(const Sink& sink) {
  return draw_plain({FontId::dejavu_sans_outline, "Inkcell 42", 12 * 64,
                     2 * 64 + 13, 12 * 64 + 21},
                    kFilterText, &kHeights, sink) &&
         draw_plain({FontId::roboto_outline, "Roboty", 17 * 64 + 32,
                     80 * 64 + 40, 15 * 64 + 50},
                    kFilterText, &kAcross, sink);
}

bool draw_adaptive(const Sink& sink) {
  const CircleSamples even(kFilterMotion, kCalmRadius);
  if (!draw_painted({FontId::dejavu_sans_field, "Againniag", 10 * 64 + 11,
                     2 * 64, 28 * 64 + 17},
                    kFilterMotion, &even, nullptr, sink)) {
    return false;
  }
  const CircleSamples paper(kFilterPaperDisplay, kPaperRadius,
                            SampleRule::paper);
  return draw_painted(
      {FontId::dejavu_sans_field, "Again", 14 * 64, 90 * 64 + 7, 31 * 64},
      kFilterPaperDisplay, &paper, nullptr, sink);
}

bool draw_splats(const Sink& sink) {
  // Fewer than the pixels of a glyph.
  uint32_t sums[2 * kMinSplatSums];
  const Splat splat(sums);
  return draw_painted({FontId::dejavu_sans_field, "Again", 13 * 64 + 7,
                       112 * 64 + 9, 169 * 64 + 30},
                      kFilterText, &splat, nullptr, sink);
}

bool draw_perceptual(const Sink& sink) {
  const EdgeContrast edge_contrast;
  return draw_painted(
      {FontId::dejavu_sans_field, "Againgain", 14 * 64, 3 * 64 + 9, 45 * 64},
      kFilterText, &edge_contrast, nullptr, sink);
}

bool draw_blurred(const Sink& sink) {
  const MotionBlur blur({Q26_6::from_raw(3 * 64 + 20), Q26_6::from_raw(-70)});
  return draw_painted(
      {FontId::dejavu_sans_field, "Agin", 22 * 64, 95 * 64, 50 * 64},
      kFilterText, &blur, nullptr, sink);
}

bool draw_outlined(const Sink& sink) {
  const Stroke stroke(kFilterText, Q6_10::from_raw(1300));
  if (!draw_painted(
          {FontId::dejavu_serif_outline, "Qua", 30 * 64, 2 * 64 + 5, 78 * 64},
          kFilterText, &stroke, nullptr, sink)) {
    return false;
  }
  const StrokeAndFill both(stroke, &sink);
  return draw_painted(
      {FontId::dejavu_sans_outline, "Inn", 28 * 64, 85 * 64, 80 * 64},
      kFilterText, &both, nullptr, sink);
}

bool draw_weighted(const Sink& sink) {
  const Filter bold = with_weight(kFilterText, Q6_10::from_raw(300));
  const Filter soft = shadow_filter(Q6_10::from_raw(1500));
  return draw_plain(
             {FontId::roboto_outline, "Roboty", 16 * 64, 2 * 64, 98 * 64}, bold,
             nullptr, sink) &&
         draw_plain(
             {FontId::dejavu_sans_outline, "Ink", 26 * 64, 90 * 64, 104 * 64},
             soft, nullptr, sink);
}

bool draw_bilevel(const Sink& sink) {
  const Bilevel two(2, Q6_10::from_raw(-100));
  const Bilevel four(4);
  return draw_painted({FontId::dejavu_serif_outline, "AV Qua", 11 * 64,
                       2 * 64 + 30, 118 * 64},
                      kFilterText, &two, nullptr, sink) &&
         draw_painted({FontId::dejavu_sans_outline, "Inkcell", 9 * 64, 80 * 64,
                       118 * 64},
                      kFilterText, &four, nullptr, sink);
}

// Leaning and narrow; in a mirror; and adaptive along a turned line.
bool draw_turned(const Sink& sink) {
  const auto px = [](int32_t q10) { return Q16_16::from_raw(q10 * 64); };
  Style style({px(15000), Q16_16(), px(4300), px(20480)}, kFilterText);
  if (!draw_line({FontId::dejavu_sans_outline, "Inkcell", 0, 2 * 64, 144 * 64},
                 style, nullptr, sink)) {
    return false;
  }
  style = Style({px(-18000), Q16_16(), Q16_16(), px(18000)}, kFilterText);
  if (!draw_line({FontId::roboto_outline, "Root", 0, 158 * 64, 140 * 64}, style,
                 nullptr, sink)) {
    return false;
  }
  Direction direction;
  direction.cosine.raw = 1065418748;
  direction.sine.raw = -133530580;
  const CircleSamples even(kFilterText);
  style = Style(15_px, kFilterText, direction);
  style.set_effect(even);
  return draw_line(
      {FontId::dejavu_sans_field, "Againgain", 0, 3 * 64, 160 * 64}, style,
      nullptr, sink);
}

// By area, upright and turned.
bool draw_areas(const Sink& sink) {
  const Line upright = {FontId::dejavu_sans_outline,
                        "Inkcell 42 \xc3\xa4 \xf0\x9d\x94\xb8", 13 * 64 + 5,
                        2 * 64 + 9, 30 * 64 + 3};
  const Line turned = {FontId::dejavu_serif_outline, "Quava&", 18 * 64, 4 * 64,
                       168 * 64};
  Direction direction;
  direction.cosine.raw = 858993459;
  direction.sine.raw = 644245094;
  const Style area = style_of(upright, kFilterArea);
  const Style turned_area(Q26_6::from_raw(turned.size_q6), kFilterArea,
                          direction);
  const Style distance(15_px, kFilterText, direction);
  return draw_line(upright, area, nullptr, sink) &&
         draw_line(turned, turned_area, nullptr, sink) &&
         draw_line({FontId::roboto_outline, "Roboty", 0, 50 * 64, 170 * 64},
                   distance, nullptr, sink);
}

// By distance, as it comes, fitted, and of many contours.
bool draw_distances(const Sink& sink) {
  return draw_plain({FontId::dejavu_sans_outline, "Inkcell 42 Inkcell 24",
                     8 * 64, 2 * 64, 9 * 64},
                    kFilterText, nullptr, sink) &&
         draw_plain({FontId::dejavu_serif_outline, "AVQua & Vau", 15 * 64,
                     2 * 64, 49 * 64},
                    kFilterText, &kHeights, sink) &&
         draw_plain({FontId::noto_sans_cjk_outline,
                     "\xe6\xb0\xb8\xe5\xad\x97\xe8\xbd\x9f", 30 * 64 + 1,
                     2 * 64, 78 * 64},
                    kFilterPaperBody, nullptr, sink);
}

bool draw_soft(const Sink& sink) {
  const Filter soft = shadow_filter(Q6_10::from_raw(1500));
  return draw_plain(
      {FontId::dejavu_sans_outline, "Ink", 24 * 64, 98 * 64, 76 * 64}, soft,
      nullptr, sink);
}

bool draw_edges(const Sink& sink) {
  const Stroke stroke(kFilterText, Q6_10::from_raw(1300));
  return draw_painted(
      {FontId::roboto_outline, "Roby", 28 * 64, 2 * 64, 106 * 64}, kFilterText,
      &stroke, nullptr, sink);
}

bool draw_two_levels(const Sink& sink) {
  const Bilevel two(2, Q6_10::from_raw(-100));
  const Bilevel four(4);
  return draw_painted(
             {FontId::roboto_outline, "Robot", 11 * 64, 80 * 64, 100 * 64},
             kFilterText, &two, nullptr, sink) &&
         draw_painted({FontId::dejavu_serif_outline, "Quav", 11 * 64, 120 * 64,
                       100 * 64},
                      kFilterText, &two, &kTwoLevels, sink) &&
         draw_painted({FontId::dejavu_sans_outline, "Inkcell", 9 * 64, 80 * 64,
                       112 * 64},
                      kFilterText, &four, &kAcross, sink) &&
         draw_plain({FontId::dejavu_sans_outline, "Inkcell", 9 * 64, 118 * 64,
                     112 * 64},
                    kFilterText, &kAcross, sink);
}

using DrawLook = bool (*)(const Sink& sink);

// By address, so that none is inlined: there are
// the filters of one style at a time on the stack.
constexpr DrawLook kOutlineLooks[] = {draw_distances, draw_areas, draw_soft,
                                      draw_edges, draw_two_levels};

}  // namespace

bool draw_outlines(const Sink& sink) {
  for (const DrawLook draw : kOutlineLooks) {
    if (!draw(sink)) {
      return false;
    }
  }
  return true;
}

bool draw_styles(const Sink& sink) {
  return draw_fitted(sink) && draw_adaptive(sink) && draw_splats(sink) &&
         draw_perceptual(sink) && draw_blurred(sink) && draw_outlined(sink) &&
         draw_weighted(sink) && draw_bilevel(sink) && draw_turned(sink);
}

bool draw_sub_pixels(const Sink& sink) {
  constexpr SubPixels kOrders[] = {SubPixels::rgb, SubPixels::bgr,
                                   SubPixels::rgb_vertical,
                                   SubPixels::bgr_vertical};
  int32_t y_q6 = 20 * 64 + 11;
  for (const SubPixels order : kOrders) {
    const Lcd lcd(order, static_cast<uint8_t>(y_q6 >> 5));
    if (!draw_painted(
            {FontId::dejavu_sans_outline, "Inkcell", 13 * 64 + 9, 2 * 64, y_q6},
            kFilterText, &lcd, nullptr, sink) ||
        !draw_painted({FontId::roboto_outline, "Roy", 30 * 64, 85 * 64, y_q6},
                      kFilterText, &lcd, nullptr, sink)) {
      return false;
    }
    y_q6 += 42 * 64 + 7;
  }
  return true;
}

}  // namespace golden
