// Brute force: chords, their crossings, winding numbers, distances.
#include "truth.hpp"

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_MULTIPLE_MASTERS_H
#include FT_OUTLINE_H

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <stdexcept>
#include <string>
#include <utility>

#include "slivers.hpp"

namespace inkcell::tools {
namespace {

using Chord = TrueGlyph::Chord;

// FreeType halves sums of coordinates where points of the curve are implied;
// with this many more bits nothing is lost.
constexpr int kShift = 6;

// How far beside a piece the winding number is asked for. [u]
constexpr double kBeside = 1e-7;

// Width of a square of TrueTiles in limits.
constexpr double kTileLimits = 2;

Vector operator+(Vector a, Vector b) {
  return {a.x + b.x, a.y + b.y};
}
Vector operator-(Vector a, Vector b) {
  return {a.x - b.x, a.y - b.y};
}
Vector operator*(double s, Vector v) {
  return {s * v.x, s * v.y};
}
double dot(Vector a, Vector b) {
  return a.x * b.x + a.y * b.y;
}
double cross(Vector a, Vector b) {
  return a.x * b.y - a.y * b.x;
}
double length(Vector v) {
  return std::hypot(v.x, v.y);
}

double squared_distance(Vector p, const Chord& chord) {
  const Vector along = chord.b - chord.a;
  const Vector to_p = p - chord.a;
  const double t = std::clamp(dot(to_p, along) / dot(along, along), 0.0, 1.0);
  const Vector off = to_p - t * along;
  return dot(off, off);
}

void stretch(Vector& low, Vector& high, Vector p) {
  low = {std::min(low.x, p.x), std::min(low.y, p.y)};
  high = {std::max(high.x, p.x), std::max(high.y, p.y)};
}

// Collects chords from FreeType's walk over an outline.
struct Collector {
  double scale;  // u per unit of the walk
  std::vector<Chord> chords;
  std::vector<size_t> curve_ends;
  Vector start;
  Vector at;

  Vector point(const FT_Vector* v) const {
    return {scale * static_cast<double>(v->x),
            scale * static_cast<double>(v->y)};
  }

  void chord_to(Vector end) {
    if (length(end - at) > 1e-9) {
      chords.push_back({at, end});
      at = end;
    }
  }

  void end_curve() { curve_ends.push_back(chords.size()); }

  void close() {
    chord_to(start);
    end_curve();
  }

  // A chord over a step h of the parameter is off by at most |B''| h^2 / 8.
  static int steps(double second_derivative) {
    return 1 + static_cast<int>(
                   std::ceil(std::sqrt(second_derivative / (8 * kChordError))));
  }

  void conic(Vector control, Vector end) {
    const Vector begin = at;
    const int n = steps(2 * length(begin - 2 * control + end));
    for (int i = 1; i <= n; ++i) {
      const double t = static_cast<double>(i) / n;
      const Vector one = begin + t * (control - begin);
      const Vector two = control + t * (end - control);
      chord_to(i == n ? end : one + t * (two - one));
    }
    end_curve();
  }

