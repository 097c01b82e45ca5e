// Is a cell good enough? Compares the device's reading of it with the truth.
#pragma once

#include <array>
#include <vector>

#include "field/sample_tree.hpp"
#include "inkcell/field/cell.hpp"
#include "inkcell/field/glyph_field.hpp"
#include "shape/shape.hpp"
#include "target/grid.hpp"
#include "target/metric.hpp"

namespace inkcell::gen {

/// Nine distances, row by row from below, as bytes in ROM: the centre rounded
/// to 1/64 u, the others to 1/128 of the cell from it.
SampleCell quantise(const std::array<double, 9>& distances_u, int size_log2);

/// What the device makes of `cell` at (x, y) from its lower left corner; each
/// 0..size, the far border read as the last position inside. [u]
double read_cell(const SampleCell& cell, int size_log2, double x, double y);

/// True distances on a lattice of 17 x 17 points over a cell, computed when
/// asked for and handed down to the children.
class Lattice {
 public:
  static constexpr int kSteps = 16;

  explicit Lattice(const CellSquare& cell);

  /// The lattice of a child, with what is known here.
  Lattice child(int index) const;

  const CellSquare& cell() const { return cell_; }

  /// Makes the row `j` known at every column that `stride` divides.
  void fill_row(const Neighbourhood& truth, int j, int stride);

  /// Makes all rows known at every column.
  void fill(const Neighbourhood& truth);

  double operator()(int i, int j) const { return d_[at(i, j)]; }
  /// Row by row from below.
  double operator[](size_t point) const { return d_[point]; }

  std::array<double, 9> nine(const Neighbourhood& truth);

 private:
  static size_t at(int i, int j) {
    return static_cast<size_t>(j * (kSteps + 1) + i);
  }

  CellSquare cell_;
  // NaN: not known. A row is known at all multiples of a stride or at none
  // that the next wider stride does not have.
  std::array<double, (kSteps + 1) * (kSteps + 1)> d_;
};

/// What a test found.
struct Verdict {
  bool passed = true;
  /// Over all tested points; incomplete if the test failed. [Metric::error]
  double worst = 0;
  double mean = 0;
};

/// Tests cells against one metric and its limit.
class CellTest {
 public:
  /// `refine`: look between the points of the lattice wherever the true
  /// distance bends.
  CellTest(const Metric& metric, bool refine)
      : metric_(metric), limit_(metric.limit()), refine_(refine) {}

  /// Stops at the first point beyond the limit.
  Verdict run(const SampleCell& cell,
              Lattice& lattice,
              const Neighbourhood& truth) const;

  /// Visits every point whatever it finds.
  Verdict measure(const SampleCell& cell,
                  Lattice& lattice,
                  const Neighbourhood& truth) const;

 private:
  struct Job;
  struct Patch;

  Verdict test(const SampleCell& cell,
               Lattice& lattice,
               const Neighbourhood& truth,
               bool stop) const;
  bool test_stride(Job& job, int stride) const;
  bool test_between(Job& job) const;
  bool test_patch(Job& job, const Patch& patch) const;
  bool may_exceed(const Patch& patch) const;
  bool may_bend(const Patch& patch) const;
  bool may_peak(const Patch& patch, double kink_u) const;

  Metric metric_;
  double limit_;
  bool refine_;
};

}  // namespace inkcell::gen
