// clang-format off
// Made by port/c/make_api.py from port/c/api.txt: edit that instead.
#include "mirror.hpp"

using namespace inkcell;
using namespace inkcell::c;

const char* inkcell_status_name(inkcell_status_t status) {
  // Without pointers: nothing has to be relocated.
  static constexpr char kNames[][14] = {
      "ok",           "bad_magic",   "bad_version",  "corrupt",
      "no_glyph",     "buffer_small", "misaligned",  "unsupported",
      "bad_argument", "beyond_band", "read_failed",  "cut",
      "needs_shaping", "unknown"};
  constexpr uint8_t kUnknown = sizeof kNames / sizeof kNames[0] - 1;
  return kNames[status < kUnknown ? status : kUnknown];
}