  void cubic(Vector first, Vector second, Vector end) {
    const Vector begin = at;
    const int n = steps(6 * std::max(length(begin - 2 * first + second),
                                     length(first - 2 * second + end)));
    for (int i = 1; i <= n; ++i) {
      const double t = static_cast<double>(i) / n;
      const double s = 1 - t;
      chord_to(i == n ? end
                      : (s * s * s) * begin + (3 * s * s * t) * first +
                            (3 * s * t * t) * second + (t * t * t) * end);
    }
    end_curve();
  }
};

int move_to(const FT_Vector* to, void* user) {
  Collector& out = *static_cast<Collector*>(user);
  if (!out.chords.empty()) {
    out.close();
  }
  out.start = out.at = out.point(to);
  return 0;
}

int line_to(const FT_Vector* to, void* user) {
  Collector& out = *static_cast<Collector*>(user);
  out.chord_to(out.point(to));
  out.end_curve();
  return 0;
}

int conic_to(const FT_Vector* control, const FT_Vector* to, void* user) {
  Collector& out = *static_cast<Collector*>(user);
  out.conic(out.point(control), out.point(to));
  return 0;
}

int cubic_to(const FT_Vector* first,
             const FT_Vector* second,
             const FT_Vector* to,
             void* user) {
  Collector& out = *static_cast<Collector*>(user);
  out.cubic(out.point(first), out.point(second), out.point(to));
  return 0;
}

bool boxes_meet(const Chord& a, const Chord& b) {
  return std::min(a.a.x, a.b.x) <= std::max(b.a.x, b.b.x) &&
         std::min(b.a.x, b.b.x) <= std::max(a.a.x, a.b.x) &&
         std::min(a.a.y, a.b.y) <= std::max(b.a.y, b.b.y) &&
         std::min(b.a.y, b.b.y) <= std::max(a.a.y, a.b.y);
}

// Adds to `cuts` where, as a part of `chord`, the other one meets it: at one
// point, or - along the same line - at its ends.
void find_cuts(const Chord& chord,
               const Chord& other,
               std::vector<double>& cuts) {
  const Vector r = chord.b - chord.a;
  const Vector s = other.b - other.a;
  const double denominator = cross(r, s);
  const Vector between = other.a - chord.a;
  if (std::fabs(denominator) > 1e-12 * length(r) * length(s)) {
    const double t = cross(between, s) / denominator;
    const double u = cross(between, r) / denominator;
    if (u >= -1e-9 && u <= 1 + 1e-9) {
      cuts.push_back(t);
    }
    return;
  }
  cuts.push_back(dot(between, r) / dot(r, r));
  cuts.push_back(dot(other.b - chord.a, r) / dot(r, r));
}

// +1 if `chord` passes a ray to the right of `p` upwards, -1 if downwards.
int passes(const Chord& chord, Vector p) {
  if ((chord.a.y <= p.y) == (chord.b.y <= p.y)) {
    return 0;
  }
  const double side = cross(chord.b - chord.a, p - chord.a);
  const bool upwards = chord.b.y > chord.a.y;
  if (upwards ? side > 0 : side < 0) {
    return upwards ? 1 : -1;
  }
  return 0;
}

// Reads "wght=600" for `axis`; whether it is about it and within its range.
bool read_axis(const std::string& setting,
               const FT_Var_Axis& axis,
               FT_Fixed& out) {
  std::string tag;
  for (int shift = 24; shift >= 0; shift -= 8) {
    tag += static_cast<char>(axis.tag >> shift & 0xff);
  }
  const size_t equals = setting.find('=');
  std::string wanted = setting.substr(0, equals);
  wanted.resize(4, ' ');
  if (equals == std::string::npos || equals > 4 || wanted != tag) {
    return false;
  }
  const char* digits = setting.c_str() + equals + 1;
  char* end = nullptr;
  const double value = std::strtod(digits, &end) * 65536;
  if (end == digits || *end != '\0' ||
      !(value >= static_cast<double>(axis.minimum) &&
        value <= static_cast<double>(axis.maximum))) {
    return false;
  }
  out = std::lround(value);
  return true;
}

}  // namespace

TrueGlyph::TrueGlyph(std::vector<Chord> chords,
                     const std::vector<size_t>& curve_ends)
    : chords_(std::move(chords)) {
  find_curves(curve_ends);
  for (const Group& curve : curves_) {
    const size_t begin = pieces_.size();
    for (size_t i = curve.begin; i < curve.end; ++i) {
      split(i);
    }
    groups_.push_back({begin, pieces_.size(), {}, {}});
  }
  keep_border();
}

void TrueGlyph::find_curves(const std::vector<size_t>& curve_ends) {
  size_t begin = 0;
  for (const size_t end : curve_ends) {
    if (end > begin) {
      Group curve{begin, end, chords_[begin].a, chords_[begin].a};
      for (size_t i = begin; i < end; ++i) {
        stretch(curve.low, curve.high, chords_[i].a);
        stretch(curve.low, curve.high, chords_[i].b);
      }
      curves_.push_back(curve);
    }
    begin = end;
  }
}

// Cuts a chord where others cross it, so that each piece is border or not as a
// whole. Curves whose boxes lie apart are not compared.
void TrueGlyph::split(size_t index) {
  const Chord chord = chords_[index];
  std::vector<double> cuts = {0, 1};
  for (const Group& other : curves_) {
    if (!boxes_meet(chord, {other.low, other.high})) {
      continue;
    }
    for (size_t i = other.begin; i < other.end; ++i) {
      if (i != index && boxes_meet(chord, chords_[i])) {
        find_cuts(chord, chords_[i], cuts);
      }
    }
  }
  std::sort(cuts.begin(), cuts.end());
  const Vector along = chord.b - chord.a;
  for (size_t i = 1; i < cuts.size(); ++i) {
    const double t0 = std::clamp(cuts[i - 1], 0.0, 1.0);
    const double t1 = std::clamp(cuts[i], 0.0, 1.0);
    if ((t1 - t0) * length(along) > 1e-7) {
      pieces_.push_back({chord.a + t0 * along, chord.a + t1 * along});
    }
  }
}

// Drops the pieces with the same filling on both sides. The area lies to the
// left of those that are kept.
void TrueGlyph::keep_border() {
  for (Group& group : groups_) {
    size_t kept = group.begin;
    for (size_t i = group.begin; i < group.end; ++i) {
      const Chord piece = pieces_[i];
      const Vector along = piece.b - piece.a;
      const double step = kBeside / length(along);
      const Vector side = {-along.y * step, along.x * step};
      const Vector middle = 0.5 * (piece.a + piece.b);
      const bool left = winding(middle + side) != 0;
      if (left != (winding(middle - side) != 0)) {
        pieces_[kept++] = left ? piece : Chord{piece.b, piece.a};
      }
    }
    group.end = kept;
  }
  drop_slivers();
}

// Keeps what is left of each group, and finds the boxes.
void TrueGlyph::set_groups() {
  std::vector<Chord> border;
  std::vector<Group> groups;
  for (const Group& group : groups_) {
    Group kept{border.size(), 0, {}, {}};
    border.insert(border.end(),
                  pieces_.begin() + static_cast<std::ptrdiff_t>(group.begin),
                  pieces_.begin() + static_cast<std::ptrdiff_t>(group.end));
    kept.end = border.size();
    if (kept.end > kept.begin) {
      kept.low = kept.high = border[kept.begin].a;
      for (size_t i = kept.begin; i < kept.end; ++i) {
        stretch(kept.low, kept.high, border[i].a);
        stretch(kept.low, kept.high, border[i].b);
      }
      groups.push_back(kept);
    }
  }
  pieces_ = std::move(border);
  groups_ = std::move(groups);
  if (!groups_.empty()) {
    low_ = groups_.front().low;
    high_ = groups_.front().high;
    for (const Group& group : groups_) {
      stretch(low_, high_, group.low);
      stretch(low_, high_, group.high);
    }
  }
}

// Where an island is taken away and the hole beside it is filled, the piece
// between them stays, and the area lies on its other side.
void TrueGlyph::drop_slivers() {
  set_groups();
  const std::vector<uint8_t> slivers = find_slivers(pieces_);
  for (Group& group : groups_) {
    size_t kept = group.begin;
    for (size_t i = group.begin; i < group.end; ++i) {
      const Chord piece = pieces_[i];
      slivers_.insert(slivers_.end(), slivers[i], piece);
      if (slivers[i] != 1) {
        pieces_[kept++] = slivers[i] == 0 ? piece : Chord{piece.b, piece.a};
      }
    }
    group.end = kept;
  }
  set_groups();
}

// Counts how often contours pass a ray to the right of `p`, upwards less
// downwards.
int TrueGlyph::winding(Vector p) const {
  int turns = 0;
  for (const Group& curve : curves_) {
    if (p.y < curve.low.y || p.y > curve.high.y || p.x > curve.high.x) {
      continue;
    }
    for (size_t i = curve.begin; i < curve.end; ++i) {
      turns += passes(chords_[i], p);
    }
  }
  return turns;
}

// Inside a sliver is what lies around it.
bool TrueGlyph::is_filled(Vector p) const {
  int turns = 0;
  for (const Chord& sliver : slivers_) {
    turns += passes(sliver, p);
  }
  return (winding(p) != 0) != (turns != 0);
}

double TrueGlyph::distance(Vector p, double limit) const {
  double best = limit * limit;
  for (const Chord& piece : pieces_) {
    best = std::min(best, squared_distance(p, piece));
  }
  const double distance = std::sqrt(best);
  return is_filled(p) ? distance : -distance;
}

TrueTiles::TrueTiles(const TrueGlyph& glyph, double limit)
    : glyph_(glyph),
      limit_(limit),
      size_(kTileLimits * limit),
      low_(glyph.low() - Vector{limit, limit}) {
  const Vector extent = glyph.high() + Vector{limit, limit} - low_;
  columns_ = static_cast<size_t>(extent.x / size_) + 1;
  rows_ = static_cast<size_t>(extent.y / size_) + 1;
  tiles_.resize(glyph.empty() ? 0 : columns_ * rows_);
}

double TrueTiles::distance(Vector p) {
  const Vector at = {(p.x - low_.x) / size_, (p.y - low_.y) / size_};
  const bool within = at.x >= 0 && at.y >= 0 &&
                      at.x < static_cast<double>(columns_) &&
                      at.y < static_cast<double>(rows_);
  if (!within || tiles_.empty()) {
    return -limit_;
  }
  const auto column = static_cast<size_t>(at.x);
  const auto row = static_cast<size_t>(at.y);
  Tile& tile = tiles_[row * columns_ + column];
  if (!tile.known) {
    look(low_ + size_ * Vector{static_cast<double>(column),
                               static_cast<double>(row)},
         tile);
  }
  if (tile.near.empty()) {
    return tile.filled ? limit_ : -limit_;
  }
  double best = limit_ * limit_;
  for (const Chord& piece : tile.near) {
    best = std::min(best, squared_distance(p, piece));
  }
  const double distance = std::sqrt(best);
  int turns = 0;
  for (const Chord& chord : tile.passing) {
    turns += passes(chord, p);
  }
  int sliver_turns = 0;
  for (const Chord& sliver : tile.slivers) {
    sliver_turns += passes(sliver, p);
  }
  return (turns != 0) != (sliver_turns != 0) ? distance : -distance;
}

void TrueTiles::look(Vector low, Tile& tile) const {
  tile.known = true;
  // A little more, so that rounding drops nothing.
  const double reach = limit_ + kBeside;
  const Chord around = {low - Vector{reach, reach},
                        low + Vector{size_ + reach, size_ + reach}};
  for (const TrueGlyph::Group& group : glyph_.groups_) {
    if (!boxes_meet(around, {group.low, group.high})) {
      continue;
    }
    for (size_t i = group.begin; i < group.end; ++i) {
      if (boxes_meet(around, glyph_.pieces_[i])) {
        tile.near.push_back(glyph_.pieces_[i]);
      }
    }
  }
  if (tile.near.empty()) {
    tile.filled = glyph_.is_filled(low + Vector{size_ / 2, size_ / 2});
    return;
  }
  constexpr double kFar = 1e9;
  const Chord to_the_right = {low - Vector{kBeside, kBeside},
                              {kFar, low.y + size_ + kBeside}};
  for (const Chord& chord : glyph_.chords_) {
    if (boxes_meet(to_the_right, chord)) {
      tile.passing.push_back(chord);
    }
  }
  for (const Chord& sliver : glyph_.slivers_) {
    if (boxes_meet(to_the_right, sliver)) {
      tile.slivers.push_back(sliver);
    }
  }
}

struct TrueFont::Handles {
  FT_Library library = nullptr;
  FT_Face face = nullptr;
  std::mutex guard;  // FreeType loads one glyph at a time

