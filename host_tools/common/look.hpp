// Styles of text: the options of programs that draw, and the style that they
// give.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "inkcell/bilevel.hpp"
#include "inkcell/edge_contrast.hpp"
#include "inkcell/field/circle_samples.hpp"
#include "inkcell/field/splat.hpp"
#include "inkcell/fit.hpp"
#include "inkcell/font.hpp"
#include "inkcell/lcd.hpp"
#include "inkcell/motion_blur.hpp"
#include "inkcell/stroke.hpp"
#include "inkcell/style.hpp"
#include "inkcell/supersample.hpp"

namespace inkcell::tools {

/// The defaults of options: text whose lines may change their length, still
/// text with the designed advances, or a frame of an animation.
enum class Use { text, still, moving };

/// The options of the command line; empty: the default of the use.
struct LookOptions {
  std::string filter;
  std::string hint;
  std::string samples;
  std::string rules = "none";
  std::string motion;  // "x,y" [px]
  double radius = 0;   // of adaptive sampling [px]; 0: the default
  double weight = 0;   // [px]
  double outline = 0;  // its width [px]; 0: none
  std::string place = "centred";
  int levels = 256;  // 2 and 4: of displays of 1 and 2 bits
  std::string lcd = "none";
  double lcd_colour = 1;  // share that is kept
};

void add_look_options(CLI::App& app, LookOptions& options);

/// Throws std::runtime_error if a radius was given, but nothing that was drawn
/// uses it.
void check_radius(const LookOptions& options, bool is_used);

/// Throws std::runtime_error if fitting was asked for, but everything to draw
/// is turned. `angle` names the cause.
void check_hint(const LookOptions& options,
                bool is_turned,
                const std::string& angle);

/// A style and all that it refers to. Must not move.
class Look {
 public:
  /// `px` px/em (rounded to 1/64), `angle` in degrees, counter-clockwise. The
  /// font must outlive the look. Throws std::runtime_error if an option makes
  /// no sense or the size is out of range.
  Look(const LookOptions& options,
       const Font& font,
       double px,
       double angle,
       Use use);
  Look(const Look&) = delete;
  Look& operator=(const Look&) = delete;

  const Style& style() const { return style_; }

  /// The channels of the picture: 3 with sub-pixels, else 1.
  int channels() const { return style_.effect() == &lcd_ ? 3 : 1; }

  /// Whether the style takes as many distances of cells as a pixel needs, and
  /// how many it has taken beyond one a pixel.
  bool counts_samples() const { return style_.effect() == &circle_samples_; }
  bool uses_radius() const {
    return counts_samples() || style_.effect() == &supersample_ ||
           style_.effect() == &splat_;
  }
  uint32_t more_samples() const { return more_samples_; }

  /// How far motion blur extends glyphs. [px]
  int blur_px() const { return blur_px_; }

 private:
  [[noreturn]] void refuse_pictures(const LookOptions& options,
                                    const Font& font,
                                    Use use) const;
  void require_reach(const LookOptions& options, const Font& font) const;
  static void require_area(const LookOptions& options, const Font& font);
  void set_effect(const LookOptions& options, const Font& font, Use use);
  void set_samples(const LookOptions& options, const Font& font, Use use);
  void set_rules(const LookOptions& options);
  void set_motion(const LookOptions& options);
  void set_levels(const LookOptions& options);
  void set_lcd(const LookOptions& options);
  void set_hint(const LookOptions& options, const Font& font, Use use);

  Stroke stroke_;  // without an outline both edges are the filter
  Style style_;
  Fit fit_;
  Bilevel bilevel_;
  Supersample supersample_;
  CircleSamples circle_samples_{kFilterText};
  std::vector<uint32_t> sums_;
  Splat splat_{{}};
  EdgeContrast edge_contrast_;
  MotionBlur blur_;
  int blur_px_ = 0;
  Lcd lcd_;
  uint32_t more_samples_ = 0;
};

}  // namespace inkcell::tools
