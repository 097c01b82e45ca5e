// Whether every part of a glyph shows on displays of 1 bit, on its own side and
// at its own height.
//
//   parts <font.bin> <most lacks as designed> <fitted>, of 1000 pictures
//
// Draws every glyph at 8 to 16 px in 64 sub-pixel positions on a canvas of 1
// bit, as designed and fitted. A part is ink that touches nothing else at 128
// px. It shows if a pixel is drawn within a pixel of where its ink lies, and no
// other part is nearer. Fitted ASCII lacks none.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "bitmap.hpp"
#include "inkcell/fit.hpp"
#include "inkcell/font.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/port/a8.hpp"
#include "inkcell/port/mono_rows.hpp"
#include "rom_file.hpp"

namespace {

using namespace inkcell;

constexpr int kLarge = 128;  // size that tells the parts [px]

// The origin lies at a quarter of the side from the left, two thirds down.
Bitmap draw(const Font& font,
            uint16_t glyph,
            const Style& style,
            FinePoint shift,
            bool is_one_bit) {
  const int side = 3 * (style.size().raw >> 6) + 3;
  Bitmap picture(side);
  port::A8Canvas canvas(
      {{picture.pixels.data(), picture.pixels.size()}, 0, 0, side, side, side});
  if (is_one_bit) {
    canvas.levels = port::MonoRowsCanvas().levels;
  }
  Painter(canvas).glyph(
      font, style,
      {Q26_6::from_raw(side / 4 * 64 + static_cast<int32_t>(shift.x_q10 >> 4)),
       Q26_6::from_raw(side * 2 / 3 * 64 +
                       static_cast<int32_t>(shift.y_q10 >> 4))},
      glyph);
  return picture;
}

// A place of ink from the glyph's origin, y up, and the part that it is of.
struct Ink {
  double x;  // [1/128 em]
  double y;
  int part;
};

// The parts of a glyph; returns how many there are.
int find_parts(const Font& font, uint16_t glyph, std::vector<Ink>& ink) {
  Bitmap picture =
      draw(font, glyph, Style(Q26_6::from_int(kLarge)), {0, 0}, false);
  int parts = 0;
  for (int y = 0; y < picture.side; ++y) {
    for (int x = 0; x < picture.side; ++x) {
      if (picture.at(x, y) >= 64) {
        picture.take_piece(x, y, [&](int at_x, int at_y) {
          ink.push_back({at_x + 0.5 - picture.side / 4,
                         picture.side * 2 / 3 - (at_y + 0.5), parts});
        });
        ++parts;
      }
    }
  }
  return parts;
}

struct Tally {
  int pictures = 0;
  int lost = 0;
};

// Whether each part shows in a picture whose glyph has its origin at `origin`.
bool shows_all(const Bitmap& picture,
               const std::vector<Ink>& ink,
               int parts,
               double px,
               FinePoint origin,
               const GlyphWarp& warp) {
  const auto moved = [](const AxisMap& map, double at) {
    return map.map(static_cast<int32_t>(std::lround(at * 256))) / 256.0;
  };
  std::vector<Ink> places = ink;
  for (Ink& each : places) {
    each.x = moved(warp.x, each.x * px / kLarge) + picture.side / 4 +
             static_cast<double>(origin.x_q10) / 1024;
    each.y = picture.side * 2 / 3 + static_cast<double>(origin.y_q10) / 1024 -
             moved(warp.y, each.y * px / kLarge);
  }
  std::vector<bool> shown(static_cast<size_t>(parts));
  for (int i = 0; i < picture.side * picture.side; ++i) {
    if (picture.pixels[static_cast<size_t>(i)] < 128) {
      continue;
    }
    const double x = i % picture.side + 0.5;
    const double y = i / picture.side + 0.5;
    double nearest = 1;
    int part = -1;
    for (const Ink& each : places) {
      const double away = std::max(std::abs(each.x - x), std::abs(each.y - y));
      if (away < nearest) {
        nearest = away;
        part = each.part;
      }
    }
    if (part >= 0) {
      shown[static_cast<size_t>(part)] = true;
    }
  }
  return std::find(shown.begin(), shown.end(), false) == shown.end();
}

// Whether a code point of ASCII shows the glyph.
bool is_ascii(const Font& font, uint16_t glyph) {
  for (uint32_t code_point = 0x21; code_point != 0x7f; ++code_point) {
    uint16_t own = 0;
    if (font.glyph_of(code_point, own) == Status::ok && own == glyph) {
      return true;
    }
  }
  return false;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fprintf(stderr,
                 "parts <font.bin> <most lacks as designed> <fitted>\n");
    return 2;
  }
  const RomFile file(argv[1]);
  const Font& font = file.font();
  Tally tallies[2];
  int with_parts = 0;
  int ascii = 0;  // fitted pictures that lack a part
  for (uint16_t glyph = 1; glyph < font.glyph_count(); ++glyph) {
    std::vector<Ink> ink;
    const int parts = find_parts(font, glyph, ink);
    with_parts += parts > 1 ? 1 : 0;
    for (int px = 8; px <= 16 && parts > 0; ++px) {
      for (int fitted = 0; fitted < 2; ++fitted) {
        const Fitter* const fitter = fitted != 0 ? &kFitTwoLevels : nullptr;
        Style style(Q26_6::from_int(px));
        if (fitter != nullptr) {
          style.set_fit(*fitter, nullptr);
        } else {
          style.clear_fit();
        }
        for (int phase = 0; phase < (parts > 1 ? 64 : 4); ++phase) {
          // All 64ths of both axes, none of them with all of the other.
          const FinePoint shift = {phase * 16 * 21 % 1024, phase * 16};
          FinePoint origin = shift;
          GlyphWarp warp;
          warp.clear();
          GlyphMetrics metrics;
          if (fitter != nullptr &&
              font.glyph_metrics(glyph, metrics) == Status::ok) {
            fitter->fit(font, style, glyph, metrics, origin, warp);
          }
          const Bitmap picture = draw(font, glyph, style, shift, true);
          Tally& tally = tallies[fitted];
          ++tally.pictures;
          if (!shows_all(picture, ink, parts, px, origin, warp)) {
            ++tally.lost;
            ascii += fitted != 0 && is_ascii(font, glyph) ? 1 : 0;
          }
        }
      }
    }
  }
  std::printf(
      "%d glyphs of several parts\nas designed %6d pictures, %5d lack a part\n"
      "fitted      %6d pictures, %5d lack a part, %d of ASCII\n",
      with_parts, tallies[0].pictures, tallies[0].lost, tallies[1].pictures,
      tallies[1].lost, ascii);
  bool is_good = with_parts > 0 && ascii == 0;
  for (int i = 0; i < 2; ++i) {
    is_good = is_good && tallies[i].lost * 1000 <=
                             std::atoi(argv[2 + i]) * tallies[i].pictures;
  }
  return is_good ? 0 : 1;
}
