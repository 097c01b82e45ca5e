// The sink for 2-bit grey.
#include "inkcell/port/grey2.hpp"

#include "packed_grey.hpp"

namespace inkcell {
namespace port {

Status make_sink(Grey2Target& target, Sink& out) noexcept {
  return detail::PackedGrey<Grey2Target, PixelFormat::grey2, 1>::open(target,
                                                                      out);
}

}  // namespace port
}  // namespace inkcell
