// A sink whose target is gone before it draws.
// refused: cannot bind|no matching function|expects an lvalue
#include "inkcell/port/a8.hpp"

inkcell::Status make(inkcell::port::A8Target& target,
                     inkcell::Sink& out) noexcept {
#if REFUSED
  return make_sink(inkcell::port::A8Target{target.strip}, out);
#else
  return make_sink(target, out);
#endif
}
