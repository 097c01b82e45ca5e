// Drawing without a painter.
#pragma once

#include "inkcell/field.hpp"
#include "inkcell/render.hpp"
#include "inkcell/strip.hpp"
#include "inkcell/text_style.hpp"

namespace inkcell {
namespace detail {

// One sample a pixel.
void draw_plain(const GlyphField& field,
                const TextStyle& style,
                const FinePoint& origin,
                const Sink& sink) noexcept;

}  // namespace detail
}  // namespace inkcell
