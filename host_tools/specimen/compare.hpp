// Our text beside that of others, as in figures 5 to 7 of the paper.
#pragma once

#include "image.hpp"
#include "inkcell/font.hpp"
#include "peers.hpp"

namespace inkcell::tools {

/// Body sizes: 8, 10, 12 and 16 px.
Image compare_body(const Font& font, PeerFont& peers);

/// Letters at 40 px.
Image compare_display(const Font& font, PeerFont& peers);

}  // namespace inkcell::tools
