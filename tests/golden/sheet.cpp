#include "sheet.hpp"

#include "inkcell/field/draw.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/port/a8.hpp"
#include "inkcell/port/grey2.hpp"
#include "inkcell/port/grey4.hpp"
#include "inkcell/port/grey8.hpp"
#include "inkcell/port/lcd.hpp"
#include "inkcell/port/mono_pages.hpp"
#include "inkcell/port/mono_rows.hpp"
#include "inkcell/port/rgb565.hpp"
#include "inkcell/port/rgb888.hpp"
#include "inkcell/port/strip_loop.hpp"
#include "inkcell/port/xrgb8888.hpp"
#include "styles.hpp"

namespace golden {
namespace {

using namespace inkcell;
using namespace inkcell::port;

constexpr int32_t kOne = 1 << 30;

struct Line {
  FontId font;
  const char* text;
  int32_t size_q6;
  int32_t x_q6;
  int32_t y_q6;
  const Filter* filter;
  int32_t cosine_q30;
  int32_t sine_q30;
};

constexpr Line kLines[] = {
    {FontId::dejavu_sans_outline, "Inkcell 42 Inkcell 24", 8 * 64, 2 * 64,
     9 * 64, &kFilterText, kOne, 0},
    {FontId::dejavu_sans_outline, "Inkcell \xf0\x9d\x94\xb8 4224", 12 * 64 + 16,
     2 * 64 + 21, 25 * 64 + 7, &kFilterText, kOne, 0},
    {FontId::dejavu_serif_outline, "AVAQua & VAuQa", 16 * 64, 2 * 64 + 50,
     45 * 64, &kFilterPaperBody, kOne, 0},
    {FontId::roboto_outline, "Roboty Root", 24 * 64, 3 * 64, 72 * 64 + 33,
     &kFilterMotion, kOne, 0},
    {FontId::noto_sans_cjk_outline, "\xe6\xb0\xb8\xe5\xad\x97", 40 * 64 + 1,
     2 * 64, 113 * 64, &kFilterPaperDisplay, kOne, 0},
    {FontId::noto_sans_cjk_outline, "\xe5\xad\x97\xe6\xb0\xb8?", 20 * 64,
     90 * 64 + 9, 100 * 64 + 40, &kFilterText, kOne, 0},
    {FontId::noto_sans_cjk_outline, "\xe8\xbd\x9f", 24 * 64 + 32, 51 * 64 + 20,
     173 * 64, &kFilterPaperBody, kOne, 0},
    {FontId::dejavu_sans_field, "Again", 17 * 64, 98 * 64 + 40, 24 * 64 + 11,
     &kFilterText, kOne, 0},
    // Up and down the triangle of sides 3, 4 and 5.
    {FontId::dejavu_sans_outline, "Inkcell 24", 14 * 64, 6 * 64, 170 * 64,
     &kFilterText, 858993459, 644245094},
    {FontId::dejavu_serif_outline, "Quava&", 22 * 64, 84 * 64 + 32, 122 * 64,
     &kFilterPaperDisplay, 858993459, -644245094},
};

bool draw_line(const Line& line, const Sink& sink) {
  Font font;
  if (open_any_font(font_bytes(line.font), font) != Status::ok) {
    return false;
  }
  Direction direction;
  direction.cosine.raw = line.cosine_q30;
  direction.sine.raw = line.sine_q30;
  const Style style(Q26_6::from_raw(line.size_q6), *line.filter, direction);
  const Point origin = {Q26_6::from_raw(line.x_q6), Q26_6::from_raw(line.y_q6)};
  Painter(sink).text(font, style, origin, line.text);
  return true;
}

template <typename Canvas>
bool draw_lines(const Canvas& canvas) {
  if (canvas.status() != Status::ok) {
    return false;
  }
  for (const Line& line : kLines) {
    if (!draw_line(line, canvas)) {
      return false;
    }
  }
  return true;
}

bool draw_a8(const Strip& strip) {
  return draw_lines(A8Canvas(strip));
}

bool draw_grey8(const Strip& strip) {
  return draw_lines(Grey8Canvas(strip, 240));
}

template <BitOrder kOrder>
bool draw_grey4(const Strip& strip) {
  return draw_lines(Grey4Canvas(strip, 15, kOrder));
}

template <BitOrder kOrder>
bool draw_grey2(const Strip& strip) {
  return draw_lines(Grey2Canvas(strip, 3, kOrder));
}

template <BitOrder kOrder>
bool draw_mono_rows(const Strip& strip) {
  return draw_lines(MonoRowsCanvas(strip, 1, kOrder));
}

bool draw_mono_pages(const Strip& strip) {
  MonoPagesCanvas canvas(strip);
  canvas.set_threshold(100);
  return draw_lines(canvas);
}

template <ByteOrder kOrder>
bool draw_rgb565(const Strip& strip) {
  Strip ordered = strip;
  ordered.order = kOrder;
  return draw_lines(Rgb565Canvas(ordered, 0xfd88));
}

template <ChannelOrder kOrder>
bool draw_rgb888(const Strip& strip) {
  return draw_lines(Rgb888Canvas(strip, 0xffb040, kOrder));
}

bool draw_xrgb8888(const Strip& strip) {
  return draw_lines(Xrgb8888Canvas(strip, 0xff60c0ff));
}

bool draw_a8_styles(const Strip& strip) {
  const A8Canvas canvas(strip);
  return canvas.status() == Status::ok && draw_styles(canvas);
}

bool draw_a8_outlines(const Strip& strip) {
  const A8Canvas canvas(strip);
  return canvas.status() == Status::ok && draw_outlines(canvas);
}

bool draw_rgb888_sub_pixels(const Strip& strip) {
  Rgb888Canvas canvas(strip, 0xf0f0f0);
  set_sub_pixels(canvas);
  return canvas.status() == Status::ok && draw_sub_pixels(canvas);
}

struct DrawnPage {
  Page page;
  bool (*draw)(const Strip& strip);
};

constexpr DrawnPage kPages[kPageCount] = {
    {{"a8", PixelFormat::a8}, draw_a8},
    {{"grey8", PixelFormat::grey8}, draw_grey8},
    {{"grey4 high left", PixelFormat::grey4}, draw_grey4<BitOrder::high_left>},
    {{"grey4 low left", PixelFormat::grey4}, draw_grey4<BitOrder::low_left>},
    {{"grey2 high left", PixelFormat::grey2}, draw_grey2<BitOrder::high_left>},
    {{"grey2 low left", PixelFormat::grey2}, draw_grey2<BitOrder::low_left>},
    {{"mono rows high left", PixelFormat::mono_rows},
     draw_mono_rows<BitOrder::high_left>},
    {{"mono rows low left", PixelFormat::mono_rows},
     draw_mono_rows<BitOrder::low_left>},
    {{"mono pages", PixelFormat::mono_pages}, draw_mono_pages},
    {{"rgb565 low first", PixelFormat::rgb565},
     draw_rgb565<ByteOrder::low_first>},
    {{"rgb565 high first", PixelFormat::rgb565},
     draw_rgb565<ByteOrder::high_first>},
    {{"rgb888 red first", PixelFormat::rgb888},
     draw_rgb888<ChannelOrder::red_first>},
    {{"rgb888 blue first", PixelFormat::rgb888},
     draw_rgb888<ChannelOrder::blue_first>},
    {{"xrgb8888", PixelFormat::xrgb8888}, draw_xrgb8888},
    {{"a8 styles", PixelFormat::a8}, draw_a8_styles},
    {{"rgb888 sub-pixels", PixelFormat::rgb888}, draw_rgb888_sub_pixels},
    {{"a8 outlines", PixelFormat::a8}, draw_a8_outlines},
};

// What draw() of a loop needs to know.
struct Loop {
  const DrawnPage* page;
  TakeStrip take;
  void* context;
};

// Dark above, a half-tone below: 85 of 255 in every depth.
Status draw_strip(void* context, const Strip& strip) {
  const auto& loop = *static_cast<const Loop*>(context);
  const bool in_pages = loop.page->page.format == PixelFormat::mono_pages;
  const int32_t step = in_pages ? 8 : 1;
  uint8_t* at = strip.pixels.data;
  for (int32_t y = 0; y < strip.height; y += step) {
    for (int32_t i = 0; i < strip.stride; ++i) {
      *at++ = strip.y0 + y < 120 ? 0 : 0x55;
    }
  }
  return loop.page->draw(strip) ? Status::ok : Status::bad_argument;
}

Status take_strip(void* context, const Strip& strip) {
  const auto& loop = *static_cast<const Loop*>(context);
  loop.take(loop.context, strip);
  return Status::ok;
}

}  // namespace

const Page& page(int number) {
  return kPages[number].page;
}

bool draw_page(int number,
               int32_t rows,
               Span<uint8_t> buffer,
               TakeStrip take,
               void* context) {
  const PixelFormat format = page(number).format;
  if (rows <= 0 || rows % 8 != 0 ||
      buffer.size < page_buffer_bytes(format, rows)) {
    return false;
  }
  Loop loop = {&kPages[number], take, context};
  StripLoop strips;
  strips.buffer = {buffer.data, page_buffer_bytes(format, rows)};
  strips.format = format;
  strips.width = kPageWidth;
  strips.height = kPageHeight;
  strips.context = &loop;
  strips.draw = draw_strip;
  strips.display = &loop;
  strips.flush = take_strip;
  return run_strips(strips) == Status::ok;
}

}  // namespace golden
