// Pixels in read-only memory.
// refused: could not convert|no viable conversion
#include "inkcell/span.hpp"

#if REFUSED
inkcell::Span<uint8_t> pixels(const uint8_t (&rows)[8]) noexcept {
  return rows;
}
#else
inkcell::Span<const uint8_t> pixels(const uint8_t (&rows)[8]) noexcept {
  return rows;
}
#endif
