#include "display.hpp"

#include <algorithm>
#include <stdexcept>

#include "inkcell/port/framebuffer.hpp"
#include "inkcell/port/lcd.hpp"
#include "inkcell/port/strip_loop.hpp"
#include "look.hpp"

namespace inkcell::tools {
namespace {

using port::PixelFormat;

[[noreturn]] void refuse_size(int width, int height) {
  throw std::runtime_error("a display of " + std::to_string(width) + "x" +
                           std::to_string(height) +
                           " px: sides are 1 to 32767 px long");
}

}  // namespace

const std::vector<DisplayInfo>& display_list() {
  static const std::vector<DisplayInfo> list = {
      {Display::mono, "mono", "1 bit", "OLED, e-paper: ink or none",
       PixelFormat::mono_rows},
      {Display::mono_pages, "mono_pages", "1 bit, pages",
       "SSD1306 and its like: a byte has 8 rows", PixelFormat::mono_pages},
      {Display::grey2, "grey2", "2 bit", "4 greys", PixelFormat::grey2},
      {Display::grey4, "grey4", "4 bit", "16 greys", PixelFormat::grey4},
      {Display::grey8, "grey8", "8 bit", "256 greys", PixelFormat::grey8},
      {Display::rgb565, "rgb565", "RGB565", "16-bit colour",
       PixelFormat::rgb565},
      {Display::xrgb8888, "xrgb8888", "XRGB8888", "24-bit colour in 32 bits",
       PixelFormat::xrgb8888},
      {Display::lcd, "lcd", "LCD", "Stripes of red, green and blue",
       PixelFormat::rgb888},
  };
  return list;
}

const DisplayInfo& display_info(Display display) {
  return *std::find_if(
      display_list().begin(), display_list().end(),
      [display](const DisplayInfo& info) { return info.display == display; });
}

Display display_of(const std::string& name) {
  std::string names;
  for (const DisplayInfo& info : display_list()) {
    if (name == info.name) {
      return info.display;
    }
    names += std::string(" ") + info.name;
  }
  throw std::runtime_error("display '" + name +
                           "' is unknown; there are:" + names);
}

void suit_display(Display display, LookOptions& look) {
  look.levels = display == Display::mono || display == Display::mono_pages ? 2
                : display == Display::grey2                                ? 4
                                            : 256;
  look.lcd = display == Display::lcd ? "rgb" : "none";
}

DisplayPaper::Canvas DisplayPaper::canvas_for(Display display,
                                              const Strip& strip) {
  switch (display) {
    case Display::mono:
      return port::MonoRowsCanvas(strip);
    case Display::mono_pages:
      return port::MonoPagesCanvas(strip);
    case Display::grey2:
      return port::Grey2Canvas(strip);
    case Display::grey4:
      return port::Grey4Canvas(strip);
    case Display::grey8:
      return port::Grey8Canvas(strip);
    case Display::rgb565:
      return port::Rgb565Canvas(strip);
    case Display::xrgb8888:
      return port::Xrgb8888Canvas(strip);
    case Display::lcd:
      break;
  }
  port::Rgb888Canvas canvas(strip);
  port::set_sub_pixels(canvas);
  return canvas;
}

Sink DisplayPaper::sink() const {
  return std::visit(
      [](const auto& canvas) -> Sink {
        if (canvas.status() != Status::ok) {
          throw std::runtime_error("this strip is none of the display");
        }
        return canvas;
      },
      canvas_);
}

DisplayPaper::DisplayPaper(Display display,
                           const Strip& strip,
                           DrawStats* stats)
    : canvas_(canvas_for(display, strip)),
      counting_(sink(), stats == nullptr ? unused_ : *stats),
      sink_(counting_.sink()) {}

scenes::Paper DisplayPaper::paper() {
  return {sink_.window, this, [](void* context, uint32_t rgb) -> const Sink& {
            DisplayPaper& self = *static_cast<DisplayPaper*>(context);
            std::visit([rgb](auto& canvas) { scenes::set_ink(canvas, rgb); },
                       self.canvas_);
            return self.sink_;
          }};
}

DisplayMemory::DisplayMemory(Display display, int width, int height)
    : info_(display_info(display)),
      width_(width),
      height_(height),
      stride_(port::stride_bytes(info_.format, width)) {
  if (std::min(width, height) < 1 || std::max(width, height) > port::kMaxSide) {
    refuse_size(width, height);
  }
  bytes_.resize(port::strip_bytes(info_.format, width, height));
}

int DisplayMemory::whole_rows(int rows) const {
  const int page = port::rows_per_stride(info_.format);
  return (rows + page - 1) / page * page;
}

size_t DisplayMemory::strip_bytes(int rows) const {
  return port::strip_bytes(info_.format, width_,
                           std::min(whole_rows(rows), height_));
}

void DisplayMemory::show(int rows,
                         const std::function<void(const Strip&)>& draw) {
  if (rows >= height_) {
    Strip whole;
    whole.pixels = {bytes_.data(), bytes_.size()};
    whole.width = width_;
    whole.height = height_;
    whole.stride = stride_;
    draw(whole);
    return;
  }
  port::Framebuffer display = {
      {bytes_.data(), bytes_.size()}, info_.format, width_, height_, stride_};
  std::vector<uint8_t> buffer(strip_bytes(rows));  // aligned to more than 4
  port::StripLoop loop;
  loop.buffer = {buffer.data(), buffer.size()};
  loop.width = width_;
  loop.height = height_;
  loop.format = info_.format;
  auto context = &draw;
  loop.context = &context;
  loop.draw = [](void* to, const Strip& strip) {
    (**static_cast<decltype(&draw)*>(to))(strip);
    return Status::ok;
  };
  loop.display = &display;
  loop.flush = [](void* to, const Strip& strip) {
    return port::write(*static_cast<port::Framebuffer*>(to), strip);
  };
  if (run_strips(loop) != Status::ok) {
    throw std::runtime_error(
        std::string(info_.name) + " of " + std::to_string(width_) + "x" +
        std::to_string(height_) + " px, strips of " + std::to_string(rows) +
        " rows: its rows and pages must be whole bytes");
  }
}

void DisplayMemory::see(int x, int y, uint8_t* rgb) const {
  const int bits = port::bits_per_pixel(info_.format);
  const bool has_pages = info_.format == PixelFormat::mono_pages;
  const uint8_t* at = bytes_.data() + (has_pages ? y / 8 * stride_ + x
                                                 : y * stride_ + x * bits / 8);
  switch (info_.format) {
    case PixelFormat::rgb888:
      std::copy(at, at + 3, rgb);
      return;
    case PixelFormat::xrgb8888:
      std::reverse_copy(at, at + 3, rgb);
      return;
    case PixelFormat::rgb565: {
      const unsigned value = at[0] | static_cast<unsigned>(at[1]) << 8;
      rgb[0] = static_cast<uint8_t>((value >> 11) * 255 / 31);
      rgb[1] = static_cast<uint8_t>((value >> 5 & 63) * 255 / 63);
      rgb[2] = static_cast<uint8_t>((value & 31) * 255 / 31);
      return;
    }
    default: {
      const int shift = has_pages ? y % 8 : 8 - bits - x * bits % 8;
      const unsigned most = (1u << bits) - 1;
      rgb[0] = rgb[1] = rgb[2] =
          static_cast<uint8_t>((at[0] >> shift & most) * 255 / most);
    }
  }
}

Image DisplayMemory::picture() const {
  Image image(width_, height_, 3);
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      see(x, y, image.at(x, y));
    }
  }
  return image;
}

}  // namespace inkcell::tools
