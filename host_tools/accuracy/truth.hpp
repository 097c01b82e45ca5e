// The exact signed distance of a glyph, by brute force.
//
// The judge of the generator: it shares no source file with it. It loads the
// outline with FreeType itself, cuts curves into chords in its own way, finds
// the border of the filled area by asking for the winding number on both sides
// of every piece, and measures to those pieces. Islands and holes of next to no
// width, which contours leave that cross by accident, are no part of the area
// (docs/DESIGN.md).
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace inkcell::tools {

/// A position in u (1/1024 em), y up, origin on the baseline.
struct Vector {
  double x = 0;
  double y = 0;
};

/// Chords stay this close to their curves. [u] 1/8000 px at 64 px/em.
inline constexpr double kChordError = 0.002;

/// The filled area of one glyph under the non-zero rule.
class TrueGlyph {
 public:
  /// A straight piece of a contour.
  struct Chord {
    Vector a;
    Vector b;
  };

  /// Closed contours as chords, those of one curve after each other;
  /// `curve_ends[i]` is the number of chords up to the end of curve i.
  TrueGlyph(std::vector<Chord> chords, const std::vector<size_t>& curve_ends);

  /// Without ink.
  bool empty() const { return groups_.empty(); }

  Vector low() const { return low_; }  // corners of the ink box
  Vector high() const { return high_; }

  /// The border in pieces, the area to the left of each. [u]
  const std::vector<Chord>& border() const { return pieces_; }

  /// Distance to the border, positive inside, clamped to +-`limit`. [u]
  double distance(Vector p, double limit) const;

 private:
  friend class TrueTiles;

  // Consecutive chords or pieces of one curve, and the box around them.
  struct Group {
    size_t begin = 0;
    size_t end = 0;
    Vector low;
    Vector high;
  };

  int winding(Vector p) const;
  void find_curves(const std::vector<size_t>& curve_ends);
  void split(size_t index);
  void keep_border();
  void set_groups();
  void drop_slivers();
  bool is_filled(Vector p) const;

  std::vector<Chord> chords_;   // all, for the winding number
  std::vector<Chord> slivers_;  // borders that do not count, likewise
  std::vector<Group> curves_;   // of chords_
  std::vector<Chord> pieces_;   // the border
  std::vector<Group> groups_;   // of pieces_
  Vector low_;
  Vector high_;
};

/// The same distances at many points, cheaper.
///
/// The plane is divided into squares. A piece of the border that is nowhere
/// nearer to a square than the limit changes no clamped distance in it, so that
/// each square keeps a list of the others; where the list is empty, no border
/// passes, and the whole square is filled or not. A chord that lies above,
/// below or to the left of a square is met by no ray from it to the right.
/// Beyond the limit around the ink box nothing is. One thread at a time;
/// `glyph` must outlive it.
class TrueTiles {
 public:
  TrueTiles(const TrueGlyph& glyph, double limit);

  /// TrueGlyph::distance(p, limit). [u]
  double distance(Vector p);

 private:
  struct Tile {
    bool known = false;
    bool filled = false;  // if nothing is near
    std::vector<TrueGlyph::Chord> near;
    std::vector<TrueGlyph::Chord> passing;  // for the winding number
    std::vector<TrueGlyph::Chord> slivers;
  };

  void look(Vector low, Tile& tile) const;

  const TrueGlyph& glyph_;
  double limit_;
  double size_;  // of a square [u]
  Vector low_;   // corner of the first one
  size_t columns_ = 0;
  size_t rows_ = 0;
  std::vector<Tile> tiles_;  // row by row from below
};

/// A face of a font file.
class TrueFont {
 public:
  /// `axes` are settings of a variable font, such as "wght=600"; the others
  /// keep their defaults. Throws std::runtime_error.
  TrueFont(const std::filesystem::path& file,
           int face,
           const std::vector<std::string>& axes = {});
  ~TrueFont();
  TrueFont(const TrueFont&) = delete;
  TrueFont& operator=(const TrueFont&) = delete;

  /// Throws std::runtime_error if the font has no glyph for it. Any number of
  /// threads may call it.
  TrueGlyph glyph(char32_t code_point) const;

 private:
  struct Handles;

  [[noreturn]] void refuse(const std::string& text) const;
  void set_axes(const std::vector<std::string>& axes);

  std::string name_;  // of the file
  std::unique_ptr<Handles> handles_;
};

}  // namespace inkcell::tools
