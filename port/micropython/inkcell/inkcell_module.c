// The module `inkcell` of MicroPython: text of any size in the buffers of
// framebuf.
//
//   import framebuf, inkcell
//   rgb = bytearray(240 * 60 * 2)
//   paper = framebuf.FrameBuffer(rgb, 240, 60, framebuf.RGB565)
//   # By inkcell-fontgen --format bin:
//   sans = inkcell.Font(open("sans.bin", "rb").read())
//   sans.text(rgb, 240, 60, framebuf.RGB565, "21.5", 4, 44, 40, 0xFFFF)
//   width = sans.width("21.5", 40)
//
// (x, y) is the left end of the baseline. Text is fitted to the grid of pixels,
// unless fit=False; size and position may be floats. RGB565 has the low byte
// first, as framebuf writes it; high_first=True for buffers of panels.
#include "inkcell/inkcell.h"
#include "py/obj.h"
#include "py/runtime.h"

typedef struct font_obj_t {
  mp_obj_base_t base;
  mp_obj_t bytes;  // keeps the font's memory
  inkcell_font_t font;
} font_obj_t;

// A font at a size, with what its style points to.
typedef struct look_t {
  inkcell_style_t style;
  inkcell_fit_t fit;
} look_t;

typedef union target_t {
  inkcell_rgb565_target_t rgb565;
  inkcell_grey8_target_t grey8;
  inkcell_grey4_target_t grey4;
  inkcell_grey2_target_t grey2;
  inkcell_mono_rows_target_t rows;
  inkcell_mono_pages_target_t pages;
} target_t;

static void check(inkcell_status_t status) {
  if (status != INKCELL_OK) {
    mp_raise_msg_varg(&mp_type_ValueError, MP_ERROR_TEXT("inkcell: %s"),
                      inkcell_status_name(status));
  }
}

static int32_t px_q6(mp_obj_t number) {
#if MICROPY_PY_BUILTINS_FLOAT
  if (mp_obj_is_float(number)) {
    return (int32_t)(mp_obj_get_float(number) * 64);
  }
#endif
  return (int32_t)mp_obj_get_int(number) * 64;
}

static void make_look(const font_obj_t* self,
                      mp_obj_t size,
                      bool fitted,
                      bool is_mono,
                      look_t* look) {
  const int32_t size_q6 = px_q6(size);
  check(inkcell_style_make(size_q6, &inkcell_filter_area, &look->style));
  if (fitted) {
    check(inkcell_fit_make(&self->font, &look->style,
                           is_mono || size_q6 < INKCELL_Q6(12), is_mono ? 2 : 0,
                           256, &look->fit));
    inkcell_style_set_fit(&look->style, &look->fit);
  }
}

static mp_obj_t font_make_new(const mp_obj_type_t* type,
                              size_t n_args,
                              size_t n_kw,
                              const mp_obj_t* args) {
  mp_arg_check_num(n_args, n_kw, 1, 1, false);
  font_obj_t* self = mp_obj_malloc(font_obj_t, type);
  mp_buffer_info_t rom;
  mp_get_buffer_raise(args[0], &rom, MP_BUFFER_READ);
  self->bytes = args[0];
  check(inkcell_font_open(rom.buf, rom.len, &self->font));
  return MP_OBJ_FROM_PTR(self);
}

// The sink of a buffer of framebuf, whose formats have these numbers.
static inkcell_status_t make_sink(inkcell_strip_t strip,
                                  mp_int_t format,
                                  mp_int_t colour,
                                  target_t* target,
                                  inkcell_sink_t* sink) {
  const uint8_t level = (uint8_t)colour;
  const bool is_set = colour != 0;
  const int32_t width = strip.width;
  strip.stride = format == 0   ? width
                 : format == 1 ? 2 * width
                 : format == 2 ? (width + 1) / 2
                 : format == 5 ? (width + 3) / 4
                 : format == 6 ? width
                               : (width + 7) / 8;
  switch (format) {
    case 0:  // MVLSB
      target->pages = (inkcell_mono_pages_target_t){strip, 128, is_set};
      return inkcell_mono_pages_sink(&target->pages, sink);
    case 1:  // RGB565
      target->rgb565 = (inkcell_rgb565_target_t){strip, (uint16_t)colour};
      return inkcell_rgb565_sink(&target->rgb565, sink);
    case 2:  // GS4_HMSB
      target->grey4 =
          (inkcell_grey4_target_t){strip, level & 15, INKCELL_HIGH_LEFT};
      return inkcell_grey4_sink(&target->grey4, sink);
    case 3:  // MHLSB: the left pixel is the high bit
    case 4:  // MHMSB
      target->rows = (inkcell_mono_rows_target_t){
          strip, 128, is_set,
          format == 3 ? INKCELL_HIGH_LEFT : INKCELL_LOW_LEFT};
      return inkcell_mono_rows_sink(&target->rows, sink);
    case 5:  // GS2_HMSB
      target->grey2 =
          (inkcell_grey2_target_t){strip, level & 3, INKCELL_LOW_LEFT};
      return inkcell_grey2_sink(&target->grey2, sink);
    case 6:  // GS8
      target->grey8 = (inkcell_grey8_target_t){strip, level};
      return inkcell_grey8_sink(&target->grey8, sink);
    default:
      return INKCELL_UNSUPPORTED;
  }
}

