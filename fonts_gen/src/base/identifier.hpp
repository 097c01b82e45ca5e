// Names that C and C++ accept.
#pragma once

#include <string>

namespace inkcell::gen {

/// Whether `name` is made of letters, digits and _, and begins with no digit.
bool has_letters_of_identifier(const std::string& name);

/// Whether `name` is a keyword, or another spelling of an operator, of C up to
/// C23 or C++ up to C++23, or reserved: _ and a capital.
bool is_keyword(const std::string& name);

}  // namespace inkcell::gen
