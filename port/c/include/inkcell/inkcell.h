// Inkcell from C99: everything. docs/DRAW.md, "From C", has an example.
//
// Each header has one topic; a program may include one alone. They say what a
// function does, its units and its errors; the C++ headers that they name say
// more. Rules for all of them:
//
// - Memory is the caller's: nothing is allocated, nothing has to be freed.
//   Types whose members are `words` and `numbers` are opaque; the others are
//   plain, and their members may be read and written.
// - What an object was made of must outlive it, unless it says otherwise.
//   Opaque objects may be copied by assignment.
// - A function that fails returns the reason, and makes `out` the empty object
//   of its type, which may be used: it draws nothing, or as its comment says.
// - Pointers must not be null, unless the function's comment allows it.
// - Numbers with a suffix such as _q6 are fixed-point: the value times 2^6.
// - Fonts are constant: any number of tasks may draw from one at once.
//
// Made by port/c/make_api.py from port/c/api.txt: edit that instead.
#pragma once

#include "inkcell/c/cache.h"
#include "inkcell/c/circle_text.h"
#include "inkcell/c/display.h"
#include "inkcell/c/draw.h"
#include "inkcell/c/effects.h"
#include "inkcell/c/filter.h"
#include "inkcell/c/font.h"
#include "inkcell/c/layout.h"
#include "inkcell/c/morph.h"
#include "inkcell/c/pixel.h"
#include "inkcell/c/shaped_run.h"
#include "inkcell/c/sink.h"
#include "inkcell/c/style.h"
#include "inkcell/c/text_box.h"
#include "inkcell/c/types.h"
#include "inkcell/c/value.h"
