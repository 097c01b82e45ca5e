// A font of outlines. Apart, so that fonts of strikes alone link none.
#include "inkcell/coding.hpp"

#include "font_state.hpp"

lv_result_t inkcell_lv_font_init(inkcell_lv_font_t* font,
                                 const void* rom,
                                 size_t rom_bytes,
                                 int32_t size_q6) {
  using namespace inkcell;
  port::FontState state;
  const Status status =
      port::open_font(rom, rom_bytes, kOutlineCoding, size_q6, state.font);
  if (status == Status::ok) {
    state.style = Style(Q26_6::from_raw(size_q6), kFilterText);
    port::begin_font(state, *font);
  }
  return port::result_of("inkcell_lv_font_init", status);
}
