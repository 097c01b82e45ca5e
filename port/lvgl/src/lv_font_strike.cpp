// A font of strikes alone.
#include "inkcell/strike/strike.hpp"

#include "font_state.hpp"

lv_result_t inkcell_lv_font_init_strike(inkcell_lv_font_t* font,
                                        const void* rom,
                                        size_t rom_bytes,
                                        int32_t size_q6) {
  using namespace inkcell;
  port::FontState state;
  Status status =
      port::open_font(rom, rom_bytes, kStrikeCoding, size_q6, state.font);
  if (status == Status::ok) {
    state.style = Style(Q26_6::from_raw(size_q6));
    status = state.font.check(state.style);
  }
  if (status == Status::ok) {
    port::begin_font(state, *font);
  }
  return port::result_of("inkcell_lv_font_init_strike", status);
}
