// Small valid fonts, to be damaged.
#pragma once

#include <stdint.h>

#include <string>
#include <vector>

namespace hostile {

using Bytes = std::vector<uint8_t>;

/// `kind`: "1" or "2", cells with kerning classes of one byte or of
/// two; "outline"; "strikes" of 22 px alone, "both". Empty if there is no such
/// kind.
Bytes good_font(const std::string& kind);

}  // namespace hostile
