#include "field_glyph.hpp"

#include "field_encoder.hpp"
#include "field_record.hpp"

namespace inkcell {
namespace gen {
namespace {

// Encodings at most, before what is left is reported.
constexpr int kMostRounds = 6;

}  // namespace

FieldGlyph build_fields(const Shape& shape, const AdfOptions& options) {
  LoopOptions loop_options;
  loop_options.min_px = static_cast<int>(options.min_px);
  loop_options.max_px = static_cast<int>(options.max_px);
  loop_options.tolerance = options.tolerance;
  ClosedLoop loop(shape, loop_options);
  FieldEncoder encoder(shape, options);
  FieldGlyph best;
  for (int round = 0; round < kMostRounds; ++round) {
    FieldGlyph glyph;
    glyph.tree = encoder.encode();
    glyph.record = direct_record(glyph.tree);
    glyph.rounds = round + 1;
    GlyphField field;
    if (GlyphField::open({glyph.record.data(), glyph.record.size()}, field) !=
        Status::ok) {
      throw GeometryError(GeometryError::Kind::too_large,
                          "the glyph reaches farther than cells of fields");
    }
    glyph.errors = loop.draw_and_compare(field);
    if (round == 0 || glyph.errors.worst < best.errors.worst) {
      const int rounds = glyph.rounds;
      best = glyph;
      best.rounds = rounds;
    }
    if (glyph.errors.misses.empty()) {
      break;
    }
    for (const LoopMiss& miss : glyph.errors.misses) {
      encoder.add_point({miss.x_u, miss.y_u});
    }
  }
  return best;
}

}  // namespace gen
}  // namespace inkcell
