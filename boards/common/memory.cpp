// The four memory functions that a compiler may call by itself.
//
// Compiled with -fno-tree-loop-distribute-patterns, otherwise the loops would
// become calls of themselves.
#include <stddef.h>
#include <stdint.h>

namespace {

// A word that may alias anything.
using Word [[gnu::may_alias]] = uint32_t;
constexpr size_t kWord = sizeof(Word);

bool aligned(const void* a, const void* b) noexcept {
  return ((reinterpret_cast<uintptr_t>(a) | reinterpret_cast<uintptr_t>(b)) %
          kWord) == 0;
}

}  // namespace

extern "C" {

void* memcpy(void* destination, const void* source, size_t size) noexcept {
  uint8_t* to = static_cast<uint8_t*>(destination);
  const uint8_t* from = static_cast<const uint8_t*>(source);
  if (aligned(to, from)) {
    for (; size >= kWord; size -= kWord, to += kWord, from += kWord) {
      *reinterpret_cast<Word*>(to) = *reinterpret_cast<const Word*>(from);
    }
  }
  while (size-- != 0) {
    *to++ = *from++;
  }
  return destination;
}

void* memmove(void* destination, const void* source, size_t size) noexcept {
  uint8_t* to = static_cast<uint8_t*>(destination);
  const uint8_t* from = static_cast<const uint8_t*>(source);
  if (to <= from || to >= from + size) {
    return memcpy(destination, source, size);
  }
  while (size-- != 0) {
    to[size] = from[size];
  }
  return destination;
}

void* memset(void* destination, int value, size_t size) noexcept {
  uint8_t* to = static_cast<uint8_t*>(destination);
  const uint8_t byte = static_cast<uint8_t>(value);
  if (aligned(to, to)) {
    const Word word = byte * 0x01010101u;
    for (; size >= kWord; size -= kWord, to += kWord) {
      *reinterpret_cast<Word*>(to) = word;
    }
  }
  while (size-- != 0) {
    *to++ = byte;
  }
  return destination;
}

int memcmp(const void* left, const void* right, size_t size) noexcept {
  const uint8_t* a = static_cast<const uint8_t*>(left);
  const uint8_t* b = static_cast<const uint8_t*>(right);
  for (; size != 0; --size, ++a, ++b) {
    if (*a != *b) {
      return *a - *b;
    }
  }
  return 0;
}

}  // extern "C"
