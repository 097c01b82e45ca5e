// clang-format off
// Made by port/c/make_api.py from its tables: edit that instead.
#include "mirror.hpp"

using namespace inkcell;
using namespace inkcell::c;

#pragma GCC diagnostic ignored "-Winvalid-offsetof"
static_assert(static_cast<int>(INKCELL_OK) == static_cast<int>(Status::ok));
static_assert(static_cast<int>(INKCELL_BAD_MAGIC) ==
    static_cast<int>(Status::bad_magic));
static_assert(static_cast<int>(INKCELL_BAD_VERSION) ==
    static_cast<int>(Status::bad_version));
static_assert(static_cast<int>(INKCELL_CORRUPT) ==
    static_cast<int>(Status::corrupt));
static_assert(static_cast<int>(INKCELL_NO_GLYPH) ==
    static_cast<int>(Status::no_glyph));
static_assert(static_cast<int>(INKCELL_BUFFER_SMALL) ==
    static_cast<int>(Status::buffer_small));
static_assert(static_cast<int>(INKCELL_MISALIGNED) ==
    static_cast<int>(Status::misaligned));
static_assert(static_cast<int>(INKCELL_UNSUPPORTED) ==
    static_cast<int>(Status::unsupported));
static_assert(static_cast<int>(INKCELL_BAD_ARGUMENT) ==
    static_cast<int>(Status::bad_argument));
static_assert(static_cast<int>(INKCELL_BEYOND_BAND) ==
    static_cast<int>(Status::beyond_band));
static_assert(offsetof(inkcell_rect_t, x0) == offsetof(Rect, x0) &&
    sizeof(inkcell_rect_t::x0) == sizeof(Rect::x0));
static_assert(offsetof(inkcell_rect_t, y0) == offsetof(Rect, y0) &&
    sizeof(inkcell_rect_t::y0) == sizeof(Rect::y0));
static_assert(offsetof(inkcell_rect_t, x1) == offsetof(Rect, x1) &&
    sizeof(inkcell_rect_t::x1) == sizeof(Rect::x1));
static_assert(offsetof(inkcell_rect_t, y1) == offsetof(Rect, y1) &&
    sizeof(inkcell_rect_t::y1) == sizeof(Rect::y1));
static_assert(offsetof(inkcell_workspace_t, data) == offsetof(Workspace, data)
    && sizeof(inkcell_workspace_t::data) == sizeof(Workspace::data));
static_assert(offsetof(inkcell_workspace_t, size) == offsetof(Workspace, size)
    && sizeof(inkcell_workspace_t::size) == sizeof(Workspace::size));
static_assert(static_cast<int>(INKCELL_LOW_FIRST) ==
    static_cast<int>(ByteOrder::low_first));
static_assert(static_cast<int>(INKCELL_HIGH_FIRST) ==
    static_cast<int>(ByteOrder::high_first));
static_assert(offsetof(inkcell_strip_t, pixels) == offsetof(Strip, pixels.data)
    && sizeof(inkcell_strip_t::pixels) == sizeof(Strip::pixels.data));
static_assert(offsetof(inkcell_strip_t, size) == offsetof(Strip, pixels.size) &&
    sizeof(inkcell_strip_t::size) == sizeof(Strip::pixels.size));
static_assert(offsetof(inkcell_strip_t, x0) == offsetof(Strip, x0) &&
    sizeof(inkcell_strip_t::x0) == sizeof(Strip::x0));
static_assert(offsetof(inkcell_strip_t, y0) == offsetof(Strip, y0) &&
    sizeof(inkcell_strip_t::y0) == sizeof(Strip::y0));
static_assert(offsetof(inkcell_strip_t, width) == offsetof(Strip, width) &&
    sizeof(inkcell_strip_t::width) == sizeof(Strip::width));
static_assert(offsetof(inkcell_strip_t, height) == offsetof(Strip, height) &&
    sizeof(inkcell_strip_t::height) == sizeof(Strip::height));
static_assert(offsetof(inkcell_strip_t, stride) == offsetof(Strip, stride) &&
    sizeof(inkcell_strip_t::stride) == sizeof(Strip::stride));
static_assert(offsetof(inkcell_strip_t, order) == offsetof(Strip, order) &&
    sizeof(inkcell_strip_t::order) == sizeof(Strip::order));
static_assert(offsetof(inkcell_sink_t, window) == offsetof(Sink, window) &&
    sizeof(inkcell_sink_t::window) == sizeof(Sink::window));
static_assert(offsetof(inkcell_sink_t, context) == offsetof(Sink, context) &&
    sizeof(inkcell_sink_t::context) == sizeof(Sink::context));
static_assert(offsetof(inkcell_sink_t, coverage) == offsetof(Sink, coverage) &&
    sizeof(inkcell_sink_t::coverage) == sizeof(Sink::coverage));
static_assert(offsetof(inkcell_sink_t, solid) == offsetof(Sink, solid) &&
    sizeof(inkcell_sink_t::solid) == sizeof(Sink::solid));
static_assert(offsetof(inkcell_sink_t, block) == offsetof(Sink, block) &&
    sizeof(inkcell_sink_t::block) == sizeof(Sink::block));
static_assert(offsetof(inkcell_sink_t, coverage_rgb) == offsetof(Sink,
    coverage_rgb) && sizeof(inkcell_sink_t::coverage_rgb) ==
    sizeof(Sink::coverage_rgb));
static_assert(offsetof(inkcell_sink_t, ramp) == offsetof(Sink, ramp) &&
    sizeof(inkcell_sink_t::ramp) == sizeof(Sink::ramp));
static_assert(static_cast<int>(INKCELL_A8) ==
    static_cast<int>(port::PixelFormat::a8));
