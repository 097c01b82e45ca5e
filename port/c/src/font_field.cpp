// Fonts of fields: of font.h.
#include "inkcell/c/font.h"
#include "inkcell/field/draw.hpp"
#include "mirror.hpp"

using namespace inkcell;
using c::cpp;

inkcell_status_t inkcell_font_open_field(const void* rom,
                                         size_t size,
                                         inkcell_font_t* out) {
  *cpp(out) = Font();
  return c::code(Font::open({static_cast<const uint8_t*>(rom), size},
                            kFieldCoding, *cpp(out)));
}
