// Tables for line breaking that host_tools/unicode/make_tables.py generates.
#pragma once

#include <stdint.h>

#include "class_table.hpp"

namespace inkcell::detail {

// Values of LineClass: of U+0000 to U+007F, and from U+0080 on.
extern const uint8_t kAsciiLineClasses[128];
extern const ClassTable kLineClasses;

}  // namespace inkcell::detail
