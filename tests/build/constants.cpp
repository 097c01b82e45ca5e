// Styles that a program has as constants: in ROM, and made by no code.
#include "inkcell/fit.hpp"
#include "inkcell/style.hpp"

using namespace inkcell;

namespace {
constexpr Fit kFit;
}  // namespace

extern const Style kTitle;
extern const Style kBody;
extern const Style kFitted;
const Style kTitle = Style(24_px);
const Style kBody = Style(12.5_px, kFilterText);
const Style kFitted = Style(11_px).set_fit(kFit).clear_effect();
