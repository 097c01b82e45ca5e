// The painter of C as that of C++.
#include "mirror.hpp"

inkcell::Painter inkcell::c::painter_of(
    const inkcell_painter_t* painter) noexcept {
  if (painter == nullptr) {
    return {};
  }
  const detail::GlyphDrawer* const drawer =
      painter->colours == nullptr
          ? static_cast<const detail::GlyphDrawer*>(cpp(painter->cache))
          : cpp(painter->colours);
  const Painter plain(
      painter->sink == nullptr ? inkcell::detail::kNoSink : ref(painter->sink),
      ref(&painter->ram), drawer,
      reinterpret_cast<TextReport*>(painter->report));
  return painter->lines == nullptr ? plain : plain.with(ref(painter->lines));
}