static_assert(static_cast<int>(INKCELL_GREY8) ==
    static_cast<int>(port::PixelFormat::grey8));
static_assert(static_cast<int>(INKCELL_GREY4) ==
    static_cast<int>(port::PixelFormat::grey4));
static_assert(static_cast<int>(INKCELL_GREY2) ==
    static_cast<int>(port::PixelFormat::grey2));
static_assert(static_cast<int>(INKCELL_MONO_ROWS) ==
    static_cast<int>(port::PixelFormat::mono_rows));
static_assert(static_cast<int>(INKCELL_MONO_PAGES) ==
    static_cast<int>(port::PixelFormat::mono_pages));
static_assert(static_cast<int>(INKCELL_RGB565) ==
    static_cast<int>(port::PixelFormat::rgb565));
static_assert(static_cast<int>(INKCELL_RGB888) ==
    static_cast<int>(port::PixelFormat::rgb888));
static_assert(static_cast<int>(INKCELL_XRGB8888) ==
    static_cast<int>(port::PixelFormat::xrgb8888));
static_assert(static_cast<int>(INKCELL_HIGH_LEFT) ==
    static_cast<int>(port::BitOrder::high_left));
static_assert(static_cast<int>(INKCELL_LOW_LEFT) ==
    static_cast<int>(port::BitOrder::low_left));
static_assert(static_cast<int>(INKCELL_RED_FIRST) ==
    static_cast<int>(port::ChannelOrder::red_first));
static_assert(static_cast<int>(INKCELL_BLUE_FIRST) ==
    static_cast<int>(port::ChannelOrder::blue_first));
static_assert(offsetof(inkcell_a8_target_t, strip) ==
    offsetof(port::detail::A8Pixels, strip) &&
    sizeof(inkcell_a8_target_t::strip) ==
    sizeof(port::detail::A8Pixels::strip));
static_assert(offsetof(inkcell_grey8_target_t, strip) ==
    offsetof(port::detail::Grey8Pixels, strip) &&
    sizeof(inkcell_grey8_target_t::strip) ==
    sizeof(port::detail::Grey8Pixels::strip));
static_assert(offsetof(inkcell_grey8_target_t, level) ==
    offsetof(port::detail::Grey8Pixels, level) &&
    sizeof(inkcell_grey8_target_t::level) ==
    sizeof(port::detail::Grey8Pixels::level));
static_assert(offsetof(inkcell_grey4_target_t, strip) ==
    offsetof(port::detail::Grey4Pixels, strip) &&
    sizeof(inkcell_grey4_target_t::strip) ==
    sizeof(port::detail::Grey4Pixels::strip));
static_assert(offsetof(inkcell_grey4_target_t, level) ==
    offsetof(port::detail::Grey4Pixels, level) &&
    sizeof(inkcell_grey4_target_t::level) ==
    sizeof(port::detail::Grey4Pixels::level));
static_assert(offsetof(inkcell_grey4_target_t, order) ==
    offsetof(port::detail::Grey4Pixels, order) &&
    sizeof(inkcell_grey4_target_t::order) ==
    sizeof(port::detail::Grey4Pixels::order));
static_assert(offsetof(inkcell_grey2_target_t, strip) ==
    offsetof(port::detail::Grey2Pixels, strip) &&
    sizeof(inkcell_grey2_target_t::strip) ==
    sizeof(port::detail::Grey2Pixels::strip));
static_assert(offsetof(inkcell_grey2_target_t, level) ==
    offsetof(port::detail::Grey2Pixels, level) &&
    sizeof(inkcell_grey2_target_t::level) ==
    sizeof(port::detail::Grey2Pixels::level));
static_assert(offsetof(inkcell_grey2_target_t, order) ==
    offsetof(port::detail::Grey2Pixels, order) &&
    sizeof(inkcell_grey2_target_t::order) ==
    sizeof(port::detail::Grey2Pixels::order));
static_assert(offsetof(inkcell_mono_rows_target_t, strip) ==
    offsetof(port::detail::MonoRowsPixels, strip) &&
    sizeof(inkcell_mono_rows_target_t::strip) ==
    sizeof(port::detail::MonoRowsPixels::strip));
static_assert(offsetof(inkcell_mono_rows_target_t, threshold) ==
    offsetof(port::detail::MonoRowsPixels, threshold) &&
    sizeof(inkcell_mono_rows_target_t::threshold) ==
    sizeof(port::detail::MonoRowsPixels::threshold));
static_assert(offsetof(inkcell_mono_rows_target_t, level) ==
    offsetof(port::detail::MonoRowsPixels, level) &&
    sizeof(inkcell_mono_rows_target_t::level) ==
    sizeof(port::detail::MonoRowsPixels::level));
static_assert(offsetof(inkcell_mono_rows_target_t, order) ==
    offsetof(port::detail::MonoRowsPixels, order) &&
    sizeof(inkcell_mono_rows_target_t::order) ==
    sizeof(port::detail::MonoRowsPixels::order));
static_assert(offsetof(inkcell_mono_pages_target_t, strip) ==
    offsetof(port::detail::MonoPagesPixels, strip) &&
    sizeof(inkcell_mono_pages_target_t::strip) ==
    sizeof(port::detail::MonoPagesPixels::strip));
static_assert(offsetof(inkcell_mono_pages_target_t, threshold) ==
    offsetof(port::detail::MonoPagesPixels, threshold) &&
    sizeof(inkcell_mono_pages_target_t::threshold) ==
    sizeof(port::detail::MonoPagesPixels::threshold));