static mp_obj_t font_text(size_t n_args,
                          const mp_obj_t* pos_args,
                          mp_map_t* kw_args) {
  enum { buf, wide, high, format, text, x, y, size, colour, fit, order };
  static const mp_arg_t allowed[] = {
      {MP_QSTR_buffer, MP_ARG_REQUIRED | MP_ARG_OBJ, {0}},
      {MP_QSTR_width, MP_ARG_REQUIRED | MP_ARG_INT, {0}},
      {MP_QSTR_height, MP_ARG_REQUIRED | MP_ARG_INT, {0}},
      {MP_QSTR_format, MP_ARG_REQUIRED | MP_ARG_INT, {0}},
      {MP_QSTR_text, MP_ARG_REQUIRED | MP_ARG_OBJ, {0}},
      {MP_QSTR_x, MP_ARG_REQUIRED | MP_ARG_OBJ, {0}},
      {MP_QSTR_y, MP_ARG_REQUIRED | MP_ARG_OBJ, {0}},
      {MP_QSTR_size, MP_ARG_REQUIRED | MP_ARG_OBJ, {0}},
      {MP_QSTR_colour, MP_ARG_INT, {.u_int = 0xffff}},
      {MP_QSTR_fit, MP_ARG_KW_ONLY | MP_ARG_BOOL, {.u_bool = true}},
      {MP_QSTR_high_first, MP_ARG_KW_ONLY | MP_ARG_BOOL, {.u_bool = false}},
  };
  mp_arg_val_t args[MP_ARRAY_SIZE(allowed)];
  mp_arg_parse_all(n_args - 1, pos_args + 1, kw_args, MP_ARRAY_SIZE(allowed),
                   allowed, args);
  const font_obj_t* self = MP_OBJ_TO_PTR(pos_args[0]);
  mp_buffer_info_t pixels;
  mp_get_buffer_raise(args[buf].u_obj, &pixels, MP_BUFFER_RW);
  const mp_int_t kind = args[format].u_int;
  look_t look;
  make_look(self, args[size].u_obj, args[fit].u_bool,
            kind == 0 || kind == 3 || kind == 4, &look);
  inkcell_strip_t strip = {.pixels = pixels.buf,
                           .size = pixels.len,
                           .width = (int32_t)args[wide].u_int,
                           .height = (int32_t)args[high].u_int};
  strip.order = args[order].u_bool ? INKCELL_HIGH_FIRST : INKCELL_LOW_FIRST;
  target_t target;
  inkcell_sink_t sink;
  check(make_sink(strip, kind, args[colour].u_int, &target, &sink));
  size_t count;
  const char* const string = mp_obj_str_get_data(args[text].u_obj, &count);
  const inkcell_painter_t painter = {.sink = &sink};
  inkcell_draw_text(&painter, &self->font, string, count, &look.style,
                    px_q6(args[x].u_obj), px_q6(args[y].u_obj));
  return mp_const_none;
}
static MP_DEFINE_CONST_FUN_OBJ_KW(font_text_obj, 9, font_text);

// font.width(text, size, fit=True): how far the next character is, in px.
static mp_obj_t font_width(size_t n_args, const mp_obj_t* args) {
  const font_obj_t* self = MP_OBJ_TO_PTR(args[0]);
  look_t look;
  make_look(self, args[2], n_args < 4 || mp_obj_is_true(args[3]), false, &look);
  size_t count;
  const char* const string = mp_obj_str_get_data(args[1], &count);
  inkcell_pixel_measure_t measure;
  inkcell_measure(NULL, &self->font, string, count, &look.style, &measure);
  return mp_obj_new_int((measure.advance_q6 + 63) / 64);
}
static MP_DEFINE_CONST_FUN_OBJ_VAR_BETWEEN(font_width_obj, 3, 4, font_width);

static const mp_rom_map_elem_t font_locals_table[] = {
    {MP_ROM_QSTR(MP_QSTR_text), MP_ROM_PTR(&font_text_obj)},
    {MP_ROM_QSTR(MP_QSTR_width), MP_ROM_PTR(&font_width_obj)},
};
static MP_DEFINE_CONST_DICT(font_locals, font_locals_table);

MP_DEFINE_CONST_OBJ_TYPE(inkcell_font_type,
                         MP_QSTR_Font,
                         MP_TYPE_FLAG_NONE,
                         make_new,
                         font_make_new,
                         locals_dict,
                         &font_locals);

static const mp_rom_map_elem_t module_table[] = {
    {MP_ROM_QSTR(MP_QSTR___name__), MP_ROM_QSTR(MP_QSTR_inkcell)},
    {MP_ROM_QSTR(MP_QSTR_Font), MP_ROM_PTR(&inkcell_font_type)},
};
static MP_DEFINE_CONST_DICT(module_globals, module_table);

const mp_obj_module_t inkcell_module = {
    .base = {&mp_type_module},
    .globals = (mp_obj_dict_t*)&module_globals,
};

MP_REGISTER_MODULE(MP_QSTR_inkcell, inkcell_module);
