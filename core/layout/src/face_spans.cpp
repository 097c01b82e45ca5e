#include "face_spans.hpp"

namespace inkcell::detail {

FaceGlyph find_in_spans(const Pen& pen,
                        uint32_t code_point,
                        const LineCell& cell) noexcept {
  const LayoutOptions& options = pen.options();
  for (const FaceSpan& span : options.spans->all) {
    if (cell.begin >= span.begin && cell.begin < span.end && !cell.is_added) {
      FaceGlyph glyph = {0, span.face, false};
      if (span.face != 0 && span.face <= options.fallback.size &&
          pen.setting().face(span.face).font->glyph_of(code_point, glyph.id) ==
              Status::ok) {
        glyph.is_found = true;
        return glyph;
      }
      break;
    }
  }
  return pen.find(code_point);
}

}  // namespace inkcell::detail
