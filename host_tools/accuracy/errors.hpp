// Statistics of pixel errors: of a glyph at one size, and of all glyphs.
#pragma once

#include <cstdint>
#include <vector>

namespace inkcell::tools {

/// The sub-pixel position of a glyph's origin. [1/64 px]
struct Offset {
  int x = 0;
  int y = 0;
};

/// The place of an error.
struct ErrorPlace {
  char32_t code_point = 0;
  Offset offset;
  int x = 0;  // of the pixel, relative to the glyph's origin, y down
  int y = 0;
  int drawn = 0;     // [1/255]
  double exact = 0;  // [1/255]

  double error() const;
};

/// Errors of one glyph at one size, for all offsets.
class GlyphErrors {
 public:
  /// Adds a pixel that should be `place.exact` and is `place.drawn`. `in_box`:
  /// it counts for the mean.
  void add(const ErrorPlace& place, bool in_box);

  double worst() const { return worst_; }
  const ErrorPlace& worst_place() const { return worst_place_; }

  /// Over the pixels of the glyph's box; 0 if none was added.
  double mean() const;
  int64_t pixels() const { return box_pixels_; }

 private:
  double worst_ = -1;  // none yet
  ErrorPlace worst_place_;
  double box_sum_ = 0;
  int64_t box_pixels_ = 0;
};

/// Errors of many glyphs, at one size or at several.
class ErrorSummary {
 public:
  void add(const GlyphErrors& errors);

  /// Adds the errors of another summary.
  void add(const ErrorSummary& other);

  /// The error of the worst pixel; of equal ones the first.
  double worst() const { return worst_place_.error(); }
  const ErrorPlace& worst_place() const { return worst_place_; }

  /// The largest mean of a glyph at one size, and that glyph's character.
  double worst_mean() const { return worst_mean_; }
  char32_t worst_mean_character() const { return worst_mean_character_; }

  /// The mean of the glyphs' means: each glyph with ink has the same weight.
  double mean() const;

 private:
  ErrorPlace worst_place_;
  double worst_mean_ = 0;
  char32_t worst_mean_character_ = 0;
  double mean_sum_ = 0;
  int64_t glyphs_ = 0;
};

}  // namespace inkcell::tools
