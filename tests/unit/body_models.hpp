// Glyphs as bodies, and the exact depth of one in another.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "check.hpp"
#include "inkcell/font.hpp"
#include "inkcell/motion/numbers.hpp"
#include "inkcell/simulation/bodies.hpp"
#include "outline_record.hpp"

namespace body_models {

using namespace inkcell;
using namespace inkcell::motion;
using namespace inkcell::simulation;
using outline_record::OutlinePoint;

inline constexpr int32_t kSide = 56;
inline constexpr int32_t kSize = 48;  // [px to the em]
inline constexpr int32_t kLeft = 8;   // of glyphs' origins in their grids
inline constexpr int32_t kBase = 46;

/// A letter U.
inline constexpr OutlinePoint kYoke[] = {
    {outline_record::start, 100, 0},    {outline_record::corner, 600, 0},
    {outline_record::corner, 600, 600}, {outline_record::corner, 480, 600},
    {outline_record::corner, 480, 120}, {outline_record::corner, 220, 120},
    {outline_record::corner, 220, 600}, {outline_record::corner, 100, 600}};
inline constexpr uint16_t kModels = 3;

/// A glyph and its exact edges.
struct Model {
  Span<const OutlinePoint> points;
  int8_t samples[kSide * kSide];
  BodyPoint edge[80];
  BodyShape shape;
};
inline Model models[kModels];
alignas(4) inline uint8_t font_bytes[outline_record::kSampleFontBytes];

inline void make_models() {
  using outline_record::OutlineSource;
  static const OutlineSource kGlyphs[] = {{600, {outline_record::kBar, 4}},
                                          {600, {outline_record::kEll, 6}},
                                          {700, {kYoke, 8}}};
  const size_t size =
      outline_record::build_outline_font({kGlyphs, 3}, 0, 'A', font_bytes);
  Font font;
  CHECK_OK(Font::open({font_bytes, size}, font));
  for (uint16_t i = 0; i < kModels; ++i) {
    Model& model = models[i];
    model.points = kGlyphs[i].points;
    DistanceGrid grid(model.samples, kSide, kSide, 0);
    grid.clear();
    CHECK_OK(grid.paint(font, i, Q26_6::from_int(kSize), {kLeft, kBase}));
    CHECK_OK(model.shape.make(grid, model.edge));
  }
}

inline const Model& model_of(const Body& body) {
  for (const Model& model : models) {
    if (body.shape == &model.shape) {
      return model;
    }
  }
  return models[0];
}

/// [px, Q8]
struct Spot {
  int32_t x;
  int32_t y;
};

/// A corner of the outline as the body stands.
inline Spot corner_of(const Body& body, const OutlinePoint& point) {
  const int32_t x =
      kLeft * 256 + point.x * kSize / 4 - (body.shape->centre_x().raw >> 8);
  const int32_t y =
      kBase * 256 - point.y * kSize / 4 - (body.shape->centre_y().raw >> 8);
  const int32_t c = cosine(body.angle()).raw;
  const int32_t s = sine(body.angle()).raw;
  return {(body.x.raw >> 8) + ((x * c + y * s) >> 14),
          (body.y.raw >> 8) + ((y * c - x * s) >> 14)};
}

struct Edges {
  Spot from[16];
  Spot to[16];
  size_t count = 0;
};

inline Edges edges_of(const Body& body) {
  Edges edges;
  const Span<const OutlinePoint> points = model_of(body).points;
  size_t start = 0;
  for (size_t i = 0; i < points.size; ++i) {
    if (points[i].kind == outline_record::start) {
      start = i;
    }
    const bool is_last =
        i + 1 == points.size || points[i + 1].kind == outline_record::start;
    edges.from[edges.count] = corner_of(body, points[i]);
    edges.to[edges.count++] = corner_of(body, points[is_last ? start : i + 1]);
  }
  return edges;
}

/// How deep a spot is inside of a shape; 0 outside. [px, Q8]
inline int32_t depth_in(const Edges& edges, const Spot& at) {
  bool is_inside = false;
  int64_t least = INT64_MAX;
  for (size_t i = 0; i < edges.count; ++i) {
    const Spot& a = edges.from[i];
    const Spot& b = edges.to[i];
    const int64_t ex = b.x - a.x;
    const int64_t ey = b.y - a.y;
    const int64_t px = at.x - a.x;
    const int64_t py = at.y - a.y;
    if ((a.y > at.y) != (b.y > at.y)) {
      const int64_t cross = ex * py - ey * px;
      is_inside = is_inside != ((cross < 0) == (ey > 0));
    }
    const int64_t length = ex * ex + ey * ey;
    int64_t along = px * ex + py * ey;
    along = along < 0 ? 0 : along > length ? length : along;
    const int64_t dx = px - ex * along / length;
    const int64_t dy = py - ey * along / length;
    const int64_t square = dx * dx + dy * dy;
    least = square < least ? square : least;
  }
  return is_inside
             ? static_cast<int32_t>(square_root(static_cast<uint64_t>(least)))
             : 0;
}

/// The deepest that any spot of one's edges, 1/4 px apart, is in the other.
inline int32_t overlap_of(const Edges& a, const Edges& b) {
  int32_t most = 0;
  for (size_t i = 0; i < a.count; ++i) {
    const int32_t dx = a.to[i].x - a.from[i].x;
    const int32_t dy = a.to[i].y - a.from[i].y;
    const auto pieces = static_cast<int32_t>(length_of(dx, dy) / 64 + 1);
    for (int32_t k = 0; k < pieces; ++k) {
      const Spot at = {a.from[i].x + dx * k / pieces,
                       a.from[i].y + dy * k / pieces};
      const int32_t depth = depth_in(b, at);
      most = depth > most ? depth : most;
    }
  }
  return most;
}

}  // namespace body_models
