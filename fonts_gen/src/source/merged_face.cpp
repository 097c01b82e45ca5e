#include "source/merged_face.hpp"

#include <charconv>
#include <string_view>

#include "base/error.hpp"

namespace inkcell::gen {
namespace {

bool is_file(std::string_view name) {
  std::error_code error;
  return std::filesystem::exists(name, error);
}

// The colon before the settings of "FILE:NAME=..."; npos if there are none. The
// colon of "C:\fonts\a.ttf=A" does not count.
size_t find_settings(std::string_view text) {
  for (size_t at = text.find(':'); at != std::string_view::npos;
       at = text.find(':', at + 1)) {
    const size_t end = text.find_first_of("=:,/\\", at + 1);
    if (end != std::string_view::npos && end > at + 1 && text[end] == '=') {
      return at;
    }
  }
  return std::string_view::npos;
}

// Where the file's name ends.
size_t file_end(std::string_view text) {
  const size_t equals = text.rfind('=');
  if (is_file(text) || equals == std::string_view::npos) {
    return text.size();
  }
  const size_t settings = find_settings(text);
  return settings == std::string_view::npos || is_file(text.substr(0, equals))
             ? equals
             : settings;
}

int parse_face(std::string_view text) {
  int face = 0;
  const char* end = text.data() + text.size();
  const auto [at, error] = std::from_chars(text.data(), end, face);
  if (error != std::errc() || at != end || face < 0) {
    throw Error("face is a number from 0 on, such as face=1");
  }
  return face;
}

void read_setting(const std::string& name,
                  const std::string& value,
                  MergedFace& face) {
  if (value.empty()) {
    throw Error("'" + name +
                "' has no value; settings are TAG=VALUE of an axis, "
                "instance=NAME, face=N, height=em|cap|NUMBER and "
                "baseline=own|middle|bottom|NUMBER");
  }
  if (name == "instance") {
    face.instance = value;
  } else if (name == "face") {
    face.face = parse_face(value);
  } else if (name == "height") {
    parse_icon_height(value, face.place);
  } else if (name == "baseline" && value == "own") {
    face.baseline = MergedFace::Baseline::own;
  } else if (name == "baseline") {
    face.baseline = MergedFace::Baseline::placed;
    parse_icon_baseline(value, face.place);
  } else if (name.size() > 4) {
    throw Error("'" + name +
                "' is no setting; they are TAG=VALUE of an axis, "
                "instance=NAME, face=N, height=em|cap|NUMBER and "
                "baseline=own|middle|bottom|NUMBER");
  } else {
    face.axes.push_back(parse_axis(name + "=" + value));
  }
}

// Reads "NAME=VALUE,NAME=VALUE". Returns the rest, from "=LIST" on.
std::string_view read_settings(std::string_view text, MergedFace& face) {
  while (true) {
    const std::string_view name = text.substr(0, text.find_first_of("=,"));
    text.remove_prefix(name.size());
    std::string_view value;
    if (!text.empty() && text.front() == '=') {
      value = text.substr(1, text.substr(1).find_first_of("=,"));
      text.remove_prefix(1 + value.size());
    }
    read_setting(std::string(name), std::string(value), face);
    if (text.empty() || text.front() == '=') {
      return text;
    }
    text.remove_prefix(1);
  }
}

}  // namespace

MergedFace parse_merged_face(const std::string& text) {
  MergedFace face;
  const size_t end = file_end(text);
  face.file = text.substr(0, end);
  std::string_view rest = std::string_view(text).substr(end);
  try {
    if (!rest.empty() && rest.front() == ':') {
      rest = read_settings(rest.substr(1), face);
    }
    if (!rest.empty()) {
      add_ranges(rest.substr(1), face.characters);
    }
  } catch (const Error& why) {
    throw Error("--merge '" + text + "': " + why.what());
  }
  return face;
}

}  // namespace inkcell::gen
