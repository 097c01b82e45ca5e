// What a sketch includes: the font, styles, text and the usual pixel formats.
#pragma once

#include "inkcell/filter.hpp"
#include "inkcell/font.hpp"
#include "inkcell/port/grey4.hpp"
#include "inkcell/port/mono_pages.hpp"
#include "inkcell/port/rgb565.hpp"
#include "inkcell/style.hpp"
#include "inkcell/text.hpp"
