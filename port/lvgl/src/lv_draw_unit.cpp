// A draw unit of LVGL that draws glyphs straight into a layer.
//
// LVGL lays labels out and calls back for each glyph, with a buffer for
// bitmaps. Our glyphs have the format CUSTOM, which needs no buffer: their
// coverage is blended by LVGL in blocks of a few rows.
#include "inkcell/canvas_colour.hpp"
#include "inkcell/geometry.hpp"
#include "inkcell/lvgl/inkcell_lvgl.h"
#include "inkcell/painter.hpp"
#include "inkcell/strip.hpp"
#include "lvgl_private.h"

#include "font_state.hpp"
#include "letter_matrix.hpp"

namespace inkcell::port {
namespace {

// LVGL's own units have numbers below 20.
constexpr uint8_t kUnitId = 73;

lv_area_t area_of(const Rect& pixels) noexcept {
  return {pixels.x0, pixels.y0, pixels.x1 - 1, pixels.y1 - 1};
}

Rect rect_of(const lv_area_t& area) noexcept {
  return {area.x1, area.y1, area.x2 + 1, area.y2 + 1};
}

// Blends coverage in one colour onto a task's layer.
struct Brush {
  lv_draw_task_t* task;
  lv_color_t colour;
  lv_opa_t opacity;

  // Without a mask coverage is full.
  void blend(const Rect& pixels,
             const uint8_t* mask,
             int32_t stride) const noexcept {
    const lv_area_t area = area_of(pixels);
    lv_draw_sw_blend_dsc_t blend = {};
    blend.blend_area = &area;
    blend.color = colour;
    blend.opa = opacity;
    blend.mask_buf = mask;
    blend.mask_area = &area;
    blend.mask_stride = stride;
    blend.mask_res = mask == nullptr ? LV_DRAW_SW_MASK_RES_FULL_COVER
                                     : LV_DRAW_SW_MASK_RES_CHANGED;
    lv_draw_sw_blend(task, &blend);
  }

  static void coverage(void* context,
                       int32_t x,
                       int32_t y,
                       const uint8_t* coverage,
                       int32_t count) {
    static_cast<const Brush*>(context)->blend({x, y, x + count, y + 1},
                                              coverage, count);
  }
  static void solid(void* context, int32_t x, int32_t y, int32_t count) {
    static_cast<const Brush*>(context)->blend({x, y, x + count, y + 1}, nullptr,
                                              0);
  }
  static void block(void* context, const CoverageBlock& block) {
    static_cast<const Brush*>(context)->blend(block.pixels, block.coverage,
                                              block.stride);
  }

  // For layers of several colours: 0xRRGGBB.
  static uint32_t exchange(void* context, uint32_t pixel) noexcept {
    auto& self = *static_cast<Brush*>(context);
    const lv_color_t before = self.colour;
    self.colour = lv_color_hex(pixel);
    return uint32_t{before.red} << 16 | uint32_t{before.green} << 8 |
           before.blue;
  }
  static uint32_t pixel_of(const LayerColour& colour) noexcept {
    return uint32_t{colour.red} << 16 | uint32_t{colour.green} << 8 |
           colour.blue;
  }
};

// The part of a glyph that a task draws.
struct Part {
  const FontState& state;
  const lv_layer_t& layer;
  uint16_t glyph;
  Rect window;
  LetterMatrix matrix;
  Point origin;

  Part(const FontState& font,
       const lv_draw_task_t& task,
       const lv_draw_glyph_dsc_t& dsc) noexcept
      : state(font),
        layer(*task.target_layer),
        glyph(static_cast<uint16_t>(dsc.g->gid.index)),
        window(intersect(rect_of(task.clip_area), rect_of(layer.buf_area))),
        matrix(task, dsc) {
    const lv_area_t& box = *dsc.letter_coords;
    origin = {Q26_6::from_int(box.x1 - dsc.g->ofs_x),
              Q26_6::from_int(box.y2 + 1 + dsc.g->ofs_y)};
    if (!matrix.is_upright) {
      // Its pivot stays: a point of the base line, `pivot.x` from the origin.
      const int32_t back = dsc.pivot.x;
      origin.x.raw += back * 64 - ((back * matrix.x_right + 256) >> 9);
      origin.y.raw += (back * matrix.x_up + 256) >> 9;
    }
  }

  Style style(const Filter& filter) const noexcept {
    if (matrix.is_upright) {
      return with_filter(state.style, filter);
    }
    Style turned(matrix.of_size(state.style.size().raw), filter);
    if (state.style.effect() != nullptr) {
      turned.set_effect(*state.style.effect());
    }
    return turned;
  }

