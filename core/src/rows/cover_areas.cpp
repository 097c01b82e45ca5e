// From painted areas to coverage: an object of its own, which strikes do not
// link.
#include "rows/band.hpp"

#include "inkcell/painted.hpp"
#include "rows/cover_words.hpp"

namespace inkcell::detail {

#ifndef INKCELL_ONLY_STRIKES
void cover_areas(const Band& band, const Filter&) noexcept {
  cover_words(band, SumWords{});
}
#endif

}  // namespace inkcell::detail
