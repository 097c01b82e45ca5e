// clang-format off
// Made by port/c/make_api.py from its tables: edit that instead.
#include "mirror.hpp"

using namespace inkcell;
using namespace inkcell::c;

#pragma GCC diagnostic ignored "-Winvalid-offsetof"
#define SAME_VALUE(c, cpp) \
  static_assert(static_cast<int>(c) == static_cast<int>(cpp))
#define SAME_FIELD(c, member, cpp, twin)                \
  static_assert(offsetof(c, member) == offsetof(cpp, twin) && \
                sizeof(c::member) == sizeof(cpp::twin))
SAME_VALUE(INKCELL_OK, Status::ok);
SAME_VALUE(INKCELL_BAD_MAGIC, Status::bad_magic);
SAME_VALUE(INKCELL_BAD_VERSION, Status::bad_version);
SAME_VALUE(INKCELL_CORRUPT, Status::corrupt);
SAME_VALUE(INKCELL_NO_GLYPH, Status::no_glyph);
SAME_VALUE(INKCELL_BUFFER_SMALL, Status::buffer_small);
SAME_VALUE(INKCELL_MISALIGNED, Status::misaligned);
SAME_VALUE(INKCELL_UNSUPPORTED, Status::unsupported);
SAME_VALUE(INKCELL_BAD_ARGUMENT, Status::bad_argument);
SAME_VALUE(INKCELL_BEYOND_BAND, Status::beyond_band);
SAME_VALUE(INKCELL_READ_FAILED, Status::read_failed);
SAME_VALUE(INKCELL_CUT, Status::cut);
SAME_VALUE(INKCELL_NEEDS_SHAPING, Status::needs_shaping);
SAME_FIELD(inkcell_rect_t, x0, Rect, x0);
SAME_FIELD(inkcell_rect_t, y0, Rect, y0);
SAME_FIELD(inkcell_rect_t, x1, Rect, x1);
SAME_FIELD(inkcell_rect_t, y1, Rect, y1);
SAME_FIELD(inkcell_workspace_t, data, Workspace, data);
SAME_FIELD(inkcell_workspace_t, size, Workspace, size);
SAME_VALUE(INKCELL_LOW_FIRST, ByteOrder::low_first);
SAME_VALUE(INKCELL_HIGH_FIRST, ByteOrder::high_first);
SAME_FIELD(inkcell_strip_t, pixels, Strip, pixels.data);
SAME_FIELD(inkcell_strip_t, size, Strip, pixels.size);
SAME_FIELD(inkcell_strip_t, x0, Strip, x0);
SAME_FIELD(inkcell_strip_t, y0, Strip, y0);
SAME_FIELD(inkcell_strip_t, width, Strip, width);
SAME_FIELD(inkcell_strip_t, height, Strip, height);
SAME_FIELD(inkcell_strip_t, stride, Strip, stride);
SAME_FIELD(inkcell_strip_t, order, Strip, order);
SAME_FIELD(inkcell_sink_t, window, Sink, window);
SAME_FIELD(inkcell_sink_t, context, Sink, context);
SAME_FIELD(inkcell_sink_t, coverage, Sink, coverage);
SAME_FIELD(inkcell_sink_t, solid, Sink, solid);
SAME_FIELD(inkcell_sink_t, block, Sink, block);
SAME_FIELD(inkcell_sink_t, coverage_rgb, Sink, coverage_rgb);
SAME_FIELD(inkcell_sink_t, ramp, Sink, ramp);
SAME_FIELD(inkcell_sink_t, levels, Sink, levels);
SAME_VALUE(INKCELL_A8, port::PixelFormat::a8);
SAME_VALUE(INKCELL_GREY8, port::PixelFormat::grey8);
SAME_VALUE(INKCELL_GREY4, port::PixelFormat::grey4);
SAME_VALUE(INKCELL_GREY2, port::PixelFormat::grey2);
SAME_VALUE(INKCELL_MONO_ROWS, port::PixelFormat::mono_rows);
SAME_VALUE(INKCELL_MONO_PAGES, port::PixelFormat::mono_pages);
SAME_VALUE(INKCELL_RGB565, port::PixelFormat::rgb565);
SAME_VALUE(INKCELL_RGB888, port::PixelFormat::rgb888);
SAME_VALUE(INKCELL_XRGB8888, port::PixelFormat::xrgb8888);
SAME_VALUE(INKCELL_HIGH_LEFT, port::BitOrder::high_left);
SAME_VALUE(INKCELL_LOW_LEFT, port::BitOrder::low_left);
SAME_VALUE(INKCELL_RED_FIRST, port::ChannelOrder::red_first);
SAME_VALUE(INKCELL_BLUE_FIRST, port::ChannelOrder::blue_first);
SAME_FIELD(inkcell_a8_target_t, strip, port::detail::A8Pixels, strip);
SAME_FIELD(inkcell_grey8_target_t, strip, port::detail::Grey8Pixels, strip);
SAME_FIELD(inkcell_grey8_target_t, level, port::detail::Grey8Pixels, level);
SAME_FIELD(inkcell_grey4_target_t, strip, port::detail::Grey4Pixels, strip);
SAME_FIELD(inkcell_grey4_target_t, level, port::detail::Grey4Pixels, level);
SAME_FIELD(inkcell_grey4_target_t, order, port::detail::Grey4Pixels, order);
SAME_FIELD(inkcell_grey2_target_t, strip, port::detail::Grey2Pixels, strip);
SAME_FIELD(inkcell_grey2_target_t, level, port::detail::Grey2Pixels, level);
SAME_FIELD(inkcell_grey2_target_t, order, port::detail::Grey2Pixels, order);
SAME_FIELD(inkcell_mono_rows_target_t, strip, port::detail::MonoRowsPixels,
    strip);
