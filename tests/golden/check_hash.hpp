// Checks hashes, and prints them for regenerate.py.
#pragma once

#include "check.hpp"
#include "sha256.hpp"

namespace golden {

inline bool equal(const char* a, const char* b) {
  while (*a != '\0' && *a == *b) {
    ++a;
    ++b;
  }
  return *a == *b;
}

// A hash without a name is not printed.
inline void check_hash(const char* name, Sha256& sha, const char* expected) {
  char hex[65];
  sha.finish().to_hex(hex);
  if (name != nullptr) {
    check::write(hex);
    check::write("  ");
    check::write(name);
    check::write("\n");
  }
  CHECK(equal(hex, expected));
}

}  // namespace golden
