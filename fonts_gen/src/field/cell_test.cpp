#include "field/cell_test.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace inkcell::gen {
namespace {

constexpr int kPointsAcross = Lattice::kSteps + 1;

// How far the true distance may lie above or below what the corners of a patch
// promise, in patch widths times the missing gradient; see may_exceed().
constexpr double kMissed = 0.75;

// Width of the smallest patch that is looked into, as a part of the distance
// from the edge (at least of half a pixel at the largest size). What a bend can
// hide in it is below 1.5/255.
constexpr double kFinestPatch = 1.0 / 64;

// The same where the metric, not the truth, has a bend, as a part of the
// distance at which it has it. A cell that departs by 1/10 of the way hides
// less than 1/255 in it.
constexpr double kFinestPeak = 1.0 / 16;

int32_t position_q16(double u, int size_log2) {
  const double last = static_cast<double>((int32_t{65536} << size_log2) - 1);
  return static_cast<int32_t>(std::min(u * 65536, last));
}

double to_u(int32_t distance_q10) {
  return distance_q10 / 1024.0;
}

// Lattices of small cells end at a stride of 2: their steps are below a
// quarter of what any size in use can show.
int finest_stride(int size_log2) {
  return size_log2 >= 4 ? 1 : 2;
}

}  // namespace

SampleCell quantise(const std::array<double, 9>& distances_u, int size_log2) {
  const double centre_q6 =
      std::clamp(std::round(distances_u[4] * 64), -32768.0, 32767.0);
  SampleCell cell;
  const uint16_t raw = static_cast<uint16_t>(static_cast<int16_t>(centre_q6));
  cell[format::samples::kCentre] = static_cast<uint8_t>(raw & 0xff);
  cell[format::samples::kCentre + 1] = static_cast<uint8_t>(raw >> 8);
  size_t out = format::samples::kOffsets;
  const double quanta =
      std::ldexp(1.0, format::samples::kQuantaLog2 - size_log2);
  for (size_t i = 0; i < 9; ++i) {
    if (i != 4) {
      const double offset =
          std::round((distances_u[i] - centre_q6 / 64) * quanta);
      cell[out++] = static_cast<uint8_t>(
          static_cast<int8_t>(std::clamp(offset, -128.0, 127.0)));
    }
  }
  return cell;
}

double read_cell(const SampleCell& cell, int size_log2, double x, double y) {
  return to_u(samples_distance(cell.data(), static_cast<uint8_t>(size_log2),
                               position_q16(x, size_log2),
                               position_q16(y, size_log2))
                  .raw);
}

Lattice::Lattice(const CellSquare& cell) : cell_(cell) {
  d_.fill(std::numeric_limits<double>::quiet_NaN());
}

Lattice Lattice::child(int index) const {
  Lattice result(cell_.child(index));
  const int i0 = (index & 1) * kSteps / 2;
  const int j0 = (index >> 1) * kSteps / 2;
  for (int j = 0; j <= kSteps / 2; ++j) {
    for (int i = 0; i <= kSteps / 2; ++i) {
      result.d_[at(2 * i, 2 * j)] = d_[at(i0 + i, j0 + j)];
    }
  }
  return result;
}

void Lattice::fill_row(const Neighbourhood& truth, int j, int stride) {
  if (!std::isnan(d_[at(stride, j)])) {
    return;
  }
  // Wider strides came first where they divide j.
  const bool half_known =
      !std::isnan(d_[at(0, j)]) && !std::isnan(d_[at(2 * stride, j)]);
  const int first = half_known ? stride : 0;
  const int step = half_known ? 2 * stride : stride;
  const size_t count = static_cast<size_t>((kSteps - first) / step + 1);
  const double width = static_cast<double>(cell_.size_u()) / kSteps;
  double row[kPointsAcross];
  truth.distances(cell_.x_u + first * width, cell_.y_u + j * width,
                  step * width, count, row);
  for (size_t k = 0; k < count; ++k) {
    d_[at(first + static_cast<int>(k) * step, j)] = row[k];
  }
}

void Lattice::fill(const Neighbourhood& truth) {
  for (int stride = 8; stride >= 1; stride /= 2) {
    for (int j = 0; j < kPointsAcross; j += stride) {
      fill_row(truth, j, stride);
    }
  }
}

