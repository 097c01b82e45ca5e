#include "edges/candidates.hpp"

#include <algorithm>
#include <cmath>

#include "edges/code.hpp"
#include "shape/points.hpp"

namespace inkcell {
namespace gen {
namespace {

// Candidates that are tried in a cell, at least and for each step of effort.
constexpr size_t kReused = 7;
constexpr size_t kReusedPerEffort = 1;
constexpr size_t kNew = 12;
constexpr size_t kNewPerEffort = 3;

constexpr size_t kMostChains = 5;

// What the device's 32 bits hold in a cell up to the largest size, with room to
// spare: of a distance, of the way w along an arc, of what its bend k w^2 adds
// [u], and of k w, half the slope there.
constexpr float kLargestValue_u = 480;
constexpr float kLargestAlong_u = 480;
constexpr float kLargestBend_u = 240;
constexpr float kLargestSlope = 1.9f;

// A reused field that serves a smaller part of a cell is not tried.
constexpr size_t kLeastPart = 50;

// What a field through a corner is worth to the points that are rounded there.
constexpr size_t kCornerWorth = 40;

// A field passes through a corner if it does within this many e0.
constexpr double kCornerReach = 1.5;

// Points across a window.
constexpr int kWindowSteps = 8;

// Windows around the cell, in its sizes, and around a corner that no window of
// the cell serves, in u.
constexpr double kWindowScales[] = {1.0, 1.5, 2.2, 3.5};
constexpr double kCornerWindows_u[] = {20, 40};

// Quarters of smaller cells are not fitted on their own. [u, log2]
constexpr int kLeastQuartered = 3;

// Steps along the border. [u]
constexpr double kBorderStep_u = 8;

// What a new field saves later: bits for each 64 u of border that it follows
// and no known field does, and at most.
constexpr double kBonus = 6;
constexpr double kMostBonus = 14;

// A field follows the border within so many e0: a known one, a new one.
constexpr double kServes = 1;
constexpr double kWillServe = 0.7;

// And if it points the same way. [cosine]
constexpr double kAlongBorder = 0.9;

// Cells of up to this size are tried as one field, whatever is nearest. [u,
// log2]
constexpr int kMostAnyLog2 = 5;
constexpr int kAnyChain = -1;

// Fields whose angle is within this of an axis are tried along it. [quarters]
constexpr double kNearAxis = 0.08;

bool same_code(const PrimitiveCode& a, const PrimitiveCode& b) {
  return a.kind == b.kind && a.d0 == b.d0 && a.angle == b.angle &&
         a.bend == b.bend;
}

}  // namespace

CandidateSource::CandidateSource(PointSource& points,
                                 const PrimitiveSteps& steps,
                                 const Target& options)
    : source_(points),
      steps_(steps),
      e0_u_(e0_u(options)),
      effort_(static_cast<size_t>(options.effort)) {
  sample_border();
}

void CandidateSource::evaluate(Candidate& c, const Points& points) const {
  const Primitive model(c.field);
  const size_t count = points.size();
  c.is_arc = gen::is_arc(c.field);
  c.nx = static_cast<float>(model.nx);
  c.ny = static_cast<float>(model.ny);
  const auto offset = static_cast<float>(model.c);
  bool in_range = true;
  c.value.resize(count);
  for (size_t i = 0; i < count; ++i) {
    c.value[i] = c.nx * points.x[i] + c.ny * points.y[i] + offset;
  }
  if (c.is_arc) {
    c.gx.resize(count);
    c.gy.resize(count);
    const auto along = static_cast<float>(model.cw);
    const auto k = static_cast<float>(model.k);
    for (size_t i = 0; i < count; ++i) {
      const float w = c.nx * points.y[i] - c.ny * points.x[i] + along;
      c.value[i] += k * w * w;
      in_range &= std::fabs(w) < kLargestAlong_u &&
                  std::fabs(k * w * w) < kLargestBend_u &&
                  std::fabs(k * w) < kLargestSlope;
      c.gx[i] = c.nx - 2 * k * w * c.ny;
      c.gy[i] = c.ny + 2 * k * w * c.nx;
    }
  }
  c.passes.assign((count + 63) / 64, 0);
  c.covered = 0;
  for (size_t i = 0; i < count; ++i) {
    const bool ok = points.keeps_limit(i, c.value[i]);
    c.passes[i / 64] |= uint64_t{ok} << (i % 64);
    c.covered += ok && points.in_band[i] ? 1u : 0u;
  }
  for (const int16_t corner : points.corners) {
    const Point& at = source_.truth().corners()[static_cast<size_t>(corner)].at;
    if (std::fabs(model.value(at.x, at.y)) < kCornerReach * e0_u_) {
      c.covered += kCornerWorth;
    }
  }
  for (const float value : c.value) {
    in_range &= std::fabs(value) < kLargestValue_u;
  }
  if (!in_range) {
    c.covered = 0;
  }
}

double CandidateSource::bits_of(const PrimitiveCode& code,
                                int size_log2) const {
  const int angle = has_angle(code.kind) ? steps_.angle_bits(size_log2) : 2;
  const int bend =
      is_bent(code.kind) ? steps_.bend_bits(code.bend, size_log2) : 0;
  return steps_.d0_bits(size_log2) + angle + bend;
}

std::vector<Candidate> CandidateSource::find_reused(
    const std::vector<Known>& list, const Points& points) const {
  std::vector<Candidate> out;
  for (size_t rank = 0; rank < list.size(); ++rank) {
    Candidate c;
    c.id = list[rank].first;
    c.field = list[rank].second;
    c.rank = static_cast<int>(rank);
    evaluate(c, points);
    if (c.covered > 0 && c.covered * kLeastPart >= points.in_band_count) {
      out.push_back(std::move(c));
    }
  }
  const size_t most = kReused + kReusedPerEffort * effort_;
  if (out.size() > most) {
    std::stable_sort(out.begin(), out.end(),
                     [](const Candidate& a, const Candidate& b) {
                       return a.covered > b.covered;
                     });
    out.resize(most);
  }
  return out;
}

std::vector<Candidate> CandidateSource::find_new(
    int x_u,
    int y_u,
    int size_log2,
    const Points& points,
    const std::vector<Known>& list) {
  const Square square = {x_u, y_u, size_log2};
  const std::array<int, 3> key = {x_u, y_u, size_log2};
  auto known = known_.find(key);
  if (known == known_.end()) {
    known = known_.emplace(key, find_codes(square, points)).first;
  }
  const std::vector<size_t> border = unserved_border(square, list);
  std::vector<Candidate> out;
  const int half = 1 << size_log2 >> 1;
  for (const PrimitiveCode& code : known->second) {
    Candidate c;
    c.field = field_numbers(code, steps_, size_log2, x_u + half, y_u + half);
    c.code = code;
    c.is_new = true;
    c.bits = bits_of(code, size_log2);
    evaluate(c, points);
    if (c.covered > 0) {
      c.bonus = bonus_of(c, border);
      out.push_back(std::move(c));
    }
  }
  // A cheap one that covers less may do as well.
  std::stable_sort(out.begin(), out.end(),
                   [](const Candidate& a, const Candidate& b) {
                     return static_cast<double>(a.covered) / (20 + a.bits) >
                            static_cast<double>(b.covered) / (20 + b.bits);
                   });
  const size_t most = kNew + kNewPerEffort * effort_;
  if (out.size() > most) {
    out.resize(most);
  }
  return out;
}

void CandidateSource::sample_border() {
  double carry = 0;
  for (const Edge& edge : source_.truth().shape().edges()) {
    const double dx = edge.b.x - edge.a.x;
    const double dy = edge.b.y - edge.a.y;
    const double length = std::hypot(dx, dy);
    for (; carry < length; carry += kBorderStep_u) {
      border_.push_back({edge.a.x + dx * carry / length,
                         edge.a.y + dy * carry / length, -dy / length,
                         dx / length});
    }
    carry -= length;
  }
}

bool CandidateSource::follows(const Primitive& model,
                              const BorderPoint& at,
                              double reach_u) const {
  if (std::fabs(model.value(at.x, at.y)) > reach_u) {
    return false;
  }
  double gx = 0;
  double gy = 0;
  model.gradient(at.x, at.y, gx, gy);
  return gx * at.nx + gy * at.ny > kAlongBorder;
}

// The border outside of the cell that no known field follows.
std::vector<size_t> CandidateSource::unserved_border(
    const Square& square, const std::vector<Known>& list) const {
  std::vector<Primitive> models;
  for (const Known& known : list) {
    models.emplace_back(known.second);
  }
  const int size = 1 << square.size_log2;
  std::vector<size_t> out;
  for (size_t i = 0; i < border_.size(); ++i) {
    const BorderPoint& at = border_[i];
    bool served = at.x >= square.x_u && at.x <= square.x_u + size &&
                  at.y >= square.y_u && at.y <= square.y_u + size;
    for (size_t m = 0; m < models.size() && !served; ++m) {
      served = follows(models[m], at, kServes * e0_u_);
    }
    if (!served) {
      out.push_back(i);
    }
  }
  return out;
}

// A field that follows more of the border will be used again there.
double CandidateSource::bonus_of(const Candidate& candidate,
                                 const std::vector<size_t>& border) const {
  const Primitive model(candidate.field);
  int count = 0;
  for (const size_t i : border) {
    count += follows(model, border_[i], kWillServe * e0_u_) ? 1 : 0;
  }
  return std::min(kMostBonus, kBonus * count * kBorderStep_u / 64);
}

std::vector<PrimitiveCode> CandidateSource::find_codes(const Square& square,
                                                       const Points& points) {
  const std::vector<Corner>& corners = source_.truth().corners();
  std::map<int, size_t> chains;
  for (size_t i = 0; i < points.size(); ++i) {
    if (points.in_band[i] && points.corner[i] < 0) {
      ++chains[points.chain[i]];
    }
  }
  for (const int16_t corner : points.corners) {
    chains[corners[static_cast<size_t>(corner)].before] += 0;
    chains[corners[static_cast<size_t>(corner)].after] += 0;
  }
  std::vector<std::pair<size_t, int>> order;
  for (const auto& chain : chains) {
    order.push_back({chain.second, chain.first});
  }
  std::sort(order.rbegin(), order.rend());
  order.resize(std::min(order.size(), kMostChains));

  std::vector<PrimitiveCode> out;
  const double half = std::ldexp(0.5, square.size_log2);
  const double cx = square.x_u + half;
  const double cy = square.y_u + half;
  for (const auto& [count, chain] : order) {
    const size_t before = out.size();
    for (const double scale : kWindowScales) {
      fit_window(chain, {cx, cy, half * scale}, square, out);
    }
    for (int quarter = 0; quarter < 4 && square.size_log2 >= kLeastQuartered;
         ++quarter) {
      fit_window(chain,
                 {cx + (quarter % 2 == 0 ? -0.5 : 0.5) * half,
                  cy + (quarter / 2 == 0 ? -0.5 : 0.5) * half, 0.5 * half},
                 square, out);
    }
    if (count != 0 && out.size() != before) {
      continue;
    }
    for (const int16_t number : points.corners) {
      const Corner& corner = corners[static_cast<size_t>(number)];
      if (corner.before == chain || corner.after == chain) {
        for (const double reach : kCornerWindows_u) {
          fit_window(chain, {corner.at.x, corner.at.y, reach}, square, out);
        }
      }
    }
  }
  for (const int16_t number : points.corners) {
    const Corner& corner = corners[static_cast<size_t>(number)];
    add_tangent(corner, corner.edge_before, square, out);
    add_tangent(corner, corner.edge_after, square, out);
  }
  // Wherever the distance is smooth, be it the distance to a corner, it is a
  // field if one looks closely enough.
  if (square.size_log2 <= kMostAnyLog2) {
    fit_window(kAnyChain, {cx, cy, half}, square, out);
  }
  return out;
}

// The line through a corner along an edge that begins or ends there.
void CandidateSource::add_tangent(const Corner& corner,
                                  uint32_t edge_number,
                                  const Square& square,
                                  std::vector<PrimitiveCode>& out) {
  const Edge& edge = source_.truth().shape().edges()[edge_number];
  const int half = 1 << square.size_log2 >> 1;
  PrimitiveFit fit;
  // The filled side is on the left of an edge.
  fit.angle = std::atan2(edge.b.x - edge.a.x, -(edge.b.y - edge.a.y));
  fit.d0 = std::cos(fit.angle) * (square.x_u + half - corner.at.x) +
           std::sin(fit.angle) * (square.y_u + half - corner.at.y);
  fit_points_.clear();
  fit_points_.push_back({corner.at.x - square.x_u - half,
                         corner.at.y - square.y_u - half, 0, -e0_u_, e0_u_});
  add_codes(fit, square, out);
}

// Fits a field to what is nearest to `chain` in a window, or to all there.
void CandidateSource::fit_window(int chain,
                                 const Window& window,
                                 const Square& square,
                                 std::vector<PrimitiveCode>& out) {
  const Grid& grid = source_.grid();
  const int x1 = grid.x0_u + (grid.tiles_x << grid.tile_log2);
  const int y1 = grid.y0_u + (grid.tiles_y << grid.tile_log2);
  const int half = 1 << square.size_log2 >> 1;
  const double step = 2 * window.half / kWindowSteps;
  fit_points_.clear();
  for (int j = 0; j <= kWindowSteps; ++j) {
    const int y =
        static_cast<int>(std::lround(window.y - window.half + step * j));
    if (y < grid.y0_u || y > y1) {
      continue;
    }
    for (int i = 0; i <= kWindowSteps; ++i) {
      const int x =
          static_cast<int>(std::lround(window.x - window.half + step * i));
      if (x < grid.x0_u || x > x1) {
        continue;
      }
      const TruthSample& sample = source_.truth().at(x, y);
      const bool wanted =
          chain == kAnyChain || (sample.chain == chain && sample.corner < 0);
      if (!wanted || std::fabs(sample.distance_u) > source_.metric().band_u()) {
        continue;
      }
      float low = 0;
      float high = 0;
      source_.allow(sample.distance_u, low, high);
      fit_points_.push_back({static_cast<double>(x - square.x_u - half),
                             static_cast<double>(y - square.y_u - half),
                             sample.distance_u, std::max<double>(low, -1e4),
                             std::min<double>(high, 1e4)});
    }
  }
  PrimitiveFit fit;
  if (fit_field(fit_points_, true, fit)) {
    add_codes(fit, square, out);
  }
}

// Quantises a fit in all ways that may do.
void CandidateSource::add_codes(const PrimitiveFit& fit,
                                const Square& square,
                                std::vector<PrimitiveCode>& out) {
  const double turn = fit.angle / (2 * kPi);
  const double quarters = std::round(turn * 4);
  if (std::fabs(turn * 4 - quarters) < kNearAxis) {
    const int axis = static_cast<int>(quarters) & 3;
    add_code(fit, PrimitiveKind::axis, axis, axis / 4.0, square, out);
    add_code(fit, PrimitiveKind::axis_arc, axis, axis / 4.0, square, out);
  }
  const int turn_steps = 1 << steps_.angle_bits(square.size_log2);
  const int angle =
      static_cast<int>(std::lround(turn * turn_steps)) & (turn_steps - 1);
  const double nearest = static_cast<double>(angle) / turn_steps;
  add_code(fit, PrimitiveKind::line, angle, nearest, square, out);
  add_code(fit, PrimitiveKind::arc, angle, nearest, square, out);
}

// With the angle given, the rest is fitted again; with the bend quantised, the
// distance is put into the middle of what passes.
void CandidateSource::add_code(const PrimitiveFit& fit,
                               PrimitiveKind kind,
                               int angle,
                               double turn,
                               const Square& square,
                               std::vector<PrimitiveCode>& out) {
  const int log2 = square.size_log2;
  PrimitiveFit fixed = fit;
  fixed.angle = turn * 2 * kPi;
  fit_at_angle(fit_points_, is_bent(kind), fixed);
  PrimitiveCode code;
  code.kind = kind;
  code.angle = static_cast<uint32_t>(angle);
  if (is_bent(kind)) {
    const double length =
        std::ldexp(1.0, PrimitiveSteps::bend_length_log2(log2));
    const double step_u = steps_.bend_step / 64.0;
    code.bend = std::clamp(
        static_cast<int>(std::lround(0.5 * fixed.k * length * length / step_u)),
        -steps_.most_bend(log2), steps_.most_bend(log2));
    if (code.bend == 0) {
      return;
    }
    const double k = 2 * code.bend * step_u / (length * length);
    const double nx = std::cos(fixed.angle);
    const double ny = std::sin(fixed.angle);
    double low = -1e9;
    double high = 1e9;
    for (const FitPoint& p : fit_points_) {
      const double v = nx * p.y - ny * p.x;
      const double rest = nx * p.x + ny * p.y + 0.5 * k * v * v;
      low = std::max(low, p.low - rest);
      high = std::min(high, p.high - rest);
    }
    fixed.d0 = 0.5 * (low + high);
  }
  code.d0 = steps_.quantised_d0(fixed.d0, log2);
  for (const PrimitiveCode& other : out) {
    if (same_code(other, code)) {
      return;
    }
  }
  out.push_back(code);
}

}  // namespace gen
}  // namespace inkcell
