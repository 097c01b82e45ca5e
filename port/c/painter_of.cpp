// The painter of C as that of C++.
#include "mirror.hpp"

inkcell::Painter inkcell::c::painter_of(
    const inkcell_painter_t* painter) noexcept {
  if (painter == nullptr) {
    return {};
  }
  return {painter->sink == nullptr ? inkcell::detail::kNoSink
                                   : ref(painter->sink),
          ref(&painter->ram), cpp(painter->cache),
          reinterpret_cast<TextReport*>(painter->report)};
}
