// A folder of icons, for tests of icons and of faces beside them.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "messages.hpp"
#include "sfnt_builder.hpp"

namespace inkcell::gen::test {

// A square of the whole viewBox, which is 20 wide and 10 high.
inline constexpr const char* kBox =
    "<svg viewBox='10 5 20 10'><path d='M10 5h20v10h-20z'/></svg>";

class Icons : public testing::Test {
 protected:
  std::filesystem::path write(const std::string& name,
                              const std::string& text = kBox) const {
    return folder_.write(name, text);
  }
  std::string file(const std::string& icon) const {
    return (folder_.path() / icon).string();
  }

  TestFolder folder_;
};

}  // namespace inkcell::gen::test