static_assert(offsetof(inkcell_mono_pages_target_t, level) ==
    offsetof(port::detail::MonoPagesPixels, level) &&
    sizeof(inkcell_mono_pages_target_t::level) ==
    sizeof(port::detail::MonoPagesPixels::level));
static_assert(offsetof(inkcell_rgb565_target_t, strip) ==
    offsetof(port::detail::Rgb565Pixels, strip) &&
    sizeof(inkcell_rgb565_target_t::strip) ==
    sizeof(port::detail::Rgb565Pixels::strip));
static_assert(offsetof(inkcell_rgb565_target_t, colour) ==
    offsetof(port::detail::Rgb565Pixels, colour) &&
    sizeof(inkcell_rgb565_target_t::colour) ==
    sizeof(port::detail::Rgb565Pixels::colour));
static_assert(offsetof(inkcell_rgb888_target_t, strip) ==
    offsetof(port::detail::Rgb888Pixels, strip) &&
    sizeof(inkcell_rgb888_target_t::strip) ==
    sizeof(port::detail::Rgb888Pixels::strip));
static_assert(offsetof(inkcell_rgb888_target_t, colour) ==
    offsetof(port::detail::Rgb888Pixels, colour) &&
    sizeof(inkcell_rgb888_target_t::colour) ==
    sizeof(port::detail::Rgb888Pixels::colour));
static_assert(offsetof(inkcell_rgb888_target_t, order) ==
    offsetof(port::detail::Rgb888Pixels, order) &&
    sizeof(inkcell_rgb888_target_t::order) ==
    sizeof(port::detail::Rgb888Pixels::order));
static_assert(offsetof(inkcell_xrgb8888_target_t, strip) ==
    offsetof(port::detail::Xrgb8888Pixels, strip) &&
    sizeof(inkcell_xrgb8888_target_t::strip) ==
    sizeof(port::detail::Xrgb8888Pixels::strip));
static_assert(offsetof(inkcell_xrgb8888_target_t, colour) ==
    offsetof(port::detail::Xrgb8888Pixels, colour) &&
    sizeof(inkcell_xrgb8888_target_t::colour) ==
    sizeof(port::detail::Xrgb8888Pixels::colour));
static_assert(offsetof(inkcell_glyph_metrics_t, advance) ==
    offsetof(GlyphMetrics, advance) && sizeof(inkcell_glyph_metrics_t::advance)
    == sizeof(GlyphMetrics::advance));
static_assert(offsetof(inkcell_glyph_metrics_t, x_min) == offsetof(GlyphMetrics,
    x_min) && sizeof(inkcell_glyph_metrics_t::x_min) ==
    sizeof(GlyphMetrics::x_min));
static_assert(offsetof(inkcell_glyph_metrics_t, y_min) == offsetof(GlyphMetrics,
    y_min) && sizeof(inkcell_glyph_metrics_t::y_min) ==
    sizeof(GlyphMetrics::y_min));
static_assert(offsetof(inkcell_glyph_metrics_t, x_max) == offsetof(GlyphMetrics,
    x_max) && sizeof(inkcell_glyph_metrics_t::x_max) ==
    sizeof(GlyphMetrics::x_max));
static_assert(offsetof(inkcell_glyph_metrics_t, y_max) == offsetof(GlyphMetrics,
    y_max) && sizeof(inkcell_glyph_metrics_t::y_max) ==
    sizeof(GlyphMetrics::y_max));
static_assert(offsetof(inkcell_font_metrics_t, units_per_em) ==
    offsetof(FontMetrics, units_per_em) &&
    sizeof(inkcell_font_metrics_t::units_per_em) ==
    sizeof(FontMetrics::units_per_em));
static_assert(offsetof(inkcell_font_metrics_t, ascender) ==
    offsetof(FontMetrics, ascender) && sizeof(inkcell_font_metrics_t::ascender)
    == sizeof(FontMetrics::ascender));
static_assert(offsetof(inkcell_font_metrics_t, descender) ==
    offsetof(FontMetrics, descender) &&
    sizeof(inkcell_font_metrics_t::descender) ==
    sizeof(FontMetrics::descender));
static_assert(offsetof(inkcell_font_metrics_t, line_gap) ==
    offsetof(FontMetrics, line_gap) && sizeof(inkcell_font_metrics_t::line_gap)
    == sizeof(FontMetrics::line_gap));
static_assert(offsetof(inkcell_font_metrics_t, x_height) ==
    offsetof(FontMetrics, x_height) && sizeof(inkcell_font_metrics_t::x_height)
    == sizeof(FontMetrics::x_height));
static_assert(offsetof(inkcell_font_metrics_t, cap_height) ==
    offsetof(FontMetrics, cap_height) &&
    sizeof(inkcell_font_metrics_t::cap_height) ==
    sizeof(FontMetrics::cap_height));
static_assert(offsetof(inkcell_font_metrics_t, x_min) == offsetof(FontMetrics,
    x_min) && sizeof(inkcell_font_metrics_t::x_min) ==
    sizeof(FontMetrics::x_min));
static_assert(offsetof(inkcell_font_metrics_t, y_min) == offsetof(FontMetrics,
    y_min) && sizeof(inkcell_font_metrics_t::y_min) ==
    sizeof(FontMetrics::y_min));
static_assert(offsetof(inkcell_font_metrics_t, x_max) == offsetof(FontMetrics,
    x_max) && sizeof(inkcell_font_metrics_t::x_max) ==
    sizeof(FontMetrics::x_max));
static_assert(offsetof(inkcell_font_metrics_t, y_max) == offsetof(FontMetrics,
    y_max) && sizeof(inkcell_font_metrics_t::y_max) ==
    sizeof(FontMetrics::y_max));
