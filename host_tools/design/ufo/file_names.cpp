#include "ufo/file_names.hpp"

#include <algorithm>
#include <cstring>

namespace inkcell::design {
namespace {

constexpr const char* kIllegal = "\"*+/:<>?[\\]|";
constexpr size_t kMostLength = 255 - 5 - 15;  // ".glif" and a number

const char* const kReserved[] = {
    "con",  "prn",  "aux",  "clock$", "nul",  "a:",   "b:",   "c:",   "d:",
    "e:",   "f:",   "g:",   "h:",     "i:",   "j:",   "k:",   "l:",   "m:",
    "n:",   "o:",   "p:",   "q:",     "r:",   "s:",   "t:",   "u:",   "v:",
    "w:",   "x:",   "y:",   "z:",     "com1", "lpt1", "com2", "lpt2", "com3",
    "lpt3", "com4", "com5", "com6",   "com7", "com8", "com9", "lpt4", "lpt5",
    "lpt6", "lpt7", "lpt8", "lpt9"};

std::string lower(std::string text) {
  for (char& c : text) {
    c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return text;
}

bool is_reserved(const std::string& part) {
  return std::any_of(std::begin(kReserved), std::end(kReserved),
                     [&part](const char* name) { return lower(part) == name; });
}

// Each part between dots must not be a reserved name.
std::string without_reserved(const std::string& name) {
  std::string result;
  size_t begin = 0;
  while (begin <= name.size()) {
    const size_t end = std::min(name.find('.', begin), name.size());
    const std::string part = name.substr(begin, end - begin);
    result += (is_reserved(part) ? "_" : "") + part;
    result += end < name.size() ? "." : "";
    begin = end + 1;
  }
  return result;
}

}  // namespace

std::string glif_file_name(const std::string& glyph,
                           std::set<std::string>& taken) {
  std::string name;
  for (size_t i = 0; i < glyph.size(); ++i) {
    const char c = glyph[i];
    const bool bad = static_cast<unsigned char>(c) < 32 || c == 127 ||
                     std::strchr(kIllegal, c) != nullptr ||
                     (i == 0 && c == '.');
    name += bad ? '_' : c;
    if (c >= 'A' && c <= 'Z') {
      name += '_';
    }
  }
  name = without_reserved(name).substr(0, kMostLength);
  std::string file = name + ".glif";
  for (int number = 1; !taken.insert(lower(file)).second; ++number) {
    std::string digits = std::to_string(number);
    digits.insert(0, 15 - std::min<size_t>(15, digits.size()), '0');
    file = name + digits + ".glif";
  }
  return file;
}

}  // namespace inkcell::design
