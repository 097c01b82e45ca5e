// What all effects have in common. An effect draws glyphs in another way than
// one sample a pixel.
#pragma once

#include "inkcell/cpp17.hpp"

namespace inkcell {

struct Mixer;

namespace detail {
// How the effects of this folder draw.
extern const Mixer kStrokeMixer;
extern const Mixer kStrokeAndFillMixer;
extern const Mixer kLcdMixer;
extern const Mixer kBilevelMixer;
extern const Mixer kFewLevelsMixer;
extern const Mixer kSupersampleMixer;
extern const Mixer kMotionBlurMixer;
extern const Mixer kEdgeContrastMixer;
}  // namespace detail

/// The base of all effects: stroke.hpp, lcd.hpp, bilevel.hpp, supersample.hpp,
/// motion_blur.hpp, edge_contrast.hpp; inkcell/field has others. Effects hold
/// their options, may lie in ROM, and serve any number of styles:
///
///     constexpr Stroke kStroke(kFilterText, Q6_10::from_int(1));
///     style.set_effect(kStroke);
///
/// The linker drops the effects that a program does not name. mixer.hpp says
/// how to write one.
class Effect {
 public:
  constexpr const Mixer& mixer() const noexcept { return *mixer_; }

 protected:
  // A copy of the base alone would have no options.
  constexpr explicit Effect(const Mixer& mixer) noexcept : mixer_(&mixer) {}
  constexpr Effect(const Effect&) noexcept = default;
  constexpr Effect& operator=(const Effect&) noexcept = default;

 private:
  const Mixer* mixer_;
};

}  // namespace inkcell