static_assert(offsetof(inkcell_font_range_t, min_px) == offsetof(FontRange,
    min_px) && sizeof(inkcell_font_range_t::min_px) ==
    sizeof(FontRange::min_px));
static_assert(offsetof(inkcell_font_range_t, max_px) == offsetof(FontRange,
    max_px) && sizeof(inkcell_font_range_t::max_px) ==
    sizeof(FontRange::max_px));
static_assert(offsetof(inkcell_font_range_t, band_u) == offsetof(FontRange,
    band_u) && sizeof(inkcell_font_range_t::band_u) ==
    sizeof(FontRange::band_u));
static_assert(offsetof(inkcell_font_range_t, tolerance) == offsetof(FontRange,
    tolerance) && sizeof(inkcell_font_range_t::tolerance) ==
    sizeof(FontRange::tolerance));
static_assert(offsetof(inkcell_font_range_t, max_cells) == offsetof(FontRange,
    max_cells) && sizeof(inkcell_font_range_t::max_cells) ==
    sizeof(FontRange::max_cells));
static_assert(offsetof(inkcell_font_range_t, max_nodes) == offsetof(FontRange,
    max_nodes) && sizeof(inkcell_font_range_t::max_nodes) ==
    sizeof(FontRange::max_nodes));
static_assert(offsetof(inkcell_font_range_t, max_depth) == offsetof(FontRange,
    max_depth) && sizeof(inkcell_font_range_t::max_depth) ==
    sizeof(FontRange::max_depth));
static_assert(static_cast<int>(INKCELL_PROFILE_LINEAR) ==
    static_cast<int>(FilterProfile::linear));
static_assert(static_cast<int>(INKCELL_PROFILE_GAUSSIAN) ==
    static_cast<int>(FilterProfile::gaussian));
static_assert(static_cast<int>(INKCELL_PROFILE_SIGMOID) ==
    static_cast<int>(FilterProfile::sigmoid));
static_assert(static_cast<int>(INKCELL_LIGHT_ON_DARK) ==
    static_cast<int>(Polarity::light_on_dark));
static_assert(static_cast<int>(INKCELL_DARK_ON_LIGHT) ==
    static_cast<int>(Polarity::dark_on_light));
static_assert(offsetof(inkcell_positioned_glyph_t, x) ==
    offsetof(PositionedGlyph, x) && sizeof(inkcell_positioned_glyph_t::x) ==
    sizeof(PositionedGlyph::x));
static_assert(offsetof(inkcell_positioned_glyph_t, y) ==
    offsetof(PositionedGlyph, y) && sizeof(inkcell_positioned_glyph_t::y) ==
    sizeof(PositionedGlyph::y));
static_assert(offsetof(inkcell_positioned_glyph_t, glyph) ==
    offsetof(PositionedGlyph, glyph) &&
    sizeof(inkcell_positioned_glyph_t::glyph) ==
    sizeof(PositionedGlyph::glyph));
static_assert(offsetof(inkcell_positioned_glyph_t, offset) ==
    offsetof(PositionedGlyph, offset) &&
    sizeof(inkcell_positioned_glyph_t::offset) ==
    sizeof(PositionedGlyph::offset));
static_assert(offsetof(inkcell_positioned_glyph_t, face) ==
    offsetof(PositionedGlyph, face) && sizeof(inkcell_positioned_glyph_t::face)
    == sizeof(PositionedGlyph::face));
static_assert(offsetof(inkcell_face_t, font) == offsetof(Face, font) &&
    sizeof(inkcell_face_t::font) == sizeof(Face::font));
static_assert(offsetof(inkcell_face_t, style) == offsetof(Face, style) &&
    sizeof(inkcell_face_t::style) == sizeof(Face::style));
static_assert(offsetof(inkcell_text_measure_t, advance) == offsetof(TextMeasure,
    advance) && sizeof(inkcell_text_measure_t::advance) ==
    sizeof(TextMeasure::advance));
static_assert(offsetof(inkcell_text_measure_t, x_min) == offsetof(TextMeasure,
    x_min) && sizeof(inkcell_text_measure_t::x_min) ==
    sizeof(TextMeasure::x_min));
static_assert(offsetof(inkcell_text_measure_t, y_min) == offsetof(TextMeasure,
    y_min) && sizeof(inkcell_text_measure_t::y_min) ==
    sizeof(TextMeasure::y_min));
static_assert(offsetof(inkcell_text_measure_t, x_max) == offsetof(TextMeasure,
    x_max) && sizeof(inkcell_text_measure_t::x_max) ==
    sizeof(TextMeasure::x_max));
static_assert(offsetof(inkcell_text_measure_t, y_max) == offsetof(TextMeasure,
    y_max) && sizeof(inkcell_text_measure_t::y_max) ==
    sizeof(TextMeasure::y_max));
static_assert(static_cast<int>(INKCELL_OUTLINE_INNER) ==
    static_cast<int>(StrokePlace::inner));
static_assert(static_cast<int>(INKCELL_OUTLINE_CENTRED) ==
    static_cast<int>(StrokePlace::centred));
static_assert(static_cast<int>(INKCELL_OUTLINE_OUTER) ==
    static_cast<int>(StrokePlace::outer));
static_assert(static_cast<int>(INKCELL_SUB_PIXELS_RGB) ==
    static_cast<int>(SubPixels::rgb));
static_assert(static_cast<int>(INKCELL_SUB_PIXELS_BGR) ==
    static_cast<int>(SubPixels::bgr));
static_assert(static_cast<int>(INKCELL_SUB_PIXELS_RGB_VERTICAL) ==
    static_cast<int>(SubPixels::rgb_vertical));
