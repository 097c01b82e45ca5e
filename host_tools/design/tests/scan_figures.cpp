// Traces scans of drawn glyphs and compares them with the outlines.
//
// Usage: inkcell_scan_figures FONT.ttf SYMBOLS PX_PER_EM [WORST_U RMS_U]
//
// A scan is the glyph on a skewed sheet: blurred, under uneven light, with the
// grain of paper and sensor, dark specks on the paper and white ones in the
// ink. It is traced like `inkcell-design trace --scan --em` does; the two
// points of the baseline are known. Errors in u, beyond 3 u from corners. Fails
// beyond the limits, or if a contour is missing or a speck is left.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>

#include "bitmap/bitmap.hpp"
#include "bitmap/edge_walk.hpp"
#include "bitmap/scan.hpp"
#include "fit/curve_fitter.hpp"
#include "master_oracle.hpp"
#include "outlines/unite.hpp"
#include "source/font_source.hpp"

namespace inkcell::design::test {
namespace {

constexpr double kSkew = 0.02;  // the baseline falls by 1.1 degrees
constexpr double kBlur_px = 0.7;
constexpr int kBlurReach_px = 3;
// Greys as a scanner has them, 255 white.
constexpr double kPaper = 236;
constexpr double kInk = 38;
// The loss of light towards the right and the lower edge.
constexpr double kFall[] = {0.25, 0.1};
constexpr double kGrain = 6;  // of 255, one standard deviation
// Specks on each glyph, of up to 3 x 3 pixels.
constexpr int kSpecks = 60;
constexpr int kSpeckRoom_px = 3;  // between a speck and an edge

class Noise {
 public:
  explicit Noise(unsigned seed) : engine_(seed) {}

  int below(int limit) {
    return static_cast<int>(engine_() % static_cast<unsigned>(limit));
  }
  // Mean 0, variance 1: the sum of twelve even numbers.
  double grain() {
    double sum = -6;
    for (int i = 0; i < 12; ++i) {
      sum += static_cast<double>(engine_()) / 4294967296.0;
    }
    return sum;
  }

 private:
  std::mt19937 engine_;  // the same numbers everywhere
};

// The outline on the sheet, turned clockwise about its origin.
gen::Outline askew(gen::Outline outline) {
  const double c = std::cos(kSkew);
  const double s = std::sin(kSkew);
  for (gen::Contour& contour : outline.contours) {
    for (gen::Segment& segment : contour.segments) {
      for (Point& p : segment.p) {
        p = {c * p.x + s * p.y, c * p.y - s * p.x};
      }
    }
  }
  return outline;
}

// Blurs along x or along y.
void blur(std::vector<double>& values, int width, int height, bool in_x) {
  double weights[2 * kBlurReach_px + 1];
  double sum = 0;
  for (int k = -kBlurReach_px; k <= kBlurReach_px; ++k) {
    weights[k + kBlurReach_px] = std::exp(-k * k / (2 * kBlur_px * kBlur_px));
    sum += weights[k + kBlurReach_px];
  }
  const std::vector<double> in = values;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      double value = 0;
      for (int k = -kBlurReach_px; k <= kBlurReach_px; ++k) {
        const int from_x = std::clamp(in_x ? x + k : x, 0, width - 1);
        const int from_y = std::clamp(in_x ? y : y + k, 0, height - 1);
        value += weights[k + kBlurReach_px] *
                 in[static_cast<size_t>(from_y * width + from_x)];
      }
      values[static_cast<size_t>(y * width + x)] = value / sum;
    }
  }
}

// Whether all pixels around the square of 3 x 3 at x, y are equal: a speck that
// touches an edge looks like a part of the glyph.
bool is_even(const std::vector<double>& ink, int width, int x, int y) {
  const double value = ink[static_cast<size_t>(y * width + x)];
  for (int dy = -kSpeckRoom_px; dy < 3 + kSpeckRoom_px; ++dy) {
    for (int dx = -kSpeckRoom_px; dx < 3 + kSpeckRoom_px; ++dx) {
      if (ink[static_cast<size_t>((y + dy) * width + x + dx)] != value) {
        return false;
      }
    }
  }
  return true;
}

