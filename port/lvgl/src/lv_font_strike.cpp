// A font of strikes alone.
#include "inkcell/strike/strike.hpp"

#include "font_state.hpp"

lv_result_t inkcell_lv_font_init_strike(inkcell_lv_font_t* font,
                                        const void* rom,
                                        size_t rom_bytes,
                                        int32_t size_q6) {
  using namespace inkcell;
  port::FontState state;
  if (!port::open_font(rom, rom_bytes, kStrikeCoding, size_q6, state.font)) {
    return LV_RESULT_INVALID;
  }
  state.style = Style(Q26_6::from_raw(size_q6));
  if (state.font.check(state.style) != Status::ok) {
    return LV_RESULT_INVALID;
  }
  port::begin_font(state, *font);
  return LV_RESULT_OK;
}
