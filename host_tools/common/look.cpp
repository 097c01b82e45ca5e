// Sets brushes up as people ask for them.
#include "look.hpp"

#include <cmath>
#include <map>
#include <sstream>
#include <stdexcept>

#include "canvas.hpp"
#include "filters.hpp"

namespace inkcell::tools {
namespace {

// Below this size text reads better of several samples.
constexpr Q26_6 kLeastForOne = Q26_6::from_int(10);

// Of splats: a larger glyph is drawn in parts.
constexpr size_t kMaxSums = 1 << 16;

const Filter& filter_for(const std::string& name, Use use) {
  if (name.empty()) {
    return use == Use::moving ? kFilterMotion : kFilterText;
  }
  return filter_of(name);
}

Q6_10 to_q10(double px) {
  return Q6_10::from_raw(static_cast<int16_t>(std::lround(px * 1024)));
}

}  // namespace

void add_look_options(CLI::App& app, LookOptions& options) {
  app.add_option("--filter", options.filter,
                 "text, motion, paper_display or paper_body [text; motion for "
                 "jobs of kind anim]");
  app.add_option("--hint", options.hint,
                 "Fit to the pixel grid: none; vertical, heights; both, stems "
                 "too; auto, vertical but for jobs of kind anim")
      ->check(CLI::IsMember({"none", "vertical", "both", "auto"}))
      ->capture_default_str();
  app.add_option(
         "--samples", options.samples,
         "Distances a pixel: one; adaptive, up to 13 where one does "
         "not tell enough; paper, as the paper has it; splats, cells "
         "smaller than a pixel once each; auto, one, but adaptive below "
         "10 px and for jobs of kind anim")
      ->check(CLI::IsMember({"one", "adaptive", "paper", "splats", "auto"}))
      ->capture_default_str();
  app.add_option("--radius", options.radius,
                 "Of the filter over samples [px; 0.85, 0.75 for jobs of kind "
                 "anim, 1.3 for paper and splats]")
      ->check(CLI::Range(0.25, 1.5));
  app.add_option("--rules", options.rules,
                 "Contrast as eyes prefer it, with one sample a pixel: edges, "
                 "darker on the left and below; thin, thin strokes darker; all")
      ->check(CLI::IsMember({"none", "edges", "thin", "all"}))
      ->capture_default_str();
  app.add_option("--motion", options.motion,
                 "Blur by a movement of X,Y while the shutter is open [px]")
      ->type_name("X,Y");
  app.add_option("--weight", options.weight,
                 "Move edges outwards, strokes gain twice that [px]")
      ->check(CLI::Range(-2.0, 2.0));
  app.add_option("--outline", options.outline,
                 "Draw outlines of this width, in place of the inside [px]")
      ->check(CLI::Range(0.0, 4.0));
  const std::map<std::string, OutlinePlace> places = {
      {"inner", OutlinePlace::inner},
      {"centred", OutlinePlace::centred},
      {"outer", OutlinePlace::outer}};
  app.add_option("--outline-place", options.place, "Where they lie [centred]")
      ->transform(
          CLI::CheckedTransformer(places).description("inner|centred|outer"))
      ->type_name("");
  app.add_option("--levels", options.levels,
                 "Draw for displays of 2 or 4 levels, without broken strokes")
      ->check(CLI::IsMember({2, 4, 256}))
      ->capture_default_str();
}

Look::Look(const LookOptions& options,
           const Font& font,
           double px,
           double angle,
           Use use)
    : edges_(make_outline(
          with_weight(filter_for(options.filter, use), to_q10(options.weight)),
          to_q10(options.outline),
          options.place)),
      brush_(make_brush(px, angle, edges_.outer)) {
  set_painter(options, font, use);
  set_hint(options, font, use);
}

void Look::set_painter(const LookOptions& options, const Font& font, Use use) {
  // Filters as they are reach what fonts are made for; with two levels only
  // distances close to the edge count.
  const bool reaches =
      (options.weight == 0 && options.outline == 0) || options.levels == 2;
  for (const Filter* edge : {&edges_.outer, &edges_.inner}) {
    if (!reaches &&
        check_reach(font.range(), brush_.size(), *edge) != Status::ok) {
      throw std::runtime_error(
          "at this size the font's distances do not reach as far as --weight "
          "and --outline: draw it larger, or give the font a --band-px");
    }
  }
  const int ways =
      (options.outline != 0 ? 1 : 0) + (options.levels != 256 ? 1 : 0) +
      (options.motion.empty() ? 0 : 1) + (options.rules == "none" ? 0 : 1) +
      (options.samples == "auto" || options.samples == "one" ? 0 : 1);
  if (ways > 1) {
    throw std::runtime_error(
        "--outline, --levels, --motion, --rules and --samples exclude each "
        "other");
  }
  if (options.outline != 0) {
    brush_.set_painter(paint_outline, &edges_.inner);
  } else if (options.levels != 256) {
    crisp_.levels = static_cast<uint8_t>(options.levels);
    crisp_.threshold_px.raw = static_cast<int16_t>(-1024 * options.weight);
    brush_.set_painter(paint_crisp, &crisp_, kCrispReach);
  } else if (!options.motion.empty()) {
    set_motion(options);
  } else if (options.rules != "none") {
    set_rules(options);
  } else {
    set_samples(options, use);
  }
}

void Look::set_samples(const LookOptions& options, Use use) {
  if (options.samples == "one" ||
      (options.samples == "auto" && use == Use::still &&
       brush_.size().raw >= kLeastForOne.raw)) {
    return;
  }
  const bool is_paper = options.samples == "paper";
  const bool is_splats = options.samples == "splats";
  Q6_10 radius = is_paper || is_splats ? kPaperRadius
                 : use == Use::moving  ? kCalmRadius
                                       : kSharpRadius;
  if (options.radius > 0) {
    radius = Q6_10::from_raw(static_cast<int16_t>(options.radius * 1024));
  }
  if (is_splats) {
    sums_.resize(kMaxSums);
    if (make_splats({sums_.data(), sums_.size()}, radius, splats_) !=
        Status::ok) {
      throw std::runtime_error("--samples splats: --radius is 0.75 to 1.5 px");
    }
    brush_.set_painter(paint_splats, &splats_, kSplatReach);
    return;
  }
  adaptive_ = make_adaptive(brush_.filter(), radius,
                            is_paper ? SampleRule::paper : SampleRule::even);
  adaptive_.more_samples = &more_samples_;
  brush_.set_painter(paint_adaptive, &adaptive_, kAdaptiveReach);
}

void Look::set_rules(const LookOptions& options) {
  perception_.edge = options.rules == "thin" ? 0 : perception_.edge;
  perception_.thin = options.rules == "edges" ? 0 : perception_.thin;
  brush_.set_painter(paint_perceptual, &perception_, kPerceptionReach);
}

void Look::set_motion(const LookOptions& options) {
  std::istringstream in(options.motion);
  double x = 0;
  double y = 0;
  char comma = 0;
  if (!(in >> x >> comma >> y) || comma != ',' || !in.eof() ||
      make_motion_blur(brush_.filter(), make_point(x, y), blur_) !=
          Status::ok) {
    throw std::runtime_error("--motion takes X,Y, up to 32 px each");
  }
  brush_.set_painter(paint_motion_blur, &blur_, blur_.reach_px);
}

void Look::set_hint(const LookOptions& options, const Font& font, Use use) {
  if (options.hint == "none" ||
      (options.hint == "auto" &&
       (use == Use::moving || options.samples == "splats"))) {
    return;
  }
  FitOptions fit;
  fit.stems = options.hint == "both";
  // Without hints, or with broken ones, glyphs stay as they are.
  Hints hints;
  if (Hints::open(font, hints) == Status::ok && !hints.empty() &&
      Fit::make(font, brush_, fit, fit_) == Status::ok) {
    brush_.set_fitter(fit_glyph, &fit_);
  }
}

}  // namespace inkcell::tools
