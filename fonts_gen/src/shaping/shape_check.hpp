// Shapes words by HarfBuzz and by the device's code.
#pragma once

#include <string>
#include <vector>

#include "base/byte_writer.hpp"
#include "shaping/shape_tables.hpp"

namespace inkcell::gen {

/// Shapes texts, and random words of the characters of each plan, by HarfBuzz
/// and by the device's code with `rom`, a whole font. Returns the least work a
/// character, in powers of 2, that all of them need. Throws Error that names
/// the word and the lookup if glyphs, places or advances differ.
unsigned check_shaping(const ShapeSource& source,
                       const Bytes& rom,
                       const std::vector<std::u32string>& texts);

}  // namespace inkcell::gen
