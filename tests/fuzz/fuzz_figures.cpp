// Figures from a fuzzer: any points, pens, windows, canvases and RAM. Nothing
// may be drawn outside of the window or of what the boxes say, no pixel twice,
// and the picture is the same in strips, in parts and with any RAM; rectangles
// are those of a plain twin.
//
// An input is numbers, in the order in which they are asked for. Beyond its end
// they are 0.
#include "inkcell/figures/figures.hpp"

#include <algorithm>
#include <memory>
#include <vector>

#include "front_ends.hpp"
#include "inkcell/port/grey2.hpp"
#include "inkcell/port/grey4.hpp"
#include "inkcell/port/grey8.hpp"
#include "inkcell/port/mono_pages.hpp"
#include "inkcell/port/mono_rows.hpp"
#include "inkcell/port/pixel.hpp"
#include "inkcell/port/rgb565.hpp"
#include "moving_input.hpp"

namespace {

using namespace inkcell;
using namespace inkcell::figures;
using hostile::require;
using moving_input::Choices;

constexpr size_t kMostPoints = 40;

struct Drawing {
  Point points[kMostPoints];
  Figure figure;
  Pen pen;
  bool is_stroked = false;

  void draw(const Painter& painter) const {
    if (is_stroked) {
      stroke(painter, figure, pen);
    } else {
      fill(painter, figure);
    }
  }
  Rect box() const {
    return is_stroked ? stroke_box(figure, pen) : fill_box(figure);
  }
};

// Near the first point by turns, so that figures are in the window.
Point point_of(Choices& choices, const Point& first) {
  if (choices.byte() % 4 == 0) {
    return choices.point();
  }
  const int32_t x = choices.i16() / 8;
  const int32_t y = choices.i16() / 8;
  const auto moved = [](Q26_6 from, int32_t by) {
    return Q26_6::from_raw(static_cast<int32_t>(
        static_cast<uint32_t>(from.raw) + static_cast<uint32_t>(by)));
  };
  return {moved(first.x, x), moved(first.y, y)};
}

void take(Choices& choices, Drawing& drawing) {
  const uint32_t kind = choices.byte() % 5;
  const size_t count = choices.byte() % (kMostPoints + 1);
  Point* const points = drawing.points;
  points[0] = point_of(choices, {});
  for (size_t i = 1; i < std::max<size_t>(count, 2); ++i) {
    points[i] = point_of(choices, points[0]);
  }
  const Q26_6 radius = choices.q6();
  switch (kind) {
    case 0:
      drawing.figure = rounded_rectangle(points[0], points[1], radius);
      break;
    case 1: {
      const auto from = motion::Angle::from_raw(choices.u16());
      drawing.figure = arc(points[0], radius, from, choices.q16());
      break;
    }
    case 2:
      drawing.figure = line(points[0], points[1]);
      break;
    case 3:
      drawing.figure = polygon({points, count});
      break;
    default:
      drawing.figure = polyline({points, count});
  }
  drawing.is_stroked = choices.byte() % 2 != 0;
  drawing.pen.width = choices.q6();
  drawing.pen.cap = static_cast<Cap>(choices.byte() % 3);
  drawing.pen.join = static_cast<Join>(choices.byte() % 2);
}

// A picture that knows its window, and which pixels were drawn.
struct Paper {
  explicit Paper(const Rect& rect)
      : all(rect),
        pixels(static_cast<size_t>((rect.x1 - rect.x0) * (rect.y1 - rect.y0)),
               -1) {}

  Sink sink(const Rect& part) {
    window = intersect(part, all);
    Sink sink;
    sink.window = window;
    sink.context = this;
    sink.coverage = [](void* context, int32_t x, int32_t y,
                       const uint8_t* values, int32_t count) {
      require(count <= kMaxSpan, "spans are short");
      static_cast<Paper*>(context)->put(x, y, values, count);
    };
    sink.solid = [](void* context, int32_t x, int32_t y, int32_t count) {
      static_cast<Paper*>(context)->put(x, y, nullptr, count);
    };
    return sink;
  }
  int32_t at(int32_t x, int32_t y) const {
    return std::max(0, pixels[place(x, y)]);
  }

  Rect all;
  Rect window;
  std::vector<int32_t> pixels;  // -1: not drawn

