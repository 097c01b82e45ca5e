#include "morph/morph_record.hpp"

#include <algorithm>

#include "base/bit_table_writer.hpp"
#include "base/bit_writer.hpp"
#include "inkcell/format/rom.hpp"

namespace inkcell::gen {
namespace {

namespace morphs = format::morphs;

constexpr size_t kMostPieces = (1 << morphs::kPieceCountBits) - 1;
constexpr unsigned kMostWidth = (1 << morphs::kPointWidthBits) - 1;

class RecordWriter {
 public:
  explicit RecordWriter(const SegmentPoints (&points)[2]) : points_(points) {
    int most = 0;
    for (const SegmentPoints& glyph : points) {
      for (const int point : glyph) {
        most = std::max(most, point);
      }
    }
    width_ = width_of(static_cast<uint32_t>(most));
    if (width_ > kMostWidth) {
      throw GeometryError(GeometryError::Kind::too_complex,
                          "too many points for a morph");
    }
    put(width_, morphs::kPointWidthBits);
  }

  void put(unsigned value, unsigned bits) {
    bits_.put(static_cast<int>(value), static_cast<int>(bits));
  }

  void put_eighth(int eighth) {
    put(static_cast<unsigned>(eighth), morphs::kEighthBits);
  }

  void put_stop(const MorphStop& stop, size_t glyph) {
    const auto segment = static_cast<size_t>(stop.segment);
    put(static_cast<unsigned>(points_[glyph].at(segment)), width_);
    put_eighth(stop.eighth);
  }

  void put_side(const MorphSide& side, size_t glyph) {
    switch (side.move) {
      case MorphMove::to_end:
        put(0, 1);
        return;
      case MorphMove::stay:
        put(2, 2);
        return;
      case MorphMove::to_stop:
        put(6, 3);
        put_eighth(side.eighth);
        return;
      case MorphMove::jump:
        put(7, 3);
        put_stop(side.target, glyph);
        return;
    }
  }

  void put_contour(const MorphContour& contour) {
    if (contour.pieces.size() > kMostPieces) {
      throw GeometryError(GeometryError::Kind::too_complex,
                          "too many pieces for a morph");
    }
    put(contour.missing < 0    ? morphs::kBoth
        : contour.missing == 0 ? morphs::kSecondOnly
                               : morphs::kFirstOnly,
        morphs::kKindBits);
    put(static_cast<unsigned>(contour.pieces.size()), morphs::kPieceCountBits);
    for (size_t glyph = 0; glyph < 2; ++glyph) {
      if (contour.missing != static_cast<int>(glyph)) {
        put_stop(contour.start[glyph], glyph);
        continue;
      }
      for (const MorphStop& stop : contour.chord) {
        put_stop(stop, glyph);
      }
      put(static_cast<unsigned>(contour.birth), morphs::kBirthBits);
      put(static_cast<unsigned>(contour.swell), morphs::kSwellBits);
    }
    for (const MorphPiece& piece : contour.pieces) {
      for (size_t glyph = 0; glyph < 2; ++glyph) {
        if (contour.missing != static_cast<int>(glyph)) {
          put_side(piece.side[glyph], glyph);
        }
      }
    }
  }

  std::vector<uint8_t> take() { return bits_.take(); }

 private:
  const SegmentPoints (&points_)[2];
  BitWriter bits_;
  unsigned width_ = 0;
};

}  // namespace

std::vector<uint8_t> morph_record(const MorphPair& pair,
                                  const SegmentPoints (&points)[2]) {
  RecordWriter writer(points);
  for (const MorphContour& contour : pair.contours) {
    writer.put_contour(contour);
  }
  return writer.take();
}

int morph_points(const MorphPair& pair) {
  int points = 0;
  for (const MorphContour& contour : pair.contours) {
    points += 1 + 2 * static_cast<int>(contour.pieces.size());
  }
  return points;
}

}  // namespace inkcell::gen
