// How text is laid out that moves, whatever it is drawn with.
#pragma once

#include "inkcell/style.hpp"

namespace inkcell::motion {

inline constexpr Style kAsDesigned;

}  // namespace inkcell::motion
