// Names of statuses, and what all other sources rely on.
#include "inkcell/c/types.h"
#include "mirror.hpp"

using namespace inkcell;

INKCELL_SAME_VALUE(INKCELL_OK, Status::ok);
INKCELL_SAME_VALUE(INKCELL_BAD_MAGIC, Status::bad_magic);
INKCELL_SAME_VALUE(INKCELL_BAD_VERSION, Status::bad_version);
INKCELL_SAME_VALUE(INKCELL_CORRUPT, Status::corrupt);
INKCELL_SAME_VALUE(INKCELL_NO_GLYPH, Status::no_glyph);
INKCELL_SAME_VALUE(INKCELL_BUFFER_SMALL, Status::buffer_small);
INKCELL_SAME_VALUE(INKCELL_MISALIGNED, Status::misaligned);
INKCELL_SAME_VALUE(INKCELL_UNSUPPORTED, Status::unsupported);
INKCELL_SAME_VALUE(INKCELL_BAD_ARGUMENT, Status::bad_argument);
INKCELL_SAME_VALUE(INKCELL_BEYOND_BAND, Status::beyond_band);

INKCELL_SAME_PLACE(inkcell_rect_t, x0, x0);
INKCELL_SAME_PLACE(inkcell_rect_t, y0, y0);
INKCELL_SAME_PLACE(inkcell_rect_t, x1, x1);
INKCELL_SAME_PLACE(inkcell_rect_t, y1, y1);
INKCELL_SAME_PLACE(inkcell_workspace_t, data, data);
INKCELL_SAME_PLACE(inkcell_workspace_t, size, size);

const char* inkcell_status_name(inkcell_status_t status) {
  // Without pointers: nothing has to be relocated.
  static constexpr char kNames[][13] = {
      "ok",           "bad_magic",    "bad_version", "corrupt",
      "no_glyph",     "buffer_small", "misaligned",  "unsupported",
      "bad_argument", "beyond_band",  "unknown"};
  constexpr uint8_t kUnknown = sizeof kNames / sizeof kNames[0] - 1;
  return kNames[status < kUnknown ? status : kUnknown];
}
