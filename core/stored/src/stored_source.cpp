#include "stored_source.hpp"

#include "rows/outline_source.hpp"
#include "stored_store.hpp"

namespace inkcell {
namespace detail {
namespace {

bool prepare_stored(GlyphJob& job,
                    const GlyphRef& ref,
                    const Placed& placed) noexcept {
  const Source& outlines = *kOutlineCoding.source;
  uint32_t glyph = ref.glyph;
  const Font* const font =
      StoredStore::font_to_draw(*static_cast<const Font*>(ref.from), glyph);
  if (font == nullptr) {
    return false;
  }
  // What follows comes from the page.
  job.source = &outlines;
  return outlines.prepare(job, {&outlines, font, static_cast<uint16_t>(glyph)},
                          placed);
}

constexpr Source kStoredSource = {
    prepare_stored,       nullptr,    nullptr, sizeof(OutlineJob),
    SourceKind::outlines, draw_banded};

}  // namespace
}  // namespace detail

const Coding kStoredOutlineCoding = {
    static_cast<uint8_t>(format::Coding::outline), &detail::kStoredSource};

}  // namespace inkcell
