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
// A TrueType file is a font, too, fitted in height alone. Text in a font that
// was made with --shape is shaped, and ordered from right to left where it is
// to be.
//
// help(inkcell.Font) lists the functions. (x, y) is the left end of the first
// baseline. Text is fitted to the grid of pixels, unless fit=False: measure
// with the format that it is drawn in. Size and position may be floats. RGB565
// has the low byte first, as framebuf writes it; high_first=True for buffers of
// panels. ValueError: what is out of range, or says why a font is none.
#include <string.h>

#include "inkcell/inkcell.h"
#include "py/obj.h"
#include "py/objlist.h"
#include "py/objstr.h"
#include "py/runtime.h"

// Positions and sizes are below this. [px]
#define MOST_PX 32767

typedef struct font_obj_t {
  mp_obj_base_t base;
  mp_obj_t object;    // keeps the memory of the font
  const void* bytes;  // the memory when the font was opened
  size_t size;        // likewise
  bool is_copy;
  inkcell_font_t font;
  inkcell_truetype_t file;  // of a font that is a TrueType file
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

// Raises what is wrong with an argument.
static void check(const char* argument, inkcell_status_t status) {
  if (status != INKCELL_OK) {
    mp_raise_msg_varg(&mp_type_ValueError, MP_ERROR_TEXT("inkcell: %s: %s"),
                      argument, inkcell_status_name(status));
  }
}

// What shapes a text, in memory of the heap.
typedef struct shaping_t {
  inkcell_bidi_t bidi;
  inkcell_text_shaper_t shaper;
  inkcell_line_shaper_t lines;
} shaping_t;

// Longer words are shaped in parts, which join.
#define MOST_GLYPHS 64

// Null: the font shapes nothing.
static shaping_t* make_shaping(const inkcell_font_t* font, size_t size) {
  if (size == 0 || !inkcell_font_shapes(font)) {
    return NULL;
  }
  shaping_t* const made = m_new(shaping_t, 1);
  inkcell_bidi_init(&made->bidi, m_new(uint16_t, size), size);
  inkcell_text_shaper_init_devanagari(m_new(inkcell_text_glyph_t, MOST_GLYPHS),
                                      MOST_GLYPHS, &made->shaper);
  inkcell_line_shaper_init(&made->shaper, &made->bidi, &made->lines);
  return made;
}

static int32_t within(const char* argument, mp_int_t number, mp_int_t least) {
  check(argument, number >= least && number <= MOST_PX ? INKCELL_OK
                                                       : INKCELL_BAD_ARGUMENT);
  return (int32_t)number;
}

static int32_t px_q6(const char* argument, mp_obj_t number) {
#if MICROPY_PY_BUILTINS_FLOAT
  if (mp_obj_is_float(number)) {
    const mp_float_t px = mp_obj_get_float(number);
    // Also what is not a number.
    check(argument,
          px >= -MOST_PX && px <= MOST_PX ? INKCELL_OK : INKCELL_BAD_ARGUMENT);
    return (int32_t)(px * 64);
  }
#endif
  return within(argument, mp_obj_get_int(number), -MOST_PX) * 64;
}

// MVLSB, MHLSB and MHMSB.
static bool is_mono_format(mp_int_t format) {
  return format == 0 || format == 3 || format == 4;
}

// The font, whose memory is where it was: a bytearray may have grown.
static const inkcell_font_t* font_of(const font_obj_t* self) {
  if (!self->is_copy) {
    mp_buffer_info_t rom;
    mp_get_buffer_raise(self->object, &rom, MP_BUFFER_READ);
    check("font", rom.buf == self->bytes && rom.len >= self->size
                      ? INKCELL_OK
                      : INKCELL_READ_FAILED);
  }
  return &self->font;
}

static void make_look(const font_obj_t* self,
                      mp_obj_t size,
                      bool fitted,
                      bool is_mono,
                      look_t* look) {
  const int32_t size_q6 = px_q6("size", size);
  check("size",
        inkcell_style_make(size_q6, &inkcell_filter_area, &look->style));
  if (fitted) {
    check("size", inkcell_fit_make(&self->font, &look->style,
                                   is_mono || size_q6 < INKCELL_Q6(12),
                                   is_mono ? 2 : 0, 256, &look->fit));
    inkcell_style_set_fit(&look->style, &look->fit);
  } else {
    // Painters of 1 and 2 bits would fit it.
    inkcell_style_clear_fit(&look->style);
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
  self->object = args[0];
  self->bytes = rom.buf;
  self->size = rom.len;
  self->is_copy = false;
  inkcell_status_t status =
      inkcell_truetype_open(rom.buf, rom.len, 0, &self->file, &self->font);
  if (status == INKCELL_BAD_MAGIC) {
    self->is_copy = ((uintptr_t)rom.buf & 3) != 0;
    if (self->is_copy) {
      // Frozen bytes and files of ROMFS may lie anywhere: a copy does not.
      uint8_t* const copy = m_new(uint8_t, rom.len);
      memcpy(copy, rom.buf, rom.len);
      self->bytes = copy;
    }
    status = inkcell_font_open(self->bytes, self->size, &self->font);
  }
  check("font", status);
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

// Draws lines that end at line feeds, each a line height below the one before.
static void draw_lines(const inkcell_painter_t* painter,
                       const inkcell_font_t* font,
                       const inkcell_style_t* style,
                       const char* text,
                       size_t size,
                       int32_t x_q6,
                       int32_t y_q6) {
  inkcell_layout_options_t options;
  inkcell_layout_options_init(&options, font, style);
  for (;;) {
    const char* const end = memchr(text, '\n', size);
    const size_t length = end == NULL ? size : (size_t)(end - text);
    inkcell_draw_text(painter, font, text, length, style, x_q6, y_q6);
    if (end == NULL || y_q6 > INKCELL_Q6(MOST_PX)) {
      return;
    }
    text = end + 1;
    size -= length + 1;
    y_q6 += inkcell_line_height(&options);
  }
}

static mp_obj_t font_text(size_t n_args,
                          const mp_obj_t* pos_args,
                          mp_map_t* kw_args) {
  enum { buf, wide, high, format, text, x, y, size, colour, color, fit, order };
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
      {MP_QSTR_color, MP_ARG_KW_ONLY | MP_ARG_INT, {.u_int = -1}},
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
  make_look(self, args[size].u_obj, args[fit].u_bool, is_mono_format(kind),
            &look);
  inkcell_strip_t strip = {.pixels = pixels.buf,
                           .size = pixels.len,
                           .width = within("width", args[wide].u_int, 0),
                           .height = within("height", args[high].u_int, 0)};
  strip.order = args[order].u_bool ? INKCELL_HIGH_FIRST : INKCELL_LOW_FIRST;
  target_t target;
  inkcell_sink_t sink;
  const mp_int_t ink = args[color].u_int;
  const inkcell_status_t made = make_sink(
      strip, kind, ink < 0 ? args[colour].u_int : ink, &target, &sink);
  check(made == INKCELL_UNSUPPORTED ? "format" : "buffer", made);
  size_t count;
  const char* const string = mp_obj_str_get_data(args[text].u_obj, &count);
  shaping_t* const shaping = make_shaping(font_of(self), count);
  const inkcell_painter_t painter = {
      .sink = &sink, .lines = shaping == NULL ? NULL : &shaping->lines};
  draw_lines(&painter, font_of(self), &look.style, string, count,
             px_q6("x", args[x].u_obj), px_q6("y", args[y].u_obj));
  return mp_const_none;
}
static MP_DEFINE_CONST_FUN_OBJ_KW(font_text_obj, 1, font_text);

// The font, text and look of what measures: `n` arguments come first, then
// `format`, by default RGB565, and `fit`.
static const inkcell_font_t* parse(const mp_arg_t* allowed,
                                   size_t n,
                                   size_t n_args,
                                   const mp_obj_t* pos_args,
                                   mp_map_t* kw_args,
                                   mp_arg_val_t* args,
                                   look_t* look) {
  mp_arg_parse_all(n_args - 1, pos_args + 1, kw_args, n + 2, allowed, args);
  const font_obj_t* self = MP_OBJ_TO_PTR(pos_args[0]);
  make_look(self, args[n - 1].u_obj, args[n + 1].u_bool,
            is_mono_format(args[n].u_int), look);
  return font_of(self);
}

// How far the next character is, of the longest line.
static mp_obj_t font_width(size_t n_args,
                           const mp_obj_t* pos_args,
                           mp_map_t* kw_args) {
  static const mp_arg_t allowed[] = {
      {MP_QSTR_text, MP_ARG_REQUIRED | MP_ARG_OBJ, {0}},
      {MP_QSTR_size, MP_ARG_REQUIRED | MP_ARG_OBJ, {0}},
      {MP_QSTR_format, MP_ARG_INT, {.u_int = 1}},
      {MP_QSTR_fit, MP_ARG_KW_ONLY | MP_ARG_BOOL, {.u_bool = true}},
  };
  mp_arg_val_t args[MP_ARRAY_SIZE(allowed)];
  look_t look;
  const inkcell_font_t* const font =
      parse(allowed, 2, n_args, pos_args, kw_args, args, &look);
  size_t size;
  const char* text = mp_obj_str_get_data(args[0].u_obj, &size);
  shaping_t* const shaping = make_shaping(font, size);
  const inkcell_painter_t painter = {
      .lines = shaping == NULL ? NULL : &shaping->lines};
  int32_t most_q6 = 0;
  for (;;) {
    const char* const end = memchr(text, '\n', size);
    const size_t length = end == NULL ? size : (size_t)(end - text);
    inkcell_pixel_measure_t measure;
    inkcell_measure(&painter, font, text, length, &look.style, &measure);
    most_q6 = measure.advance_q6 > most_q6 ? measure.advance_q6 : most_q6;
    if (end == NULL) {
      return mp_obj_new_int((most_q6 + 63) / 64);
    }
    text = end + 1;
    size -= length + 1;
  }
}
static MP_DEFINE_CONST_FUN_OBJ_KW(font_width_obj, 1, font_width);

// The lines of a text that are at most `width` px long, as a list.
static mp_obj_t font_wrap(size_t n_args,
                          const mp_obj_t* pos_args,
                          mp_map_t* kw_args) {
  static const mp_arg_t allowed[] = {
      {MP_QSTR_text, MP_ARG_REQUIRED | MP_ARG_OBJ, {0}},
      {MP_QSTR_width, MP_ARG_REQUIRED | MP_ARG_INT, {0}},
      {MP_QSTR_size, MP_ARG_REQUIRED | MP_ARG_OBJ, {0}},
      {MP_QSTR_format, MP_ARG_INT, {.u_int = 1}},
      {MP_QSTR_fit, MP_ARG_KW_ONLY | MP_ARG_BOOL, {.u_bool = true}},
  };
  mp_arg_val_t args[MP_ARRAY_SIZE(allowed)];
  look_t look;
  const inkcell_font_t* const font =
      parse(allowed, 3, n_args, pos_args, kw_args, args, &look);
  const int32_t width_q6 = within("width", args[1].u_int, 0) * 64;
  size_t size;
  const char* const text = mp_obj_str_get_data(args[0].u_obj, &size);
  inkcell_layout_options_t options;
  inkcell_layout_options_init(&options, font, &look.style);
  shaping_t* const shaping = make_shaping(font, size);
  if (shaping != NULL) {
    inkcell_layout_options_set_bidi(&options, &shaping->bidi);
    inkcell_layout_options_set_shaper(&options, &shaping->shaper);
  }
  const mp_obj_t lines = mp_obj_new_list(0, NULL);
  inkcell_text_line_t line = {0};
  while (inkcell_next_line(&options, NULL, text, size, width_q6, &line)) {
    vstr_t string;
    vstr_init(&string, line.length + 1u);
    vstr_add_strn(&string, text + line.begin, line.length);
    if (line.has_hyphen) {
      vstr_add_byte(&string, '-');
    }
    mp_obj_list_append(lines, mp_obj_new_str_from_vstr(&string));
  }
  return lines;
}
static MP_DEFINE_CONST_FUN_OBJ_KW(font_wrap_obj, 1, font_wrap);

// A length of lines, rounded up.
static mp_obj_t of_lines(mp_obj_t object,
                         mp_obj_t size,
                         int32_t (*length)(const inkcell_layout_options_t*)) {
  const font_obj_t* const self = MP_OBJ_TO_PTR(object);
  look_t look;
  make_look(self, size, false, false, &look);
  inkcell_layout_options_t options;
  inkcell_layout_options_init(&options, font_of(self), &look.style);
  return mp_obj_new_int((length(&options) + 63) / 64);
}

static mp_obj_t font_height(mp_obj_t self, mp_obj_t size) {
  return of_lines(self, size, inkcell_line_height);
}
static MP_DEFINE_CONST_FUN_OBJ_2(font_height_obj, font_height);

static mp_obj_t font_ascent(mp_obj_t self, mp_obj_t size) {
  return of_lines(self, size, inkcell_baseline);
}
static MP_DEFINE_CONST_FUN_OBJ_2(font_ascent_obj, font_ascent);

static MP_DEFINE_STR_OBJ(
    font_doc,
    "Font(bytes): a font that inkcell-fontgen --format bin made, or a TrueType "
    "file. Lengths in px.\n"
    "text(buffer, width, height, format, text, x, y, size, colour=0xFFFF, *, "
    "color, fit=True, high_first=False): draws lines into a buffer of "
    "framebuf, "
    "from the left end of the first baseline, (x, y). color is colour.\n"
    "width(text, size, format=RGB565, *, fit=True): of the longest line, as "
    "drawn in that format.\n"
    "wrap(text, width, size, format=RGB565, *, fit=True): a list of lines.\n"
    "height(size): of a line. ascent(size): from its top to the baseline.");

static const mp_rom_map_elem_t font_locals_table[] = {
    {MP_ROM_QSTR(MP_QSTR___doc__), MP_ROM_PTR(&font_doc)},
    {MP_ROM_QSTR(MP_QSTR_ascent), MP_ROM_PTR(&font_ascent_obj)},
    {MP_ROM_QSTR(MP_QSTR_height), MP_ROM_PTR(&font_height_obj)},
    {MP_ROM_QSTR(MP_QSTR_text), MP_ROM_PTR(&font_text_obj)},
    {MP_ROM_QSTR(MP_QSTR_width), MP_ROM_PTR(&font_width_obj)},
    {MP_ROM_QSTR(MP_QSTR_wrap), MP_ROM_PTR(&font_wrap_obj)},
};
static MP_DEFINE_CONST_DICT(font_locals, font_locals_table);

MP_DEFINE_CONST_OBJ_TYPE(inkcell_font_type,
                         MP_QSTR_Font,
                         MP_TYPE_FLAG_NONE,
                         make_new,
                         font_make_new,
                         locals_dict,
                         &font_locals);

static MP_DEFINE_STR_OBJ(module_doc,
                         "Text of any size in buffers of framebuf: see "
                         "help(inkcell.Font).");

static const mp_rom_map_elem_t module_table[] = {
    {MP_ROM_QSTR(MP_QSTR___name__), MP_ROM_QSTR(MP_QSTR_inkcell)},
    {MP_ROM_QSTR(MP_QSTR___doc__), MP_ROM_PTR(&module_doc)},
    {MP_ROM_QSTR(MP_QSTR_Font), MP_ROM_PTR(&inkcell_font_type)},
};
static MP_DEFINE_CONST_DICT(module_globals, module_table);

const mp_obj_module_t inkcell_module = {
    .base = {&mp_type_module},
    .globals = (mp_obj_dict_t*)&module_globals,
};

MP_REGISTER_MODULE(MP_QSTR_inkcell, inkcell_module);
