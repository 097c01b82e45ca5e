// The display of a board as memory, and its visible picture.
//
// The whole screen is one strip here. Each controller maps pixels differently:
//
//     grey4        SSD0323: level g is grey 17 g; 4 x 4 points a pixel
//     mono_pages   SSD0303: white on black; 4 x 4 points a pixel
//     rgb565       PL110: channels shifted up; VGA: high bits repeated below
//     xrgb8888     unchanged
#pragma once

#include <string>

/// Writes the visible picture as PPM. False if the file cannot be written.
bool write_ppm(const std::string& name);
