// All that a first program needs: fonts, styles, the painter and canvases, the
// loop over strips, and values that change.
//
//   Font font;
//   INKCELL_TRY(Font::open(fonts::dejavu_sans, font));
//   port::Rgb565Canvas canvas(strip, port::rgb565(255, 255, 255));
//   Painter painter(canvas);
//   painter.text(font, style, pen, "Hello, 12:34");
//
// Effects, grid fitting, libraries and displays have headers of their own.
#pragma once

#include "inkcell/font.hpp"
#include "inkcell/number_text.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/port/a8.hpp"
#include "inkcell/port/grey2.hpp"
#include "inkcell/port/grey4.hpp"
#include "inkcell/port/grey8.hpp"
#include "inkcell/port/mono_pages.hpp"
#include "inkcell/port/mono_rows.hpp"
#include "inkcell/port/rgb565.hpp"
#include "inkcell/port/rgb888.hpp"
#include "inkcell/port/strip_loop.hpp"
#include "inkcell/port/xrgb8888.hpp"
#include "inkcell/style.hpp"
#include "inkcell/value_label.hpp"
