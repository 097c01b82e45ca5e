// Sets of characters with a name, such as latin-1.
#pragma once

#include <string_view>

#include "source/char_set.hpp"

namespace inkcell::gen {

/// Adds the sets of a list such as "latin-1,greek". Throws Error, which lists
/// the names, for one that is not known.
void add_named_sets(std::string_view list, CharSet& out);

/// The names that are known: "ascii, latin-1, ...".
std::string known_sets();

}  // namespace inkcell::gen