  ~Handles() {
    FT_Done_Face(face);
    FT_Done_FreeType(library);
  }
};

TrueFont::TrueFont(const std::filesystem::path& file,
                   int face,
                   const std::vector<std::string>& axes)
    : name_(file.string()), handles_(std::make_unique<Handles>()) {
  if (FT_Init_FreeType(&handles_->library) != 0 ||
      FT_New_Face(handles_->library, file.c_str(), face, &handles_->face) !=
          0 ||
      !FT_IS_SCALABLE(handles_->face)) {
    refuse("no outlines can be read; check the file and --face");
  }
  if (handles_->face->charmap == nullptr) {
    FT_Select_Charmap(handles_->face, FT_ENCODING_MS_SYMBOL);
  }
  if (!axes.empty()) {
    set_axes(axes);
  }
}

TrueFont::~TrueFont() = default;

void TrueFont::refuse(const std::string& text) const {
  throw std::runtime_error(name_ + ": " + text);
}

void TrueFont::set_axes(const std::vector<std::string>& axes) {
  FT_MM_Var* known = nullptr;
  if (FT_Get_MM_Var(handles_->face, &known) != 0) {
    refuse("is not a variable font: leave out --axis");
  }
  std::vector<FT_Fixed> values;
  size_t found = 0;
  for (FT_UInt i = 0; i < known->num_axis; ++i) {
    values.push_back(known->axis[i].def);
    for (const std::string& setting : axes) {
      found += read_axis(setting, known->axis[i], values.back()) ? 1u : 0u;
    }
  }
  FT_Done_MM_Var(handles_->library, known);
  if (found < axes.size() ||
      FT_Set_Var_Design_Coordinates(handles_->face,
                                    static_cast<FT_UInt>(values.size()),
                                    values.data()) != 0) {
    refuse("has no such --axis; give those that inkcell-fontgen was given");
  }
}

TrueGlyph TrueFont::glyph(char32_t code_point) const {
  FT_Face face = handles_->face;
  Collector out{1024.0 / (face->units_per_EM << kShift), {}, {}, {}, {}};
  {
    const std::lock_guard<std::mutex> lock(handles_->guard);
    FT_UInt index = FT_Get_Char_Index(face, code_point);
    if (index == 0 && code_point < 0x100 && face->charmap != nullptr &&
        face->charmap->encoding == FT_ENCODING_MS_SYMBOL) {
      index = FT_Get_Char_Index(face, 0xf000 + code_point);
    }
    if (index == 0 ||
        FT_Load_Glyph(face, index, FT_LOAD_NO_SCALE | FT_LOAD_NO_HINTING)) {
      char name[16];
      std::snprintf(name, sizeof name, "U+%04X",
                    static_cast<unsigned>(code_point));
      refuse("has no glyph for " + std::string(name) +
             "; name the file and the --face that the font was made of");
    }
    const FT_Outline_Funcs walk = {move_to,  line_to, conic_to,
                                   cubic_to, kShift,  0};
    if (FT_Outline_Decompose(&face->glyph->outline, &walk, &out) != 0) {
      refuse("has a broken outline");
    }
  }
  out.close();
  return TrueGlyph(std::move(out.chords), out.curve_ends);
}

}  // namespace inkcell::tools
