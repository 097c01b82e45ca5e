#include "glyph_outlines.hpp"

#include <ft2build.h>

#include <memory>
#include <stdexcept>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

namespace inkcell::gen {
namespace test {
namespace {

struct OutlineSink {
  Outline outline;
  double u_per_unit = 1;
  Point pen;

  Point u(const FT_Vector* v) const {
    return {static_cast<double>(v->x) * u_per_unit,
            static_cast<double>(v->y) * u_per_unit};
  }
  void add(Segment::Kind kind, std::vector<Point> rest) {
    Segment segment;
    segment.kind = kind;
    segment.p[0] = pen;
    for (size_t i = 0; i < rest.size(); ++i) {
      segment.p[i + 1] = rest[i];
    }
    pen = rest.back();
    outline.contours.back().segments.push_back(segment);
  }
};

OutlineSink& sink(void* user) {
  return *static_cast<OutlineSink*>(user);
}

int move_to(const FT_Vector* to, void* user) {
  sink(user).outline.contours.emplace_back();
  sink(user).pen = sink(user).u(to);
  return 0;
}

int line_to(const FT_Vector* to, void* user) {
  sink(user).add(Segment::Kind::line, {sink(user).u(to)});
  return 0;
}

int conic_to(const FT_Vector* control, const FT_Vector* to, void* user) {
  sink(user).add(Segment::Kind::quadratic,
                 {sink(user).u(control), sink(user).u(to)});
  return 0;
}

int cubic_to(const FT_Vector* control1,
             const FT_Vector* control2,
             const FT_Vector* to,
             void* user) {
  sink(user).add(
      Segment::Kind::cubic,
      {sink(user).u(control1), sink(user).u(control2), sink(user).u(to)});
  return 0;
}

}  // namespace

std::vector<Outline> load_outlines(const std::string& file,
                                   int face_index,
                                   const std::vector<uint32_t>& code_points) {
  FT_Library library = nullptr;
  FT_Init_FreeType(&library);
  const std::unique_ptr<FT_LibraryRec_, int (*)(FT_Library)> done(
      library, FT_Done_FreeType);
  FT_Face face = nullptr;
  if (FT_New_Face(library, file.c_str(), face_index, &face) != 0) {
    throw std::runtime_error("no font: " + file);
  }
  std::vector<Outline> outlines;
  for (const uint32_t code_point : code_points) {
    if (FT_Load_Char(face, code_point, FT_LOAD_NO_SCALE | FT_LOAD_NO_HINTING) !=
        0) {
      throw std::runtime_error("no glyph in " + file);
    }
    OutlineSink into;
    into.u_per_unit = 1024.0 / face->units_per_EM;
    const FT_Outline_Funcs functions = {move_to,  line_to, conic_to,
                                        cubic_to, 0,       0};
    FT_Outline_Decompose(&face->glyph->outline, &functions, &into);
    outlines.push_back(into.outline);
  }
  return outlines;
}

std::vector<uint32_t> ascii() {
  std::vector<uint32_t> result;
  for (uint32_t c = 0x21; c < 0x7f; ++c) {
    result.push_back(c);
  }
  return result;
}

Contour polygon(const std::vector<Point>& corners) {
  Contour contour;
  for (size_t i = 0; i < corners.size(); ++i) {
    Segment segment;
    segment.p[0] = corners[i];
    segment.p[1] = corners[(i + 1) % corners.size()];
    contour.segments.push_back(segment);
  }
  return contour;
}

Contour rectangle(double x0, double y0, double x1, double y1) {
  return polygon({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}});
}

Contour circle(double x, double y, double radius) {
  const double k = 0.5522847498;
  const Point at[5] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 0}};
  Contour contour;
  // A negative radius mirrors x alone, which turns the direction round.
  const double rx = radius;
  const double ry = radius < 0 ? -radius : radius;
  for (int i = 0; i < 4; ++i) {
    const Point a = at[i];
    const Point b = at[i + 1];
    Segment segment;
    segment.kind = Segment::Kind::cubic;
    segment.p[0] = {x + rx * a.x, y + ry * a.y};
    segment.p[1] = {x + rx * (a.x + k * b.x), y + ry * (a.y + k * b.y)};
    segment.p[2] = {x + rx * (b.x + k * a.x), y + ry * (b.y + k * a.y)};
    segment.p[3] = {x + rx * b.x, y + ry * b.y};
    contour.segments.push_back(segment);
  }
  return contour;
}

}  // namespace test
}  // namespace inkcell::gen
