// A font of outlines with strikes beside them.
#include "inkcell/strike/outline_strike.hpp"

#include "font_state.hpp"

lv_result_t inkcell_lv_font_init_outline_strike(inkcell_lv_font_t* font,
                                                const void* rom,
                                                size_t rom_bytes,
                                                int32_t size_q6,
                                                bool across) {
  using namespace inkcell;
  port::FontState state;
  const Status status = port::open_font(rom, rom_bytes, kOutlineStrikeCoding,
                                        size_q6, state.font);
  if (status == Status::ok) {
    const Q26_6 size = Q26_6::from_raw(size_q6);
    state.style = across ? strike_style(size) : strike_height_style(size);
    port::begin_font(state, *font);
  }
  return port::result_of("inkcell_lv_font_init_outline_strike", status);
}