// Turns paper into ink and ink into paper.
void add_specks(std::vector<double>& ink, int width, int height, Noise& noise) {
  const int room = 3 + 2 * kSpeckRoom_px;
  for (int i = 0; i < kSpecks; ++i) {
    const int x = kSpeckRoom_px + noise.below(width - room);
    const int y = kSpeckRoom_px + noise.below(height - room);
    if (!is_even(ink, width, x, y)) {
      continue;
    }
    for (int k = 0; k < 9; ++k) {
      if (noise.below(2) != 0) {
        const auto at = static_cast<size_t>((y + k / 3) * width + x + k % 3);
        ink[at] = 1 - ink[at];
      }
    }
  }
}

void scan(Bitmap& bitmap, Noise& noise) {
  std::vector<double> ink;
  for (const uint8_t v : bitmap.ink) {
    ink.push_back(v / 255.0);
  }
  add_specks(ink, bitmap.width, bitmap.height, noise);
  blur(ink, bitmap.width, bitmap.height, true);
  blur(ink, bitmap.width, bitmap.height, false);
  for (size_t i = 0; i < ink.size(); ++i) {
    const auto width = static_cast<size_t>(bitmap.width);
    const double x = static_cast<double>(i % width) / bitmap.width;
    const double y = static_cast<double>(i / width) / bitmap.height;
    const double light = 1 - kFall[0] * x - kFall[1] * y * y;
    const double grey =
        light * (kPaper + ink[i] * (kInk - kPaper)) + kGrain * noise.grain();
    bitmap.ink[i] =
        static_cast<uint8_t>(std::lround(255 - std::clamp(grey, 0.0, 255.0)));
  }
}

struct Sum {
  Errors off_corners;
  Errors all;
  size_t wrong_contours = 0;
  size_t segments = 0;
};

void measure(const gen::SourceGlyph& glyph,
             double px_per_em,
             Noise& noise,
             Sum& sum) {
  const gen::Shape truth(glyph.outline);
  MasterPlace drawn;
  Bitmap bitmap =
      draw_master(gen::Shape(askew(glyph.outline)), px_per_em, true, drawn);
  scan(bitmap, noise);
  MasterOptions options;
  options.place = place_between({drawn.origin_x, drawn.origin_y},
                                {drawn.origin_x + px_per_em * std::cos(kSkew),
                                 drawn.origin_y + px_per_em * std::sin(kSkew)});
  divide_scan(bitmap, options);
  const gen::Outline curves = outline_of(bitmap, options);
  const std::vector<Point> corners = corners_of(glyph.outline);
  const gen::Shape traced(curves);
  compare_edges(traced, truth, corners, sum.off_corners, sum.all);
  compare_edges(truth, traced, corners, sum.off_corners, sum.all);
  sum.segments += segment_count(curves);
  sum.wrong_contours +=
      curves.contours.size() != gen::unite(glyph.outline).contours.size();
}

int run(char** arguments, bool has_limits) {
  gen::FontRequest request;
  request.file = arguments[1];
  gen::add_text(arguments[2], "SYMBOLS", request.characters);
  gen::Warnings warnings;
  const gen::SourceFont font = gen::load_font(request, 1, warnings);
  const double px_per_em = std::atof(arguments[3]);
  Noise noise(1);
  Sum sum;
  for (size_t i = 1; i < font.glyphs.size(); ++i) {
    measure(font.glyphs[i], px_per_em, noise, sum);
  }
  std::printf(
      "%g px/em scan: curves %.3f u worst (%.3f at corners), %.4f RMS, %zu "
      "segments, %zu glyphs with a speck or without a contour\n",
      px_per_em, sum.off_corners.worst, sum.all.worst, sum.off_corners.rms(),
      sum.segments, sum.wrong_contours);
  if (!has_limits) {
    return 0;
  }
  const bool is_good = sum.off_corners.worst <= std::atof(arguments[4]) &&
                       sum.off_corners.rms() <= std::atof(arguments[5]) &&
                       sum.wrong_contours == 0;
  return is_good ? 0 : 1;
}

}  // namespace
}  // namespace inkcell::design::test

int main(int argc, char** argv) {
  if (argc != 4 && argc != 6) {
    std::fprintf(stderr,
                 "usage: inkcell_scan_figures FONT.ttf SYMBOLS PX_PER_EM "
                 "[WORST_U RMS_U]\n");
    return 2;
  }
  return inkcell::design::test::run(argv, argc == 6);
}