std::array<double, 9> Lattice::nine(const Neighbourhood& truth) {
  std::array<double, 9> result;
  for (int k = 0; k < 9; ++k) {
    fill_row(truth, k / 3 * 8, 8);
    result[static_cast<size_t>(k)] = (*this)(k % 3 * 8, k / 3 * 8);
  }
  return result;
}

// One run over one cell.
struct CellTest::Job {
  const SampleCell& cell;
  Lattice& lattice;
  const Neighbourhood& truth;
  bool stop;  // at the first error beyond the limit
  Verdict verdict;
  std::array<double, kPointsAcross * kPointsAcross>
      reads;  // the cell's distances [u]
  double sum = 0;
  int count = 0;

  // False to stop.
  bool take(double error, double limit) {
    verdict.worst = std::max(verdict.worst, error);
    verdict.passed = verdict.passed && error <= limit;
    return verdict.passed || !stop;
  }
};

// A square between points whose distances are known, the true ones and the
// cell's: lower left, lower right, upper left, upper right. Positions are
// relative to the cell. [u]
struct CellTest::Patch {
  double x;
  double y;
  double width;
  double d[4];
  double read[4];
};

Verdict CellTest::run(const SampleCell& cell,
                      Lattice& lattice,
                      const Neighbourhood& truth) const {
  return test(cell, lattice, truth, true);
}

Verdict CellTest::measure(const SampleCell& cell,
                          Lattice& lattice,
                          const Neighbourhood& truth) const {
  return test(cell, lattice, truth, false);
}

Verdict CellTest::test(const SampleCell& cell,
                       Lattice& lattice,
                       const Neighbourhood& truth,
                       bool stop) const {
  Job job{cell, lattice, truth, stop, {}, {}, 0, 0};
  // From coarse to fine: most cells that fail do so within a few points.
  bool go_on = true;
  for (int stride = 8;
       go_on && stride >= finest_stride(lattice.cell().size_log2);
       stride /= 2) {
    go_on = test_stride(job, stride);
  }
  if (go_on && refine_) {
    test_between(job);
  }
  job.verdict.mean = job.count > 0 ? job.sum / job.count : 0;
  return job.verdict;
}

bool CellTest::test_stride(Job& job, int stride) const {
  const int log2 = job.lattice.cell().size_log2;
  const double width = static_cast<double>(1 << log2) / Lattice::kSteps;
  for (int j = 0; j < kPointsAcross; j += stride) {
    job.lattice.fill_row(job.truth, j, stride);
    const bool half_done = stride < 8 && j % (2 * stride) == 0;
    SamplesRow row;
    row.set_up(job.cell.data(), static_cast<uint8_t>(log2),
               position_q16(j * width, log2));
    for (int i = half_done ? stride : 0; i < kPointsAcross;
         i += half_done ? 2 * stride : stride) {
      const double read = to_u(row.distance_q10(position_q16(i * width, log2)));
      const double error = metric_.error(job.lattice(i, j), read);
      job.reads[static_cast<size_t>(j * kPointsAcross + i)] = read;
      job.sum += error;
      ++job.count;
      if (!job.take(error, limit_)) {
        return false;
      }
    }
  }
  return true;
}

// The cell is smooth, so the error between four lattice points is what their
// errors say unless the true distance bends there, on a medial axis or next to
// a corner, or the metric does. Bends are narrow and get patches of their own.
bool CellTest::test_between(Job& job) const {
  const int stride = finest_stride(job.lattice.cell().size_log2);
  const double width =
      static_cast<double>(job.lattice.cell().size_u()) / Lattice::kSteps;
  for (int j = 0; j < Lattice::kSteps; j += stride) {
    for (int i = 0; i < Lattice::kSteps; i += stride) {
      Patch patch{i * width, j * width, stride * width, {}, {}};
      for (int k = 0; k < 4; ++k) {
        const int ki = i + (k & 1) * stride;
        const int kj = j + (k >> 1) * stride;
        patch.d[k] = job.lattice(ki, kj);
        patch.read[k] = job.reads[static_cast<size_t>(kj * kPointsAcross + ki)];
      }
      if (!test_patch(job, patch)) {
        return false;
      }
    }
  }
  return true;
}

