// The drawing surface of scenes: a strip in the display's format, and ink of
// any colour.
#pragma once

#include <stdint.h>

#include "canvas.hpp"
#include "ink.hpp"
#include "paper.hpp"

namespace inkcell {
namespace demo {
inline namespace INKCELL_DEMO_NAME {
/// A strip to draw a scene on.
class MotionPaper {
 public:
  explicit MotionPaper(const Strip& strip) noexcept {
    target_.strip = strip;
    // Cannot fail, as the demo made the strip; else nothing is drawn.
    static_cast<void>(port::make_sink(target_, sink_));
  }
  MotionPaper(const MotionPaper&) = delete;
  MotionPaper& operator=(const MotionPaper&) = delete;

  scenes::Paper paper() noexcept {
    return {sink_.window, this, [](void* context, uint32_t rgb) -> const Sink& {
              MotionPaper& self = *static_cast<MotionPaper*>(context);
              scenes::set_ink(self.target_, rgb);
              return self.sink_;
            }};
  }

 private:
  detail::Paint<kFormat>::Target target_;
  Sink sink_;
};

}  // namespace INKCELL_DEMO_NAME
}  // namespace demo
}  // namespace inkcell