static_assert(static_cast<int>(INKCELL_SUB_PIXELS_BGR_VERTICAL) ==
    static_cast<int>(SubPixels::bgr_vertical));
static_assert(static_cast<int>(INKCELL_ALIGN_START) ==
    static_cast<int>(Align::start));
static_assert(static_cast<int>(INKCELL_ALIGN_LEFT) ==
    static_cast<int>(Align::left));
static_assert(static_cast<int>(INKCELL_ALIGN_CENTRE) ==
    static_cast<int>(Align::centre));
static_assert(static_cast<int>(INKCELL_ALIGN_RIGHT) ==
    static_cast<int>(Align::right));
static_assert(static_cast<int>(INKCELL_ALIGN_JUSTIFY) ==
    static_cast<int>(Align::justify));
static_assert(static_cast<int>(INKCELL_ELLIPSIS_NONE) ==
    static_cast<int>(Ellipsis::none));
static_assert(static_cast<int>(INKCELL_ELLIPSIS_END) ==
    static_cast<int>(Ellipsis::end));
static_assert(static_cast<int>(INKCELL_ELLIPSIS_MIDDLE) ==
    static_cast<int>(Ellipsis::middle));
static_assert(static_cast<int>(INKCELL_DIRECTION_FROM_TEXT) ==
    static_cast<int>(BaseDirection::from_text));
static_assert(static_cast<int>(INKCELL_LEFT_TO_RIGHT) ==
    static_cast<int>(BaseDirection::left_to_right));
static_assert(static_cast<int>(INKCELL_RIGHT_TO_LEFT) ==
    static_cast<int>(BaseDirection::right_to_left));
static_assert(offsetof(inkcell_layout_t, face) == offsetof(LayoutOptions, face)
    && sizeof(inkcell_layout_t::face) == sizeof(LayoutOptions::face));
static_assert(offsetof(inkcell_layout_t, fallback) == offsetof(LayoutOptions,
    fallback.data) && sizeof(inkcell_layout_t::fallback) ==
    sizeof(LayoutOptions::fallback.data));
static_assert(offsetof(inkcell_layout_t, fallback_count) ==
    offsetof(LayoutOptions, fallback.size) &&
    sizeof(inkcell_layout_t::fallback_count) ==
    sizeof(LayoutOptions::fallback.size));
static_assert(offsetof(inkcell_layout_t, align) == offsetof(LayoutOptions,
    align) && sizeof(inkcell_layout_t::align) == sizeof(LayoutOptions::align));
static_assert(offsetof(inkcell_layout_t, ellipsis) == offsetof(LayoutOptions,
    ellipsis) && sizeof(inkcell_layout_t::ellipsis) ==
    sizeof(LayoutOptions::ellipsis));
static_assert(offsetof(inkcell_layout_t, wraps) == offsetof(LayoutOptions,
    wraps) && sizeof(inkcell_layout_t::wraps) == sizeof(LayoutOptions::wraps));
static_assert(offsetof(inkcell_layout_t, tabular_digits) ==
    offsetof(LayoutOptions, tabular_digits) &&
    sizeof(inkcell_layout_t::tabular_digits) ==
    sizeof(LayoutOptions::tabular_digits));
static_assert(offsetof(inkcell_layout_t, direction) == offsetof(LayoutOptions,
    direction) && sizeof(inkcell_layout_t::direction) ==
    sizeof(LayoutOptions::direction));
static_assert(offsetof(inkcell_layout_t, letter_spacing_q6) ==
    offsetof(LayoutOptions, letter_spacing) &&
    sizeof(inkcell_layout_t::letter_spacing_q6) ==
    sizeof(LayoutOptions::letter_spacing));
static_assert(offsetof(inkcell_layout_t, line_height_q6) ==
    offsetof(LayoutOptions, line_height) &&
    sizeof(inkcell_layout_t::line_height_q6) ==
    sizeof(LayoutOptions::line_height));
static_assert(offsetof(inkcell_layout_t, tab_stops_q6) ==
    offsetof(LayoutOptions, tab_stops.data) &&
    sizeof(inkcell_layout_t::tab_stops_q6) ==
    sizeof(LayoutOptions::tab_stops.data));
static_assert(offsetof(inkcell_layout_t, tab_stop_count) ==
    offsetof(LayoutOptions, tab_stops.size) &&
    sizeof(inkcell_layout_t::tab_stop_count) ==
    sizeof(LayoutOptions::tab_stops.size));
static_assert(offsetof(inkcell_layout_t, tab_width_q6) ==
    offsetof(LayoutOptions, tab_width) && sizeof(inkcell_layout_t::tab_width_q6)
    == sizeof(LayoutOptions::tab_width));
static_assert(offsetof(inkcell_line_t, begin) == offsetof(TextLine, begin) &&
    sizeof(inkcell_line_t::begin) == sizeof(TextLine::begin));
static_assert(offsetof(inkcell_line_t, next) == offsetof(TextLine, next) &&
    sizeof(inkcell_line_t::next) == sizeof(TextLine::next));
static_assert(offsetof(inkcell_line_t, paragraph) == offsetof(TextLine,
    paragraph) && sizeof(inkcell_line_t::paragraph) ==
    sizeof(TextLine::paragraph));
static_assert(offsetof(inkcell_line_t, width) == offsetof(TextLine, width) &&
    sizeof(inkcell_line_t::width) == sizeof(TextLine::width));
static_assert(offsetof(inkcell_line_t, length) == offsetof(TextLine, length) &&
    sizeof(inkcell_line_t::length) == sizeof(TextLine::length));
static_assert(offsetof(inkcell_line_t, skip_at) == offsetof(TextLine, skip_at)
    && sizeof(inkcell_line_t::skip_at) == sizeof(TextLine::skip_at));
