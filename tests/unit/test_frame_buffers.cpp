// Canvases over the memory of other libraries' pictures, against plain versions
// of how these libraries read a pixel; and the lines of docs/DISPLAY.md.
#include "check.hpp"
#include "display_page.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/port/gfx_canvas.hpp"
#include "inkcell/port/tft_sprite.hpp"
#include "inkcell/port/u8g2_buffer.hpp"
#include "pixels.hpp"

namespace {

using namespace inkcell;
using namespace inkcell::port;

constexpr int32_t kWidth = 133;
constexpr int32_t kHeight = 70;

// Coverage of the page, as 8-bit grey.
uint8_t grey_at(int32_t x, int32_t y) {
  static const Strip picture = display_page::reference(
      Grey8Canvas(), PixelFormat::grey8, kWidth, kHeight, 0);
  return picture.pixels[static_cast<size_t>(y * picture.stride + x)];
}

// Each pixel of the picture must be what `read(x, y)` finds.
template <typename Read, typename Expected>
void check_pixels(int32_t width,
                  int32_t height,
                  const Read& read,
                  const Expected& expected) {
  for (const auto [x, y] : pixels_of(width, height)) {
    CHECK_EQ(read(x, y), expected(grey_at(x, y)));
  }
}

bool is_drawn(uint8_t coverage) {
  return coverage >= 128;
}

// GFXcanvas1, and TFT_eSPI's sprite of 1 bit: rows of bytes, high bit left.
using MakeBits = MonoRowsCanvas (*)(uint8_t*, int32_t, int32_t);
void check_bits(MakeBits make) {
  constexpr int32_t kBytes = (kWidth + 7) / 8;
  static uint8_t buffer[kBytes * kHeight + 1];
  buffer[sizeof buffer - 1] = 0x5a;
  MonoRowsCanvas canvas = make(buffer, kWidth, kHeight);
  CHECK_EQ(canvas.strip().pixels.size, sizeof buffer - 1);
  canvas.levels = nullptr;  // text as on other canvases
  display_page::draw_page(canvas, 0);
  check_pixels(
      kWidth, kHeight,
      [](int32_t x, int32_t y) {
        return (buffer[x / 8 + y * kBytes] & (0x80 >> (x & 7))) != 0;
      },
      is_drawn);
  CHECK_EQ(buffer[sizeof buffer - 1], 0x5a);
}

TEST(gfx_canvas1_is_drawn_on) {
  check_bits([](uint8_t* buffer, int32_t width, int32_t height) {
    return gfx_canvas1(buffer, width, height);
  });
}

TEST(tft_sprites_of_1_bit_are_drawn_on) {
  check_bits([](uint8_t* buffer, int32_t width, int32_t height) {
    return tft_sprite1(buffer, width, height);
  });
}

TEST(gfx_canvas8_is_drawn_on) {
  static uint8_t buffer[kWidth * kHeight];
  display_page::draw_page(gfx_canvas8(buffer, kWidth, kHeight), 0);
  check_pixels(
      kWidth, kHeight,
      [](int32_t x, int32_t y) { return buffer[x + y * kWidth]; },
      [](uint8_t coverage) { return coverage; });
}

// What an Rgb565Canvas makes of white over black: rgb565.hpp says how far from
// exact, so that only its two ends and its order are compared.
template <typename Read>
void check_white(const Read& read) {
  int32_t middle = 0;
  for (const auto [x, y] : pixels_of(kWidth, kHeight)) {
    const int32_t pixel = read(x, y);
    const uint8_t coverage = grey_at(x, y);
    if (coverage == 0 || coverage == 255) {
      CHECK_EQ(pixel, coverage == 0 ? 0 : 0xffff);
    } else {
      // Red, green and blue are within a level of each other, on 32 levels.
      const int32_t red = pixel >> 11;
      const int32_t green = pixel >> 6 & 31;
      const int32_t blue = pixel & 31;
      CHECK(red - green <= 1 && green - red <= 1 && red == blue);
      CHECK(8 * red - coverage <= 16 && coverage - 8 * red <= 16);
      ++middle;
    }
  }
  CHECK(middle > 100);
}

TEST(gfx_canvas16_is_drawn_on) {
  static uint16_t buffer[kWidth * kHeight];
  display_page::draw_page(gfx_canvas16(buffer, kWidth, kHeight), 0);
  check_white([](int32_t x, int32_t y) { return buffer[x + y * kWidth]; });
}

// TFT_eSPI keeps the bytes as the display takes them.
TEST(tft_sprites_of_16_bits_are_drawn_on) {
  static uint16_t buffer[kWidth * kHeight];
  display_page::draw_page(tft_sprite16(buffer, kWidth, kHeight), 0);
  check_white([](int32_t x, int32_t y) {
    const auto bytes =
        reinterpret_cast<const uint8_t*>(buffer + x + y * kWidth);
    return bytes[0] << 8 | bytes[1];
  });
}

// U8g2: tiles of 8 x 8, a byte for a column of a tile.
TEST(u8g2_buffers_are_drawn_on) {
  constexpr int32_t kTiles = 16;
  static uint8_t buffer[8 * kTiles * 8];
  const auto canvas_of = [](uint8_t* bytes, auto... where) {
    MonoPagesCanvas canvas = u8g2_buffer(bytes, kTiles, where...);
    canvas.levels = nullptr;  // text as on other canvases
    return canvas;
  };
  display_page::draw_page(canvas_of(buffer, 8), 0);
  check_pixels(
      8 * kTiles, 64,
      [](int32_t x, int32_t y) {
        return (buffer[x + y / 8 * 8 * kTiles] >> (y & 7) & 1) != 0;
      },
      is_drawn);
  // One page after the other, as firstPage() and nextPage() go.
  for (int32_t row = 0; row < 8; row += 2) {
    static uint8_t page[2 * 8 * kTiles];
    display_page::draw_page(canvas_of(page, 2, row), 0);
    for (size_t i = 0; i < sizeof page && !check::failed(); ++i) {
      CHECK_EQ(page[i], buffer[static_cast<size_t>(row * 8 * kTiles) + i]);
    }
  }
}

// Stand-ins for the functions of those libraries that docs/DISPLAY.md names.
struct GFXcanvas16 {
  static constexpr int32_t kSide = 40;
  uint16_t pixels[kSide * kSide] = {};
  uint16_t* getBuffer() { return pixels; }
  int16_t width() const { return kSide; }
  int16_t height() const { return kSide; }
};

Status draw_on_canvas(GFXcanvas16& canvas,
                      const Font& font,
                      const Style& style) {
  const port::Rgb565Canvas paper =
      port::gfx_canvas16(canvas.getBuffer(), canvas.width(), canvas.height(),
                         port::rgb565(255, 200, 0));
  Painter(paper).text(font, style, {4, 28}, "ABC");
  return paper.status();
}

TEST(a_canvas_takes_text) {
  uint8_t rom[outline_record::kSampleFontBytes];
  Font font;
  CHECK_OK(Font::open({rom, outline_record::build_sample_font(rom)}, font));
  Style style(24_px, kFilterArea);
  GFXcanvas16 canvas;
  CHECK_OK(draw_on_canvas(canvas, font, style));
  int32_t full = 0;
  for (const uint16_t pixel : canvas.pixels) {
    full += pixel == rgb565(255, 200, 0) ? 1 : 0;
  }
  CHECK(full > 100);
}

}  // namespace
