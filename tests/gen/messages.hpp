// What errors and messages say.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "base/error.hpp"

namespace inkcell::gen::test {

/// The text of the Error that a call throws; "no error" if it throws none.
template <typename Call>
std::string error_of(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

/// Whether a text has a part, or begins with it; the text is shown if not.
inline testing::AssertionResult contains(const std::string& text,
                                         const std::string& part) {
  return text.find(part) != std::string::npos
             ? testing::AssertionSuccess() << "found '" << part << "'"
             : testing::AssertionFailure() << "no '" << part << "' in " << text;
}
inline testing::AssertionResult begins_with(const std::string& text,
                                            const std::string& part) {
  return text.compare(0, part.size(), part) == 0 ? testing::AssertionSuccess()
                                                 : testing::AssertionFailure()
                                                       << "no '" << part
                                                       << "' before " << text;
}

}  // namespace inkcell::gen::test
