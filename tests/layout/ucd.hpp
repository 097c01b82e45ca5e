// Reads files of the Unicode Character Database.
#pragma once

#include <cstdint>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

namespace ucd {

/// Calls `take` for each line with data, and its comment.
inline void for_each_line(
    const std::string& file,
    const std::function<void(const std::string& line,
                             const std::string& comment)>& take) {
  std::ifstream in(file);
  std::string line;
  while (std::getline(in, line)) {
    const size_t end = line.find('#');
    const std::string body = line.substr(0, end);
    if (body.find_first_not_of(" \t\r") != std::string::npos) {
      take(body, end == std::string::npos ? "" : line.substr(end + 1));
    }
  }
}

inline std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == at) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

/// Words between spaces and tabs.
inline std::vector<std::string> words(const std::string& text) {
  std::vector<std::string> found;
  bool is_open = false;
  for (const char c : text) {
    if (c == ' ' || c == '\t' || c == '\r') {
      is_open = false;
    } else {
      if (!is_open) {
        found.emplace_back();
      }
      found.back() += c;
      is_open = true;
    }
  }
  return found;
}

inline uint32_t hex(const std::string& digits) {
  return static_cast<uint32_t>(std::stoul(digits, nullptr, 16));
}

/// Appends a code point as UTF-8; a surrogate as bytes that read as U+FFFD.
inline void append(std::string& text, uint32_t code_point) {
  const auto put = [&text](uint32_t byte) { text += static_cast<char>(byte); };
  if (code_point < 0x80) {
    put(code_point);
  } else if (code_point < 0x800) {
    put(0xc0 | code_point >> 6);
    put(0x80 | (code_point & 63));
  } else if (code_point < 0x10000) {
    put(0xe0 | code_point >> 12);
    put(0x80 | (code_point >> 6 & 63));
    put(0x80 | (code_point & 63));
  } else {
    put(0xf0 | code_point >> 18);
    put(0x80 | (code_point >> 12 & 63));
    put(0x80 | (code_point >> 6 & 63));
    put(0x80 | (code_point & 63));
  }
}

}  // namespace ucd
