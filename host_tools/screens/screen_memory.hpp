// The display of a board as a piece of memory, and the picture that it shows.
//
// The whole screen is one strip here. What becomes of a pixel is each
// controller's rule:
//
//     grey4        SSD0323: level g is grey 17 g; 4 x 4 points a pixel
//     mono_pages   SSD0303: white on black; 4 x 4 points a pixel
//     rgb565       PL110: channels shifted up; VGA: high bits repeated below
//     xrgb8888     as it is
#pragma once

#include <string>

/// Writes what the display shows as PPM. False if the file cannot be written.
bool write_ppm(const std::string& name);
