// Morphs of digits frame by frame, in pixels: holes are born at points, no
// stroke is cut, and few corners are sharper than those of both digits.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include "inkcell/filter.hpp"
#include "inkcell/motion/outline_morph.hpp"
#include "inkcell/port/a8.hpp"
#include "morph/morph_thorns.hpp"
#include "morph_font.hpp"
#include "morph_reader.hpp"
#include "shape/points.hpp"

namespace inkcell::gen::test {
namespace {

using motion::OutlineMorph;

const char kBold[] = "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf";

constexpr int kFrames = 32;
constexpr int kSizes_px[] = {24, 48, 96};

struct Frame {
  int side = 0;
  std::vector<uint8_t> pixels;

  bool is_ink(int x, int y) const {
    return x >= 0 && y >= 0 && x < side && y < side &&
           pixels[static_cast<size_t>(y * side + x)] >= 128;
  }
  double area() const {
    double sum = 0;
    for (const uint8_t pixel : pixels) {
      sum += pixel / 255.0;
    }
    return sum;
  }
};

Frame frame_of(const OutlineMorph& morph, int px, int step) {
  alignas(4) static uint8_t ram[8192];
  const int side = px + px / 2;
  Frame out = {side, std::vector<uint8_t>(static_cast<size_t>(side * side))};
  const port::A8Canvas canvas(
      {{out.pixels.data(), out.pixels.size()}, 0, 0, side, side, side});
  morph.draw(Painter(canvas, Span<uint8_t>(ram)),
             Style(Q26_6::from_int(px), kFilterArea), {px / 4, px + px / 8},
             Q16_16::from_raw(step * 65536 / kFrames));
  return out;
}

// Connected pixels of ink, by edges and corners, and of background inside it,
// by edges. Specks have one pixel.
struct Parts {
  int islands = 0;
  int holes = 0;
  int specks = 0;
};

Parts parts_of(const Frame& frame) {
  const int width = frame.side + 2;
  const auto is_ink = [&](int at) {
    return frame.is_ink(at % width - 1, at / width - 1);
  };
  Parts parts;
  std::vector<bool> seen(static_cast<size_t>(width * width));
  std::vector<int> stack;
  for (int first = 0; first < width * width; ++first) {
    if (seen[static_cast<size_t>(first)]) {
      continue;
    }
    const bool ink = is_ink(first);
    int size = 0;
    seen[static_cast<size_t>(first)] = true;
    for (stack = {first}; !stack.empty(); ++size) {
      const int at = stack.back();
      stack.pop_back();
      for (int k = 0; k < 9; ++k) {
        const int dx = k % 3 - 1;
        const int dy = k / 3 - 1;
        const int x = at % width + dx;
        const int y = at / width + dy;
        const int next = y * width + x;
        if (x >= 0 && y >= 0 && x < width && y < width &&
            (ink || dx * dy == 0) && !seen[static_cast<size_t>(next)] &&
            is_ink(next) == ink) {
          seen[static_cast<size_t>(next)] = true;
          stack.push_back(next);
        }
      }
    }
    if (first != 0) {  // else the background around all
      (size == 1 ? parts.specks : ink ? parts.islands : parts.holes) += 1;
    }
  }
  return parts;
}

// The mean width of strokes, or less: twice the area by the length of the edge,
// which steps from pixel to pixel. [px]
double stroke_of(const Frame& frame) {
  double edge = 0;
  for (int y = 0; y < frame.side; ++y) {
    for (int x = 0; x < frame.side; ++x) {
      edge += frame.is_ink(x, y) != frame.is_ink(x + 1, y) ? 1 : 0;
      edge += frame.is_ink(x, y) != frame.is_ink(x, y + 1) ? 1 : 0;
    }
  }
  return 2 * frame.area() / std::max(edge, 1.0);
}

// Strokes that are narrower are in pieces at rest, too.
constexpr double kLeastStroke_px = 1.5;

// What all frames of a pair at a size have: no more holes and islands than its
// ends, specks for two frames in a row, area between that of the ends.
void check_frames(const OutlineMorph& morph, int px, const std::string& name) {
  const Frame first = frame_of(morph, px, 0);
  const Frame last = frame_of(morph, px, kFrames);
  if (std::min(stroke_of(first), stroke_of(last)) < kLeastStroke_px) {
    return;
  }
  const Parts ends[] = {parts_of(first), parts_of(last)};
  const double least = std::min(first.area(), last.area());
  const double most = std::max(first.area(), last.area());
  int specks = 0;  // frames in a row
  for (int step = 1; step < kFrames; ++step) {
    const Frame frame = frame_of(morph, px, step);
    const Parts parts = parts_of(frame);
    const std::string where =
        name + ", " + std::to_string(px) + " px, frame " + std::to_string(step);
    EXPECT_LE(parts.holes, std::max(ends[0].holes, ends[1].holes)) << where;
    EXPECT_LE(parts.islands, std::max(ends[0].islands, ends[1].islands))
        << where;
    specks = parts.specks > std::max(ends[0].specks, ends[1].specks)
                 ? specks + 1
                 : 0;
    EXPECT_LE(specks, 2) << where;
    EXPECT_GE(frame.area(), least - 0.05 * most) << where;
    EXPECT_LE(frame.area(), 1.05 * most) << where;
  }
}

// The pairs of `chars` that the font holds.
int check_pairs(const MorphFont& digits,
                const std::string& chars,
                const std::string& file) {
  int pairs = 0;
  for (size_t i = 0; i < chars.size(); ++i) {
    for (size_t j = i + 1; j < chars.size(); ++j) {
      const auto glyph = [&](size_t at) {
        return digits.font.glyph_or_notdef(static_cast<uint8_t>(chars[at]));
      };
      OutlineMorph morph;
      if (OutlineMorph::open(digits.font, glyph(i), glyph(j), morph) !=
          Status::ok) {
        continue;
      }
      ++pairs;
      for (const int px : kSizes_px) {
        check_frames(morph, px, file + ", " + chars[i] + " and " + chars[j]);
      }
    }
  }
  return pairs;
}

// The thorns of all pairs that the font holds, in the mean. [degrees]
double mean_thorns(const MorphFont& digits) {
  const std::vector<MorphEntry> pairs =
      read_morphs(bytes_of(digits.font.section(format::section::kMorphs)));
  double sum = 0;
  for (const MorphEntry& pair : pairs) {
    std::vector<MorphPolygons> frames;
    for (int step = 0; step <= kMorphSteps; ++step) {
      frames.push_back(read_morph(pair.record, digits.outline_of(pair.first),
                                  digits.outline_of(pair.second),
                                  static_cast<double>(step) / kMorphSteps, 5));
      for (auto& polygon : frames.back()) {
        for (Point& p : polygon) {
          p = digits.grid_u() * p;
        }
      }
    }
    sum += thorns_of(frames);
  }
  return sum / static_cast<double>(pairs.size());
}

TEST(MorphFrame, HolesAreBornAtPoints) {
  EXPECT_EQ(check_pairs(digits_of(kBold, "013"), "013", kBold), 3);
}

struct DigitFace {
  const char* file;
  int least;    // pairs that have a way; others roll
  double most;  // thorns: degrees a frame, in the mean
};

class MorphFrames : public testing::TestWithParam<DigitFace> {};

TEST_P(MorphFrames, AreClean) {
  const auto& [file, least, most] = GetParam();
  const MorphFont& digits = digits_of(file, "0123456789");
  const int pairs = check_pairs(digits, "0123456789", file);
  const double thorns = mean_thorns(digits);
  std::printf("%s: %d of 45 pairs, thorns of %.1f degrees\n", file, pairs,
              thorns);
  EXPECT_GE(pairs, least);
  EXPECT_LE(thorns, most);
}

constexpr char kSerif[] = "/usr/share/fonts/truetype/dejavu/DejaVuSerif.ttf";
constexpr char kSerifItalic[] =
    "/usr/share/fonts/truetype/liberation/LiberationSerif-Italic.ttf";
constexpr char kThin[] =
    "/usr/share/fonts/truetype/roboto/unhinted/RobotoTTF/Roboto-Thin.ttf";
constexpr char kBlack[] =
    "/usr/share/fonts/truetype/roboto/unhinted/RobotoTTF/Roboto-Black.ttf";
constexpr char kMono[] =
    "/usr/share/fonts/truetype/liberation/LiberationMono-Regular.ttf";
constexpr char kMonoTall[] =
    "/usr/share/fonts/truetype/jetbrains-mono/JetBrainsMono-Regular.ttf";

INSTANTIATE_TEST_SUITE_P(Faces,
                         MorphFrames,
                         testing::Values(DigitFace{kDejaVuSans, 34, 15},
                                         DigitFace{kBold, 41, 7},
                                         DigitFace{kSerif, 22, 27},
                                         DigitFace{kLiberationSerif, 27, 23},
                                         DigitFace{kSerifItalic, 19, 16},
                                         DigitFace{kRoboto, 27, 18},
                                         DigitFace{kThin, 7, 68},
                                         DigitFace{kBlack, 34, 15},
                                         DigitFace{kMono, 21, 28},
                                         DigitFace{kMonoTall, 20, 37}));

}  // namespace
}  // namespace inkcell::gen::test
