// Pictures of glyphs, by FreeType and by the library, and how they differ.
#pragma once

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include <algorithm>
#include <vector>

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include "inkcell/painter.hpp"
#include "inkcell/port/a8.hpp"
#include "inkcell/truetype/truetype_font.hpp"

namespace glyph_pictures {

inline constexpr int32_t kSide = 192;
inline constexpr int32_t kX = kSide / 4;
inline constexpr int32_t kY = kSide * 3 / 4;
inline constexpr int32_t kPixels = kSide * kSide;
inline constexpr int32_t kSamples = 8;
inline constexpr int32_t kOff = 16;

// Of each pixel 0..255, in steps that hold the mean of 8 x 8 samples exactly.
using Picture = std::vector<uint16_t>;
inline constexpr int32_t kStepsOfOne = kSamples * kSamples;

inline void require(bool condition, const char* what) {
  if (!condition) {
    printf("%s\n", what);
    exit(1);
  }
}

// FreeType's coverage of a glyph, of `samples` squared a pixel: 1 or kSamples.
inline Picture freetype_picture(FT_Face face,
                                uint32_t glyph,
                                int32_t px,
                                int32_t samples) {
  Picture out(kPixels);
  FT_Set_Pixel_Sizes(face, 0, static_cast<FT_UInt>(px * samples));
  require(
      FT_Load_Glyph(face, glyph, FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP) == 0,
      "FreeType loads the glyph");
  face->glyph->outline.flags &= ~FT_OUTLINE_OVERLAP;
  require(FT_Render_Glyph(face->glyph, FT_RENDER_MODE_NORMAL) == 0,
          "FreeType draws the glyph");
  const FT_Bitmap& bitmap = face->glyph->bitmap;
  for (int32_t y = 0; y < static_cast<int32_t>(bitmap.rows); ++y) {
    for (int32_t x = 0; x < static_cast<int32_t>(bitmap.width); ++x) {
      const int32_t at_x = x + face->glyph->bitmap_left + kX * samples;
      const int32_t at_y = y - face->glyph->bitmap_top + kY * samples;
      out[static_cast<size_t>(at_y / samples * kSide + at_x / samples)] +=
          static_cast<uint16_t>(bitmap.buffer[y * bitmap.pitch + x] *
                                (kStepsOfOne / (samples * samples)));
    }
  }
  return out;
}

// In strips of 16 rows, with or without lent RAM.
inline Picture own_picture(const inkcell::Font& font,
                           uint16_t glyph,
                           int32_t px,
                           inkcell::Span<uint8_t> ram) {
  using namespace inkcell;
  static std::vector<uint8_t> bytes(kPixels);
  std::fill(bytes.begin(), bytes.end(), uint8_t{0});
  port::A8Canvas canvas;
  const Style style(Q26_6::from_int(px));
  for (int32_t y = 0; y < kSide; y += 16) {
    canvas.set_strip(
        {{bytes.data() + y * kSide, 16 * kSide}, 0, y, kSide, 16, kSide});
    Painter(canvas, Workspace(ram))
        .glyph(font, style, {Q26_6::from_int(kX), Q26_6::from_int(kY)}, glyph);
  }
  Picture out(kPixels);
  for (size_t i = 0; i < out.size(); ++i) {
    out[i] = static_cast<uint16_t>(bytes[i] * kStepsOfOne);
  }
  return out;
}

struct Error {
  double worst = 0;
  double sum = 0;
  int64_t count = 0;
  int64_t off = 0;

  void add(const Picture& truth, const Picture& drawn) {
    for (size_t i = 0; i < truth.size(); ++i) {
      const double away =
          static_cast<double>(abs(truth[i] - drawn[i])) / kStepsOfOne;
      worst = fmax(worst, away);
      off += away > kOff ? 1 : 0;
      if (truth[i] != 0 || drawn[i] != 0) {
        sum += away;
        ++count;
      }
    }
  }
  double mean() const { return sum / static_cast<double>(count); }
};

}  // namespace glyph_pictures
