// A font of bytes in memory.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "inkcell/field/draw.hpp"
#include "inkcell/font.hpp"

namespace inkcell::gen::test {

/// The font of `bytes`, which must open, and must outlive it.
inline Font opened(const std::vector<uint8_t>& bytes) {
  Font font;
  EXPECT_EQ(open_any_font({bytes.data(), bytes.size()}, font), Status::ok);
  return font;
}

}  // namespace inkcell::gen::test
