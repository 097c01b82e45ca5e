// Layers of stored fonts (StoredFont::layers()): an object of its own, which
// programs without colours do not link.
#pragma once

#include "inkcell/stored/stored_font.hpp"
