#include "texts/string_file.hpp"

#include <algorithm>
#include <cstddef>
#include <string_view>

#include "base/identifier.hpp"
#include "base/trimmed.hpp"
#include "source/char_set.hpp"
#include "texts/located_text.hpp"

namespace inkcell::gen {
namespace {

// Subtags of 1 to 8 letters and digits; the first one has letters only.
bool is_language(std::string_view tag) {
  size_t length = 0;
  bool is_first = true;
  for (const char c : tag) {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    const bool digit = c >= '0' && c <= '9' && !is_first;
    if (c == '-' && length != 0) {
      length = 0;
      is_first = false;
    } else if ((letter || digit) && length < 8) {
      ++length;
    } else {
      return false;
    }
  }
  return length != 0;
}

// One line of a file.
class LineParser {
 public:
  LineParser(const std::string& file, int number) {
    string_.file = file;
    string_.line_number = number;
  }

  NamedString parse(std::string_view line) {
    const size_t equals = line.find('=');
    if (equals == std::string_view::npos) {
      refuse("there is no '='; write name = text, or # before a comment");
    }
    parse_name(trimmed(line.substr(0, equals)));
    parse_text(trimmed(line.substr(equals + 1)));
    return std::move(string_);
  }

  [[noreturn]] void refuse(const std::string& what) const {
    gen::refuse(string_.file, string_.line_number, what);
  }

 private:
  void parse_name(std::string_view head) {
    const size_t bracket = head.find('[');
    if (bracket != std::string_view::npos) {
      if (head.back() != ']') {
        refuse("there is no ']' before the '='");
      }
      parse_attributes(head.substr(bracket + 1, head.size() - bracket - 2));
    }
    string_.name = trimmed(head.substr(0, bracket));
    if (!has_letters_of_identifier(string_.name)) {
      refuse("'" + string_.name +
             "' is not an identifier; use letters, digits and _");
    }
    if (is_keyword(string_.name)) {
      refuse("'" + string_.name +
             "' belongs to C or C++; use another name, such as text_" +
             string_.name);
    }
  }

  void parse_attributes(std::string_view list) {
    while (true) {
      const size_t comma = list.find(',');
      const std::string_view word = trimmed(list.substr(0, comma));
      if (word == "ltr" || word == "rtl") {
        string_.line.direction = word == "ltr" ? LineDirection::left_to_right
                                               : LineDirection::right_to_left;
      } else if (is_language(word)) {
        string_.line.language = word;
      } else {
        refuse("'" + std::string(word) +
               "' is no language, such as ar or zh-Hant, nor ltr or rtl");
      }
      if (comma == std::string_view::npos) {
        return;
      }
      list.remove_prefix(comma + 1);
    }
  }

  void parse_text(std::string_view text) {
    if (text.empty()) {
      refuse("'" + string_.name + "' has no text; write \"\" for an empty one");
    }
    const std::string bytes =
        text[0] == '"' ? unquoted(text, string_.file, string_.line_number)
                       : std::string(text);
    std::string_view rest = bytes;
    while (!rest.empty()) {
      const auto c = read_utf8(rest);
      if (!c) {
        refuse("the text is not UTF-8; save the file as UTF-8");
      }
      if (!is_shown(*c)) {
        refuse("'" + string_.name + "' holds " + describe(*c) +
               ", a control character; a string is one line without tabs");
      }
      string_.line.text += *c;
    }
  }

  NamedString string_;
};

void check_new(const NamedString& string,
               const std::vector<NamedString>& others) {
  for (const NamedString& other : others) {
    if (other.name == string.name) {
      refuse(string.file, string.line_number,
             "'" + string.name + "' is defined in " + other.file + ":" +
                 std::to_string(other.line_number) + ", too; rename one");
    }
  }
}

}  // namespace

void add_string_file(const std::filesystem::path& file,
                     std::vector<NamedString>& out) {
  const std::string content = read_text_file(file, "--strings");
  std::string_view rest = without_byte_order_mark(content);
  for (int number = 1; !rest.empty(); ++number) {
    const size_t end = std::min(rest.find('\n'), rest.size());
    const std::string_view line = trimmed(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (line.empty() || line[0] == '#') {
      continue;
    }
    NamedString string = LineParser(file.string(), number).parse(line);
    check_new(string, out);
    out.push_back(std::move(string));
  }
}

}  // namespace inkcell::gen
