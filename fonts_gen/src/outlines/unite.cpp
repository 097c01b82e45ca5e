#include "outlines/unite.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

#include "outlines/curves.hpp"
#include "shape/flatten.hpp"
#include "shape/points.hpp"

namespace inkcell::gen {
namespace {

// The border is a polygon: chords of the source and, at crossings, parts of
// chords. An edge of it is part of a source segment if its ends and its middle
// are this near to the chords of that segment, in order. If curves run along
// each other, either may be chosen. [u]
constexpr double kNear_u = kFlatteningBound;

// Points nearer than this are one: crossings are rounded to 1/65536 u. [u]
constexpr double kSamePoint_u = 1e-4;

struct Source {
  Segment curve;
  std::vector<Point> chords;  // corners of its polygon
};

std::vector<Source> sources_of(const Outline& outline) {
  std::vector<Source> sources;
  const auto add = [&](const Segment& curve) {
    Source source{curve, {curve.p[0]}};
    const int count = chord_count(curve);
    for (int i = 1; i <= count; ++i) {
      source.chords.push_back(
          i == count ? end_of(curve)
                     : point_on(curve, static_cast<double>(i) / count));
    }
    sources.push_back(std::move(source));
  };
  for (const Contour& contour : outline.contours) {
    for (const Segment& segment : contour.segments) {
      add(segment);
    }
    if (!contour.segments.empty()) {
      add(line_segment(end_of(contour.segments.back()),
                       contour.segments.front().p[0]));
    }
  }
  return sources;
}

// A place on the chords of a source: index of the chord + part of it.
struct Projection {
  double at = 0;
  double distance = kInfinity;  // of the point that was looked for [u]
};

// The nearest place to `p` on a chord.
Projection project(const Source& source, size_t chord, const Point& p) {
  const Chord line =
      chord_between(source.chords[chord], source.chords[chord + 1]);
  return {static_cast<double>(chord) + line.nearest(p),
          std::sqrt(line.squared_distance(p))};
}

// Moves `at` along the chords, forward or back by about `reach` at most, to the
// nearest place to `p`. Returns the distance of `p` from there.
double advance(const Source& source,
               bool ahead,
               const Point& p,
               double reach,
               double& at) {
  const size_t count = source.chords.size() - 1;
  Projection best;
  size_t chord = std::min(static_cast<size_t>(at), count - 1);
  if (!ahead && chord > 0 && at == static_cast<double>(chord)) {
    --chord;  // it begins here, the one before ends here
  }
  double walked = 0;
  double from = at;
  while (true) {
    Projection place = project(source, chord, p);
    place.at = ahead ? std::max(place.at, at) : std::min(place.at, at);
    if (place.distance < best.distance) {
      best = place;
    }
    const double end = static_cast<double>(ahead ? chord + 1 : chord);
    walked += std::fabs(end - from) *
              length(source.chords[chord + 1] - source.chords[chord]);
    from = end;
    if (walked > reach || (ahead ? chord + 1 == count : chord == 0)) {
      break;
    }
    chord = ahead ? chord + 1 : chord - 1;
  }
  at = best.at;
  return best.distance;
}

// A part of a source segment on the border, or a line of the border that
// belongs to no source.
struct Piece {
  const Source* source = nullptr;
  bool ahead = true;  // in the direction of the source
  double from = 0;    // places on the source
  double to = 0;
  Point a;  // corners of the border
  Point b;
};

// Extends `piece` along its source to the end of an edge that begins at the end
// of the piece. Returns the largest distance of the edge from the source.
double extend_piece(const Edge& edge, Piece& piece) {
  const double reach = length(edge.b - edge.a) + 2 * kNear_u;
  double at = piece.to;
  double most = 0;
  for (const Point& p : {middle(edge.a, edge.b), edge.b}) {
    most = std::max(most, advance(*piece.source, piece.ahead, p, reach, at));
  }
  piece.to = at;
  piece.b = edge.b;
  return most;
}

// Begins a piece with an edge: the part of the nearest source.
Piece start_piece(const std::vector<Source>& sources, const Edge& edge) {
  Piece best;
  best.a = edge.a;
  best.b = edge.b;
  double least = kNear_u;
  for (const Source& source : sources) {
    for (size_t chord = 0; chord + 1 < source.chords.size(); ++chord) {
      const Projection place = project(source, chord, edge.a);
      if (place.distance >= least) {
        continue;
      }
      for (const bool ahead : {true, false}) {
        Piece piece{&source, ahead, place.at, place.at, edge.a, edge.b};
        const double most = std::max(place.distance, extend_piece(edge, piece));
        if (most < least && piece.to != piece.from) {
          least = most;
          best = piece;
        }
      }
    }
  }
  return best;
}

bool continues(const Piece& a, const Piece& b) {
  return a.source != nullptr && a.source == b.source && a.ahead == b.ahead &&
         length(a.b - b.a) <= kNear_u && std::fabs(b.from - a.to) <= 1;
}

// Joins consecutive pieces, also the last with the first.
void join(std::vector<Piece>& pieces) {
  std::vector<Piece> joined;
  for (const Piece& piece : pieces) {
    if (!joined.empty() && continues(joined.back(), piece)) {
      joined.back().to = piece.to;
      joined.back().b = piece.b;
    } else {
      joined.push_back(piece);
    }
  }
  if (joined.size() > 1 && continues(joined.back(), joined.front())) {
    joined.front().from = joined.back().from;
    joined.front().a = joined.back().a;
    joined.pop_back();
  }
  pieces = std::move(joined);
}

// The edges of a contour as the fewest pieces.
std::vector<Piece> pieces_of(const std::vector<Source>& sources,
                             const Edge* edges,
                             size_t count) {
  std::vector<Piece> pieces;
  for (size_t i = 0; i < count; ++i) {
    if (!pieces.empty() && pieces.back().source != nullptr) {
      Piece longer = pieces.back();
      if (extend_piece(edges[i], longer) <= kNear_u) {
        pieces.back() = longer;
        continue;
      }
    }
    pieces.push_back(start_piece(sources, edges[i]));
  }
  join(pieces);
  // Residues of crossings at a narrow angle.
  const auto is_tiny = [](const Piece& piece) {
    return length(piece.b - piece.a) <= kNear_u &&
           (piece.source == nullptr || std::fabs(piece.to - piece.from) <= 1);
  };
  pieces.erase(std::remove_if(pieces.begin(), pieces.end(), is_tiny),
               pieces.end());
  join(pieces);
  return pieces;
}

// The segment of a piece. Ends at the source's ends are exact.
Segment segment_of(const Piece& piece) {
  if (piece.source == nullptr) {
    return line_segment(piece.a, piece.b);
  }
  const Segment& whole = piece.source->curve;
  const double chords = static_cast<double>(piece.source->chords.size() - 1);
  Point a = piece.ahead ? piece.a : piece.b;
  Point b = piece.ahead ? piece.b : piece.a;
  double t0 = std::min(piece.from, piece.to) / chords;
  double t1 = std::max(piece.from, piece.to) / chords;
  if (length(a - whole.p[0]) < kSamePoint_u) {
    a = whole.p[0];
    t0 = 0;
  }
  if (length(b - end_of(whole)) < kSamePoint_u) {
    b = end_of(whole);
    t1 = 1;
  }
  Segment part = part_of(whole, t0, t1);
  part.p[0] = a;
  part.p[degree_of(part)] = b;
  return piece.ahead ? part : reversed(part);
}

// Orders pieces as in the source, independent of the border's order.
std::tuple<bool, const Source*, double> rank(const Piece& piece) {
  return {piece.source == nullptr, piece.source,
          std::min(piece.from, piece.to)};
}

bool comes_first(const Piece& a, const Piece& b) {
  return rank(a) < rank(b);
}

Contour contour_of(const std::vector<Piece>& pieces) {
  Contour contour;
  for (const Piece& piece : pieces) {
    Segment segment = segment_of(piece);
    if (!contour.segments.empty()) {
      segment.p[0] = end_of(contour.segments.back());
    }
    contour.segments.push_back(segment);
  }
  Segment& last = contour.segments.back();
  last.p[degree_of(last)] = contour.segments.front().p[0];
  return contour;
}

}  // namespace

Outline unite(const Outline& outline) {
  return unite(outline, Shape(outline));
}

Outline unite(const Outline& outline, const Shape& shape) {
  const std::vector<Source> sources = sources_of(outline);
  std::vector<std::vector<Piece>> contours;
  const std::vector<Edge>& edges = shape.edges();
  for (size_t first = 0, i = 0; i < edges.size(); ++i) {
    if (!(edges[i].b == edges[first].a)) {
      continue;
    }
    std::vector<Piece> pieces =
        pieces_of(sources, edges.data() + first, i + 1 - first);
    if (!pieces.empty()) {
      std::rotate(pieces.begin(),
                  std::min_element(pieces.begin(), pieces.end(), comes_first),
                  pieces.end());
      contours.push_back(std::move(pieces));
    }
    first = i + 1;
  }
  std::stable_sort(contours.begin(), contours.end(),
                   [](const auto& a, const auto& b) {
                     return comes_first(a.front(), b.front());
                   });
  Outline result;
  for (const std::vector<Piece>& pieces : contours) {
    result.contours.push_back(contour_of(pieces));
  }
  return result;
}

}  // namespace inkcell::gen
