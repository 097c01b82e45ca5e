#include "texts/located_text.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "source/char_set.hpp"
#include "texts/c_escape.hpp"

namespace inkcell::gen {

void add_shown(std::string_view text,
               int line,
               const std::string& file,
               LocatedText& out) {
  while (!text.empty()) {
    const auto c = read_utf8(text);
    if (!c) {
      refuse(file, line, "the text is not UTF-8; save the file as UTF-8");
    }
    if (is_shown(*c)) {
      out.push_back({*c, line});
    }
  }
}

std::string unquoted(std::string_view text, const std::string& file, int line) {
  std::string bytes;
  text.remove_prefix(1);
  while (!text.empty() && text[0] != '"') {
    const char c = text[0];
    text.remove_prefix(1);
    if (c != '\\') {
      bytes += c;
      continue;
    }
    const auto escape = read_escape(text);
    if (!escape) {
      refuse(file, line,
             "a backslash is followed by no escape sequence of C; write "
             "\\\\ for a backslash");
    }
    bytes += bytes_of(*escape);
  }
  if (text != "\"") {
    refuse(file, line,
           text.empty() ? "there is no quotation mark at the end; add it"
                        : "something follows the last quotation mark; write "
                          "\\\" for one that is shown");
  }
  return bytes;
}

std::string_view without_byte_order_mark(std::string_view text) {
  constexpr std::string_view kMark = "\xef\xbb\xbf";
  return text.substr(0, kMark.size()) == kMark ? text.substr(kMark.size())
                                               : text;
}

int line_at(std::string_view content, size_t offset) {
  const std::string_view before = content.substr(0, offset);
  return 1 + static_cast<int>(std::count(before.begin(), before.end(), '\n'));
}

void refuse(const std::string& file, int line, const std::string& what) {
  throw Error(file + ":" + std::to_string(line) + ": " + what);
}

}  // namespace inkcell::gen
