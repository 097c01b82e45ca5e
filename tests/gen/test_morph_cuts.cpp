// Cuts of morphs do not show while they are closed.
#include <gtest/gtest.h>

#include <cstdint>
#include <cstdio>
#include <vector>

#include "inkcell/filter.hpp"
#include "inkcell/motion/outline_morph.hpp"
#include "inkcell/port/a8.hpp"
#include "morph_font.hpp"
#include "morph_reader.hpp"

namespace inkcell::gen::test {
namespace {

using motion::OutlineMorph;

constexpr int kCutSteps = 16;

const char* const kCutFaces[] = {
    kDejaVuSans, kLiberationSerif, kInterVariable, kRoboto,
    "/usr/share/fonts/truetype/lato/Lato-Regular.ttf"};

struct CutFrame {
  int side;
  std::vector<uint8_t> pixels;

  int at(int x, int y) const {
    return pixels[static_cast<size_t>(y * side + x)];
  }
};

CutFrame cut_frame(const OutlineMorph& morph,
                   int px,
                   const Filter& filter,
                   int step) {
  alignas(4) static uint8_t ram[8192];
  const int side = px + px / 2;
  CutFrame out = {side, std::vector<uint8_t>(static_cast<size_t>(side * side))};
  const port::A8Canvas canvas(
      {{out.pixels.data(), out.pixels.size()}, 0, 0, side, side, side});
  morph.draw(Painter(canvas, Span<uint8_t>(ram)),
             Style(Q26_6::from_int(px), filter), {px / 4, px},
             Q16_16::from_raw(step * 65536 / kCutSteps));
  return out;
}

// Dark pixels of `drawn` that lie deep in the ink of `exact`: the pixel and its
// neighbours are full there.
int seams(const CutFrame& exact, const CutFrame& drawn) {
  int count = 0;
  for (int y = 1; y + 1 < exact.side; ++y) {
    for (int x = 1; x + 1 < exact.side; ++x) {
      bool is_deep = true;
      for (int i = 0; i < 9; ++i) {
        is_deep = is_deep && exact.at(x + i % 3 - 1, y + i / 3 - 1) >= 254;
      }
      count += is_deep && drawn.at(x, y) < 240 ? 1 : 0;
    }
  }
  return count;
}

class MorphCuts : public testing::TestWithParam<const char*> {};

TEST_P(MorphCuts, DoNotShow) {
  const MorphFont& digits = digits_of(GetParam(), "0123456789");
  const std::vector<MorphEntry> pairs =
      read_morphs(bytes_of(digits.font.section(format::section::kMorphs)));
  int pixels = 0;
  for (const MorphEntry& pair : pairs) {
    OutlineMorph morph;
    ASSERT_EQ(OutlineMorph::open(digits.font, static_cast<uint16_t>(pair.first),
                                 static_cast<uint16_t>(pair.second), morph),
              Status::ok);
    for (const int px : {24, 48, 96}) {
      for (int step = 1; step < kCutSteps; ++step) {
        // Exact areas show no cut of no width, distances to edges would.
        const CutFrame exact = cut_frame(morph, px, kFilterArea, step);
        const CutFrame drawn = cut_frame(morph, px, kFilterMotion, step);
        const int count = seams(exact, drawn);
        EXPECT_EQ(count, 0) << "glyphs " << pair.first << " and " << pair.second
                            << ", " << px << " px, step " << step;
        pixels += count;
      }
    }
  }
  std::printf("%s: %zu pairs, %d dark pixels along cuts\n", GetParam(),
              pairs.size(), pixels);
}

INSTANTIATE_TEST_SUITE_P(Faces, MorphCuts, testing::ValuesIn(kCutFaces));

}  // namespace
}  // namespace inkcell::gen::test