SAME_FIELD(inkcell_mono_rows_target_t, threshold, port::detail::MonoRowsPixels,
    threshold);
SAME_FIELD(inkcell_mono_rows_target_t, level, port::detail::MonoRowsPixels,
    level);
SAME_FIELD(inkcell_mono_rows_target_t, order, port::detail::MonoRowsPixels,
    order);
SAME_FIELD(inkcell_mono_pages_target_t, strip, port::detail::MonoPagesPixels,
    strip);
SAME_FIELD(inkcell_mono_pages_target_t, threshold,
    port::detail::MonoPagesPixels, threshold);
SAME_FIELD(inkcell_mono_pages_target_t, level, port::detail::MonoPagesPixels,
    level);
SAME_FIELD(inkcell_rgb565_target_t, strip, port::detail::Rgb565Pixels, strip);
SAME_FIELD(inkcell_rgb565_target_t, colour, port::detail::Rgb565Pixels, colour);
SAME_FIELD(inkcell_rgb888_target_t, strip, port::detail::Rgb888Pixels, strip);
SAME_FIELD(inkcell_rgb888_target_t, colour, port::detail::Rgb888Pixels, colour);
SAME_FIELD(inkcell_rgb888_target_t, order, port::detail::Rgb888Pixels, order);
SAME_FIELD(inkcell_xrgb8888_target_t, strip, port::detail::Xrgb8888Pixels,
    strip);
SAME_FIELD(inkcell_xrgb8888_target_t, colour, port::detail::Xrgb8888Pixels,
    colour);
