// Figures from C draw what those of C++ do.
#include <inkcell/inkcell.h>

#include "check.hpp"
#include "inkcell/figures/figures.hpp"
#include "picture.hpp"

namespace {

using namespace inkcell;
using namespace inkcell::figures;
using motion::Angle;

Picture<32, 24> papers[2];  // more than the stack of a board

constexpr int32_t q6(double px) {
  return static_cast<int32_t>(px * 64);
}

void check_same(const inkcell_figure_t& in_c, const Figure& figure) {
  constexpr inkcell_pen_t kPenOfC = {q6(2.5), INKCELL_CAP_SQUARE,
                                     INKCELL_JOIN_ROUND};
  constexpr Pen kPen = {2.5_px, Cap::square, Join::round};
  for (auto& paper : papers) {
    paper.clear();
  }
  Sink sinks[] = {papers[0].sink(), papers[1].sink()};
  inkcell_painter_t painter = {};
  painter.sink = reinterpret_cast<const inkcell_sink_t*>(&sinks[0]);
  inkcell_rect_t box;
  inkcell_figure_box(&in_c, nullptr, &box);
  Rect expected = fill_box(figure);
  CHECK(box.x0 == expected.x0 && box.y1 == expected.y1);
  inkcell_fill_figure(&painter, &in_c);
  fill(sinks[1], figure);
  papers[0].next_glyph();
  papers[1].next_glyph();
  inkcell_figure_box(&in_c, &kPenOfC, &box);
  expected = stroke_box(figure, kPen);
  CHECK(box.x0 == expected.x0 && box.y1 == expected.y1);
  CHECK(box.x1 > box.x0);
  inkcell_stroke_figure(&painter, &in_c, &kPenOfC);
  stroke(sinks[1], figure, kPen);
  CHECK(papers[0] == papers[1] && papers[0].ink() > 0);
}

}  // namespace

TEST(figures_are_the_same_in_c) {
  inkcell_figure_t figure;
  inkcell_rectangle(q6(3), q6(4), q6(20), q6(12.5), q6(2), &figure);
  check_same(figure, rounded_rectangle({3, 4}, {20_px, 12.5_px}, 2_px));
  inkcell_circle(q6(14), q6(12), q6(7.5), &figure);
  check_same(figure, circle({14, 12}, 7.5_px));
  inkcell_arc(q6(14), q6(12), q6(7.5), 40960, -40960, &figure);
  check_same(figure, arc({14, 12}, 7.5_px, Angle::from_raw(40960),
                         Q16_16::from_raw(-40960)));
  inkcell_line(q6(4), q6(5), q6(25), q6(18), &figure);
  check_same(figure, line({4, 5}, {25, 18}));
  constexpr inkcell_point_t kOfC[] = {
      {q6(4), q6(5)}, {q6(25), q6(8)}, {q6(12), q6(20)}};
  constexpr Point kPoints[] = {{4, 5}, {25, 8}, {12, 20}};
  inkcell_polygon(kOfC, 3, &figure);
  check_same(figure, polygon(kPoints));
  inkcell_polyline(kOfC, 3, &figure);
  check_same(figure, polyline(kPoints));
}