static_assert(offsetof(inkcell_line_t, skip_length) == offsetof(TextLine,
    skip_length) && sizeof(inkcell_line_t::skip_length) ==
    sizeof(TextLine::skip_length));
static_assert(offsetof(inkcell_line_t, gaps) == offsetof(TextLine, gaps) &&
    sizeof(inkcell_line_t::gaps) == sizeof(TextLine::gaps));
static_assert(offsetof(inkcell_line_t, base_level) == offsetof(TextLine,
    base_level) && sizeof(inkcell_line_t::base_level) ==
    sizeof(TextLine::base_level));
static_assert(offsetof(inkcell_line_t, is_found) == offsetof(TextLine, is_found)
    && sizeof(inkcell_line_t::is_found) == sizeof(TextLine::is_found));
static_assert(offsetof(inkcell_line_t, is_last) == offsetof(TextLine, is_last)
    && sizeof(inkcell_line_t::is_last) == sizeof(TextLine::is_last));
static_assert(offsetof(inkcell_line_t, ends_paragraph) == offsetof(TextLine,
    ends_paragraph) && sizeof(inkcell_line_t::ends_paragraph) ==
    sizeof(TextLine::ends_paragraph));
static_assert(offsetof(inkcell_line_t, has_hyphen) == offsetof(TextLine,
    has_hyphen) && sizeof(inkcell_line_t::has_hyphen) ==
    sizeof(TextLine::has_hyphen));
static_assert(offsetof(inkcell_line_t, has_ellipsis) == offsetof(TextLine,
    has_ellipsis) && sizeof(inkcell_line_t::has_ellipsis) ==
    sizeof(TextLine::has_ellipsis));
static_assert(static_cast<int>(INKCELL_VERTICAL_TOP) ==
    static_cast<int>(VerticalAlign::top));
static_assert(static_cast<int>(INKCELL_VERTICAL_MIDDLE) ==
    static_cast<int>(VerticalAlign::middle));
static_assert(static_cast<int>(INKCELL_VERTICAL_OPTICAL) ==
    static_cast<int>(VerticalAlign::optical));
static_assert(static_cast<int>(INKCELL_VERTICAL_BOTTOM) ==
    static_cast<int>(VerticalAlign::bottom));
static_assert(offsetof(inkcell_text_box_t, layout) == offsetof(TextBox, options)
    && sizeof(inkcell_text_box_t::layout) == sizeof(TextBox::options));
static_assert(offsetof(inkcell_text_box_t, rect) == offsetof(TextBox, rect) &&
    sizeof(inkcell_text_box_t::rect) == sizeof(TextBox::rect));
static_assert(offsetof(inkcell_text_box_t, clip) == offsetof(TextBox, clip) &&
    sizeof(inkcell_text_box_t::clip) == sizeof(TextBox::clip));
static_assert(offsetof(inkcell_text_box_t, vertical) == offsetof(TextBox,
    vertical) && sizeof(inkcell_text_box_t::vertical) ==
    sizeof(TextBox::vertical));
static_assert(offsetof(inkcell_text_place_t, offset) == offsetof(TextPlace,
    offset) && sizeof(inkcell_text_place_t::offset) ==
    sizeof(TextPlace::offset));
static_assert(offsetof(inkcell_text_place_t, is_line_end) == offsetof(TextPlace,
    is_line_end) && sizeof(inkcell_text_place_t::is_line_end) ==
    sizeof(TextPlace::is_line_end));
static_assert(offsetof(inkcell_text_size_t, width_q6) == offsetof(TextSize,
    width) && sizeof(inkcell_text_size_t::width_q6) == sizeof(TextSize::width));
static_assert(offsetof(inkcell_text_size_t, height_q6) == offsetof(TextSize,
    height) && sizeof(inkcell_text_size_t::height_q6) ==
    sizeof(TextSize::height));
static_assert(offsetof(inkcell_text_size_t, lines) == offsetof(TextSize, lines)
    && sizeof(inkcell_text_size_t::lines) == sizeof(TextSize::lines));
static_assert(offsetof(inkcell_shaped_glyph_t, glyph) == offsetof(ShapedGlyph,
    glyph) && sizeof(inkcell_shaped_glyph_t::glyph) ==
    sizeof(ShapedGlyph::glyph));
static_assert(offsetof(inkcell_shaped_glyph_t, x) == offsetof(ShapedGlyph, x) &&
    sizeof(inkcell_shaped_glyph_t::x) == sizeof(ShapedGlyph::x));
static_assert(offsetof(inkcell_shaped_glyph_t, y) == offsetof(ShapedGlyph, y) &&
    sizeof(inkcell_shaped_glyph_t::y) == sizeof(ShapedGlyph::y));
static_assert(offsetof(inkcell_shaped_run_t, glyphs) == offsetof(ShapedRun,
    glyphs.data) && sizeof(inkcell_shaped_run_t::glyphs) ==
    sizeof(ShapedRun::glyphs.data));
static_assert(offsetof(inkcell_shaped_run_t, count) == offsetof(ShapedRun,
    glyphs.size) && sizeof(inkcell_shaped_run_t::count) ==
    sizeof(ShapedRun::glyphs.size));
static_assert(offsetof(inkcell_shaped_run_t, advance) == offsetof(ShapedRun,
    advance) && sizeof(inkcell_shaped_run_t::advance) ==
    sizeof(ShapedRun::advance));
static_assert(offsetof(inkcell_glyph_cache_stats_t, hits) ==
    offsetof(GlyphCacheStats, hits) && sizeof(inkcell_glyph_cache_stats_t::hits)
    == sizeof(GlyphCacheStats::hits));