SAME_FIELD(inkcell_glyph_metrics_t, advance, GlyphMetrics, advance);
SAME_FIELD(inkcell_glyph_metrics_t, x_min, GlyphMetrics, x_min);
SAME_FIELD(inkcell_glyph_metrics_t, y_min, GlyphMetrics, y_min);
SAME_FIELD(inkcell_glyph_metrics_t, x_max, GlyphMetrics, x_max);
SAME_FIELD(inkcell_glyph_metrics_t, y_max, GlyphMetrics, y_max);
SAME_FIELD(inkcell_font_metrics_t, units_per_em, FontMetrics, units_per_em);
SAME_FIELD(inkcell_font_metrics_t, ascender, FontMetrics, ascender);
SAME_FIELD(inkcell_font_metrics_t, descender, FontMetrics, descender);
SAME_FIELD(inkcell_font_metrics_t, line_gap, FontMetrics, line_gap);
SAME_FIELD(inkcell_font_metrics_t, x_height, FontMetrics, x_height);
SAME_FIELD(inkcell_font_metrics_t, cap_height, FontMetrics, cap_height);
SAME_FIELD(inkcell_font_metrics_t, x_min, FontMetrics, x_min);
SAME_FIELD(inkcell_font_metrics_t, y_min, FontMetrics, y_min);
SAME_FIELD(inkcell_font_metrics_t, x_max, FontMetrics, x_max);
SAME_FIELD(inkcell_font_metrics_t, y_max, FontMetrics, y_max);
SAME_FIELD(inkcell_font_range_t, min_px, FontRange, min_px);
SAME_FIELD(inkcell_font_range_t, max_px, FontRange, max_px);
SAME_FIELD(inkcell_font_range_t, band_u, FontRange, band_u);
SAME_FIELD(inkcell_font_range_t, tolerance, FontRange, tolerance);
SAME_FIELD(inkcell_font_range_t, max_cells, FontRange, max_cells);
SAME_FIELD(inkcell_font_range_t, max_nodes, FontRange, max_nodes);
SAME_FIELD(inkcell_font_range_t, max_depth, FontRange, max_depth);
SAME_VALUE(INKCELL_PROFILE_LINEAR, FilterProfile::linear);
SAME_VALUE(INKCELL_PROFILE_GAUSSIAN, FilterProfile::gaussian);
SAME_VALUE(INKCELL_PROFILE_SIGMOID, FilterProfile::sigmoid);
SAME_VALUE(INKCELL_LIGHT_ON_DARK, Polarity::light_on_dark);
SAME_VALUE(INKCELL_DARK_ON_LIGHT, Polarity::dark_on_light);
SAME_FIELD(inkcell_text_report_t, instead, TextReport, instead);
SAME_FIELD(inkcell_text_report_t, substitute, TextReport, substitute);
SAME_FIELD(inkcell_text_report_t, missing, TextReport, missing);
SAME_FIELD(inkcell_text_report_t, first_missing, TextReport, first_missing);
SAME_FIELD(inkcell_text_report_t, status, TextReport, status);
SAME_FIELD(inkcell_text_report_t, replace, TextReport, replace);
SAME_FIELD(inkcell_positioned_glyph_t, x, PositionedGlyph, x);
SAME_FIELD(inkcell_positioned_glyph_t, y, PositionedGlyph, y);
SAME_FIELD(inkcell_positioned_glyph_t, glyph, PositionedGlyph, glyph);
SAME_FIELD(inkcell_positioned_glyph_t, offset, PositionedGlyph, offset);
SAME_FIELD(inkcell_positioned_glyph_t, face, PositionedGlyph, face);
SAME_FIELD(inkcell_face_t, font, Face, font);
SAME_FIELD(inkcell_face_t, style, Face, style);
SAME_FIELD(inkcell_pixel_measure_t, advance_q6, PixelMeasure, advance);
SAME_FIELD(inkcell_pixel_measure_t, left_q6, PixelMeasure, left);
SAME_FIELD(inkcell_pixel_measure_t, top_q6, PixelMeasure, top);
SAME_FIELD(inkcell_pixel_measure_t, right_q6, PixelMeasure, right);
SAME_FIELD(inkcell_pixel_measure_t, bottom_q6, PixelMeasure, bottom);
SAME_VALUE(INKCELL_STROKE_INNER, StrokePlace::inner);
SAME_VALUE(INKCELL_STROKE_CENTRED, StrokePlace::centred);
SAME_VALUE(INKCELL_STROKE_OUTER, StrokePlace::outer);
SAME_VALUE(INKCELL_SUB_PIXELS_RGB, SubPixels::rgb);
SAME_VALUE(INKCELL_SUB_PIXELS_BGR, SubPixels::bgr);
SAME_VALUE(INKCELL_SUB_PIXELS_RGB_VERTICAL, SubPixels::rgb_vertical);
SAME_VALUE(INKCELL_SUB_PIXELS_BGR_VERTICAL, SubPixels::bgr_vertical);
SAME_VALUE(INKCELL_ALIGN_START, Align::start);
SAME_VALUE(INKCELL_ALIGN_LEFT, Align::left);
SAME_VALUE(INKCELL_ALIGN_CENTRE, Align::centre);
SAME_VALUE(INKCELL_ALIGN_RIGHT, Align::right);
SAME_VALUE(INKCELL_ALIGN_JUSTIFY, Align::justify);
SAME_VALUE(INKCELL_ELLIPSIS_NONE, Ellipsis::none);
SAME_VALUE(INKCELL_ELLIPSIS_END, Ellipsis::end);
SAME_VALUE(INKCELL_ELLIPSIS_MIDDLE, Ellipsis::middle);
SAME_VALUE(INKCELL_DIRECTION_FROM_TEXT, BaseDirection::from_text);
SAME_VALUE(INKCELL_LEFT_TO_RIGHT, BaseDirection::left_to_right);
SAME_VALUE(INKCELL_RIGHT_TO_LEFT, BaseDirection::right_to_left);
SAME_FIELD(inkcell_layout_options_t, face, LayoutOptions, face);
SAME_FIELD(inkcell_layout_options_t, fallback, LayoutOptions, fallback.data);
SAME_FIELD(inkcell_layout_options_t, fallback_count, LayoutOptions,
    fallback.size);
