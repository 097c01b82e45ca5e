// The drawing surface of scenes: a strip in the display's format, and ink of
// any colour.
#pragma once

#include <stdint.h>

#include "canvas.hpp"
#include "ink.hpp"
#include "paper.hpp"

namespace inkcell::demo {
inline namespace INKCELL_DEMO_NAME {
/// A strip to draw a scene on.
class MotionPaper {
 public:
  explicit MotionPaper(const Strip& strip) noexcept : canvas_(strip) {
    canvas_.levels = nullptr;  // type that moves is not fitted
  }
  MotionPaper(const MotionPaper&) = delete;
  MotionPaper& operator=(const MotionPaper&) = delete;

  scenes::Paper paper() noexcept {
    return {canvas_.window, this,
            [](void* context, uint32_t rgb) -> const Sink& {
              MotionPaper& self = *static_cast<MotionPaper*>(context);
              scenes::set_ink(self.canvas_, rgb);
              return self.canvas_;
            }};
  }

 private:
  detail::Paint<kFormat>::Canvas canvas_;
};

}  // namespace INKCELL_DEMO_NAME
}  // namespace inkcell::demo
