#include "model/arguments.hpp"

#include <cmath>

namespace inkcell::design {

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
  const Value& found = array(key);
  double* const members[] = {&m.xx, &m.xy, &m.yx, &m.yy, &m.dx, &m.dy};
  bool ok = found.size() == 6;
  for (size_t i = 0; ok && i < 6; ++i) {
    ok = found[i].is_number() && std::isfinite(found[i].get<double>());
    *members[i] = ok ? found[i].get<double>() : 0;
  }
  if (!ok) {
    refuse(std::string("\"") + key +
           "\" is six numbers: xx, xy, yx, yy, dx, dy");
  }
  return m;
}

}  // namespace inkcell::design
