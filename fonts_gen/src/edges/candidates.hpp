// Fields that a cell may be made of.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "edges/code.hpp"
#include "edges/fit.hpp"
#include "edges/model.hpp"
#include "edges/points.hpp"
#include "target/target.hpp"

namespace inkcell {
namespace gen {

/// A field and how it does in one cell.
struct Candidate {
  PrimitiveNumbers field;
  bool is_new = false;
  int rank = 0;        // reused: place in the list
  uint16_t id = 0;     // reused: number of the field
  PrimitiveCode code;  // new
  double bits = 0;     // new: of all but its kind
  double bonus = 0;    // new: what later cells may save by it [bits]

  // At the cell's points:
  bool is_arc = false;
  float nx = 0;  // the gradient of a line
  float ny = 0;
  std::vector<float> value;
  std::vector<float> gx, gy;     // the gradient of an arc
  std::vector<uint64_t> passes;  // bit i: it keeps the limit at point i
  size_t covered = 0;            // points in the band that it serves
};

class CandidateSource {
 public:
  /// `points` must outlive it.
  CandidateSource(PointSource& points,
                  const PrimitiveSteps& steps,
                  const Target& options);

  /// A field that may be used again, and its number.
  using Known = std::pair<uint16_t, PrimitiveNumbers>;

  /// New fields for a cell, the most useful first. `list`: known fields, most
  /// recent first.
  std::vector<Candidate> find_new(int x_u,
                                  int y_u,
                                  int size_log2,
                                  const Points& points,
                                  const std::vector<Known>& list);

  /// Those of the fields in `list` that serve the cell.
  std::vector<Candidate> find_reused(const std::vector<Known>& list,
                                     const Points& points) const;

  /// Bits of a new field without its kind.
  double bits_of(const PrimitiveCode& code, int size_log2) const;

  /// Sets what `candidate` says at `points`.
  void evaluate(Candidate& candidate, const Points& points) const;

 private:
  struct Square {
    int x_u;
    int y_u;
    int size_log2;
  };

  // A point of the shape's border and the unit normal there, inwards.
  struct BorderPoint {
    double x;
    double y;
    double nx;
    double ny;
  };

  void sample_border();
  bool follows(const Primitive& model,
               const BorderPoint& at,
               double reach_u) const;

  // A window in which a field is fitted.
  struct Window {
    double x;
    double y;
    double half;
  };

  std::vector<PrimitiveCode> find_codes(const Square& square,
                                        const Points& points);
  void fit_window(int chain,
                  const Window& window,
                  const Square& square,
                  std::vector<PrimitiveCode>& out);
  void add_tangent(const Corner& corner,
                   uint32_t edge_number,
                   const Square& square,
                   std::vector<PrimitiveCode>& out);
  void add_codes(const PrimitiveFit& fit,
                 const Square& square,
                 std::vector<PrimitiveCode>& out);
  void add_code(const PrimitiveFit& fit,
                PrimitiveKind kind,
                int angle,
                double turn,
                const Square& square,
                std::vector<PrimitiveCode>& out);
  std::vector<size_t> unserved_border(const Square& square,
                                      const std::vector<Known>& list) const;
  double bonus_of(const Candidate& candidate,
                  const std::vector<size_t>& border) const;

  PointSource& source_;
  PrimitiveSteps steps_;
  double e0_u_;
  size_t effort_;
  std::vector<BorderPoint> border_;
  std::vector<FitPoint> fit_points_;
  // What find_codes said of a cell: it does not depend on other cells.
  std::map<std::array<int, 3>, std::vector<PrimitiveCode>> known_;
};

}  // namespace gen
}  // namespace inkcell
