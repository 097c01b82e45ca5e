// Makes styles from options.
#include "look.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "canvas.hpp"
#include "filters.hpp"
#include "inkcell/few_levels.hpp"
#include "inkcell/shadow.hpp"
#include "rom_file.hpp"

namespace inkcell::tools {
namespace {

// Smaller text is better with several samples a pixel.
constexpr Q26_6 kLeastForOne = Q26_6::from_int(10);

// The most sums of splats: larger glyphs are drawn in parts.
constexpr size_t kMaxSums = 1 << 16;

// The filter for exact area, which is not a function of distance.
constexpr const char* kArea = "area";

const Filter& filter_for(const std::string& name, Use use) {
  if (name == kArea) {
    return kFilterText;  // what advances and boxes are taken from
  }
  if (name.empty()) {
    return use == Use::moving ? kFilterMotion : kFilterText;
  }
  return filter_of(name);
}

StrokePlace place_of(const std::string& name) {
  return name == "inner"   ? StrokePlace::inner
         : name == "outer" ? StrokePlace::outer
                           : StrokePlace::centred;
}

SubPixels order_of(const std::string& name) {
  return name == "bgr"            ? SubPixels::bgr
         : name == "rgb_vertical" ? SubPixels::rgb_vertical
         : name == "bgr_vertical" ? SubPixels::bgr_vertical
                                  : SubPixels::rgb;
}

Q6_10 to_q10(double px) {
  return Q6_10::from_raw(static_cast<int16_t>(std::lround(px * 1024)));
}

// CLI::Range lets "nan" pass.
CLI::Validator within(double low, double high) {
  return CLI::Range(low, high) &
         CLI::Validator(
             [](std::string& text) {
               return std::isnan(std::atof(text.c_str()))
                          ? text + " is no number"
                          : std::string();
             },
             "");
}

// An option with a few words as values.
void add_words(CLI::App& app,
               const std::string& option,
               std::string& target,
               const std::vector<std::string>& words,
               const std::string& help) {
  app.add_option(option, target, help)
      ->check(CLI::IsMember(words).description(""))
      ->type_name(CLI::detail::join(words, "|"))
      ->default_str(target);
}

// Whether the display's canvas decides.
bool is_as_display(const LookOptions& options) {
  return options.hint == "display" && options.levels != 256;
}

// Defaults for text are those of the library; those of jobs depend on their
// kind.
LookOptions fill_in(LookOptions options, Use use) {
  const bool is_text = use == Use::text;
  if (options.hint.empty()) {
    options.hint = is_text ? "none" : "auto";
  }
  if (options.samples.empty()) {
    options.samples = is_text ? "one" : "auto";
  }
  return options;
}

// A strike alone: pictures, which take neither filters, effects nor fitting.
bool has_pictures(const Font& font) {
  return coding_name(font) == "strike";
}

}  // namespace

void add_look_options(CLI::App& app, LookOptions& options) {
  app.add_option("--filter", options.filter,
                 "text, motion, paper_display or paper_body, of distance, not "
                 "with --levels 2; area, exact, for --coding outline [text; "
                 "motion for jobs of kind anim]")
      ->type_name("NAME");
  add_words(app, "--hint", options.hint,
            {"none", "vertical", "both", "auto", "display"},
            "Fit upright text of outlines to the pixel grid: none; vertical, "
            "heights; both, stems and advances too; auto, both below 12 px "
            "and with --levels 2 and 4, but in --jobs, and else vertical; "
            "nothing of jobs of kind anim; display, as canvases of 1 and 2 "
            "bits do by themselves, with --levels 2 and 4, and else none "
            "[none; auto with --jobs]");
  add_words(
      app, "--samples", options.samples,
      {"one", "adaptive", "paper", "splats", "auto"},
      "Samples a pixel: one; adaptive, five of outlines, up to 13 of cells "
      "where one is not accurate enough; paper, as the paper has it; splats, "
      "cells smaller than a pixel once each; both for --coding field; "
      "auto, one, but of cells adaptive below 10 px and for jobs of kind "
      "anim [one; auto with --jobs]");
  app.add_option("--radius", options.radius,
                 "Of the filter over several samples [px; 0.85, 0.75 for jobs "
                 "of kind anim, 1.3 for paper and splats]")
      ->check(within(0.25, 1.5));
  add_words(app, "--rules", options.rules, {"none", "edges", "thin", "all"},
            "Contrast as eyes prefer it, with one sample a pixel: edges, "
            "darker on the left and below; thin, thin strokes darker; all");
  app.add_option("--motion", options.motion,
                 "Blur by a movement of X,Y while the shutter is open [px]")
      ->type_name("X,Y");
  app.add_option("--weight", options.weight,
                 "Move edges outwards, strokes gain twice that; with --levels "
                 "up to 0.5 [px]")
      ->check(within(-2.0, 2.0));
  app.add_option("--outline", options.outline,
                 "Draw outlines of this width, in place of the inside [px]")
      ->check(within(0.0, 4.0));
  add_words(app, "--outline-place", options.place,
            {"inner", "centred", "outer"}, "Where they lie");
  app.add_option("--levels", options.levels,
                 "Draw for displays of 2 or 4 levels, without broken strokes")
      ->check(CLI::IsMember({2, 4, 256}).description(""))
      ->type_name("2|4|256")
      ->capture_default_str();
  add_words(app, "--lcd", options.lcd,
            {"none", "rgb", "bgr", "rgb_vertical", "bgr_vertical"},
            "Draw for coloured stripes, from left to right or (vertical) from "
            "top to bottom; the picture is a PNG or PPM in colour");
  app.add_option("--lcd-colour", options.lcd_colour,
                 "How much of the stripes' colour is kept: 0 is grey")
      ->check(within(0.0, 1.0))
      ->capture_default_str();
}

void check_radius(const LookOptions& options, bool is_used) {
  if (options.radius > 0 && !is_used) {
    throw std::runtime_error(
        "--radius is for several samples a pixel: --samples adaptive, paper or "
        "splats");
  }
}

void check_hint(const LookOptions& options,
                bool is_turned,
                const std::string& angle) {
  const bool is_asked = options.hint == "vertical" || options.hint == "both";
  if (is_asked && is_turned) {
    throw std::runtime_error("--hint " + options.hint +
                             " fits upright text only, and " + angle +
                             " turns it; leave out one of the two");
  }
}

Look::Look(const LookOptions& asked,
           const Font& font,
           double px,
           double angle,
           Use use)
    : stroke_(with_weight(filter_for(asked.filter, use), to_q10(asked.weight)),
              to_q10(asked.outline),
              place_of(asked.place)),
      style_(make_style(px, angle, stroke_.outer)) {
  const LookOptions options = fill_in(asked, use);
  if (!has_pictures(font)) {
    require_reach(options, font);
  }
  const bool is_plain = options.filter.empty() && options.weight == 0;
  if (options.filter == kArea) {
    require_area(options, font);
    style_ = make_style(px, angle, kFilterArea);
  } else if (is_plain && (is_as_display(options) || has_pictures(font))) {
    style_ = make_style(px, angle, kFilterArea);  // the default of styles
  }
  set_effect(options, font, use);
  if (has_pictures(font) && font.check(style_) != Status::ok) {
    refuse_pictures(options, font, use);
  }
  if (font.check(style_) != Status::ok) {
    throw std::runtime_error(
        "--samples paper and splats draw cells, and this font has outlines: "
        "use --samples adaptive, or make it by inkcell-fontgen --coding "
        "field");
  }
  set_hint(options, font, use);
}

void Look::refuse_pictures(const LookOptions& options,
                           const Font& font,
                           Use use) const {
  const bool is_text = use == Use::text;
  const std::string px = std::to_string(font.range().min_px);
  const int32_t step = Q26_6::from_int(font.range().min_px).raw;
  std::string size;
  if (step == 0 || style_.size().raw % step != 0) {
    size = std::string("take ") + (is_text ? "--px " : "size ") + px +
           " or a multiple";
  }
  const struct {
    bool is_given;
    const char* name;
  } others[] = {
      {!style_.is_upright(), is_text ? "--angle" : "angle"},
      {!options.filter.empty() && options.filter != kArea, "--filter"},
      {options.weight != 0, "--weight"},
      {options.outline != 0, "--outline"},
      {options.lcd != "none", "--lcd"},
      {!options.motion.empty(), "--motion"},
      {options.rules != "none", "--rules"},
      {options.samples != "one" && options.samples != "auto", "--samples"}};
  std::string rest;
  for (const auto& other : others) {
    if (other.is_given) {
      rest += (rest.empty() ? "leave out " : ", ") + std::string(other.name);
    }
  }
  throw std::runtime_error("this font has pictures of " + px +
                           " px alone: " + size +
                           (size.empty() || rest.empty() ? "" : "; ") + rest);
}

void Look::require_reach(const LookOptions& options, const Font& font) const {
  // Filters as they are reach what fonts are made for; with two levels only
  // distances close to the edge count.
  const bool reaches =
      (options.weight == 0 && options.outline == 0) || options.levels == 2;
  for (const Filter* edge : {&stroke_.outer, &stroke_.inner}) {
    if (!reaches &&
        check_reach(font.range(), style_.size(), *edge) != Status::ok) {
      throw std::runtime_error(
          "at this size the font's distances do not reach as far as --weight "
          "and --outline: draw it larger, or give the font a --band-px");
    }
  }
}

void Look::require_area(const LookOptions& options, const Font& font) {
  if (coding_name(font) == "field") {
    throw std::runtime_error(
        "--filter area draws outlines, and this font has cells: make it by "
        "inkcell-fontgen --coding outline");
  }
  const bool has_levels =
      options.levels != 256 && !is_as_display(options) && !has_pictures(font);
  if (options.weight != 0 || options.outline != 0 || has_levels ||
      options.lcd != "none") {
    throw std::runtime_error(
        "--filter area is exact coverage; --weight, --outline, --levels and "
        "--lcd take a filter of distance, such as text");
  }
}

void Look::set_effect(const LookOptions& options, const Font& font, Use use) {
  const int effects =
      (options.outline != 0 ? 1 : 0) + (options.levels != 256 ? 1 : 0) +
      (options.lcd == "none" ? 0 : 1) + (options.motion.empty() ? 0 : 1) +
      (options.rules == "none" ? 0 : 1) +
      (options.samples == "auto" || options.samples == "one" ? 0 : 1);
  if (effects > 1) {
    throw std::runtime_error(
        "--outline, --levels, --lcd, --motion, --rules and --samples exclude "
        "each other");
  }
  if (options.lcd == "none" && options.lcd_colour != 1) {
    throw std::runtime_error("--lcd-colour is for --lcd");
  }
  if (options.outline == 0 && options.place != LookOptions().place) {
    throw std::runtime_error("--outline-place is for --outline");
  }
  if (options.outline != 0) {
    style_.set_effect(stroke_);
  } else if (options.levels != 256 && !has_pictures(font)) {
    set_levels(options);
  } else if (options.lcd != "none") {
    set_lcd(options);
  } else if (!options.motion.empty()) {
    set_motion(options);
  } else if (options.rules != "none") {
    set_rules(options);
  } else {
    set_samples(options, font, use);
  }
}

void Look::set_samples(const LookOptions& options, const Font& font, Use use) {
  if (options.samples == "one" ||
      (options.samples == "auto" &&
       (font.has_outlines() || has_pictures(font) ||
        (use != Use::moving && style_.size().raw >= kLeastForOne.raw)))) {
    return;
  }
  const bool is_paper = options.samples == "paper";
  const bool is_splats = options.samples == "splats";
  Q6_10 radius = is_paper || is_splats ? kPaperRadius
                 : use == Use::moving  ? kCalmRadius
                                       : kSharpRadius;
  if (options.radius > 0) {
    radius = to_q10(options.radius);
  }
  if (is_splats) {
    sums_.resize(kMaxSums);
    splat_ = Splat(Span<uint32_t>(sums_.data(), sums_.size()), radius);
    if (splat_.radius_q10 != radius.raw) {
      throw std::runtime_error("--samples splats: --radius is 0.75 to 1.5 px");
    }
    style_.set_effect(splat_);
    return;
  }
  if (font.has_outlines() && !is_paper) {
    supersample_ = Supersample(radius);
    style_.set_effect(supersample_);
    return;
  }
  circle_samples_ = CircleSamples(
      style_.filter(), radius, is_paper ? SampleRule::paper : SampleRule::even);
  circle_samples_.more_samples = &more_samples_;
  style_.set_effect(circle_samples_);
}

void Look::set_levels(const LookOptions& options) {
  constexpr double kMostWeight = 0.5;  // of Bilevel::threshold_px
  if (std::abs(options.weight) > kMostWeight) {
    throw std::runtime_error("--levels takes a --weight of -0.5 to 0.5 px");
  }
  if (options.levels == 2 && !options.filter.empty()) {
    throw std::runtime_error(
        "--levels 2 draws without greys, where --filter changes nothing; leave "
        "out --filter, or use --levels 4");
  }
  if (is_as_display(options)) {
    const auto& rule = options.levels == 2 ? inkcell::detail::kTwoLevelRule
                                           : inkcell::detail::kFourLevelRule;
    Style adapted;
    style_ = rule.adapt(rule, style_, true, adapted);
    return;
  }
  bilevel_ =
      Bilevel(static_cast<uint8_t>(options.levels), to_q10(-options.weight));
  style_.set_effect(bilevel_);
}

void Look::set_lcd(const LookOptions& options) {
  lcd_.order = order_of(options.lcd);
  lcd_.colour = static_cast<uint8_t>(std::lround(255 * options.lcd_colour));
  style_.set_effect(lcd_);
}

void Look::set_rules(const LookOptions& options) {
  edge_contrast_.edge = options.rules == "thin" ? 0 : edge_contrast_.edge;
  edge_contrast_.thin = options.rules == "edges" ? 0 : edge_contrast_.thin;
  style_.set_effect(edge_contrast_);
}

void Look::set_motion(const LookOptions& options) {
  std::istringstream in(options.motion);
  double x = 0;
  double y = 0;
  char comma = 0;
  constexpr double kMost = 32;
  if (!(in >> x >> comma >> y) || comma != ',' || !in.eof() ||
      !(std::abs(x) <= kMost) || !(std::abs(y) <= kMost)) {
    throw std::runtime_error("--motion takes X,Y, up to 32 px each");
  }
  blur_ = MotionBlur(make_point(x, y));
  blur_px_ = static_cast<int>(std::max(std::abs(x), std::abs(y)) / 2) + 1;
  style_.set_effect(blur_);
}

void Look::set_hint(const LookOptions& options, const Font& font, Use use) {
  const bool is_auto = options.hint == "auto";
  if (options.hint == "none" || options.hint == "display" ||
      (is_auto && use == Use::moving)) {
    return;
  }
  if (!font.has_outlines()) {
    if (!is_auto) {
      throw std::runtime_error(
          "--hint " + options.hint + " moves points of outlines, and this " +
          (has_pictures(font) ? "font has pictures: leave it out"
                              : "font has cells: make it by inkcell-fontgen "
                                "--coding outline"));
    }
    return;
  }
  // At 12 px both read alike, and lines keep their length.
  constexpr Q26_6 kAcrossBelow = Q26_6::from_int(12);
  FitOptions fit;
  fit.across =
      options.hint == "both" ||
      (is_auto && use == Use::text &&
       (options.levels != 256 || style_.size().raw < kAcrossBelow.raw));
  fit.levels = static_cast<uint8_t>(options.levels == 256 ? 0 : options.levels);
  // Without hints, or with broken ones, glyphs stay as they are.
  if (Fit::make(font, style_, fit, fit_) == Status::ok &&
      !fit_.hints().empty()) {
    style_.set_fit(fit_);
    if (options.levels == 2 && options.weight == 0) {
      bilevel_.threshold_px = fit_.bilevel_weight();
    }
  }
}

}  // namespace inkcell::tools