 private:
  size_t place(int32_t x, int32_t y) const {
    return static_cast<size_t>((y - all.y0) * (all.x1 - all.x0) + x - all.x0);
  }
  void put(int32_t x, int32_t y, const uint8_t* values, int32_t count) {
    require(count >= 1 && x >= window.x0 && x <= window.x1 - count &&
                y >= window.y0 && y < window.y1,
            "pixels are in the window");
    for (int32_t i = 0; i != count; ++i) {
      int32_t& pixel = pixels[place(x + i, y)];
      require(pixel < 0, "pixels are drawn once");
      pixel = values == nullptr ? 255 : values[i];
    }
  }
};

template <typename Work>
void for_pixels(const Rect& rect, const Work& work) {
  for (int32_t y = rect.y0; y < rect.y1; ++y) {
    for (int32_t x = rect.x0; x < rect.x1; ++x) {
      work(x, y);
    }
  }
}

// What a filled rectangle without a radius covers of a pixel, to 1/4096.
int32_t covered(const Figure& figure, int32_t x, int32_t y) {
  const auto part = [](Q26_6 a, Q26_6 b, int32_t pixel) {
    constexpr int32_t kReach = 2047 * 64;
    const int64_t origin = a.raw & ~63;
    const int64_t away = static_cast<int32_t>(static_cast<uint32_t>(b.raw) -
                                              static_cast<uint32_t>(origin));
    const int64_t other = origin + std::clamp<int64_t>(away, -kReach, kReach);
    const int64_t low = std::min<int64_t>(a.raw, other);
    const int64_t high = std::max<int64_t>(a.raw, other);
    return std::max<int64_t>(0, std::min<int64_t>(high, pixel * 64 + 64) -
                                    std::max<int64_t>(low, pixel * 64));
  };
  return static_cast<int32_t>(part(figure.ends[0].x, figure.ends[1].x, x) *
                              part(figure.ends[0].y, figure.ends[1].y, y));
}

// RAM and pixels in blocks of their size, which a sanitizer watches.
Workspace lend(Choices& choices, std::unique_ptr<uint32_t[]>& block) {
  const size_t words = choices.u16() % 700;
  block = std::make_unique<uint32_t[]>(words);
  return {reinterpret_cast<uint8_t*>(block.get()), 4 * words};
}

template <typename Canvas, typename... Ink>
std::vector<uint8_t> draw_on(port::PixelFormat format,
                             const Drawing& drawing,
                             const Rect& rect,
                             const Workspace& ram,
                             Ink... ink) {
  const int32_t width = rect.x1 - rect.x0;
  const int32_t height = rect.y1 - rect.y0;
  std::vector<uint8_t> pixels(port::strip_bytes(format, width, height));
  const int32_t stride = port::stride_bytes(format, width);
  drawing.draw(Painter(Canvas(Strip{{pixels.data(), pixels.size()},
                                    rect.x0,
                                    rect.y0,
                                    width,
                                    height,
                                    stride},
                              ink...),
                       ram));
  return pixels;
}

void draw_on_canvas(uint32_t kind,
                    const Drawing& drawing,
                    const Rect& rect,
                    const Workspace& ram,
                    const Paper& paper) {
  using port::PixelFormat;
  switch (kind) {
    case 0: {
      const auto pixels =
          draw_on<port::Grey8Canvas>(PixelFormat::grey8, drawing, rect, ram);
      size_t at = 0;
      for_pixels(rect, [&](int32_t x, int32_t y) {
        require(pixels[at++] == paper.at(x, y), "coverage is white on black");
      });
      break;
    }
    case 1:
      draw_on<port::Rgb565Canvas>(PixelFormat::rgb565, drawing, rect, ram,
                                  uint16_t{0xfc1f});
      break;
    case 2:
      draw_on<port::Grey4Canvas>(PixelFormat::grey4, drawing, rect, ram);
      break;
    case 3:
      draw_on<port::Grey2Canvas>(PixelFormat::grey2, drawing, rect, ram);
      break;
    case 4:
      draw_on<port::MonoRowsCanvas>(PixelFormat::mono_rows, drawing, rect, ram);
      break;
    default:
      draw_on<port::MonoPagesCanvas>(PixelFormat::mono_pages, drawing, rect,
                                     ram);
  }
}

}  // namespace

void run(const uint8_t* data, size_t size) {
  Choices choices({data, size});
  Drawing drawing;
  take(choices, drawing);
  const Point& first = drawing.figure.ends[0];
  const int32_t left = choices.byte() - 128;
  const int32_t top = choices.byte() - 128;
  const auto near = [](Q26_6 at, int32_t by) {
    return std::clamp(at.floor() + by, -32767, 32000);
  };
  Rect all = {near(first.x, left / 4), near(first.y, top / 4), 0, 0};
  all.x1 = all.x0 + 1 + choices.byte() % 160;
  all.y1 = all.y0 + 1 + choices.byte() % 40;

  Paper paper(all);
  drawing.draw(paper.sink(all));
  const Rect box = drawing.box();
  const bool is_plain = drawing.figure.trace == &detail::trace_box &&
                        drawing.figure.radius.raw <= 0 && !drawing.is_stroked;
  for_pixels(all, [&](int32_t x, int32_t y) {
    const int32_t value = paper.at(x, y);
    require(
        value == 0 || (x >= box.x0 && x < box.x1 && y >= box.y0 && y < box.y1),
        "pixels are in the box");
    require(!is_plain || std::abs(value * 4096 - covered(drawing.figure, x, y) *
                                                     255) <= 2 * 4096,
            "rectangles cover what they hold");
  });

  std::unique_ptr<uint32_t[]> block;
  const Workspace ram = lend(choices, block);
  const int32_t rows = 1 + choices.byte() % 16;
  const int32_t column = all.x0 + choices.byte();
  Paper parts(all);
  for (int32_t y = all.y0; y < all.y1; y += rows) {
    drawing.draw(Painter(parts.sink({all.x0, y, column, y + rows}), ram));
    drawing.draw(Painter(parts.sink({column, y, all.x1, y + rows}), ram));
  }
  Rect clip = {all.x0 + choices.byte() % 40, all.y0 + choices.byte() % 20, 0,
               0};
  clip.x1 = clip.x0 + choices.byte() % 80;
  clip.y1 = clip.y0 + choices.byte() % 20;
  Paper clipped(all);
  drawing.draw(Painter(clipped.sink(clip), ram));
  for_pixels(all, [&](int32_t x, int32_t y) {
    require(parts.at(x, y) == paper.at(x, y), "parts are the whole");
    const bool is_seen =
        x >= clip.x0 && x < clip.x1 && y >= clip.y0 && y < clip.y1;
    require(clipped.at(x, y) == (is_seen ? paper.at(x, y) : 0),
            "a clip changes nothing within");
  });
  draw_on_canvas(choices.byte() % 6, drawing, all, ram, paper);
}
