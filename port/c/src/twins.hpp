// What types of C stand for.
// Made by port/c/make_api.py from its tables: edit that instead.
#pragma once

#include "inkcell/bilevel.hpp"
#include "inkcell/cache/glyph_cache.hpp"
#include "inkcell/edge_contrast.hpp"
#include "inkcell/few_levels.hpp"
#include "inkcell/field/circle_samples.hpp"
#include "inkcell/field/draw.hpp"
#include "inkcell/field/splat.hpp"
#include "inkcell/filter.hpp"
#include "inkcell/fit.hpp"
#include "inkcell/font.hpp"
#include "inkcell/geometry.hpp"
#include "inkcell/inkcell.h"
#include "inkcell/layout/bidi.hpp"
#include "inkcell/layout/label.hpp"
#include "inkcell/layout/layout.hpp"
#include "inkcell/layout/text_box.hpp"
#include "inkcell/lcd.hpp"
#include "inkcell/motion/easing.hpp"
#include "inkcell/motion/outline_morph.hpp"
#include "inkcell/motion/path.hpp"
#include "inkcell/motion_blur.hpp"
#include "inkcell/number_text.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/port/a8.hpp"
#include "inkcell/port/dither.hpp"
#include "inkcell/port/gc9a01.hpp"
#include "inkcell/port/grey2.hpp"
#include "inkcell/port/grey4.hpp"
#include "inkcell/port/grey8.hpp"
#include "inkcell/port/i2c_display.hpp"
#include "inkcell/port/ili9341.hpp"
#include "inkcell/port/lcd.hpp"
#include "inkcell/port/mono_pages.hpp"
#include "inkcell/port/mono_rows.hpp"
#include "inkcell/port/pixel.hpp"
#include "inkcell/port/rgb565.hpp"
#include "inkcell/port/rgb888.hpp"
#include "inkcell/port/ssd1306.hpp"
#include "inkcell/port/ssd1680.hpp"
#include "inkcell/port/st7735.hpp"
#include "inkcell/port/st7789.hpp"
#include "inkcell/port/strip_loop.hpp"
#include "inkcell/port/xrgb8888.hpp"
#include "inkcell/prepared_glyph.hpp"
#include "inkcell/shadow.hpp"
#include "inkcell/shaped_run.hpp"
#include "inkcell/status.hpp"
#include "inkcell/strip.hpp"
#include "inkcell/stroke.hpp"
#include "inkcell/style.hpp"
#include "inkcell/supersample.hpp"
#include "inkcell/text.hpp"
#include "inkcell/value_label.hpp"
#include "inkcell/workspace.hpp"

