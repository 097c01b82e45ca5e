// Pieces are linked where they meet, and the loops that they make are measured.
#include "slivers.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>

namespace inkcell::tools {
namespace {

using Chord = TrueGlyph::Chord;

// Ends closer than this are one: both pieces of a crossing have it as they
// computed it. [u]
constexpr double kSame = 1e-5;

constexpr double kTurn = 6.283185307179586;

double direction(Vector from, Vector to) {
  return std::atan2(to.y - from.y, to.x - from.x);
}

// Numbers places.
class Places {
 public:
  size_t number(Vector p) {
    const auto x = static_cast<int64_t>(std::floor(p.x / kSame));
    const auto y = static_cast<int64_t>(std::floor(p.y / kSame));
    for (int64_t i = -1; i <= 1; ++i) {
      for (int64_t k = -1; k <= 1; ++k) {
        const auto found = places_.find({x + i, y + k});
        if (found != places_.end()) {
          return found->second;
        }
      }
    }
    return places_.emplace(std::make_pair(x, y), places_.size()).first->second;
  }
  size_t count() const { return places_.size(); }

 private:
  std::map<std::pair<int64_t, int64_t>, size_t> places_;
};

enum class Kind { island, hole };

class Links {
 public:
  explicit Links(const std::vector<Chord>& border) : border_(border) {
    Places places;
    for (const Chord& piece : border) {
      const size_t from = places.number(piece.a);
      ends_.push_back(places.number(piece.b));
      leaving_.resize(places.count());
      leaving_[from].push_back(ends_.size() - 1);
    }
  }

  // Counts the pieces of all slivers of a kind.
  void count(Kind kind, std::vector<uint8_t>& slivers) const {
    std::vector<bool> is_done(border_.size());
    for (size_t first = 0; first < border_.size(); ++first) {
      if (is_done[first]) {
        continue;
      }
      std::vector<size_t> loop;
      size_t at = first;
      do {
        is_done[at] = true;
        loop.push_back(at);
        at = next(kind, at);
      } while (at < border_.size() && !is_done[at]);
      if (at == first && is_thin(kind, loop)) {
        for (const size_t piece : loop) {
          ++slivers[piece];
        }
      }
    }
  }

 private:
  // The piece that goes on around the same part of the area, or of what lies
  // outside, where several meet; none: the number of pieces.
  size_t next(Kind kind, size_t piece) const {
    const double back = direction(border_[piece].b, border_[piece].a);
    size_t best = border_.size();
    double least = 2 * kTurn;
    for (const size_t other : leaving_[ends_[piece]]) {
      const double ahead = direction(border_[other].a, border_[other].b);
      const double angle = kind == Kind::island ? back - ahead : ahead - back;
      const double turn = angle - kTurn * std::floor(angle / kTurn);
      if (turn < least) {
        least = turn;
        best = other;
      }
    }
    return best;
  }

  bool is_thin(Kind kind, const std::vector<size_t>& loop) const {
    const Vector origin = border_[loop.front()].a;
    double area = 0;
    double length = 0;
    for (const size_t piece : loop) {
      const Chord& chord = border_[piece];
      area += ((chord.a.x - origin.x) * (chord.b.y - origin.y) -
               (chord.a.y - origin.y) * (chord.b.x - origin.x)) /
              2;
      length += std::hypot(chord.b.x - chord.a.x, chord.b.y - chord.a.y);
    }
    if (kind == Kind::hole) {
      area = -area;
    }
    return area > 0 && area < kSliverArea && 2 * area < kSliverWidth * length;
  }

  const std::vector<Chord>& border_;
  std::vector<size_t> ends_;                  // the place of each piece's end
  std::vector<std::vector<size_t>> leaving_;  // the pieces that begin there
};

}  // namespace

std::vector<uint8_t> find_slivers(const std::vector<Chord>& border) {
  std::vector<uint8_t> slivers(border.size());
  const Links links(border);
  links.count(Kind::island, slivers);
  links.count(Kind::hole, slivers);
  return slivers;
}

}  // namespace inkcell::tools
