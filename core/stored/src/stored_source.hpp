// Draws outlines of stored fonts, by the source of outlines, from their page:
// an object of its own (kStoredOutlineCoding), which strikes do not link.
#pragma once

#include "inkcell/stored/stored_font.hpp"
