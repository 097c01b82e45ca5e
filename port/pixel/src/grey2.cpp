// The canvas of 2-bit grey.
#include "inkcell/port/grey2.hpp"

#include "packed_grey.hpp"

namespace inkcell {
namespace port {
namespace detail {

const SinkKind Grey2Pixels::kKind =
    kPackedGrey<Grey2Pixels, PixelFormat::grey2, 1>;

}  // namespace detail
}  // namespace port
}  // namespace inkcell
