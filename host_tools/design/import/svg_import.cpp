#include "import/svg_import.hpp"

#include "base/error.hpp"
#include "model/error.hpp"
#include "shape/outline.hpp"
#include "svg/svg_drawing.hpp"

namespace inkcell::design {

gen::Outline read_svg(const std::filesystem::path& file,
                      const DrawingPlace& place) {
  const double scale = gen::kUPerEm / place.px_per_em;
  try {
    return gen::SvgDrawing(file).outline(
        {scale, 0, 0, -scale, -scale * place.origin.x, scale * place.origin.y});
  } catch (const gen::Error& error) {
    throw Error(error.what());
  }
}

}  // namespace inkcell::design
