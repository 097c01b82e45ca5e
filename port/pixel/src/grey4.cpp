// The sink for 4-bit grey.
#include "inkcell/port/grey4.hpp"

#include "packed_grey.hpp"

namespace inkcell {
namespace port {

Status make_sink(Grey4Target& target, Sink& out) noexcept {
  return detail::PackedGrey<Grey4Target, PixelFormat::grey4, 2>::open(target,
                                                                      out);
}

}  // namespace port
}  // namespace inkcell
