// Random valid commands.
#pragma once

#include <random>

#include "model/project.hpp"

namespace inkcell::design::test {

/// Makes commands of every kind. The same seed gives the same ones.
class RandomCommands {
 public:
  explicit RandomCommands(uint32_t seed) : random_(seed) {}

  /// One that change_of() accepts for `project`.
  Value next(const Project& project);

 private:
  int below(int count) {
    return std::uniform_int_distribution<int>(0, count - 1)(random_);
  }
  double coordinate() { return below(4000) * 0.5 - 1000; }

  Value attempt(const Project& project);
  Value on_glyph(const std::string& name, const Glyph& glyph);
  Value on_contour(Value command, const Glyph& glyph);
  Value on_font(const Project& project);
  Value points();
  std::string any_glyph(const Project& project);

  std::mt19937 random_;
};

}  // namespace inkcell::design::test
