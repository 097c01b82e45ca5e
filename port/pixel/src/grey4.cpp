// The canvas of 4-bit grey.
#include "inkcell/port/grey4.hpp"

#include "packed_grey.hpp"

namespace inkcell::port::detail {

const SinkKind Grey4Pixels::kKind =
    kPackedGrey<Grey4Pixels, PixelFormat::grey4, 2>;

}  // namespace inkcell::port::detail
