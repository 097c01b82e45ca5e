// Traces bitmaps of glyphs and compares the curves with the outlines that they
// were drawn from.
//
// Usage: inkcell_bitmap_figures FONT.ttf SYMBOLS PX_PER_EM bilevel|grey|scan
//          [WORST_U RMS_U]
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
#include "fixtures.hpp"
#include "outlines/curves.hpp"
#include "outlines/unite.hpp"
#include "shape/shape.hpp"
#include "work_time.hpp"

namespace inkcell::design::test {
namespace {

struct Errors {
  double worst = 0;
  double sum = 0;
  double count = 0;

  void note(double error, double weight = 1) {
    worst = std::max(worst, std::fabs(error));
    sum += weight * error * error;
    count += weight;
  }
  double rms() const { return count == 0 ? 0 : std::sqrt(sum / count); }
};

constexpr double kCorner_u = 3;
constexpr double kCornerTurn = 0.17;  // [radians]
constexpr int kGreyRows = 16;
constexpr double kMargin_u = 16;

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

// Adds the ink between the crossings of a row to each pixel. [px]
void add_row(std::vector<double>& row,
             const std::vector<double>& crossings,
             double x0_u,
             double px_u) {
  for (size_t i = 0; i + 1 < crossings.size(); i += 2) {
    const double a = (crossings[i] - x0_u) / px_u;
    const double b = (crossings[i + 1] - x0_u) / px_u;
    for (int x = static_cast<int>(std::max(a, 0.0));
         x < b && x < static_cast<int>(row.size()); ++x) {
      row[static_cast<size_t>(x)] +=
          std::min(b, x + 1.0) - std::max(a, static_cast<double>(x));
    }
  }
}

// The shape with a margin, in grey or bilevel, and its position.
Bitmap draw_master(const gen::Shape& shape,
                   double px_per_em,
                   bool is_grey,
                   MasterPlace& place) {
  const double px = 1024 / px_per_em;
  const gen::Box& box = shape.box();
  place.px_per_em = px_per_em;
  place.origin_x = std::ceil((kMargin_u - box.x0) / px);
  place.origin_y = std::ceil((kMargin_u + box.y1) / px);
  Bitmap bitmap;
  bitmap.width =
      static_cast<int>(place.origin_x + (box.x1 + kMargin_u) / px) + 1;
  bitmap.height =
      static_cast<int>(place.origin_y + (kMargin_u - box.y0) / px) + 1;
  const int rows = is_grey ? kGreyRows : 1;
  std::vector<double> crossings;
  for (int y = 0; y < bitmap.height; ++y) {
    std::vector<double> row(static_cast<size_t>(bitmap.width), 0);
    for (int i = 0; i < rows; ++i) {
      shape.crossings((place.origin_y - y - (i + 0.5) / rows) * px, crossings);
      if (is_grey) {
        add_row(row, crossings, -place.origin_x * px, px);
        continue;
      }
      for (size_t k = 0; k + 1 < crossings.size(); k += 2) {
        const double a = crossings[k] / px + place.origin_x - 0.5;
        const double b = crossings[k + 1] / px + place.origin_x - 0.5;
        for (int x = static_cast<int>(std::ceil(a)); x < b; ++x) {
          row[static_cast<size_t>(x)] = 1;
        }
      }
    }
    for (const double ink : row) {
      bitmap.ink.push_back(
          static_cast<uint8_t>(std::lround(255 * std::min(ink / rows, 1.0))));
    }
  }
  return bitmap;
}

// Places where the united contours turn by more than 10 degrees. [u]
std::vector<Point> corners_of(const gen::Outline& source) {
  std::vector<Point> corners;
  for (const gen::Contour& contour : gen::unite(source).contours) {
    for (size_t i = 0; i < contour.segments.size(); ++i) {
      const gen::Segment& next =
          contour.segments[(i + 1) % contour.segments.size()];
      const double angle = turn(gen::direction_at_end(contour.segments[i]),
                                gen::direction_at_start(next));
      if (std::fabs(angle) > kCornerTurn) {
        corners.push_back(next.p[0]);
      }
    }
  }
  return corners;
}

// Whether a corner is nearer than kCorner_u.
bool is_near_any(const Point& p, const std::vector<Point>& corners) {
  return std::any_of(corners.begin(), corners.end(), [&p](const Point& c) {
    return length(c - p) < kCorner_u;
  });
}

// Records the distances of the border of `from` from that of `to`: everywhere,
// and away from corners. [u]
void compare_edges(const gen::Shape& from,
                   const gen::Shape& to,
                   const std::vector<Point>& corners,
                   Errors& off_corners,
                   Errors& all) {
  for (const gen::Edge& edge : from.edges()) {
    const Point middle = 0.5 * (edge.a + edge.b);
    for (const Point& p : {edge.a, middle}) {
      const double d = to.distance(p.x, p.y);
      const double weight = length(edge.b - edge.a);
      all.note(d, weight);
      if (!is_near_any(p, corners)) {
        off_corners.note(d, weight);
      }
    }
  }
}

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
  double most_s = 0;  // of a glyph
};

void measure(const gen::SourceGlyph& glyph,
             double px_per_em,
             const std::string& kind,
             Noise& noise,
             Sum& sum) {
  const gen::Shape truth(glyph.outline);
  const bool is_scan = kind == "scan";
  MasterOptions options;
  MasterPlace& place = options.place;
  Bitmap bitmap =
      draw_master(is_scan ? gen::Shape(askew(glyph.outline)) : truth, px_per_em,
                  kind != "bilevel", place);
  if (is_scan) {
    scan(bitmap, noise);
    place = place_between({place.origin_x, place.origin_y},
                          {place.origin_x + px_per_em * std::cos(kSkew),
                           place.origin_y + px_per_em * std::sin(kSkew)});
  }
  const double begin = tools::work_done_ms();
  if (is_scan) {
    divide_scan(bitmap, options);
  }
  const gen::Outline curves = outline_of(bitmap, options);
  sum.most_s = std::max(sum.most_s, (tools::work_done_ms() - begin) / 1e3);
  const std::vector<Point> corners = corners_of(glyph.outline);
  const gen::Shape traced(curves);
  compare_edges(traced, truth, corners, sum.off_corners, sum.all);
  compare_edges(truth, traced, corners, sum.off_corners, sum.all);
  sum.segments += segment_count(curves);
  sum.wrong_contours +=
      curves.contours.size() != gen::unite(glyph.outline).contours.size();
}

int measure_all(char** arguments, bool has_limits) {
  const gen::SourceFont font = letters_of(arguments[1], arguments[2]);
  const double px_per_em = std::atof(arguments[3]);
  Noise noise(1);
  Sum sum;
  for (const gen::SourceGlyph& glyph : font.glyphs) {
    measure(glyph, px_per_em, arguments[4], noise, sum);
  }
  std::printf(
      "%g px/em %s: curves %.3f u worst (%.3f at corners), %.4f RMS, %zu "
      "segments, %zu glyphs with a speck or without a contour, %.2f s a glyph "
      "at most\n",
      px_per_em, arguments[4], sum.off_corners.worst, sum.all.worst,
      sum.off_corners.rms(), sum.segments, sum.wrong_contours, sum.most_s);
  const bool is_good =
      !has_limits || (sum.off_corners.worst <= std::atof(arguments[5]) &&
                      sum.off_corners.rms() <= std::atof(arguments[6]) &&
                      sum.wrong_contours == 0);
  return is_good ? 0 : 1;
}

}  // namespace
}  // namespace inkcell::design::test

int main(int argc, char** argv) {
  const std::string kind = argc > 4 ? argv[4] : "";
  if ((argc != 5 && argc != 7) ||
      (kind != "bilevel" && kind != "grey" && kind != "scan")) {
    std::fprintf(stderr,
                 "usage: inkcell_bitmap_figures FONT.ttf SYMBOLS PX_PER_EM "
                 "bilevel|grey|scan [WORST_U RMS_U]\n");
    return 2;
  }
  return inkcell::design::test::measure_all(argv, argc == 7);
}
