// The order of mixed lines: of layout.h. Alone, for it links large tables.
#include "inkcell/layout/bidi.hpp"

#include "layouts.hpp"

using namespace inkcell;
using c::cpp;

void inkcell_bidi_init(inkcell_bidi_t* bidi, uint16_t* cells, size_t count) {
  *cpp(bidi) = Bidi({cells, count});
}

void inkcell_bidi_forget(inkcell_bidi_t* bidi) {
  cpp(bidi)->forget();
}

void inkcell_layout_set_bidi(inkcell_layout_t* layout, inkcell_bidi_t* bidi) {
  cpp(layout)->set_bidi(*cpp(bidi));
}