SAME_FIELD(inkcell_layout_options_t, align, LayoutOptions, align);
SAME_FIELD(inkcell_layout_options_t, ellipsis, LayoutOptions, ellipsis);
SAME_FIELD(inkcell_layout_options_t, wraps, LayoutOptions, wraps);
SAME_FIELD(inkcell_layout_options_t, tabular_digits, LayoutOptions,
    tabular_digits);
SAME_FIELD(inkcell_layout_options_t, direction, LayoutOptions, direction);
SAME_FIELD(inkcell_layout_options_t, letter_spacing_q6, LayoutOptions,
    letter_spacing);
SAME_FIELD(inkcell_layout_options_t, line_height_q6, LayoutOptions,
    line_height);
SAME_FIELD(inkcell_layout_options_t, tab_stops_q6, LayoutOptions,
    tab_stops.data);
SAME_FIELD(inkcell_layout_options_t, tab_stop_count, LayoutOptions,
    tab_stops.size);
SAME_FIELD(inkcell_layout_options_t, tab_width_q6, LayoutOptions, tab_width);
SAME_FIELD(inkcell_text_line_t, begin, TextLine, begin);
SAME_FIELD(inkcell_text_line_t, next, TextLine, next);
SAME_FIELD(inkcell_text_line_t, paragraph, TextLine, paragraph);
SAME_FIELD(inkcell_text_line_t, width, TextLine, width);
SAME_FIELD(inkcell_text_line_t, length, TextLine, length);
SAME_FIELD(inkcell_text_line_t, skip_at, TextLine, skip_at);
SAME_FIELD(inkcell_text_line_t, skip_length, TextLine, skip_length);
SAME_FIELD(inkcell_text_line_t, gaps, TextLine, gaps);
SAME_FIELD(inkcell_text_line_t, base_level, TextLine, base_level);
SAME_FIELD(inkcell_text_line_t, is_found, TextLine, is_found);
SAME_FIELD(inkcell_text_line_t, is_last, TextLine, is_last);
SAME_FIELD(inkcell_text_line_t, ends_paragraph, TextLine, ends_paragraph);
SAME_FIELD(inkcell_text_line_t, has_hyphen, TextLine, has_hyphen);
SAME_FIELD(inkcell_text_line_t, has_ellipsis, TextLine, has_ellipsis);
SAME_VALUE(INKCELL_VERTICAL_TOP, VerticalAlign::top);
SAME_VALUE(INKCELL_VERTICAL_MIDDLE, VerticalAlign::middle);
SAME_VALUE(INKCELL_VERTICAL_OPTICAL, VerticalAlign::optical);
SAME_VALUE(INKCELL_VERTICAL_BOTTOM, VerticalAlign::bottom);
SAME_FIELD(inkcell_text_box_t, options, TextBox, options);
SAME_FIELD(inkcell_text_box_t, rect, TextBox, rect);
SAME_FIELD(inkcell_text_box_t, clip, TextBox, clip);
SAME_FIELD(inkcell_text_box_t, vertical, TextBox, vertical);
SAME_FIELD(inkcell_text_place_t, offset, TextPlace, offset);
SAME_FIELD(inkcell_text_place_t, is_line_end, TextPlace, is_line_end);
SAME_FIELD(inkcell_text_size_t, width_q6, TextSize, width);
SAME_FIELD(inkcell_text_size_t, height_q6, TextSize, height);
SAME_FIELD(inkcell_text_size_t, lines, TextSize, lines);
SAME_VALUE(INKCELL_ANCHOR_LEFT, Anchor::left);
SAME_VALUE(INKCELL_ANCHOR_CENTRE, Anchor::centre);
SAME_VALUE(INKCELL_ANCHOR_RIGHT, Anchor::right);
SAME_FIELD(inkcell_shaped_glyph_t, glyph, ShapedGlyph, glyph);
SAME_FIELD(inkcell_shaped_glyph_t, x, ShapedGlyph, x);
SAME_FIELD(inkcell_shaped_glyph_t, y, ShapedGlyph, y);
SAME_FIELD(inkcell_shaped_run_t, glyphs, ShapedRun, glyphs.data);
SAME_FIELD(inkcell_shaped_run_t, count, ShapedRun, glyphs.size);
SAME_FIELD(inkcell_shaped_run_t, advance, ShapedRun, advance);
SAME_FIELD(inkcell_glyph_cache_stats_t, hits, GlyphCacheStats, hits);
SAME_FIELD(inkcell_glyph_cache_stats_t, misses, GlyphCacheStats, misses);
SAME_FIELD(inkcell_glyph_cache_stats_t, bypasses, GlyphCacheStats, bypasses);
SAME_FIELD(inkcell_glyph_cache_stats_t, evictions, GlyphCacheStats, evictions);
SAME_FIELD(inkcell_glyph_cache_stats_t, glyphs, GlyphCacheStats, glyphs);
SAME_FIELD(inkcell_glyph_cache_stats_t, bytes, GlyphCacheStats, bytes);
SAME_FIELD(inkcell_glyph_cache_stats_t, capacity, GlyphCacheStats, capacity);
SAME_FIELD(inkcell_display_bus_t, context, port::DisplayBus, context);
SAME_FIELD(inkcell_display_bus_t, command, port::DisplayBus, command);
SAME_FIELD(inkcell_display_bus_t, data, port::DisplayBus, data);
SAME_FIELD(inkcell_display_bus_t, start, port::DisplayBus, start);
SAME_FIELD(inkcell_display_bus_t, wait_sent, port::DisplayBus, wait_sent);
SAME_FIELD(inkcell_display_bus_t, reset, port::DisplayBus, reset);
SAME_FIELD(inkcell_display_bus_t, wait_ms, port::DisplayBus, wait_ms);
SAME_FIELD(inkcell_display_bus_t, wait_idle, port::DisplayBus, wait_idle);
SAME_FIELD(inkcell_i2c_display_t, context, port::I2cDisplay, context);
SAME_FIELD(inkcell_i2c_display_t, write, port::I2cDisplay, write);
SAME_FIELD(inkcell_i2c_display_t, address, port::I2cDisplay, address);
SAME_VALUE(INKCELL_ROTATION_NONE, port::Rotation::none);
SAME_VALUE(INKCELL_ROTATION_QUARTER, port::Rotation::quarter);
SAME_VALUE(INKCELL_ROTATION_HALF, port::Rotation::half);
SAME_VALUE(INKCELL_ROTATION_THREE_QUARTERS, port::Rotation::three_quarters);
SAME_FIELD(inkcell_dcs_panel_t, bus, port::DcsPanel, bus);
SAME_FIELD(inkcell_dcs_panel_t, width, port::DcsPanel, width);
SAME_FIELD(inkcell_dcs_panel_t, height, port::DcsPanel, height);
SAME_FIELD(inkcell_dcs_panel_t, first_column, port::DcsPanel, first_column);
SAME_FIELD(inkcell_dcs_panel_t, first_row, port::DcsPanel, first_row);
SAME_FIELD(inkcell_dcs_panel_t, rotation, port::DcsPanel, rotation);
SAME_FIELD(inkcell_dcs_panel_t, mirror_columns, port::DcsPanel, mirror_columns);
SAME_FIELD(inkcell_dcs_panel_t, mirror_rows, port::DcsPanel, mirror_rows);
SAME_FIELD(inkcell_dcs_panel_t, blue_first, port::DcsPanel, blue_first);
SAME_FIELD(inkcell_dcs_panel_t, inverted, port::DcsPanel, inverted);
SAME_FIELD(inkcell_dcs_panel_t, setup, port::DcsPanel, setup.data);
SAME_FIELD(inkcell_dcs_panel_t, setup_size, port::DcsPanel, setup.size);
SAME_FIELD(inkcell_ssd1306_t, bus, port::Ssd1306, bus);
SAME_FIELD(inkcell_ssd1306_t, width, port::Ssd1306, width);
SAME_FIELD(inkcell_ssd1306_t, height, port::Ssd1306, height);
SAME_FIELD(inkcell_ssd1306_t, first_column, port::Ssd1306, first_column);
SAME_FIELD(inkcell_ssd1306_t, turned, port::Ssd1306, turned);
SAME_FIELD(inkcell_ssd1306_t, sequential_rows, port::Ssd1306, sequential_rows);
SAME_FIELD(inkcell_ssd1306_t, charge_pump, port::Ssd1306, charge_pump);
SAME_VALUE(INKCELL_SSD1680, port::EpaperController::ssd1680);
SAME_VALUE(INKCELL_SSD1681, port::EpaperController::ssd1681);
SAME_VALUE(INKCELL_PLANE_NEXT, port::EpaperPlane::next);
SAME_VALUE(INKCELL_PLANE_SHOWN, port::EpaperPlane::shown);
SAME_VALUE(INKCELL_REFRESH_FULL, port::EpaperRefresh::full);
SAME_VALUE(INKCELL_REFRESH_PARTIAL, port::EpaperRefresh::partial);
SAME_FIELD(inkcell_ssd1680_t, bus, port::Ssd1680, bus);
SAME_FIELD(inkcell_ssd1680_t, controller, port::Ssd1680, controller);
SAME_FIELD(inkcell_ssd1680_t, width, port::Ssd1680, width);
SAME_FIELD(inkcell_ssd1680_t, height, port::Ssd1680, height);
SAME_FIELD(inkcell_ssd1680_t, from_output_8, port::Ssd1680, from_output_8);
