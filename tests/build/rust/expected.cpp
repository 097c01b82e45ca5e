// Draws what src/main.rs draws, by the library itself.
//
// Usage: expected FONT FILE
#include <algorithm>
#include <fstream>
#include <iterator>
#include <vector>

#include "inkcell/cache/glyph_cache.hpp"
#include "inkcell/few_levels.hpp"
#include "inkcell/fit.hpp"
#include "inkcell/layout/label.hpp"
#include "inkcell/layout/text_box.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/port/a8.hpp"
#include "inkcell/port/grey2.hpp"
#include "inkcell/port/grey4.hpp"
#include "inkcell/port/grey8.hpp"
#include "inkcell/port/mono_pages.hpp"
#include "inkcell/port/mono_rows.hpp"
#include "inkcell/port/rgb565.hpp"
#include "inkcell/port/rgb888.hpp"
#include "inkcell/port/xrgb8888.hpp"

using namespace inkcell;
using namespace inkcell::port;

namespace {

using Bytes = std::vector<uint8_t>;

Bytes all;

Strip strip_of(Bytes& bytes,
               PixelFormat format,
               int32_t width,
               int32_t height) {
  Strip strip;
  strip.width = width;
  strip.height = height;
  strip.stride = stride_bytes(format, width);
  if (bytes.empty()) {
    bytes.resize(strip_bytes(format, width, height));
  }
  strip.pixels = {bytes.data(), bytes.size()};
  return strip;
}

void put(const Bytes& bytes) {
  all.insert(all.end(), bytes.begin(), bytes.end());
}

Point at(int32_t x, int32_t y) {
  return {Q26_6::from_int(x), Q26_6::from_int(y)};
}

void label(const Font& font) {
  const Style style(12_px, kFilterText);
  Bytes bytes;
  const MonoPagesCanvas canvas(
      strip_of(bytes, PixelFormat::mono_pages, 96, 16));
  const Painter painter(canvas);
  const Text text = "23.5 \u00b0C";
  Point origin = at(0, 12);
  origin.x.raw = (96 * 64 - painter.measure(font, style, text).advance.raw) / 2;
  painter.text(font, style, origin, text);
  put(bytes);
}

void clock(const Font& font) {
  const Style style(30_px);
  alignas(8) static uint8_t ram[2048];
  GlyphCache cache;
  if (GlyphCache::make({ram, sizeof ram}, {}, cache) != Status::ok) {
    return;
  }
  for (int32_t y = 0; y < 40; y += 8) {
    Bytes bytes;
    Strip strip = strip_of(bytes, PixelFormat::rgb565, 120, 8);
    strip.y0 = y;
    const Rgb565Canvas canvas(strip, 0xfe40);
    Painter(canvas, {}, &cache).text(font, style, at(4, 32), "12:34");
    put(bytes);
  }
}

void paragraph(const Font& font) {
  const Style style(14_px, kFilterText);
  Bytes bytes;
  const Grey8Canvas canvas(strip_of(bytes, PixelFormat::grey8, 80, 64), 255);
  TextBox box(font, style, {4, 4, 76, 60}, Align::centre);
  box.options.ellipsis = Ellipsis::end;
  box.vertical = VerticalAlign::middle;
  box.draw("A paragraph that has more words than there is room for",
           Painter(canvas));
  put(bytes);
}

void take(void* context,
          int32_t x,
          int32_t y,
          const uint8_t* coverage,
          int32_t count) noexcept {
  uint8_t* const pixel = static_cast<uint8_t*>(context) + y * 64 + x;
  for (int32_t i = 0; i < count; ++i) {
    pixel[i] = std::max(pixel[i], coverage[i]);
  }
}

void solid(void* context, int32_t x, int32_t y, int32_t count) noexcept {
  std::fill_n(static_cast<uint8_t*>(context) + y * 64 + x, count, uint8_t{255});
}

void plot(const Font& font) {
  Bytes bytes(64 * 24);
  Sink sink;
  sink.window = {0, 0, 64, 24};
  sink.context = bytes.data();
  sink.coverage = take;
  sink.solid = solid;
  const Style style(16_px, kFilterText,
                    {Fixed<int32_t, 30>::from_raw(1053110176),
                     Fixed<int32_t, 30>::from_raw(209476638)});
  Painter(sink).text(font, style, {2_px, 20.5_px}, "Plot 7");
  put(bytes);
}

template <typename Canvas, typename... Ink>
void format(PixelFormat format,
            const Font& font,
            const Style& style,
            Ink... ink) {
  Bytes bytes;
  Strip strip = strip_of(bytes, format, 60, 24);
  strip.x0 = -2;
  const Canvas canvas(strip, ink...);
  Painter(canvas).text(font, style, at(0, 18), "Weight");
  put(bytes);
}

void formats(const Font& font) {
  const Filter filter = with_weight(kFilterText, Q6_10::from_raw(256));
  Style style(18_px, filter);
  Fit fit;
  FitOptions options;
  options.across = true;
  if (Fit::make(font, style, options, fit) != Status::ok) {
    return;
  }
  style.set_fit(fit);
  using F = PixelFormat;
  format<A8Canvas>(F::a8, font, style);
  format<Grey8Canvas>(F::grey8, font, style, uint8_t{200});
  format<Grey4Canvas>(F::grey4, font, style, uint8_t{15}, BitOrder::low_left);
  format<Grey2Canvas>(F::grey2, font, style, uint8_t{3}, BitOrder::high_left);
  format<MonoRowsCanvas>(F::mono_rows, font, style, uint8_t{1});
  format<MonoPagesCanvas>(F::mono_pages, font, style, uint8_t{1});
  format<Rgb565Canvas>(F::rgb565, font, style, uint16_t{0xfe40});
  format<Rgb888Canvas>(F::rgb888, font, style, uint32_t{0x123456});
  format<Xrgb8888Canvas>(F::xrgb8888, font, style, uint32_t{0x123456});
}

// 96 x 56 px, each of them `background`.
template <typename Canvas, typename... Ink>
Bytes over(PixelFormat format,
           const Bytes& background,
           const Font& font,
           const Style& style,
           Point origin,
           std::initializer_list<Text> lines,
           Ink... ink) {
  Bytes bytes;
  while (bytes.size() < 96 * 56 * background.size()) {
    bytes.insert(bytes.end(), background.begin(), background.end());
  }
  const Canvas canvas(strip_of(bytes, format, 96, 56), ink...);
  for (const Text& line : lines) {
    Painter(canvas).text(font, style, origin, line);
    origin.y.raw += (line_height({font, style}).raw + 32) & ~63;
  }
  return bytes;
}

void graphics(const Font& font) {
  using F = PixelFormat;
  const Style small(20_px);
  put(over<Rgb565Canvas>(F::rgb565, {0, 0}, font, small, at(4, 25),
                         {"Hello,", "Rust!"}, uint16_t{0xffff}));
  const Style style(30_px);
  constexpr uint16_t kInk = 31 << 11 | 50 << 5;
  constexpr uint16_t kNavy = 1 << 11 | 2 << 5 | 12;
  constexpr uint16_t kGreen = 20 << 11 | 40 << 5 | 20;
  put(over<Rgb565Canvas>(F::rgb565, {kNavy & 255, kNavy >> 8}, font, style,
                         at(-3, 41), {"Wave 0"}, kInk));
  // A line that begins at (8, 4), with its background; its ink stays inside.
  const int32_t top = 4;
  const int32_t baseline_q6 = baseline({font, style}).raw + 32;
  Bytes bytes =
      over<Rgb565Canvas>(F::rgb565, {kNavy & 255, kNavy >> 8}, font, style,
                         at(8, top + (baseline_q6 >> 6)), {"Line"}, kInk);
  const int32_t right =
      8 + ((Painter().measure(font, style, "Line").advance.raw + 32) >> 6);
  const int32_t bottom = top + ((line_height({font, style}).raw + 32) >> 6);
  for (int32_t y = 0; y < 56; ++y) {
    for (int32_t x = 0; x < 96; ++x) {
      if (x < 8 || x >= right || y < top || y >= bottom) {
        bytes[static_cast<size_t>(2 * (96 * y + x))] = kGreen & 255;
        bytes[static_cast<size_t>(2 * (96 * y + x) + 1)] = kGreen >> 8;
      }
    }
  }
  put(bytes);
  put(over<Grey8Canvas>(F::grey8, {30}, font, style, at(2, 41), {"Grey"},
                        uint8_t{220}));
  put(over<Rgb888Canvas>(F::rgb888, {0, 20, 40}, font, style, at(2, 41),
                         {"Rgb"}, uint32_t{0xfa6303}));
  const Style mono(14_px, kFilterText);
  Bytes bits;
  const MonoRowsCanvas canvas(strip_of(bits, F::mono_rows, 96, 56));
  Painter(canvas).text(font, mono, at(2, 31), "1 bit: in");
  for (size_t i = 0; i < 96 * 56; ++i) {
    all.push_back(bits[i / 8] >> (7 - i % 8) & 1);
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    return 2;
  }
  std::ifstream file(argv[1], std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
  std::vector<uint32_t> rom(bytes.size() / 4 + 1);
  std::copy(bytes.begin(), bytes.end(), reinterpret_cast<char*>(rom.data()));
  Font font;
  if (Font::open({reinterpret_cast<const uint8_t*>(rom.data()), bytes.size()},
                 font) != Status::ok) {
    return 1;
  }
  label(font);
  clock(font);
  paragraph(font);
  plot(font);
  formats(font);
  graphics(font);
  std::ofstream(argv[2], std::ios::binary)
      .write(reinterpret_cast<const char*>(all.data()),
             static_cast<std::streamsize>(all.size()));
}
