// What the code of docs/ANIMATING.md draws, and what counts its ink.
#pragma once

#include "ink.hpp"
#include "inkcell/font.hpp"
#include "outline_font.hpp"

namespace animating_input {

using namespace inkcell;

inline constexpr int32_t kSide = 48;

inline Ink ink;  // of what was drawn last

inline Sink counting_sink() {
  ink = Ink();
  return ink.sink({0, 0, kSide, kSide});
}

inline const Font& font = outline_record::sample_font();
inline constexpr Q26_6 size = Q26_6::from_int(16);
inline constexpr Point from = {Q26_6::from_int(4), Q26_6::from_int(30)};

}  // namespace animating_input
