// What the steps of layout share: options, and the painter that draws.
#pragma once

#include "inkcell/assert.hpp"
#include "inkcell/layout/layout.hpp"
#include "text/advances.hpp"

namespace inkcell::detail {

// Refers to what it is made of. The first face has index 0.
struct Setting {
  const LayoutOptions& options;
  const Painter& painter;

  const Face& face(uint32_t index = 0) const noexcept {
    const Face& face = index == 0 ? options.face : options.fallback[index - 1];
    INKCELL_ASSERT(face.font != nullptr && face.style != nullptr);
    return face;
  }
  // With the fitter that the painter takes.
  Advances advances(uint32_t index) const noexcept {
    const Face& own = face(index);
    const Fitter* const fitter = painter.fitter_of(*own.style);
    const bool is_whole = fitter != nullptr && fitter->has_advances(*own.style);
    return {*own.font, own.style, is_whole ? fitter : nullptr};
  }
  // Of a character of the paragraph that was prepared.
  uint8_t level(uint32_t at) const noexcept {
    const BidiOrder* const order = options.order();
    return order == nullptr ? uint8_t{0} : order->level(*options.bidi(), at);
  }
};

}  // namespace inkcell::detail
