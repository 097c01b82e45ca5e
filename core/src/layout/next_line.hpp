// Lines as they break, without signs: what counting them takes.
#pragma once

#include <stdint.h>

#include "inkcell/layout.hpp"

namespace inkcell {
namespace detail {

// A width in units of the pen, rounded down.
int32_t room_of(const LayoutOptions& options, Q26_6 width) noexcept;

// As next_line(), but without an ellipsis; the width of a hyphen may be wrong.
bool find_next_line(const LayoutOptions& options,
                    Text text,
                    int32_t room,
                    TextLine& line) noexcept;

}  // namespace detail
}  // namespace inkcell
