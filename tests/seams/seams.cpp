// The seams of a ROM font: how far the field jumps across the borders of cells.
//
//   seams FONT.bin
//
// Neighbouring cells are built one by one, each within the font's tolerance of
// the truth, so that a jump may be twice the tolerance and no more. Measured as
// one sees it: as a difference of coverage under the filter `text`, at the size
// of the font's range where it is largest. The points are 1/65536 u apart on
// both sides of each border, 33 along each side of each cell.
#include <stdio.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "inkcell/field/cell.hpp"
#include "inkcell/field/draw.hpp"
#include "inkcell/font.hpp"
#include "rom_file.hpp"

namespace {

using namespace inkcell;

constexpr int kSteps = 32;  // along the side of a cell

// A pair of points across a border.
struct Seam {
  double intensity = 0;   // difference of coverage, 1/255
  double distance_u = 0;  // distances cut to the band that is promised good
  double near_u = 0;      // distance on either side [u]
  double far_u = 0;
  double x_u = 0;
  double y_u = 0;
  uint16_t glyph = 0;
};

struct Summary {
  Seam brightest;
  Seam widest;
  uint64_t borders = 0;
  uint64_t points = 0;
  double sum = 0;  // of intensity
};

class Metric {
 public:
  explicit Metric(const FontRange& range)
      : min_px_(range.min_px), max_px_(range.max_px) {}

  // The largest difference of coverage over all sizes. On one side of the edge
  // it grows until the farther distance saturates; across, with the size.
  double intensity(double a_u, double b_u) const {
    const double far_u = std::max(std::fabs(a_u), std::fabs(b_u));
    double px = max_px_;
    if ((a_u > 0) == (b_u > 0) && far_u > 0) {
      px = std::clamp(512 / far_u, min_px_, max_px_);
    }
    return 255 * std::fabs(coverage(a_u * px) - coverage(b_u * px));
  }

 private:
  static double coverage(double distance) {
    return std::clamp(0.5 + distance / 1024, 0.0, 1.0);
  }

  double min_px_;
  double max_px_;
};

class Glyph {
 public:
  Glyph(const GlyphField& field,
        uint16_t id,
        double band_u,
        const Metric& metric,
        Summary& summary)
      : field_(field),
        id_(id),
        band_u_(band_u),
        metric_(metric),
        summary_(summary) {}

  void measure() {
    const int32_t tile = 1 << field_.tile_log2;
    for (int32_t y = field_.y0_u; y < field_.y1_u(); y += tile) {
      for (int32_t x = field_.x0_u; x < field_.x1_u(); x += tile) {
        visit(x, y, tile);
      }
    }
  }

 private:
  // The leaves of a square.
  void visit(int32_t x_u, int32_t y_u, int32_t size_u) {
    const Cell cell = locate(field_, x_u, y_u);
    const int32_t cell_u = 1 << cell.size_log2;
    if (cell_u < size_u) {
      const int32_t half = size_u / 2;
      for (int part = 0; part < 4; ++part) {
        visit(x_u + part % 2 * half, y_u + part / 2 * half, half);
      }
      return;
    }
    // Each border once from either side: the neighbour's may be longer.
    border(x_u, y_u, cell_u, true, x_u + cell_u);
    border(x_u, y_u, cell_u, true, x_u);
    border(x_u, y_u, cell_u, false, y_u + cell_u);
    border(x_u, y_u, cell_u, false, y_u);
  }

  void border(
      int32_t x_u, int32_t y_u, int32_t size_u, bool upright, int32_t at_u) {
    ++summary_.borders;
    for (int i = 0; i <= kSteps; ++i) {
      const int64_t size_q16 = int64_t{size_u} << 16;
      const auto along_q16 =
          static_cast<int32_t>(int64_t{upright ? y_u : x_u} * 65536 +
                               std::min(i * size_q16 / kSteps, size_q16 - 1));
      const int32_t at_q16 = at_u * 65536;
      if (upright) {
        compare(at_q16 - 1, along_q16, at_q16, along_q16);
      } else {
        compare(along_q16, at_q16 - 1, along_q16, at_q16);
      }
    }
  }

  void compare(int32_t x0, int32_t y0, int32_t x1, int32_t y1) {
    const double a = distance(x0, y0);
    const double b = distance(x1, y1);
    Seam seam;
    seam.intensity = metric_.intensity(a, b);
    seam.distance_u = std::fabs(std::clamp(a, -band_u_, band_u_) -
                                std::clamp(b, -band_u_, band_u_));
    seam.near_u = a;
    seam.far_u = b;
    seam.x_u = x1 / 65536.0;
    seam.y_u = y1 / 65536.0;
    seam.glyph = id_;
    ++summary_.points;
    summary_.sum += seam.intensity;
    if (seam.intensity > summary_.brightest.intensity) {
      summary_.brightest = seam;
    }
    if (seam.distance_u > summary_.widest.distance_u) {
      summary_.widest = seam;
    }
  }

  double distance(int32_t x_q16, int32_t y_q16) const {
    return distance_at(field_, Q16_16::from_raw(x_q16), Q16_16::from_raw(y_q16))
               .raw /
           1024.0;
  }

  const GlyphField& field_;
  uint16_t id_;
  double band_u_;
  const Metric& metric_;
  Summary& summary_;
};

std::string name_of(const Font& font, uint16_t glyph) {
  for (uint32_t code_point = 1; code_point < 0x110000; ++code_point) {
    uint16_t found = 0;
    if (font.glyph_of(code_point, found) == Status::ok && found == glyph) {
      char text[16];
      snprintf(text, sizeof(text), "U+%04X", code_point);
      return text;
    }
  }
  return ".notdef";
}

void print(const char* what, const Font& font, const Seam& seam) {
  printf("  %-22s %6.2f /255 %8.3f u  %s at (%.1f, %.1f): %.2f and %.2f u\n",
         what, seam.intensity, seam.distance_u,
         name_of(font, seam.glyph).c_str(), seam.x_u, seam.y_u, seam.near_u,
         seam.far_u);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    fprintf(stderr, "usage: seams FONT.bin\n");
    return 2;
  }
  const RomFile file(argv[1]);
  const Font& font = file.font();
  const Metric metric(font.range());
  Summary summary;
  for (uint16_t id = 0; id < font.glyph_count(); ++id) {
    if (font.record(id).size == 0) {
      continue;  // no ink
    }
    GlyphField field;
    if (read_field(font, id, field) != Status::ok) {
      fprintf(stderr, "seams: glyph %d cannot be opened\n", id);
      return 1;
    }
    Glyph(field, id, font.range().band_u, metric, summary).measure();
  }
  const double bound = 2.0 * font.range().tolerance;
  printf("%.*s, %d to %d px, tolerance %d/255\n",
         static_cast<int>(font.name().size), font.name().data,
         font.range().min_px, font.range().max_px, font.range().tolerance);
  printf("  %llu borders, %llu points, mean jump %.3f /255\n",
         static_cast<unsigned long long>(summary.borders),
         static_cast<unsigned long long>(summary.points),
         summary.sum / static_cast<double>(summary.points));
  print("largest jump, as seen", font, summary.brightest);
  print("largest jump in band", font, summary.widest);
  printf("  bound %.0f /255\n", bound);
  return summary.points > 0 && summary.brightest.intensity <= bound ? 0 : 1;
}
