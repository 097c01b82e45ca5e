// The arguments of a command, with errors that name the faulty one.
#pragma once

#include <string>

#include "model/error.hpp"
#include "model/glyph.hpp"
#include "model/value.hpp"

namespace inkcell::design {

class Arguments {
 public:
  /// `command` must outlive this. Throws Error unless it is a dictionary with a
  /// string "do".
  explicit Arguments(const Value& command);

  const std::string& name() const { return name_; }
  bool has(const char* key) const { return command_.contains(key); }

  std::string text(const char* key) const;
  std::string text(const char* key, const std::string& otherwise) const;
  /// Finite.
  double number(const char* key) const;
  double number(const char* key, double otherwise) const;
  bool flag(const char* key, bool otherwise) const;
  /// Below `count`.
  size_t index(const char* key, size_t count) const;
  /// An index to insert at, 0..`count`; `count` is the default.
  size_t place(const char* key, size_t count) const;
  const Value& array(const char* key) const;
  const Value& value(const char* key) const;
  /// A matrix: six numbers, xx xy yx yy dx dy, or a dictionary of steps,
  /// applied in this order: "reflect" ("x": swaps left and right, or "y"),
  /// "scale" (a number, or one for x and one for y), "slant" (degrees, to the
  /// right), "turn" (degrees, counter-clockwise), "move" ([dx, dy]). The
  /// identity by default.
  Matrix matrix(const char* key) const;

  /// Throws Error "command 'move_points': <text>".
  [[noreturn]] void refuse(const std::string& text) const;

 private:
  const Value& command_;
  std::string name_;
};

}  // namespace inkcell::design
