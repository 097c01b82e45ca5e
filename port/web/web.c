#include "web.h"

// The tables of a style, which must outlive it.
typedef struct {
  inkcell_font_t font;
  inkcell_style_t style;
  inkcell_filter_table_t table;
  inkcell_stroke_t stroke;
  inkcell_fit_t fit;
  inkcell_bilevel_t bilevel;
  inkcell_edge_contrast_t contrast;
  inkcell_supersample_t supersample;
  inkcell_lcd_t lcd;
} Look;

static inkcell_filter_t filter_of(const web_job_t* job, Look* look) {
  const inkcell_filter_t* presets[] = {
      &inkcell_filter_text, &inkcell_filter_motion,
      &inkcell_filter_paper_display, &inkcell_filter_paper_body,
      &inkcell_filter_area};
  const int16_t by_q10 = (int16_t)job->weight_q10;
  const int32_t last = WEB_AREA;
  inkcell_filter_t filter =
      *presets[job->filter < 0 || job->filter > last ? 0 : job->filter];
  if (job->filter == WEB_SHADOW) {
    inkcell_filter_shadow(by_q10, &look->table, &filter);
  } else if (job->filter == WEB_GLOW) {
    inkcell_filter_glow(by_q10, &look->table, &filter);
  } else if (by_q10 != 0) {
    const inkcell_filter_t preset = filter;
    inkcell_filter_with_weight(&preset, by_q10, &look->table, &filter);
  }
  return filter;
}

static void set_effect(const web_job_t* job, Look* look) {
  if (job->kind == WEB_SUB_PIXELS) {
    look->lcd = (inkcell_lcd_t){INKCELL_SUB_PIXELS_RGB, 255};
    inkcell_style_set_lcd(&look->style, &look->lcd);
  } else if (job->effect == WEB_STROKE) {
    inkcell_style_set_stroke(&look->style, &look->stroke);
  } else if (job->effect == WEB_BILEVEL) {
    const int32_t fitted_q10 =
        job->fit == WEB_FIT_ACROSS ? inkcell_fit_bilevel_weight(&look->fit) : 0;
    look->bilevel =
        (inkcell_bilevel_t){2, (int16_t)(fitted_q10 - job->weight_q10)};
    inkcell_style_set_bilevel(&look->style, &look->bilevel);
  } else if (job->effect == WEB_EDGE_CONTRAST) {
    look->contrast = (inkcell_edge_contrast_t){90, 96};
    inkcell_style_set_edge_contrast(&look->style, &look->contrast);
  } else if (job->effect == WEB_SUPERSAMPLE) {
    look->supersample = (inkcell_supersample_t){870};
    inkcell_style_set_supersample(&look->style, &look->supersample);
  }
}

static inkcell_status_t open_look(const web_job_t* job, Look* look) {
  inkcell_status_t status =
      inkcell_font_open(job->rom, job->rom_size, &look->font);
  if (status != INKCELL_OK) {
    return status;
  }
  inkcell_filter_t filter = filter_of(job, look);
  if (job->effect == WEB_STROKE) {
    const inkcell_filter_t edge = filter;
    inkcell_stroke_make(&edge, (int16_t)job->width_q10, INKCELL_STROKE_CENTRED,
                        &look->stroke, &filter);
  }
  status =
      job->cosine_q30 == 0 && job->sine_q30 == 0
          ? inkcell_style_make(job->size_q6, &filter, &look->style)
          : inkcell_style_make_turned(job->size_q6, &filter, job->cosine_q30,
                                      job->sine_q30, &look->style);
  if (status == INKCELL_OK && job->fit != WEB_FIT_NONE) {
    status =
        inkcell_fit_make(&look->font, &look->style, job->fit == WEB_FIT_ACROSS,
                         (uint8_t)job->levels, 256, &look->fit);
    if (status == INKCELL_OK) {
      inkcell_style_set_fit(&look->style, &look->fit);
    }
  }
  if (status == INKCELL_OK) {
    set_effect(job, look);
    status = inkcell_font_check(&look->font, &look->style);
  }
  return status;
}

inkcell_status_t web_verify(const web_job_t* job) {
  inkcell_font_t font;
  const inkcell_status_t status =
      inkcell_font_open(job->rom, job->rom_size, &font);
  return status != INKCELL_OK ? status : inkcell_font_verify(&font);
}

#define STRIP(FORMAT)                                             \
  {                                                               \
    job->pixels, job->pixels_size, 0, 0, job->width, job->height, \
        INKCELL_STRIDE_BYTES(FORMAT, job->width)                  \
  }
#define TARGET(name, FORMAT, ...)              \
  target->name = (inkcell_##name##_target_t) { \
    STRIP(FORMAT), __VA_ARGS__                 \
  }

static uint16_t rgb565_of(int32_t colour) {
  return INKCELL_RGB565_OF(colour >> 16 & 255, colour >> 8 & 255, colour & 255);
}

