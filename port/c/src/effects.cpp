// clang-format off
// Made by port/c/make_api.py from port/c/api.txt: edit that instead.
#include "mirror.hpp"

using namespace inkcell;
using namespace inkcell::c;

void inkcell_stroke_make(const inkcell_filter_t* edge,
                         int16_t width_q10,
                         uint8_t place,
                         inkcell_stroke_t* stroke,
                         inkcell_filter_t* outer) {
  new (into(stroke)) Stroke(filter_of(edge), Q6_10::from_raw(width_q10),
      static_cast<StrokePlace>(place));
  *outer = {&ref(stroke).outer};
}

void inkcell_style_set_stroke(inkcell_style_t* style,
                              const inkcell_stroke_t* stroke) {
  ref(style).set_effect(ref(stroke));
}

void inkcell_style_set_stroke_and_fill(inkcell_style_t* style,
                                       const inkcell_stroke_t* stroke,
                                       inkcell_stroke_and_fill_t* both) {
  ref(style).set_effect(*new (into(both)) StrokeAndFill(ref(stroke),
      cpp(both->fill)));
}

void inkcell_style_set_lcd(inkcell_style_t* style, inkcell_lcd_t* options) {
  ref(style).set_effect(made<Lcd>(options->effect,
      static_cast<SubPixels>(options->order), options->colour));
}

void inkcell_style_set_bilevel(inkcell_style_t* style,
                               inkcell_bilevel_t* options) {
  ref(style).set_effect(made<Bilevel>(options->effect, options->levels,
      Q6_10::from_raw(options->threshold_q10)));
}

void inkcell_style_set_edge_contrast(inkcell_style_t* style,
                                     inkcell_edge_contrast_t* options) {
  ref(style).set_effect(made<EdgeContrast>(options->effect, options->edge,
      options->thin));
}

void inkcell_style_set_supersample(inkcell_style_t* style,
                                   inkcell_supersample_t* options) {
  ref(style).set_effect(made<Supersample>(options->effect,
      Q6_10::from_raw(options->radius_q10)));
}

void inkcell_circle_samples_make(const inkcell_filter_t* filter,
                                 int16_t radius_q10,
                                 bool is_paper,
                                 inkcell_circle_samples_t* out) {
  new (into(out)) CircleSamples(filter_of(filter), Q6_10::from_raw(radius_q10),
      is_paper ? SampleRule::paper : SampleRule::even);
}

void inkcell_style_set_circle_samples(inkcell_style_t* style,
                                      const inkcell_circle_samples_t* options) {
  ref(style).set_effect(ref(options));
}

inkcell_status_t inkcell_motion_blur_make(int32_t way_x_q6,
                                          int32_t way_y_q6,
                                          inkcell_motion_blur_t* out) {
  constexpr int32_t kMost = MotionBlur::kMost.raw;
  if (way_x_q6 < -kMost || way_x_q6 > kMost || way_y_q6 < -kMost || way_y_q6 >
      kMost) {
    return INKCELL_BAD_ARGUMENT;
  }
  new (into(out)) MotionBlur(point_of(way_x_q6, way_y_q6));
  return INKCELL_OK;
}

void inkcell_style_set_motion_blur(inkcell_style_t* style,
                                   const inkcell_motion_blur_t* options) {
  ref(style).set_effect(ref(options));
}

inkcell_status_t inkcell_splat_make(uint32_t* sums,
                                    size_t count,
                                    int16_t radius_q10,
                                    inkcell_splat_t* out) {
  if (count < kMinSplatSums) {
    return INKCELL_BUFFER_SMALL;
  }
  if (radius_q10 < kMinSplatRadius.raw || radius_q10 > kMaxSplatRadius.raw) {
    return INKCELL_BAD_ARGUMENT;
  }
  new (into(out)) Splat(Span<uint32_t>(sums, count),
      Q6_10::from_raw(radius_q10));
  return INKCELL_OK;
}

void inkcell_style_set_splat(inkcell_style_t* style,
                             const inkcell_splat_t* options) {
  ref(style).set_effect(ref(options));
}
