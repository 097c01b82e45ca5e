// Whether thin strokes of whole fonts stay connected on displays of 1 bit.
//
//   strokes <font.bin> <most breaks of 1000 pictures>
//
// Draws every glyph at 8 to 14 px in 8 sub-pixel positions with Bilevel,
// and counts pieces of ink that touch, also at corners. A picture that has more
// pieces than the glyph at 64 px is broken. What a threshold alone would break,
// and pictures with fewer pieces, are printed beside it.
#include <cstdio>
#include <cstdlib>

#include "bitmap.hpp"
#include "inkcell/bilevel.hpp"
#include "inkcell/font.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/port/a8.hpp"
#include "rom_file.hpp"

namespace {

using namespace inkcell;

// 1 where there is ink.
Bitmap draw(const Font& font,
            uint16_t glyph,
            int px,
            int x_q6,
            int y_q6,
            bool is_bilevel) {
  const int side = 3 * px;
  Bitmap picture(side);
  const Bilevel bilevel;
  Style style(Q26_6::from_int(px), kFilterText);
  const port::A8Canvas canvas(
      {{picture.pixels.data(), picture.pixels.size()}, 0, 0, side, side, side});
  if (canvas.status() != Status::ok) {
    std::abort();
  }
  if (is_bilevel) {
    style.set_effect(bilevel);
  }
  Painter(canvas).glyph(font, style,
                        {Q26_6::from_raw(64 * px / 2 + x_q6),
                         Q26_6::from_raw(64 * 2 * px + y_q6)},
                        glyph);
  for (uint8_t& pixel : picture.pixels) {
    pixel = pixel >= 128 ? 1 : 0;
  }
  return picture;
}

int count_pieces(Bitmap picture) {
  int pieces = 0;
  for (int y = 0; y < picture.side; ++y) {
    for (int x = 0; x < picture.side; ++x) {
      if (picture.at(x, y) != 0) {
        picture.take_piece(x, y, [](int, int) {});
        ++pieces;
      }
    }
  }
  return pieces;
}

// Pictures by how many pieces they have.
struct Tally {
  int pictures = 0;
  int broken = 0;
  int joined = 0;

  void add(int pieces, int wanted) {
    ++pictures;
    broken += pieces > wanted || pieces == 0 ? 1 : 0;
    joined += pieces < wanted && pieces > 0 ? 1 : 0;
  }
  void print(const char* name) const {
    std::printf("%-10s %6d pictures, %5d broken, %5d joined\n", name, pictures,
                broken, joined);
  }
};

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "strokes <font.bin> <most breaks of 1000 pictures>\n");
    return 2;
  }
  const RomFile file(argv[1]);
  const Font& font = file.font();
  Tally threshold;
  Tally bilevel;
  for (uint16_t glyph = 1; glyph < font.glyph_count(); ++glyph) {
    const int wanted = count_pieces(draw(font, glyph, 64, 0, 0, false));
    for (int px = 8; px <= 14 && wanted > 0; ++px) {
      for (int phase = 0; phase < 8; ++phase) {
        const int x_q6 = phase % 4 * 16 + 5;
        const int y_q6 = phase / 4 * 32 + 3;
        const auto pieces = [&](bool is_bilevel) {
          return count_pieces(draw(font, glyph, px, x_q6, y_q6, is_bilevel));
        };
        threshold.add(pieces(false), wanted);
        bilevel.add(pieces(true), wanted);
      }
    }
  }
  threshold.print("threshold");
  bilevel.print("bilevel");
  // 94 characters have ink.
  constexpr int kLeastPictures = 94 * 7 * 8;
  return bilevel.pictures >= kLeastPictures &&
                 bilevel.broken * 1000 <= std::atoi(argv[2]) * bilevel.pictures
             ? 0
             : 1;
}
