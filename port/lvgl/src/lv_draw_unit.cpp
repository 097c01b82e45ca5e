// A draw unit of LVGL that draws glyphs straight into a layer.
//
// LVGL lays labels out and calls back for each glyph, with a buffer for
// bitmaps. Our glyphs have the format CUSTOM, which needs no buffer: their
// coverage is blended by LVGL in blocks of a few rows.
#include "inkcell/lvgl/inkcell_lvgl.h"
#include "inkcell/strip.hpp"
#include "lvgl_private.h"

#include "font_state.hpp"

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
};

// The part of a glyph that a task draws, and the glyph's origin.
struct Part {
  const FontState& state;
  const lv_draw_glyph_dsc_t& glyph;
  Rect window;

  void draw(Sink sink) const noexcept {
    sink.window = window;
    const lv_area_t& box = *glyph.letter_coords;
    const Point origin = {Q26_6::from_int(box.x1 - glyph.g->ofs_x),
                          Q26_6::from_int(box.y2 + 1 + glyph.g->ofs_y)};
    state.draw(static_cast<uint16_t>(glyph.g->gid.index), origin, sink);
  }
};

// Not inline: most fonts do not need its stack.
__attribute__((noinline)) bool draw_lcd(const lv_layer_t& layer,
                                        const Part& part) {
  LcdCanvas canvas;
  const Sink* const sink = part.state.open_lcd(layer, part.glyph.color, canvas);
  if (sink == nullptr) {
    return false;
  }
  part.draw(*sink);
  return true;
}

void draw_ours(lv_draw_task_t* task, const lv_draw_glyph_dsc_t& glyph) {
  const FontState* state = state_of(glyph.g->resolved_font);
  const lv_layer_t& layer = *task->target_layer;
  if (state == nullptr) {
    return;
  }
  const Rect window =
      intersect(rect_of(*glyph.letter_coords),
                intersect(rect_of(task->clip_area), rect_of(layer.buf_area)));
  const Part part = {*state, glyph, window};
  if (is_empty(window) ||
      (glyph.opa >= LV_OPA_MAX && state->open_lcd != nullptr &&
       draw_lcd(layer, part))) {
    return;
  }
  Brush brush = {task, glyph.color, glyph.opa};
  Sink sink = {{}, &brush, Brush::coverage, Brush::solid, Brush::block};
  part.draw(sink);
}

// Draws a glyph of a fallback font from its bitmap, in LVGL's buffer.
void draw_bitmap(lv_draw_task_t* task, lv_draw_glyph_dsc_t& glyph) {
  glyph.glyph_data = lv_font_get_glyph_bitmap(glyph.g, glyph._draw_buf);
  if (glyph.glyph_data == nullptr) {
    return;
  }
  const auto& bitmap = *static_cast<const lv_draw_buf_t*>(glyph.glyph_data);
  Brush{task, glyph.color, glyph.opa}.blend(
      rect_of(*glyph.letter_coords), bitmap.data,
      static_cast<int32_t>(bitmap.header.stride));
}

void draw_image(lv_draw_task_t* task, lv_draw_glyph_dsc_t& glyph) {
  glyph.glyph_data = lv_font_get_glyph_bitmap(glyph.g, glyph._draw_buf);
  lv_draw_image_dsc_t image;
  lv_draw_image_dsc_init(&image);
  image.opa = glyph.opa;
  image.src = glyph.glyph_data;
  image.recolor = glyph.color;
  lv_draw_sw_image(task, &image, glyph.letter_coords);
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

void draw_letter(lv_draw_task_t* task,
                 lv_draw_glyph_dsc_t* glyph,
                 lv_draw_fill_dsc_t* fill,
                 const lv_area_t* fill_area) {
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

int32_t evaluate(lv_draw_unit_t*, lv_draw_task_t* task) {
  for (const lv_font_t* font = font_of(*task); font != nullptr;
       font = font->fallback) {
    const FontState* state = state_of(font);
    if (state != nullptr && state->is_direct) {
      task->preference_score = 0;  // no other unit can
      task->preferred_draw_unit_id = kUnitId;
      break;
    }
  }
  return 0;
}

void draw_task(lv_draw_task_t* task) {
  if (task->type == LV_DRAW_TASK_TYPE_LABEL) {
    lv_draw_label_iterate_characters(
        task, static_cast<const lv_draw_label_dsc_t*>(task->draw_dsc),
        &task->area, draw_letter);
    return;
  }
  const auto& letter = *static_cast<lv_draw_letter_dsc_t*>(task->draw_dsc);
  if (letter.rotation % 3600 != 0) {
    return;
  }
  lv_draw_glyph_dsc_t glyph;
  lv_draw_glyph_dsc_init(&glyph);
  glyph.opa = letter.opa;
  glyph.color = letter.color;
  glyph.pivot = letter.pivot;
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
  if (!is_registered()) {
    auto* unit = static_cast<lv_draw_unit_t*>(
        lv_draw_create_unit(sizeof(lv_draw_unit_t)));
    unit->name = "INKCELL";
    unit->evaluate_cb = evaluate;
    unit->dispatch_cb = dispatch;
  }
  state_of(*font).is_direct = true;
}