  // In colours if there is an ink.
  void draw(Sink sink,
            const Style& style,
            const GlyphCache* cache = nullptr,
            const CanvasColour* ink = nullptr) const noexcept {
    sink.window = window;
    const Painter painter(sink, state.workspace, cache);
    if (ink == nullptr) {
      painter.glyph(state.font, style, origin, glyph);
    } else {
      state.draw_colours(painter, *ink, state.font, style, origin, glyph);
    }
  }
};

// Draws by LVGL's blending.
void draw_blended(lv_draw_task_t* task,
                  const Part& part,
                  lv_color_t colour,
                  lv_opa_t opacity,
                  const Style& style,
                  const GlyphCache* cache = nullptr,
                  bool in_colours = false) {
  Brush brush = {task, colour, opacity};
  const Sink sink = {{}, &brush, Brush::coverage, Brush::solid, Brush::block};
  const CanvasColour ink = {&brush, Brush::exchange, Brush::pixel_of};
  part.draw(sink, style, cache, in_colours ? &ink : nullptr);
}

// Not inline: most fonts do not need its stack.
__attribute__((noinline)) bool draw_lcd(const Part& part,
                                        lv_color_t colour,
                                        const Style& style,
                                        const GlyphCache* cache) {
  LcdCanvas canvas;
  const Sink* const sink = part.state.open_lcd(part.layer, colour, canvas);
  if (sink == nullptr) {
    return false;
  }
  part.draw(*sink, style, cache);
  return true;
}

void warn_once(const FontState& state, const char* text) noexcept {
  if (!state.has_warned) {
    state.has_warned = true;
    LV_LOG_WARN("inkcell: %s", text);
    LV_UNUSED(text);
  }
}

// Warns of a cache that makes room for more glyphs than it holds for others.
void check_cache(const FontState& state) noexcept {
  if (state.cache == nullptr || state.has_warned) {
    return;
  }
  const GlyphCacheStats stats = state.cache->stats();
  if (stats.evictions > 256 && stats.evictions > stats.hits) {
    warn_once(state, "the cache is too small: inkcell_lv_cache_stats()");
  }
}

bool is_drawn(const FontState& state, const Style& style) noexcept {
  if (state.font.check(style) == Status::ok) {
    return true;
  }
  warn_once(state, "unsupported: the font draws no such letters");
  return false;
}

// The stroke lies below the letter, and reaches `width` beyond it. Not inline,
// as above.
__attribute__((noinline)) void draw_stroke(lv_draw_task_t* task,
                                           const Part& part,
                                           const lv_draw_glyph_dsc_t& glyph) {
  const FontState& state = part.state;
  if (state.make_outline == nullptr) {
    warn_once(state,
              "text_outline_stroke wants inkcell_lv_font_set_outline_stroke()");
    return;
  }
  Filter outline;
  state.make_outline(state.style.filter(), glyph.outline_stroke_width, outline);
  const Style style = part.style(outline);
  if (is_drawn(state, style)) {
    draw_blended(task, part, glyph.outline_stroke_color,
                 glyph.outline_stroke_opa, style);
  }
}

void draw_ink(lv_draw_task_t* task,
              const Part& part,
              const lv_draw_glyph_dsc_t& glyph,
              const Style& style,
              const GlyphCache* cache) {
  const bool in_colours = part.state.draw_colours != nullptr;
  if (in_colours || glyph.opa < LV_OPA_MAX || part.state.open_lcd == nullptr ||
      !draw_lcd(part, glyph.color, style, cache)) {
    draw_blended(task, part, glyph.color, glyph.opa, style, cache, in_colours);
  }
}

__attribute__((noinline)) void draw_turned(lv_draw_task_t* task,
                                           const Part& part,
                                           const lv_draw_glyph_dsc_t& glyph) {
  const Style style = part.style(part.state.style.filter());
  if (is_drawn(part.state, style)) {
    draw_ink(task, part, glyph, style, nullptr);
  }
}

void draw_ours(lv_draw_task_t* task, const lv_draw_glyph_dsc_t& glyph) {
  const FontState* state = state_of(glyph.g->resolved_font);
  if (state == nullptr) {
    return;
  }
  const Part part(*state, *task, glyph);
  if (is_empty(part.window)) {
    return;
  }
  if (glyph.outline_stroke_width > 0 && glyph.outline_stroke_opa > LV_OPA_MIN) {
    draw_stroke(task, part, glyph);
  }
  if (!part.matrix.is_upright) {
    draw_turned(task, part, glyph);
    return;
  }
  // LVGL transforms layers with alpha: colours of pixels that are barely
  // covered then count as those of others, and a cache has none where ink is
  // below half a level.
  const bool is_exact = part.layer.parent != nullptr &&
                        lv_color_format_has_alpha(part.layer.color_format);
  draw_ink(task, part, glyph, state->style, is_exact ? nullptr : state->cache);
}

// As LVGL turns it.
void draw_image(lv_draw_task_t* task, lv_draw_glyph_dsc_t& glyph) {
  glyph.glyph_data = lv_font_get_glyph_bitmap(glyph.g, glyph._draw_buf);
  lv_draw_image_dsc_t image;
  lv_draw_image_dsc_init(&image);
  image.rotation = glyph.rotation;
  image.pivot = {glyph.pivot.x, glyph.g->box_h + glyph.g->ofs_y};
  image.opa = glyph.opa;
  image.src = glyph.glyph_data;
  image.recolor = glyph.color;
  lv_draw_sw_image(task, &image, glyph.letter_coords);
}

// Draws a glyph of a fallback font from its bitmap, in LVGL's buffer.
void draw_bitmap(lv_draw_task_t* task, lv_draw_glyph_dsc_t& glyph) {
  if (glyph.rotation % 3600 != 0) {
    draw_image(task, glyph);
    return;
  }
  glyph.glyph_data = lv_font_get_glyph_bitmap(glyph.g, glyph._draw_buf);
  if (glyph.glyph_data == nullptr) {
    return;
  }
  const auto& bitmap = *static_cast<const lv_draw_buf_t*>(glyph.glyph_data);
  Brush{task, glyph.color, glyph.opa}.blend(
      rect_of(*glyph.letter_coords), bitmap.data,
      static_cast<int32_t>(bitmap.header.stride));
}

// The placeholder for a letter that no font has, as LVGL draws it.
void draw_placeholder(lv_draw_task_t* task, const lv_draw_glyph_dsc_t& glyph) {
#if LV_USE_FONT_PLACEHOLDER
  if (glyph.bg_coords != nullptr) {
    lv_draw_border_dsc_t border;
    lv_draw_border_dsc_init(&border);
    border.opa = glyph.opa;
    border.color = glyph.color;
    border.width = 1;
    lv_draw_sw_border(task, &border, glyph.bg_coords);
  }
#else
  LV_UNUSED(task);
  LV_UNUSED(glyph);
#endif
}

// LVGL leaves out letters whose boxes lie outside of the task's clip, which is
// enlarged while it looks for them: turned ones and strokes reach beyond.
struct Unit : lv_draw_unit_t {
  lv_area_t clip;
};

Unit& unit_of(const lv_draw_task_t& task) noexcept {
  return *static_cast<Unit*>(task.draw_unit);
}

// How far the letters of a label or a letter's task may reach beyond their
// boxes. [px]
template <typename Dsc>
int32_t reach_of(const Dsc& dsc, bool is_turned, int32_t scale) noexcept {
  const int32_t turned =
      is_turned ? 2 * lv_font_get_line_height(dsc.font) * scale / LV_SCALE_NONE
                : 0;
  return turned + LV_MAX(dsc.outline_stroke_width, 0);
}

int32_t reach_of(const lv_draw_task_t& task) noexcept {
  if (task.type == LV_DRAW_TASK_TYPE_LABEL) {
    const auto& label = *static_cast<const lv_draw_label_dsc_t*>(task.draw_dsc);
    return reach_of(label, label.rotation % 3600 != 0, LV_SCALE_NONE);
  }
  const auto& letter = *static_cast<const lv_draw_letter_dsc_t*>(task.draw_dsc);
  return reach_of(letter, true, LV_MAX(letter.scale_x, letter.scale_y));
}

void draw_letter(lv_draw_task_t* task,
                 lv_draw_glyph_dsc_t* glyph,
                 lv_draw_fill_dsc_t* fill,
                 const lv_area_t* fill_area) {
  const lv_area_t searched = task->clip_area;
  task->clip_area = unit_of(*task).clip;
  if (glyph != nullptr) {
    switch (glyph->format) {
      case LV_FONT_GLYPH_FORMAT_CUSTOM:
        draw_ours(task, *glyph);
        break;
      case LV_FONT_GLYPH_FORMAT_A1:
      case LV_FONT_GLYPH_FORMAT_A2:
      case LV_FONT_GLYPH_FORMAT_A3:
      case LV_FONT_GLYPH_FORMAT_A4:
      case LV_FONT_GLYPH_FORMAT_A8:
        draw_bitmap(task, *glyph);
        break;
      case LV_FONT_GLYPH_FORMAT_IMAGE:
        draw_image(task, *glyph);
        break;
      case LV_FONT_GLYPH_FORMAT_NONE:
        draw_placeholder(task, *glyph);
        break;
      default:
        break;
    }
  }
  if (fill != nullptr && fill_area != nullptr) {
    lv_draw_sw_fill(task, fill, fill_area);
  }
  task->clip_area = searched;
}

// The font of a text task; null for other tasks.
const lv_font_t* font_of(const lv_draw_task_t& task) noexcept {
  if (task.type == LV_DRAW_TASK_TYPE_LABEL) {
    return static_cast<const lv_draw_label_dsc_t*>(task.draw_dsc)->font;
  }
  if (task.type == LV_DRAW_TASK_TYPE_LETTER) {
    return static_cast<const lv_draw_letter_dsc_t*>(task.draw_dsc)->font;
  }
  return nullptr;
}

// LVGL waits for what lies below the area that a task may touch.
void widen(lv_draw_task_t& task) noexcept {
  const int32_t reach = reach_of(task);
  lv_area_increase(&task._real_area, reach, reach);
}

int32_t evaluate(lv_draw_unit_t*, lv_draw_task_t* task) {
  for (const lv_font_t* font = font_of(*task); font != nullptr;
       font = font->fallback) {
    const FontState* state = state_of(font);
    if (state != nullptr && state->is_direct) {
      task->preference_score = 0;  // no other unit can
      widen(*task);
      task->preferred_draw_unit_id = kUnitId;
      break;
    }
  }
  return 0;
}

void draw_label(lv_draw_task_t* task) {
  const auto& label = *static_cast<const lv_draw_label_dsc_t*>(task->draw_dsc);
  const int32_t reach = reach_of(*task);
  lv_area_increase(&task->clip_area, reach, reach);
  lv_draw_label_iterate_characters(task, &label, &task->area, draw_letter);
  task->clip_area = unit_of(*task).clip;
  for (const lv_font_t* font = label.font; font != nullptr;
       font = font->fallback) {
    const FontState* state = state_of(font);
    if (state != nullptr) {
      check_cache(*state);
    }
  }
}

void draw_task(lv_draw_task_t* task) {
  unit_of(*task).clip = task->clip_area;
  if (task->type == LV_DRAW_TASK_TYPE_LABEL) {
    draw_label(task);
    return;
  }
  const auto& letter = *static_cast<lv_draw_letter_dsc_t*>(task->draw_dsc);
  lv_draw_glyph_dsc_t glyph;
  lv_draw_glyph_dsc_init(&glyph);
  glyph.opa = letter.opa;
  glyph.color = letter.color;
  glyph.rotation = letter.rotation;
  glyph.pivot = letter.pivot;
  glyph.outline_stroke_opa = letter.outline_stroke_opa;
  glyph.outline_stroke_width = letter.outline_stroke_width;
  glyph.outline_stroke_color = letter.outline_stroke_color;
  const lv_point_t at = {task->area.x1, task->area.y1};
  lv_draw_unit_draw_letter(task, &glyph, &at, letter.font, letter.unicode,
                           draw_letter);
  if (glyph._draw_buf != nullptr) {
    lv_draw_buf_destroy(glyph._draw_buf);
  }
}

int32_t dispatch(lv_draw_unit_t* unit, lv_layer_t* layer) {
  lv_draw_task_t* task = lv_draw_get_available_task(layer, nullptr, kUnitId);
  if (task == nullptr || lv_draw_layer_alloc_buf(layer) == nullptr) {
    return LV_DRAW_UNIT_IDLE;
  }
  task->state = LV_DRAW_TASK_STATE_IN_PROGRESS;
  task->draw_unit = unit;
  draw_task(task);
  task->state = LV_DRAW_TASK_STATE_FINISHED;
  lv_draw_dispatch_request();
  return 1;
}

bool is_registered() noexcept {
  const lv_draw_unit_t* unit = LV_GLOBAL_DEFAULT()->draw_info.unit_head;
  while (unit != nullptr && unit->dispatch_cb != dispatch) {
    unit = unit->next;
  }
  return unit != nullptr;
}

}  // namespace
}  // namespace inkcell::port

void inkcell_lv_font_set_direct(inkcell_lv_font_t* font) {
  using namespace inkcell::port;
  LV_ASSERT_MSG(lv_is_initialized(), "inkcell: call lv_init() first");
  if (!is_registered()) {
    auto* unit =
        static_cast<lv_draw_unit_t*>(lv_draw_create_unit(sizeof(Unit)));
    unit->name = "INKCELL";
    unit->evaluate_cb = evaluate;
    unit->dispatch_cb = dispatch;
  }
  state_of(*font).is_direct = true;
}
