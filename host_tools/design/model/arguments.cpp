#include "model/arguments.hpp"

#include <cmath>

#include "shape/points.hpp"

namespace inkcell::design {
namespace {

bool is_finite(const Value& value) {
  return value.is_number() && std::isfinite(value.get<double>());
}

// [x, y], or one number for both.
bool read_pair(const Value& value, bool may_be_one, double& x, double& y) {
  if (may_be_one && is_finite(value)) {
    x = y = value.get<double>();
    return true;
  }
  if (!value.is_array() || value.size() != 2 || !is_finite(value[0]) ||
      !is_finite(value[1])) {
    return false;
  }
  x = value[0].get<double>();
  y = value[1].get<double>();
  return true;
}

// Quarter turns are exact.
Matrix turned(double degrees) {
  const double quarters = std::fmod(degrees / 90, 4);
  double c = std::cos(degrees * gen::kDegree);
  double s = std::sin(degrees * gen::kDegree);
  if (quarters == std::floor(quarters)) {
    c = std::round(c);
    s = std::round(s);
  }
  Matrix m;
  m.xx = m.yy = c;
  m.xy = s;
  m.yx = -s;
  return m;
}

constexpr double kMostSlant = 85;  // [degrees]

// False if a step is unknown or wrong.
bool read_parts(const Value& parts, Matrix& m) {
  double x = 1;
  double y = 1;
  for (const auto& [key, part] : parts.items()) {
    const bool is_known =
        key == "reflect" ? part == "x" || part == "y"
        : key == "turn"  ? is_finite(part)
        : key == "slant"
            ? is_finite(part) && std::abs(part.get<double>()) < kMostSlant
        : key == "scale" ? read_pair(part, true, x, y)
                         : key == "move" && read_pair(part, false, x, y);
    if (!is_known) {
      return false;
    }
  }
  if (parts.contains("scale")) {
    read_pair(parts["scale"], true, m.xx, m.yy);
  }
  if (parts.contains("reflect")) {
    (parts["reflect"] == "x" ? m.xx : m.yy) *= -1;
  }
  if (parts.contains("slant")) {
    Matrix slant;
    slant.yx = std::tan(gen::kDegree * parts["slant"].get<double>());
    m = product(slant, m);
  }
  if (parts.contains("turn")) {
    m = product(turned(parts["turn"].get<double>()), m);
  }
  if (parts.contains("move")) {
    read_pair(parts["move"], false, m.dx, m.dy);
  }
  return true;
}

}  // namespace

Arguments::Arguments(const Value& command) : command_(command) {
  if (!command.is_object() || !command.contains("do") ||
      !command["do"].is_string()) {
    throw Error(
        "a command is a dictionary such as {\"do\": \"set_advance\", "
        "\"glyph\": \"a\", \"width\": 500}");
  }
  name_ = command["do"].get<std::string>();
}

void Arguments::refuse(const std::string& text) const {
  std::string where;
  if (command_.contains("glyph") && command_["glyph"].is_string()) {
    where = ", glyph '" + command_["glyph"].get<std::string>() + "'";
  }
  throw Error("command '" + name_ + "'" + where + ": " + text);
}

const Value& Arguments::value(const char* key) const {
  const auto found = command_.find(key);
  if (found == command_.end()) {
    refuse(std::string("\"") + key + "\" is missing");
  }
  return *found;
}

std::string Arguments::text(const char* key) const {
  const Value& found = value(key);
  if (!found.is_string()) {
    refuse(std::string("\"") + key + "\" is a text");
  }
  return found.get<std::string>();
}

std::string Arguments::text(const char* key,
                            const std::string& otherwise) const {
  return has(key) ? text(key) : otherwise;
}

double Arguments::number(const char* key) const {
  const Value& found = value(key);
  if (!found.is_number() || !std::isfinite(found.get<double>())) {
    refuse(std::string("\"") + key + "\" is a number");
  }
  return found.get<double>();
}

double Arguments::number(const char* key, double otherwise) const {
  return has(key) ? number(key) : otherwise;
}

bool Arguments::flag(const char* key, bool otherwise) const {
  if (!has(key)) {
    return otherwise;
  }
  if (!value(key).is_boolean()) {
    refuse(std::string("\"") + key + "\" is true or false");
  }
  return value(key).get<bool>();
}

size_t Arguments::index(const char* key, size_t count) const {
  const double found = number(key);
  if (!(found >= 0) || found != std::floor(found) ||
      found >= static_cast<double>(count)) {
    refuse(std::string("\"") + key + "\" is " + value(key).dump() +
           (count == 0 ? ", and there is none"
                       : ", allowed are 0.." + std::to_string(count - 1)));
  }
  return static_cast<size_t>(found);
}

size_t Arguments::place(const char* key, size_t count) const {
  return has(key) ? index(key, count + 1) : count;
}

const Value& Arguments::array(const char* key) const {
  const Value& found = value(key);
  if (!found.is_array()) {
    refuse(std::string("\"") + key + "\" is an array");
  }
  return found;
}

Matrix Arguments::matrix(const char* key) const {
  Matrix m;
  if (!has(key)) {
    return m;
  }
  const Value& found = value(key);
  double* const members[] = {&m.xx, &m.xy, &m.yx, &m.yy, &m.dx, &m.dy};
  bool ok = found.is_array() && found.size() == 6;
  for (size_t i = 0; ok && i < 6; ++i) {
    ok = is_finite(found[i]);
    *members[i] = ok ? found[i].get<double>() : 0;
  }
  if (!ok && !(found.is_object() && read_parts(found, m))) {
    refuse(std::string("\"") + key +
           "\" is six numbers, xx, xy, yx, yy, dx, dy, or a dictionary such "
           "as {\"reflect\": \"x\", \"scale\": 0.5, \"turn\": 90, "
           "\"move\": [100, 0]}");
  }
  return m;
}

}  // namespace inkcell::design
