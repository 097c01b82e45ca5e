// Text in colour, turned text, and a fitted paragraph in 1 bit: prints hashes
// of the pixels, which are the same on all machines.
#include <fonts/sans.hpp>
#include <inkcell/inkcell.hpp>
#include <inkcell/layout/text_box.hpp>
#include <inkcell/motion/numbers.hpp>
#include <inkcell/number_text.hpp>
#include <inkcell/port/mono_pages.hpp>

using namespace inkcell;

namespace {

#if __XTENSA__
extern "C" int sim_call(int call, int file, const char* bytes, size_t count);

void write(Text text) {
  sim_call(4, 1, text.data, text.size);
}
#else
extern "C" int printf(const char* format, ...);

void write(Text text) {
  printf("%.*s", static_cast<int>(text.size), text.data);
}
#endif

constexpr int32_t kWidth = 120;
constexpr int32_t kHeight = 64;
alignas(4) uint8_t colour[2 * kWidth * kHeight];
uint8_t pages[kWidth * kHeight / 8];

template <size_t kSize>
uint32_t hash_of(const uint8_t (&bytes)[kSize]) {
  uint32_t hash = 2166136261;
  for (const uint8_t byte : bytes) {
    hash = (hash ^ byte) * 16777619;
  }
  return hash;
}

Status draw() {
  Font font;
  INKCELL_TRY(Font::open(fonts::sans, font));
  Strip strip;
  strip.pixels = colour;
  strip.width = kWidth;
  strip.height = kHeight;
  strip.stride = 2 * kWidth;
  const port::Rgb565Canvas canvas(strip, 0xffff, 0x0013);
  const Painter painter(canvas);
  const Style upright(24_px);
  painter.text(font, upright, {4, 24}, "12:34 AVo");
  const Style upwards(15_px, kFilterText, {0, 1});  // right and up
  const motion::Angle slope = motion::from_degrees(30);
  const Style turned(15_px, kFilterText, motion::direction_of(slope));
  const Style leaning(Matrix{15, 0, 4, 15});  // narrow: {10, 0, 0, 15}
  painter.text(font, upwards, {20, 62}, "upwards");
  painter.text(font, turned, {28, 62}, "turned");
  painter.text(font, leaning, {64, 62}, "leaning");
  INKCELL_TRY(canvas.status());

  strip.pixels = pages;
  strip.stride = kWidth;
  const port::MonoPagesCanvas mono(strip, 1, 0);
  const Style small = port::MonoPagesCanvas::style(12_px);
  TextBox(font, small, {0, 0, kWidth, kHeight}, Align::centre)
      .draw("A paragraph that wraps, fitted to the grid.", mono);
  return mono.status();
}

}  // namespace

int main() {
  const Status status = draw();
  const uint32_t hashes[] = {hash_of(colour), hash_of(pages)};
  for (const uint32_t hash : hashes) {
    write(NumberText(static_cast<int32_t>(hash & 0x7fffffff)));
    write(" ");
  }
  return static_cast<int>(status);
}
