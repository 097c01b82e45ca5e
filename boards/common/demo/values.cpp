// Two values that change, on a colour and on a picture: the scene's frame is
// the number, in tenths. Each change draws and sends the pixels of the old
// value and of the new one, or the whole screen where INKCELL_VALUES_AT_ONCE
// says so: the pictures are equal.
#include <fonts/motion.hpp>

#include "canvas.hpp"
#include "display.hpp"
#include "inkcell/font.hpp"
#include "inkcell/number_text.hpp"
#include "inkcell/port/strip_loop.hpp"
#include "inkcell/value_label.hpp"
#include "motion.hpp"
#if !INKCELL_VALUES_AT_ONCE
#  include "board.hpp"
#endif

namespace inkcell::demo {
inline namespace INKCELL_DEMO_NAME {
namespace {

using Plain = detail::Paint<kFormat>::Canvas;  // of no strip
constexpr int32_t kFirst = 215;
constexpr Style kStyle = Style(kHeight >= 200  ? 48_px
                               : kHeight >= 64 ? 24_px
                                               : 12_px);
constexpr int32_t kBaseline = kHeight * 3 / 4;
constexpr int32_t kMiddle = kWidth / 2;

alignas(
    4) uint8_t buffer[port::strip_bytes(kFormat, kWidth, INKCELL_DEMO_ROWS)];
Font font;

struct Values {
  ValueLabel on_colour = {
      font, kStyle, {kMiddle - 4, kBaseline}, Anchor::right};
  ValueLabel on_picture = {
      font, kStyle, {kWidth - 4, kBaseline}, Anchor::right};
  size_t bytes_sent = 0;
} values;

// A picture in the right half of the screen.
void paint_picture(const Sink& sink, const Rect& strip) noexcept {
  const Rect rect = intersect(strip, {kMiddle, 0, kWidth, kHeight});
  for (int32_t y = rect.y0; y < rect.y1; ++y) {
    for (int32_t x = rect.x0; x < rect.x1; ++x) {
      const auto coverage = static_cast<uint8_t>((x * 3 + y * 5) & 255);
      sink.coverage(sink.context, x, y, &coverage, 1);
    }
  }
}

// The background first, then the values.
Status draw(void* context, const Strip& strip) {
  const Values& shown = *static_cast<const Values*>(context);
  Canvas canvas(strip);  // filled with a colour
  paint_picture(canvas.sink(Ink::moving), strip.rect());
  shown.on_colour.draw(canvas.sink(Ink::clock));
  shown.on_picture.draw(canvas.sink(Ink::text));
  return Status::ok;
}

Status send(void* display, const Strip& strip) {
  static_cast<Values*>(display)->bytes_sent += strip.pixels.size;
  return board::display_write(strip);
}

port::StripLoop make_loop() noexcept {
  port::StripLoop loop;
  loop.buffer = buffer;
  loop.format = kFormat;
  loop.width = kWidth;
  loop.height = kHeight;
  loop.context = loop.display = &values;
  loop.draw = draw;
  loop.flush = send;
  return loop;
}

// Sends what changes, and nothing else.
Status show_number(const port::StripLoop& loop, int32_t tenths) noexcept {
  const NumberText number(tenths, 1);
  INKCELL_TRY(run_strips(loop, values.on_colour.set(number, Plain())));
  return run_strips(loop, values.on_picture.set(number, Plain()));
}

}  // namespace

Status open_motion() noexcept {
  INKCELL_TRY(Font::open(fonts::motion, font));
  const NumberText number(kFirst, 1);
  values.on_colour.set(number, Plain());
  values.on_picture.set(number, Plain());
  return run_strips(make_loop());
}

void show_motion(uint32_t frame) noexcept {
  values.bytes_sent = 0;
  static_cast<void>(show_number(make_loop(), static_cast<int32_t>(frame)));
#if INKCELL_VALUES_AT_ONCE
  static_cast<void>(run_strips(make_loop()));
#else
  board::print_decimal(static_cast<uint32_t>(values.bytes_sent));
  board::print(" bytes sent, a screen has ");
  board::print_decimal(
      static_cast<uint32_t>(port::strip_bytes(kFormat, kWidth, kHeight)));
  board::print("\n");
#endif
}

}  // namespace INKCELL_DEMO_NAME
}  // namespace inkcell::demo
