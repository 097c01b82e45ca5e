// What the code of docs/ANIMATING.md draws, and what counts its ink.
#pragma once

#include "check.hpp"
#include "inkcell/font.hpp"
#include "inkcell/strip.hpp"
#include "outline_record.hpp"

namespace animating_input {

using namespace inkcell;

inline constexpr int32_t kSide = 48;

alignas(4) inline uint8_t font_bytes[outline_record::kSampleFontBytes];
inline int32_t ink = 0;  // of what was drawn last

inline const Font& sample_font() {
  static Font sample;
  if (sample.glyph_count() == 0) {
    const size_t bytes = outline_record::build_sample_font(font_bytes);
    CHECK_OK(Font::open({font_bytes, bytes}, sample));
  }
  return sample;
}

inline Sink counting_sink() {
  ink = 0;
  Sink sink;
  sink.window = {0, 0, kSide, kSide};
  sink.coverage = [](void*, int32_t, int32_t, const uint8_t* coverage,
                     int32_t count) {
    for (int32_t i = 0; i < count; ++i) {
      ink += coverage[i];
    }
  };
  sink.solid = [](void*, int32_t, int32_t, int32_t count) {
    ink += 255 * count;
  };
  return sink;
}

inline const Font& font = sample_font();
inline constexpr Q26_6 size = Q26_6::from_int(16);
inline constexpr Point from = {Q26_6::from_int(4), Q26_6::from_int(30)};

}  // namespace animating_input
