// clang-format off
// Made by port/c/make_api.py from port/c/api.txt: edit that instead.
#include "mirror.hpp"

using namespace inkcell;
using namespace inkcell::c;

inkcell_status_t inkcell_font_open_field(const void* rom,
                                         size_t size,
                                         inkcell_font_t* out) {
  ref(out) = Font();
  return code(Font::open({static_cast<const uint8_t*>(rom), size}, kFieldCoding,
      ref(out)));
}