namespace inkcell {
namespace c {

/// What a type of C stands for: `Type`.
template <typename C>
struct CppOf;
template <>
struct CppOf<inkcell_rect_t> {
  using Type = Rect;
};
template <>
struct CppOf<inkcell_workspace_t> {
  using Type = Workspace;
};
template <>
struct CppOf<inkcell_strip_t> {
  using Type = Strip;
};
template <>
struct CppOf<inkcell_sink_t> {
  using Type = Sink;
};
template <>
struct CppOf<inkcell_a8_target_t> {
  using Type = port::detail::A8Pixels;
};
template <>
struct CppOf<inkcell_grey8_target_t> {
  using Type = port::detail::Grey8Pixels;
};
template <>
struct CppOf<inkcell_grey4_target_t> {
  using Type = port::detail::Grey4Pixels;
};
template <>
struct CppOf<inkcell_grey2_target_t> {
  using Type = port::detail::Grey2Pixels;
};
template <>
struct CppOf<inkcell_mono_rows_target_t> {
  using Type = port::detail::MonoRowsPixels;
};
template <>
struct CppOf<inkcell_mono_pages_target_t> {
  using Type = port::detail::MonoPagesPixels;
};
template <>
struct CppOf<inkcell_rgb565_target_t> {
  using Type = port::detail::Rgb565Pixels;
};
template <>
struct CppOf<inkcell_rgb888_target_t> {
  using Type = port::detail::Rgb888Pixels;
};
template <>
struct CppOf<inkcell_xrgb8888_target_t> {
  using Type = port::detail::Xrgb8888Pixels;
};
template <>
struct CppOf<inkcell_font_t> {
  using Type = Font;
};
template <>
struct CppOf<inkcell_glyph_metrics_t> {
  using Type = GlyphMetrics;
};
template <>
struct CppOf<inkcell_font_metrics_t> {
  using Type = FontMetrics;
};
template <>
struct CppOf<inkcell_font_range_t> {
  using Type = FontRange;
};
template <>
struct CppOf<inkcell_filter_table_t> {
  using Type = Filter;
};
template <>
struct CppOf<inkcell_style_t> {
  using Type = Style;
};
template <>
struct CppOf<inkcell_fit_t> {
  using Type = Fit;
};
template <>
struct CppOf<inkcell_text_report_t> {
  using Type = TextReport;
};
template <>
struct CppOf<inkcell_positioned_glyph_t> {
  using Type = PositionedGlyph;
};
template <>
struct CppOf<inkcell_face_t> {
  using Type = Face;
};
template <>
struct CppOf<inkcell_pixel_measure_t> {
  using Type = PixelMeasure;
};
template <>
struct CppOf<inkcell_prepared_glyph_t> {
  using Type = PreparedGlyph;
};
template <>
struct CppOf<inkcell_stroke_t> {
  using Type = Stroke;
};
template <>
struct CppOf<inkcell_stroke_and_fill_t> {
  using Type = StrokeAndFill;
};
template <>
struct CppOf<inkcell_circle_samples_t> {
  using Type = CircleSamples;
};
template <>
struct CppOf<inkcell_motion_blur_t> {
  using Type = MotionBlur;
};
template <>
struct CppOf<inkcell_splat_t> {
  using Type = Splat;
};
template <>
struct CppOf<inkcell_bidi_t> {
  using Type = Bidi;
};
template <>
struct CppOf<inkcell_layout_options_t> {
  using Type = LayoutOptions;
};
template <>
struct CppOf<inkcell_text_line_t> {
  using Type = TextLine;
};
template <>
struct CppOf<inkcell_text_box_t> {
  using Type = TextBox;
};
template <>
struct CppOf<inkcell_text_place_t> {
  using Type = TextPlace;
};
template <>
struct CppOf<inkcell_text_size_t> {
  using Type = TextSize;
};
template <>
struct CppOf<inkcell_scrolling_label_t> {
  using Type = ScrollingLabel;
};
template <>
struct CppOf<inkcell_value_label_t> {
  using Type = ValueLabel;
};
template <>
struct CppOf<inkcell_text_circle_t> {
  using Type = motion::TextCircle;
};
template <>
struct CppOf<inkcell_outline_morph_t> {
  using Type = motion::OutlineMorph;
};
template <>
struct CppOf<inkcell_shaped_glyph_t> {
  using Type = ShapedGlyph;
};
template <>
struct CppOf<inkcell_shaped_run_t> {
  using Type = ShapedRun;
};
template <>
struct CppOf<inkcell_glyph_cache_t> {
  using Type = GlyphCache;
};
template <>
struct CppOf<inkcell_glyph_cache_stats_t> {
  using Type = GlyphCacheStats;
};
template <>
struct CppOf<inkcell_display_bus_t> {
  using Type = port::DisplayBus;
};
template <>
struct CppOf<inkcell_i2c_display_t> {
  using Type = port::I2cDisplay;
};
template <>
struct CppOf<inkcell_dcs_panel_t> {
  using Type = port::DcsPanel;
};
template <>
struct CppOf<inkcell_ssd1306_t> {
  using Type = port::Ssd1306;
};
template <>
struct CppOf<inkcell_ssd1680_t> {
  using Type = port::Ssd1680;
};

}  // namespace c
}  // namespace inkcell
