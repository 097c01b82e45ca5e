// Canvases and Painter, as programs in C++ have them.
#include "canvases.h"

#include "inkcell/painter.hpp"
#include "inkcell/port/a8.hpp"
#include "inkcell/port/grey2.hpp"
#include "inkcell/port/grey4.hpp"
#include "inkcell/port/grey8.hpp"
#include "inkcell/port/mono_pages.hpp"
#include "inkcell/port/mono_rows.hpp"
#include "inkcell/port/pixel.hpp"
#include "inkcell/port/rgb565.hpp"
#include "inkcell/port/rgb888.hpp"
#include "inkcell/port/xrgb8888.hpp"

using namespace inkcell;
using namespace inkcell::port;

namespace {

Font font;
Style style(kMinSize);
const Sink* sink = nullptr;

Strip strip_of(PixelFormat format, uint8_t* pixels) {
  Strip strip;
  strip.pixels = {pixels, kCanvasWidth * kCanvasHeight * kCanvasMostBytes};
  strip.width = kCanvasWidth;
  strip.height = kCanvasHeight;
  strip.stride = static_cast<int32_t>(stride_bytes(format, kCanvasWidth));
  return strip;
}

template <typename AnyCanvas>
void open(PixelFormat format, uint8_t* pixels) {
  static AnyCanvas canvas;
  canvas.set_strip(strip_of(format, pixels));
  sink = &canvas;
}

struct Kind {
  const char* name;
  PixelFormat format;
  void (*open)(PixelFormat format, uint8_t* pixels);
};

constexpr Kind kKinds[] = {
    {"a8", PixelFormat::a8, open<A8Canvas>},
    {"grey8", PixelFormat::grey8, open<Grey8Canvas>},
    {"grey4", PixelFormat::grey4, open<Grey4Canvas>},
    {"grey2", PixelFormat::grey2, open<Grey2Canvas>},
    {"mono_rows", PixelFormat::mono_rows, open<MonoRowsCanvas>},
    {"mono_pages", PixelFormat::mono_pages, open<MonoPagesCanvas>},
    {"rgb565", PixelFormat::rgb565, open<Rgb565Canvas>},
    {"rgb888", PixelFormat::rgb888, open<Rgb888Canvas>},
    {"xrgb8888", PixelFormat::xrgb8888, open<Xrgb8888Canvas>},
};

}  // namespace

bool canvas_open_font(const uint8_t* bytes, size_t size) {
  return Font::open({bytes, size}, font) == Status::ok;
}

const char* canvas_set(uint32_t number, uint8_t* pixels) {
  if (number >= sizeof kKinds / sizeof kKinds[0]) {
    return nullptr;
  }
  const Kind& kind = kKinds[number];
  kind.open(kind.format, pixels);
  return kind.name;
}

bool canvas_set_size(int32_t px) {
  style = Style(Q26_6::from_int(px));
  return font.check(style) == Status::ok;
}

void canvas_draw(const char* text, uint8_t* ram, size_t bytes) {
  const Point origin = {Q26_6::from_int(4), Q26_6::from_int(96)};
  Painter(*sink, Workspace(ram, bytes)).text(font, style, origin, text);
}
