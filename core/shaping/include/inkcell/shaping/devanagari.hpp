// Devanagari at run time: syllables, whose letters change places.
//
//   Shaping shaping;
//   INKCELL_TRY(Shaping::open(font, kDevanagari, shaping));
//
// A program that does not name it does not link it.
#pragma once

#include "inkcell/shaping/shaping.hpp"

namespace inkcell {

/// For fonts made with --shape deva: Hindi, Marathi, Nepali and others.
extern const detail::SyllableCode kDevanagari;

}  // namespace inkcell
