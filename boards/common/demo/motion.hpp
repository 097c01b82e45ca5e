// An animated scene on the screen of a board, or of the host for comparison.
//
// The build selects it: INKCELL_MOTION_HEADER and INKCELL_MOTION_SCENE, a class
// in the namespace scenes.
#pragma once

#include <stdint.h>

#include "inkcell/status.hpp"

namespace inkcell::demo {
inline namespace INKCELL_DEMO_NAME {

/// Opens font and scene. Call it once.
Status open_motion() noexcept;

/// Steps to a frame and shows all of it.
void show_motion(uint32_t frame) noexcept;

}  // namespace INKCELL_DEMO_NAME
}  // namespace inkcell::demo