static_assert(offsetof(inkcell_glyph_cache_stats_t, misses) ==
    offsetof(GlyphCacheStats, misses) &&
    sizeof(inkcell_glyph_cache_stats_t::misses) ==
    sizeof(GlyphCacheStats::misses));
static_assert(offsetof(inkcell_glyph_cache_stats_t, bypasses) ==
    offsetof(GlyphCacheStats, bypasses) &&
    sizeof(inkcell_glyph_cache_stats_t::bypasses) ==
    sizeof(GlyphCacheStats::bypasses));
static_assert(offsetof(inkcell_glyph_cache_stats_t, evictions) ==
    offsetof(GlyphCacheStats, evictions) &&
    sizeof(inkcell_glyph_cache_stats_t::evictions) ==
    sizeof(GlyphCacheStats::evictions));
static_assert(offsetof(inkcell_glyph_cache_stats_t, glyphs) ==
    offsetof(GlyphCacheStats, glyphs) &&
    sizeof(inkcell_glyph_cache_stats_t::glyphs) ==
    sizeof(GlyphCacheStats::glyphs));
static_assert(offsetof(inkcell_glyph_cache_stats_t, bytes) ==
    offsetof(GlyphCacheStats, bytes) &&
    sizeof(inkcell_glyph_cache_stats_t::bytes) ==
    sizeof(GlyphCacheStats::bytes));
static_assert(offsetof(inkcell_glyph_cache_stats_t, capacity) ==
    offsetof(GlyphCacheStats, capacity) &&
    sizeof(inkcell_glyph_cache_stats_t::capacity) ==
    sizeof(GlyphCacheStats::capacity));
static_assert(offsetof(inkcell_display_bus_t, context) ==
    offsetof(port::DisplayBus, context) &&
    sizeof(inkcell_display_bus_t::context) ==
    sizeof(port::DisplayBus::context));
static_assert(offsetof(inkcell_display_bus_t, command) ==
    offsetof(port::DisplayBus, command) &&
    sizeof(inkcell_display_bus_t::command) ==
    sizeof(port::DisplayBus::command));
static_assert(offsetof(inkcell_display_bus_t, data) ==
    offsetof(port::DisplayBus, data) && sizeof(inkcell_display_bus_t::data) ==
    sizeof(port::DisplayBus::data));
static_assert(offsetof(inkcell_display_bus_t, start) ==
    offsetof(port::DisplayBus, start) && sizeof(inkcell_display_bus_t::start) ==
    sizeof(port::DisplayBus::start));
static_assert(offsetof(inkcell_display_bus_t, wait_sent) ==
    offsetof(port::DisplayBus, wait_sent) &&
    sizeof(inkcell_display_bus_t::wait_sent) ==
    sizeof(port::DisplayBus::wait_sent));
static_assert(offsetof(inkcell_display_bus_t, reset) ==
    offsetof(port::DisplayBus, reset) && sizeof(inkcell_display_bus_t::reset) ==
    sizeof(port::DisplayBus::reset));
static_assert(offsetof(inkcell_display_bus_t, wait_ms) ==
    offsetof(port::DisplayBus, wait_ms) &&
    sizeof(inkcell_display_bus_t::wait_ms) ==
    sizeof(port::DisplayBus::wait_ms));
static_assert(offsetof(inkcell_display_bus_t, wait_idle) ==
    offsetof(port::DisplayBus, wait_idle) &&
    sizeof(inkcell_display_bus_t::wait_idle) ==
    sizeof(port::DisplayBus::wait_idle));
static_assert(offsetof(inkcell_i2c_display_t, context) ==
    offsetof(port::I2cDisplay, context) &&
    sizeof(inkcell_i2c_display_t::context) ==
    sizeof(port::I2cDisplay::context));
static_assert(offsetof(inkcell_i2c_display_t, write) ==
    offsetof(port::I2cDisplay, write) && sizeof(inkcell_i2c_display_t::write) ==
    sizeof(port::I2cDisplay::write));
static_assert(offsetof(inkcell_i2c_display_t, address) ==
    offsetof(port::I2cDisplay, address) &&
    sizeof(inkcell_i2c_display_t::address) ==
    sizeof(port::I2cDisplay::address));
static_assert(static_cast<int>(INKCELL_ROTATE_NONE) ==
    static_cast<int>(port::Rotation::none));
static_assert(static_cast<int>(INKCELL_ROTATE_QUARTER) ==
    static_cast<int>(port::Rotation::quarter));
static_assert(static_cast<int>(INKCELL_ROTATE_HALF) ==
    static_cast<int>(port::Rotation::half));
static_assert(static_cast<int>(INKCELL_ROTATE_THREE_QUARTERS) ==
    static_cast<int>(port::Rotation::three_quarters));
static_assert(offsetof(inkcell_dcs_panel_t, bus) == offsetof(port::DcsPanel,
    bus) && sizeof(inkcell_dcs_panel_t::bus) == sizeof(port::DcsPanel::bus));
static_assert(offsetof(inkcell_dcs_panel_t, width) == offsetof(port::DcsPanel,
    width) && sizeof(inkcell_dcs_panel_t::width) ==
    sizeof(port::DcsPanel::width));
static_assert(offsetof(inkcell_dcs_panel_t, height) == offsetof(port::DcsPanel,
    height) && sizeof(inkcell_dcs_panel_t::height) ==
    sizeof(port::DcsPanel::height));
static_assert(offsetof(inkcell_dcs_panel_t, first_column) ==
    offsetof(port::DcsPanel, first_column) &&
    sizeof(inkcell_dcs_panel_t::first_column) ==
    sizeof(port::DcsPanel::first_column));
