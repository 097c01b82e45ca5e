// What tests of effects draw on, and what they all must keep.
#pragma once

#include "check.hpp"
#include "inkcell/field/draw.hpp"
#include "picture.hpp"

namespace effect {

using namespace inkcell;

inline constexpr int32_t kSide = 40;
inline constexpr Rect kAll = {-3, -2, -3 + kSide, -2 + kSide};

inline Picture<kSide, kSide> picture;
inline Picture<kSide, kSide> whole;

inline void draw(const GlyphField& field,
                 const Style& style,
                 FinePoint origin) {
  picture.clear_at(kAll.x0, kAll.y0);
  draw_field(field, style, origin, picture.sink());
}

/// The windows of all cuts together show what one does; `whole` keeps it.
inline void check_windows(const GlyphField& field,
                          const Style& style,
                          FinePoint origin) {
  draw(field, style, origin);
  whole = picture;
  for (int32_t cut = 1; cut < kSide; cut += 5) {
    picture.clear();
    picture.draw_parts(cut, cut, [&](const Sink& sink) {
      draw_field(field, style, origin, sink);
    });
    CHECK(picture == whole);
  }
}

}  // namespace effect