// A distance has a gradient of length 1 almost everywhere. If the mean gradient
// over a patch of width h, from its corners, has the length g < 1, the patch
// holds different gradients. Let a straight bend divide it, with gradients at
// +-theta from their mean direction, at the part f of its width:
//
//   g^2 = cos^2 theta + (1 - 2f)^2 sin^2 theta
//   height of the bend above the chord = 2 f (1 - f) h sin theta
//                                      = h sqrt(f (1 - f)) sqrt(1 - g^2)
//
// which is at most h/2 sqrt(1 - g^2), and 0.71 h if the bend lies diagonally.
bool CellTest::may_exceed(const Patch& patch) const {
  return may_bend(patch) || may_peak(patch, metric_.sharpest_u()) ||
         may_peak(patch, metric_.band_u());
}

bool CellTest::may_bend(const Patch& patch) const {
  const double* d = patch.d;
  const double gx = (d[1] - d[0] + d[3] - d[2]) / (2 * patch.width);
  const double gy = (d[2] - d[0] + d[3] - d[1]) / (2 * patch.width);
  const double missing = std::max(0.0, 1 - gx * gx - gy * gy);
  const double nearest = std::min(
      {std::fabs(d[0]), std::fabs(d[1]), std::fabs(d[2]), std::fabs(d[3])});
  const double missed =
      kMissed * patch.width * std::sqrt(missing) * metric_.slope(nearest);
  double worst = 0;
  for (int k = 0; k < 4; ++k) {
    worst = std::max(worst, metric_.error(d[k], patch.read[k]));
  }
  const double finest = kFinestPatch * std::max(nearest, metric_.sharpest_u());
  return patch.width > finest && worst + missed > limit_;
}

// Where the larger of the two distances passes half a ramp, or the band, the
// metric changes its divisor: the error of a cell that departs steadily from
// the truth has its peak there, between points that are both better.
bool CellTest::may_peak(const Patch& patch, double kink_u) const {
  double least = patch.width + kink_u;
  double most = 0;
  double difference = 0;
  for (int k = 0; k < 4; ++k) {
    const double larger =
        std::max(std::fabs(patch.d[k]), std::fabs(patch.read[k]));
    least = std::min(least, larger);
    most = std::max(most, larger);
    difference = std::max(difference, std::fabs(patch.read[k] - patch.d[k]));
  }
  return least < kink_u && kink_u < most &&
         patch.width > kFinestPeak * kink_u &&
         255 * difference / (2 * kink_u) > limit_;
}

// Adds five points to the four of a patch, and goes on with each quarter:
//
//   2 --- 7 --- 3
//   |     |     |
//   5 --- 8 --- 6
//   |     |     |
//   0 --- 4 --- 1
constexpr double kPatchPoints[5][2] = {
    {0.5, 0}, {0, 0.5}, {1, 0.5}, {0.5, 1}, {0.5, 0.5}};
constexpr int kPatchCorners[4][4] = {
    {0, 4, 5, 8}, {4, 1, 8, 6}, {5, 8, 2, 7}, {8, 6, 7, 3}};

bool CellTest::test_patch(Job& job, const Patch& patch) const {
  if (!may_exceed(patch)) {
    return true;
  }
  double d[9];
  double read[9];
  std::copy(std::begin(patch.d), std::end(patch.d), d);
  std::copy(std::begin(patch.read), std::end(patch.read), read);
  const CellSquare& cell = job.lattice.cell();
  for (int k = 4; k < 9; ++k) {
    const double x = patch.x + kPatchPoints[k - 4][0] * patch.width;
    const double y = patch.y + kPatchPoints[k - 4][1] * patch.width;
    d[k] = job.truth.distance(cell.x_u + x, cell.y_u + y);
    read[k] = read_cell(job.cell, cell.size_log2, x, y);
    if (!job.take(metric_.error(d[k], read[k]), limit_)) {
      return false;
    }
  }
  const double half = patch.width / 2;
  for (int part = 0; part < 4; ++part) {
    Patch quarter{patch.x + (part & 1) * half,
                  patch.y + (part >> 1) * half,
                  half,
                  {},
                  {}};
    for (int k = 0; k < 4; ++k) {
      quarter.d[k] = d[kPatchCorners[part][k]];
      quarter.read[k] = read[kPatchCorners[part][k]];
    }
    if (!test_patch(job, quarter)) {
      return false;
    }
  }
  return true;
}

}  // namespace inkcell::gen
