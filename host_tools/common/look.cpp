// Sets brushes up as people ask for them.
#include "look.hpp"

#include "canvas.hpp"
#include "filters.hpp"

namespace inkcell::tools {
namespace {

const Filter& filter_for(const std::string& name, Use use) {
  if (name.empty()) {
    return use == Use::moving ? kFilterMotion : kFilterText;
  }
  return filter_of(name);
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
  app.add_option("--samples", options.samples,
                 "Distances a pixel: one; adaptive, up to 13 where one does "
                 "not tell enough; paper, as the paper has it; auto, one, but "
                 "adaptive for jobs of kind anim")
      ->check(CLI::IsMember({"one", "adaptive", "paper", "auto"}))
      ->capture_default_str();
  app.add_option("--radius", options.radius,
                 "Of the filter over samples [px; 0.85, 0.75 for jobs of kind "
                 "anim, 1.3 for paper]")
      ->check(CLI::Range(0.25, 1.5));
}

Look::Look(const LookOptions& options,
           const Font& font,
           double px,
           double angle,
           Use use)
    : brush_(make_brush(px, angle, filter_for(options.filter, use))) {
  set_samples(options, use);
  set_hint(options, font, use);
}

void Look::set_samples(const LookOptions& options, Use use) {
  if (options.samples == "one" ||
      (options.samples == "auto" && use == Use::still)) {
    return;
  }
  const bool is_paper = options.samples == "paper";
  Q6_10 radius = is_paper             ? kPaperRadius
                 : use == Use::moving ? kCalmRadius
                                      : kSharpRadius;
  if (options.radius > 0) {
    radius = Q6_10::from_raw(static_cast<int16_t>(options.radius * 1024));
  }
  adaptive_ = make_adaptive(brush_.filter(), radius,
                            is_paper ? SampleRule::paper : SampleRule::even);
  adaptive_.more_samples = &more_samples_;
  brush_.set_painter(paint_adaptive, &adaptive_, kAdaptiveReach);
}

void Look::set_hint(const LookOptions& options, const Font& font, Use use) {
  if (options.hint == "none" ||
      (options.hint == "auto" && use == Use::moving)) {
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