static_assert(offsetof(inkcell_dcs_panel_t, first_row) ==
    offsetof(port::DcsPanel, first_row) &&
    sizeof(inkcell_dcs_panel_t::first_row) ==
    sizeof(port::DcsPanel::first_row));
static_assert(offsetof(inkcell_dcs_panel_t, rotation) ==
    offsetof(port::DcsPanel, rotation) && sizeof(inkcell_dcs_panel_t::rotation)
    == sizeof(port::DcsPanel::rotation));
static_assert(offsetof(inkcell_dcs_panel_t, mirror_columns) ==
    offsetof(port::DcsPanel, mirror_columns) &&
    sizeof(inkcell_dcs_panel_t::mirror_columns) ==
    sizeof(port::DcsPanel::mirror_columns));
static_assert(offsetof(inkcell_dcs_panel_t, mirror_rows) ==
    offsetof(port::DcsPanel, mirror_rows) &&
    sizeof(inkcell_dcs_panel_t::mirror_rows) ==
    sizeof(port::DcsPanel::mirror_rows));
static_assert(offsetof(inkcell_dcs_panel_t, blue_first) ==
    offsetof(port::DcsPanel, blue_first) &&
    sizeof(inkcell_dcs_panel_t::blue_first) ==
    sizeof(port::DcsPanel::blue_first));
static_assert(offsetof(inkcell_dcs_panel_t, inverted) ==
    offsetof(port::DcsPanel, inverted) && sizeof(inkcell_dcs_panel_t::inverted)
    == sizeof(port::DcsPanel::inverted));
static_assert(offsetof(inkcell_dcs_panel_t, setup) == offsetof(port::DcsPanel,
    setup.data) && sizeof(inkcell_dcs_panel_t::setup) ==
    sizeof(port::DcsPanel::setup.data));
static_assert(offsetof(inkcell_dcs_panel_t, setup_size) ==
    offsetof(port::DcsPanel, setup.size) &&
    sizeof(inkcell_dcs_panel_t::setup_size) ==
    sizeof(port::DcsPanel::setup.size));
static_assert(offsetof(inkcell_ssd1306_t, bus) == offsetof(port::Ssd1306, bus)
    && sizeof(inkcell_ssd1306_t::bus) == sizeof(port::Ssd1306::bus));
static_assert(offsetof(inkcell_ssd1306_t, width) == offsetof(port::Ssd1306,
    width) && sizeof(inkcell_ssd1306_t::width) == sizeof(port::Ssd1306::width));
static_assert(offsetof(inkcell_ssd1306_t, height) == offsetof(port::Ssd1306,
    height) && sizeof(inkcell_ssd1306_t::height) ==
    sizeof(port::Ssd1306::height));
static_assert(offsetof(inkcell_ssd1306_t, first_column) ==
    offsetof(port::Ssd1306, first_column) &&
    sizeof(inkcell_ssd1306_t::first_column) ==
    sizeof(port::Ssd1306::first_column));
static_assert(offsetof(inkcell_ssd1306_t, turned) == offsetof(port::Ssd1306,
    turned) && sizeof(inkcell_ssd1306_t::turned) ==
    sizeof(port::Ssd1306::turned));
static_assert(offsetof(inkcell_ssd1306_t, sequential_rows) ==
    offsetof(port::Ssd1306, sequential_rows) &&
    sizeof(inkcell_ssd1306_t::sequential_rows) ==
    sizeof(port::Ssd1306::sequential_rows));
static_assert(offsetof(inkcell_ssd1306_t, charge_pump) ==
    offsetof(port::Ssd1306, charge_pump) &&
    sizeof(inkcell_ssd1306_t::charge_pump) ==
    sizeof(port::Ssd1306::charge_pump));
static_assert(static_cast<int>(INKCELL_SSD1680) ==
    static_cast<int>(port::EpaperController::ssd1680));
static_assert(static_cast<int>(INKCELL_SSD1681) ==
    static_cast<int>(port::EpaperController::ssd1681));
static_assert(static_cast<int>(INKCELL_PLANE_NEXT) ==
    static_cast<int>(port::EpaperPlane::next));
static_assert(static_cast<int>(INKCELL_PLANE_SHOWN) ==
    static_cast<int>(port::EpaperPlane::shown));
static_assert(static_cast<int>(INKCELL_REFRESH_FULL) ==
    static_cast<int>(port::EpaperRefresh::full));
static_assert(static_cast<int>(INKCELL_REFRESH_PARTIAL) ==
    static_cast<int>(port::EpaperRefresh::partial));
static_assert(offsetof(inkcell_ssd1680_t, bus) == offsetof(port::Ssd1680, bus)
    && sizeof(inkcell_ssd1680_t::bus) == sizeof(port::Ssd1680::bus));
static_assert(offsetof(inkcell_ssd1680_t, controller) == offsetof(port::Ssd1680,
    controller) && sizeof(inkcell_ssd1680_t::controller) ==
    sizeof(port::Ssd1680::controller));
static_assert(offsetof(inkcell_ssd1680_t, width) == offsetof(port::Ssd1680,
    width) && sizeof(inkcell_ssd1680_t::width) == sizeof(port::Ssd1680::width));
static_assert(offsetof(inkcell_ssd1680_t, height) == offsetof(port::Ssd1680,
    height) && sizeof(inkcell_ssd1680_t::height) ==
    sizeof(port::Ssd1680::height));
static_assert(offsetof(inkcell_ssd1680_t, from_output_8) ==
    offsetof(port::Ssd1680, from_output_8) &&
    sizeof(inkcell_ssd1680_t::from_output_8) ==
    sizeof(port::Ssd1680::from_output_8));
