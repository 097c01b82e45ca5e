// clang-format off
// Made by port/c/make_api.py from port/c/api.txt: edit that instead.
#include "mirror.hpp"

using namespace inkcell;
using namespace inkcell::c;

void inkcell_bidi_init(inkcell_bidi_t* bidi, uint16_t* cells, size_t count) {
  ref(bidi) = Bidi({cells, count});
}

void inkcell_bidi_forget(inkcell_bidi_t* bidi) {
  ref(bidi).forget();
}

void inkcell_layout_set_bidi(inkcell_layout_t* layout, inkcell_bidi_t* bidi) {
  ref(layout).set_bidi(ref(bidi));
}
