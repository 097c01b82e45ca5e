// Text through the sink of a display into its memory, and back to colours.
#include <cmath>
#include <stdexcept>

#include "canvas.hpp"
#include "editor/preview.hpp"
#include "inkcell/port/grey2.hpp"
#include "inkcell/port/grey4.hpp"
#include "inkcell/port/lcd.hpp"
#include "inkcell/port/mono_rows.hpp"
#include "inkcell/port/rgb565.hpp"
#include "look.hpp"
#include "rom_file.hpp"

namespace inkcell::design::editor {
namespace {

constexpr int kMargin = 2;  // around the ink, as inkcell-render leaves [px]

port::PixelFormat format_of(Display display) {
  switch (display) {
    case Display::mono:
      return port::PixelFormat::mono_rows;
    case Display::grey2:
      return port::PixelFormat::grey2;
    case Display::grey4:
      return port::PixelFormat::grey4;
    case Display::rgb565:
      return port::PixelFormat::rgb565;
    default:
      return port::PixelFormat::rgb888;
  }
}

tools::LookOptions look_of(Display display) {
  tools::LookOptions look;
  look.levels = display == Display::mono    ? 2
                : display == Display::grey2 ? 4
                                            : 256;
  look.lcd = display == Display::lcd ? "rgb" : "none";
  return look;
}

// The memory of a display, all of it one strip.
class Screen {
 public:
  Screen(Display display, bool dark, int width, int height)
      : format_(format_of(display)), ink_(dark ? 255 : 0) {
    strip_.width = width;
    strip_.height = height;
    strip_.stride = port::stride_bytes(format_, width);
    bytes_.assign(port::strip_bytes(format_, width, height),
                  static_cast<uint8_t>(255 - ink_));
    strip_.pixels = {bytes_.data(), bytes_.size()};
  }

  // The result writes into this object.
  Sink sink() {
    Sink sink;
    if (make(sink) != Status::ok) {
      throw std::runtime_error("the preview is too large for a display");
    }
    return sink;
  }

  tools::Image picture() const {
    tools::Image image(strip_.width, strip_.height, 3);
    for (int y = 0; y < strip_.height; ++y) {
      for (int x = 0; x < strip_.width; ++x) {
        pixel(x, y, image.at(x, y));
      }
    }
    return image;
  }

 private:
  Status make(Sink& sink) {
    switch (format_) {
      case port::PixelFormat::mono_rows:
        mono_ = {strip_};
        mono_.level = ink_ & 1;
        return port::make_sink(mono_, sink);
      case port::PixelFormat::grey2:
        grey2_ = {strip_};
        grey2_.level = ink_ & 3;
        return port::make_sink(grey2_, sink);
      case port::PixelFormat::grey4:
        grey4_ = {strip_};
        grey4_.level = ink_ & 15;
        return port::make_sink(grey4_, sink);
      case port::PixelFormat::rgb565:
        rgb565_ = {strip_};
        rgb565_.colour = port::rgb565(ink_, ink_, ink_);
        return port::make_sink(rgb565_, sink);
      default:
        lcd_ = {strip_};
        lcd_.colour = 0x010101u * ink_;
        return port::make_lcd_sink(lcd_, sink);
    }
  }

  // Bits of a pixel, the left one in the high bits of a byte.
  unsigned bits(int x, int y) const {
    const int count = port::bits_per_pixel(format_);
    const unsigned byte =
        bytes_[static_cast<size_t>(y * strip_.stride + x * count / 8)];
    return byte >> (8 - count - x * count % 8) & ((1u << count) - 1);
  }

  void pixel(int x, int y, uint8_t* rgb) const {
    const uint8_t* row = bytes_.data() + y * strip_.stride;
    if (format_ == port::PixelFormat::rgb888) {
      std::copy(row + 3 * x, row + 3 * x + 3, rgb);
    } else if (format_ == port::PixelFormat::rgb565) {
      const unsigned value = row[2 * x] | static_cast<unsigned>(row[2 * x + 1])
                                              << 8;
      rgb[0] = static_cast<uint8_t>((value >> 11) * 255 / 31);
      rgb[1] = static_cast<uint8_t>((value >> 5 & 63) * 255 / 63);
      rgb[2] = static_cast<uint8_t>((value & 31) * 255 / 31);
    } else {
      const unsigned most = (1u << port::bits_per_pixel(format_)) - 1;
      rgb[0] = rgb[1] = rgb[2] = static_cast<uint8_t>(bits(x, y) * 255 / most);
    }
  }

  port::PixelFormat format_;
  uint8_t ink_;
  Strip strip_;
  std::vector<uint8_t> bytes_;
  port::MonoRowsTarget mono_;
  port::Grey2Target grey2_;
  port::Grey4Target grey4_;
  port::Rgb565Target rgb565_;
  port::Rgb888Target lcd_;
};

// One direction of the picture. [px]
int side_of(double low, double high) {
  return static_cast<int>(std::ceil(kMargin - std::floor(low) + high) +
                          kMargin);
}

}  // namespace

const std::vector<DisplayInfo>& display_list() {
  static const std::vector<DisplayInfo> list = {
      {Display::mono, "mono", "1 bit", "OLED, e-paper: ink or none"},
      {Display::grey2, "grey2", "2 bit", "4 greys"},
      {Display::grey4, "grey4", "4 bit", "16 greys"},
      {Display::rgb565, "rgb565", "RGB565", "16-bit colour"},
      {Display::lcd, "lcd", "LCD", "Stripes of red, green and blue"},
  };
  return list;
}

tools::Image draw_on_display(const std::vector<uint8_t>& rom,
                             const std::string& text,
                             double px,
                             Display display,
                             bool dark) {
  const tools::RomFile file(rom, "preview");
  const Font& font = file.font();
  const tools::Look look(look_of(display), font, px, 0, tools::Use::text);
  const std::vector<tools::Line> lines =
      tools::lay_out_lines(font, text, tools::Kerning::font, look.style());
  const tools::InkBox ink = tools::ink_box(font, lines, look.style());
  Screen screen(display, dark, side_of(ink.x0, ink.x1),
                side_of(ink.y0, ink.y1));
  const Sink sink = screen.sink();
  const Point origin = tools::make_point(kMargin - std::floor(ink.x0),
                                         kMargin - std::floor(ink.y0));
  for (const tools::Line& line : lines) {
    draw(font, {line.glyphs.data(), line.glyphs.size()}, look.style(), origin,
         sink);
  }
  return screen.picture();
}

}  // namespace inkcell::design::editor
