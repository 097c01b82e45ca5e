// Drawing without a painter.
#pragma once

#include "inkcell/brush.hpp"
#include "inkcell/field.hpp"
#include "inkcell/render.hpp"
#include "inkcell/strip.hpp"

namespace inkcell {
namespace detail {

// One sample a pixel.
void draw_plain(const GlyphField& field,
                const Brush& brush,
                const FinePoint& origin,
                const Sink& sink) noexcept;

}  // namespace detail
}  // namespace inkcell