inkcell_status_t web_sink(const web_job_t* job,
                          web_target_t* target,
                          inkcell_sink_t* out) {
  const uint8_t level = (uint8_t)job->colour;
  const uint32_t rgb = (uint32_t)job->colour;
  const bool dithered = job->kind == WEB_DITHERED;
  const bool lcd = job->kind == WEB_SUB_PIXELS;
  switch (job->format) {
    case INKCELL_A8:
      target->a8 = (inkcell_a8_target_t){STRIP(INKCELL_A8)};
      return inkcell_a8_sink(&target->a8, out);
    case INKCELL_GREY8:
      TARGET(grey8, INKCELL_GREY8, level);
      return inkcell_grey8_sink(&target->grey8, out);
    case INKCELL_GREY4:
      TARGET(grey4, INKCELL_GREY4, level, INKCELL_HIGH_LEFT);
      return (dithered ? inkcell_grey4_dithered_sink : inkcell_grey4_sink)(
          &target->grey4, out);
    case INKCELL_GREY2:
      TARGET(grey2, INKCELL_GREY2, level, INKCELL_HIGH_LEFT);
      return (dithered ? inkcell_grey2_dithered_sink : inkcell_grey2_sink)(
          &target->grey2, out);
    case INKCELL_MONO_ROWS:
      TARGET(mono_rows, INKCELL_MONO_ROWS, 128, level, INKCELL_HIGH_LEFT);
      return (dithered ? inkcell_mono_rows_dithered_sink
                       : inkcell_mono_rows_sink)(&target->mono_rows, out);
    case INKCELL_MONO_PAGES:
      TARGET(mono_pages, INKCELL_MONO_PAGES, 128, level);
      return (dithered ? inkcell_mono_pages_dithered_sink
                       : inkcell_mono_pages_sink)(&target->mono_pages, out);
    case INKCELL_RGB565:
      TARGET(rgb565, INKCELL_RGB565, rgb565_of(job->colour));
      return (lcd ? inkcell_rgb565_lcd_sink : inkcell_rgb565_sink)(
          &target->rgb565, out);
    case INKCELL_RGB888:
      TARGET(rgb888, INKCELL_RGB888, rgb, INKCELL_RED_FIRST);
      return (lcd ? inkcell_rgb888_lcd_sink : inkcell_rgb888_sink)(
          &target->rgb888, out);
    case INKCELL_XRGB8888:
      TARGET(xrgb8888, INKCELL_XRGB8888, rgb);
      return (lcd ? inkcell_xrgb8888_lcd_sink : inkcell_xrgb8888_sink)(
          &target->xrgb8888, out);
    default:
      return INKCELL_BAD_ARGUMENT;
  }
}

inkcell_status_t web_draw(const web_job_t* job) {
  Look look;
  inkcell_status_t status = open_look(job, &look);
  web_target_t target;
  inkcell_sink_t sink;
  if (status == INKCELL_OK) {
    status = web_sink(job, &target, &sink);
  }
  if (status == INKCELL_OK) {
    const inkcell_painter_t painter = {.sink = &sink};
    inkcell_draw_text(&painter, &look.font, job->text, job->text_size,
                      &look.style, job->x_q6, job->y_q6);
  }
  return status;
}

int32_t web_advance(const web_job_t* job) {
  Look look;
  if (open_look(job, &look) != INKCELL_OK) {
    return 0;
  }
  inkcell_pixel_measure_t measure;
  inkcell_measure(NULL, &look.font, job->text, job->text_size, &look.style,
                  &measure);
  return measure.advance_q6;
}

int32_t web_glyph_count(const web_job_t* job) {
  inkcell_font_t font;
  return inkcell_font_open(job->rom, job->rom_size, &font) == INKCELL_OK
             ? inkcell_font_glyph_count(&font)
             : 0;
}

int32_t web_has(const web_job_t* job, uint32_t code_point) {
  inkcell_font_t font;
  uint16_t glyph;
  return inkcell_font_open(job->rom, job->rom_size, &font) == INKCELL_OK &&
         inkcell_font_glyph_of(&font, code_point, &glyph) == INKCELL_OK;
}

uint32_t web_sizes(const web_job_t* job) {
  inkcell_font_t font;
  inkcell_font_range_t range;
  if (inkcell_font_open(job->rom, job->rom_size, &font) != INKCELL_OK) {
    return 0;
  }
  inkcell_font_range(&font, &range);
  return range.min_px | (uint32_t)range.max_px << 16;
}

// The pixels that units from `least` to `most` meet.
static int32_t pixels(const Look* look, int32_t least, int32_t most) {
  const int32_t first_q6 = inkcell_to_px(&look->font, &look->style, least);
  const int32_t last_q6 = inkcell_to_px(&look->font, &look->style, most);
  return ((last_q6 + 63) >> 6) - (first_q6 >> 6);
}

uint32_t web_bitmap_bytes(const web_job_t* job, int32_t bits) {
  Look look;
  if (open_look(job, &look) != INKCELL_OK) {
    return 0;
  }
  uint32_t bytes = 0;
  for (uint16_t glyph = 0; glyph < inkcell_font_glyph_count(&look.font);
       ++glyph) {
    inkcell_glyph_metrics_t ink;
    inkcell_font_glyph_metrics(&look.font, glyph, &ink);
    const int32_t width = pixels(&look, ink.x_min, ink.x_max);
    const int32_t height = pixels(&look, ink.y_min, ink.y_max);
    bytes += (uint32_t)(width * height * bits + 7) / 8;
  }
  return bytes;
}
