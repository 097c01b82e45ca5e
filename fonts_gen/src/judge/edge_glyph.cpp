#include "judge/edge_glyph.hpp"

#include "edges/encoder.hpp"
#include "edges/record.hpp"

namespace inkcell {
namespace gen {
namespace {

// Encodings at most, before what is left is reported.
constexpr int kMostRounds = 8;

}  // namespace

EdgeGlyph build_edges(const Shape& shape,
                      const Target& options,
                      const LoopOptions& loop_options) {
  LoopOptions strict = loop_options;
  strict.tolerance -= kPositionReserve;
  ClosedLoop loop(shape, strict);
  EdgeEncoder encoder(shape, options);
  EdgeGlyph best;
  for (int round = 0; round < kMostRounds; ++round) {
    EdgeGlyph glyph;
    glyph.tree = encoder.encode();
    const bool last = round + 1 == kMostRounds;
    const std::vector<Point> misses =
        last ? std::vector<Point>() : encoder.find_misses(glyph.tree);
    for (const Point& miss : misses) {
      encoder.add_point(miss);
    }
    if (!misses.empty()) {
      continue;
    }
    glyph.record = edge_record(glyph.tree);
    GlyphField field;
    if (GlyphField::open({glyph.record.data(), glyph.record.size()}, field) !=
        Status::ok) {
      throw GeometryError(GeometryError::Kind::too_large,
                          "the glyph reaches farther than cells of primitives");
    }
    glyph.errors = loop.draw_and_compare(field);
    for (const LoopMiss& miss : glyph.errors.misses) {
      encoder.add_point({miss.x_u, miss.y_u});
    }
    const bool kept = glyph.errors.misses.empty();
    if (best.record.empty() || glyph.errors.worst < best.errors.worst) {
      best = std::move(glyph);
    }
    if (kept) {
      break;
    }
  }
  return best;
}

}  // namespace gen
}  // namespace inkcell
