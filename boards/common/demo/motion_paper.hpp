// Paper of scenes: a strip in the display's format, and ink of any colour.
#pragma once

#include <stdint.h>

#include "canvas.hpp"
#include "paper.hpp"

namespace inkcell {
namespace demo {
namespace detail {

// The ink that a format has for a colour.

inline void set_ink(port::Rgb565Target& target, uint32_t rgb) noexcept {
  target.colour =
      port::rgb565(static_cast<uint8_t>(rgb >> 16),
                   static_cast<uint8_t>(rgb >> 8), static_cast<uint8_t>(rgb));
}

inline void set_ink(port::Xrgb8888Target& target, uint32_t rgb) noexcept {
  target.colour = 0xff000000 | rgb;
}

// 0 to 255, by the weights of red, green and blue in light (ITU-R BT.601).
inline uint32_t lightness(uint32_t rgb) noexcept {
  return ((rgb >> 16 & 255) * 77 + (rgb >> 8 & 255) * 150 + (rgb & 255) * 29) >>
         8;
}

inline void set_ink(port::Grey4Target& target, uint32_t rgb) noexcept {
  target.level = static_cast<uint8_t>(lightness(rgb) >> 4);
}

inline void set_ink(port::MonoPagesTarget& target, uint32_t rgb) noexcept {
  target.level = lightness(rgb) >= 96 ? 1 : 0;
}

}  // namespace detail

/// A strip to draw a scene on.
class MotionPaper {
 public:
  explicit MotionPaper(const Strip& strip) noexcept {
    target_.strip = strip;
    // Of a strip that the demo made it can only be ok; else nothing is drawn.
    static_cast<void>(port::make_sink(target_, sink_));
  }
  MotionPaper(const MotionPaper&) = delete;
  MotionPaper& operator=(const MotionPaper&) = delete;

  scenes::Paper paper() noexcept {
    return {sink_.window, this, [](void* context, uint32_t rgb) -> const Sink& {
              MotionPaper& self = *static_cast<MotionPaper*>(context);
              detail::set_ink(self.target_, rgb);
              return self.sink_;
            }};
  }

 private:
  detail::Paint<kFormat>::Target target_;
  Sink sink_;
};

}  // namespace demo
}  // namespace inkcell
