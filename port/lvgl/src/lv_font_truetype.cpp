// A font of a TrueType file.
#include "inkcell/truetype/truetype_font.hpp"

#include "font_state.hpp"

namespace inkcell::port {
namespace {

static_assert(sizeof(TrueTypeFont) <= sizeof(inkcell_lv_truetype_t),
              "enlarge it");

}  // namespace
}  // namespace inkcell::port

lv_result_t inkcell_lv_truetype_open(inkcell_lv_truetype_t* file,
                                     const void* bytes,
                                     size_t count) {
  using namespace inkcell;
  auto& opened = *reinterpret_cast<TrueTypeFont*>(file->state);
  return port::result_of(
      "inkcell_lv_truetype_open",
      opened.open({static_cast<const uint8_t*>(bytes), count}));
}

lv_result_t inkcell_lv_font_init_truetype(inkcell_lv_font_t* font,
                                          const inkcell_lv_truetype_t* file,
                                          int32_t size_q6) {
  using namespace inkcell;
  const auto& opened = *reinterpret_cast<const TrueTypeFont*>(file->state);
  const bool is_closed = opened.glyph_count() == 0;
  const Status status = is_closed ? Status::bad_magic
                        : size_q6 < kMinSize.raw || size_q6 > kMaxSize.raw
                            ? Status::bad_argument
                            : Status::ok;
  if (status == Status::ok) {
    port::FontState state;
    state.font = opened.font();
    state.style = Style(Q26_6::from_raw(size_q6));
    port::begin_font(state, *font);
  }
  return port::result_of("inkcell_lv_font_init_truetype", status);
}
