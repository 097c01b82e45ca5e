// Coverage to pixels of a display of ESPHome.
#include "inkcell_font.h"

#include "esphome/core/log.h"
#include "inkcell/painter.hpp"

namespace esphome {
namespace inkcell_font {
namespace {

using ::inkcell::Sink;

// A display as a sink: pixels between the colour and the background, as fonts
// of ESPHome draw them.
struct DisplaySink : Sink {
  display::Display* display;
  Color color;
  Color background;
  bool two_colours;
};

void take_coverage(void* context,
                   int32_t x,
                   int32_t y,
                   const uint8_t* coverage,
                   int32_t count) {
  const auto& to = *static_cast<const DisplaySink*>(context);
  const auto mix = [](int share, int colour, int paper) {
    return static_cast<uint8_t>((share * colour + (255 - share) * paper + 127) /
                                255);
  };
  for (int32_t i = 0; i < count; ++i) {
    const int share =
        to.two_colours ? coverage[i] >= 128 ? 255 : 0 : coverage[i];
    if (share == 255) {
      to.display->draw_pixel_at(x + i, y, to.color);
    } else if (share != 0) {
      to.display->draw_pixel_at(x + i, y,
                                Color(mix(share, to.color.r, to.background.r),
                                      mix(share, to.color.g, to.background.g),
                                      mix(share, to.color.b, to.background.b)));
    }
  }
}

void take_solid(void* context, int32_t x, int32_t y, int32_t count) {
  const auto& to = *static_cast<const DisplaySink*>(context);
  for (int32_t i = 0; i < count; ++i) {
    to.display->draw_pixel_at(x + i, y, to.color);
  }
}

}  // namespace

InkcellFont::InkcellFont(const uint8_t* rom,
                         size_t rom_size,
                         int32_t size_q6,
                         bool two_colours)
    : style_(::inkcell::Q26_6::from_raw(size_q6)), two_colours_(two_colours) {
  is_open_ =
      ::inkcell::Font::open({rom, rom_size}, font_) == ::inkcell::Status::ok;
  ::inkcell::FitOptions options;
  options.across = two_colours || size_q6 < 12 * 64;
  options.levels = two_colours ? 2 : 0;
  if (is_open_ && ::inkcell::Fit::make(font_, style_, options, fit_) ==
                      ::inkcell::Status::ok) {
    style_.set_fit(fit_);
  }
}

int InkcellFont::ascent() const {
  return (::inkcell::to_px(font_, style_, font_.metrics().ascender).raw + 63) >>
         6;
}

void InkcellFont::print(int x,
                        int y,
                        display::Display* display,
                        Color color,
                        const char* text,
                        Color background) {
  if (!is_open_) {
    ESP_LOGE("inkcell", "the font is none of outlines of this version: \"%s\"",
             text);
    return;
  }
  DisplaySink sink;
  sink.window = {0, 0, display->get_width(), display->get_height()};
  sink.context = &sink;
  sink.coverage = take_coverage;
  sink.solid = take_solid;
  sink.display = display;
  sink.color = color;
  sink.background = background;
  sink.two_colours =
      two_colours_ ||
      display->get_display_type() == display::DisplayType::DISPLAY_TYPE_BINARY;
  ::inkcell::Painter(sink).text(font_, style_, {x, y + ascent()}, text);
}

void InkcellFont::measure(
    const char* text, int* width, int* x_offset, int* baseline, int* height) {
  *width = *x_offset = *baseline = *height = 0;
  if (!is_open_) {
    return;
  }
  const auto size = ::inkcell::Painter().measure(font_, style_, text);
  *width = (size.advance.raw + 63) >> 6;
  *baseline = ascent();
  *height =
      *baseline +
      ((63 - ::inkcell::to_px(font_, style_, font_.metrics().descender).raw) >>
       6);
}

}  // namespace inkcell_font
}  // namespace esphome
