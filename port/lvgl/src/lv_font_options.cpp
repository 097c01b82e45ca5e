// The options of a font. The linker drops those that a program does not call,
// and the code that they need.
#include "inkcell/filter.hpp"
#include "inkcell/fit.hpp"
#include "inkcell/lcd.hpp"
#include "inkcell/lvgl/inkcell_lvgl.h"
#include "inkcell/port/lcd.hpp"
#include "inkcell/status.hpp"
#include "inkcell/text.hpp"

#include "font_state.hpp"

namespace inkcell::port {
namespace {

static_assert(sizeof(Fit) <= sizeof(inkcell_lv_fit_t), "enlarge it");
static_assert(sizeof(Filter) <= sizeof(inkcell_lv_weight_t), "enlarge it");
static_assert(sizeof(GlyphCache) <= sizeof(inkcell_lv_cache_t), "enlarge it");

lv_result_t set_fit(const char* call,
                    inkcell_lv_font_t& font,
                    inkcell_lv_fit_t& room,
                    const Fitter& fitter,
                    bool is_across) noexcept {
  FontState& state = state_of(font);
  FitOptions options;
  options.across = is_across;
  auto& fit = *reinterpret_cast<Fit*>(room.state);
  const Status status = Fit::make(state.font, state.style, options, fit);
  if (status == Status::ok) {
    state.style.set_fit(fitter, &fit);
  }
  return result_of(call, status);
}

// Edges further out by `by_q6`. [px]
Filter moved(const Filter& edge, int32_t by_q6) noexcept {
  constexpr int32_t kLimit = 4 << 6;  // with_weight() clamps to less
  const int32_t limited =
      by_q6 < -kLimit ? -kLimit : (by_q6 > kLimit ? kLimit : by_q6);
  return with_weight(edge, Q6_10::from_raw(static_cast<int16_t>(limited * 16)));
}

void warn_of_weight() noexcept {
  LV_LOG_WARN("inkcell: a font with sub-pixels has no weight");
}

// Null: the strip is not one of the layer's format.
template <typename AnyCanvas>
const Sink* with_sub_pixels(AnyCanvas& canvas) {
  set_sub_pixels(canvas);
  return canvas.status() == Status::ok ? &canvas : nullptr;
}

const Sink* open_lcd(const lv_layer_t& layer,
                     lv_color_t colour,
                     LcdCanvas& canvas) {
  Strip strip;
  strip.pixels = {layer.draw_buf->data, layer.draw_buf->data_size};
  strip.x0 = layer.buf_area.x1;
  strip.y0 = layer.buf_area.y1;
  strip.width = lv_area_get_width(&layer.buf_area);
  strip.height = lv_area_get_height(&layer.buf_area);
  strip.stride = static_cast<int32_t>(layer.draw_buf->header.stride);
  const uint32_t rgb =
      uint32_t{colour.red} << 16 | uint32_t{colour.green} << 8 | colour.blue;
  switch (layer.color_format) {
    case LV_COLOR_FORMAT_RGB565:
      canvas.rgb565 =
          Rgb565Canvas(strip, rgb565(colour.red, colour.green, colour.blue));
      return with_sub_pixels(canvas.rgb565);
    case LV_COLOR_FORMAT_RGB888:
      canvas.rgb888 = Rgb888Canvas(strip, rgb, ChannelOrder::blue_first);
      return with_sub_pixels(canvas.rgb888);
    case LV_COLOR_FORMAT_XRGB8888:
      canvas.xrgb8888 = Xrgb8888Canvas(strip, 0xff000000u | rgb);
      return with_sub_pixels(canvas.xrgb8888);
    default:
      return nullptr;
  }
}

}  // namespace
}  // namespace inkcell::port

using namespace inkcell;

void inkcell_lv_font_set_sub_pixels(inkcell_lv_font_t* font,
                                    inkcell_lv_sub_pixels_t order) {
  port::FontState& state = port::state_of(*font);
  static_assert(static_cast<int>(SubPixels::bgr_vertical) ==
                    INKCELL_LV_SUB_PIXELS_BGR_VERTICAL,
                "the same order");
  if (state.has_weight) {
    port::warn_of_weight();
  }
  state.lcd.order = static_cast<SubPixels>(order);
  state.style.set_effect(state.lcd);
  state.open_lcd = port::open_lcd;
}

lv_result_t inkcell_lv_font_fit_heights(inkcell_lv_font_t* font,
                                        inkcell_lv_fit_t* fit) {
  return port::set_fit("inkcell_lv_font_fit_heights", *font, *fit, kFitHeights,
                       false);
}

lv_result_t inkcell_lv_font_fit_grid(inkcell_lv_font_t* font,
                                     inkcell_lv_fit_t* fit) {
  return port::set_fit("inkcell_lv_font_fit_grid", *font, *fit, kGridFit, true);
}

lv_result_t inkcell_lv_font_set_weight(inkcell_lv_font_t* font,
                                       inkcell_lv_weight_t* weight,
                                       int32_t weight_q6) {
  port::FontState& state = port::state_of(*font);
  auto& filter = *reinterpret_cast<Filter*>(weight->state);
  filter = port::moved(kFilterText, weight_q6);
  const Style weighted = port::with_filter(state.style, filter);
  const Status status = state.font.check(weighted);
  if (status == Status::ok) {
    if (weighted.effect() != nullptr) {
      port::warn_of_weight();
    }
    state.has_weight = true;
    state.style = weighted;
  }
  return port::result_of("inkcell_lv_font_set_weight", status);
}

void inkcell_lv_font_set_outline_stroke(inkcell_lv_font_t* font) {
  port::state_of(*font).make_outline = [](const Filter& edge, int32_t width_px,
                                          Filter& out) {
    out = port::moved(edge, width_px > 4 ? 4 << 6 : width_px << 6);
  };
}

void inkcell_lv_font_set_workspace(inkcell_lv_font_t* font,
                                   void* ram,
                                   size_t bytes) {
  port::state_of(*font).workspace = {static_cast<uint8_t*>(ram), bytes};
}

lv_result_t inkcell_lv_cache_init(inkcell_lv_cache_t* cache,
                                  void* ram,
                                  size_t bytes,
                                  uint32_t fonts) {
  GlyphCacheOptions options;
  options.phases = 1;  // LVGL places glyphs at whole pixels
  options.styles = static_cast<uint8_t>(fonts > 255 ? 255 : fonts);
  auto& out = *reinterpret_cast<GlyphCache*>(cache->state);
  return port::result_of(
      "inkcell_lv_cache_init",
      GlyphCache::make({static_cast<uint8_t*>(ram), bytes}, options, out));
}

void inkcell_lv_font_set_cache(inkcell_lv_font_t* font,
                               inkcell_lv_cache_t* cache) {
  inkcell_lv_font_set_direct(font);
  port::state_of(*font).cache = reinterpret_cast<GlyphCache*>(cache->state);
}

void inkcell_lv_cache_stats(const inkcell_lv_cache_t* cache,
                            inkcell_lv_cache_stats_t* out) {
  const GlyphCacheStats stats =
      reinterpret_cast<const GlyphCache*>(cache->state)->stats();
  *out = {stats.hits,   stats.misses, stats.bypasses, stats.evictions,
          stats.glyphs, stats.bytes,  stats.capacity};
}
