#include "field_glyph.hpp"

#include "field_encoder.hpp"
#include "field_record.hpp"

namespace inkcell {
namespace gen {
namespace {

// Encodings at most, before what is left is reported.
constexpr int kMostRounds = 6;

// Other positions than those of the loop may look a little worse. [1/255]
constexpr double kReserve = 0.4;

}  // namespace

FieldGlyph build_fields(const Shape& shape,
                        const AdfOptions& options,
                        const LoopOptions& loop_options) {
  LoopOptions strict = loop_options;
  strict.tolerance -= kReserve;
  ClosedLoop loop(shape, strict);
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
