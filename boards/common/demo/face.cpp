#include "face.hpp"

#include "display.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/text.hpp"

namespace inkcell::demo {
inline namespace INKCELL_DEMO_NAME {
namespace {

struct Line {
  Style style;
  int32_t baseline;  // [px]
  const char* text;
};

constexpr Line kLines[] = {
    {Style(20_px), 18, "AVATAR Tea"},
    {Style(14_px), 33, u8"Grüße, señor, été"},
    {Style(11_px), 46, "The quick brown fox"},
    {Style(9_px), 58, "jumps over 12 lazy dogs"},
};

alignas(4) uint8_t pixels[port::strip_bytes(kFormat, kWidth, kHeight)];

}  // namespace

Status show_face(const Font& font) noexcept {
  const Strip strip = {{pixels, sizeof pixels},
                       0,
                       0,
                       kWidth,
                       kHeight,
                       port::stride_bytes(kFormat, kWidth)};
  Canvas canvas(strip);
  const Painter painter(canvas.sink(Ink::text));
  for (const Line& line : kLines) {
    painter.text(font, line.style, {2_px, Q26_6::from_int(line.baseline)},
                 line.text);
  }
  return board::display_write(strip);
}

}  // namespace INKCELL_DEMO_NAME
}  // namespace inkcell::demo
