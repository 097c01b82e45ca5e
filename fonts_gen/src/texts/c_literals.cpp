#include "texts/c_literals.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "source/char_set.hpp"
#include "texts/c_escape.hpp"

namespace inkcell::gen {
namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

// Whether `c` can be in an identifier; bytes of UTF-8 can.
bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' ||
         c == '$' || static_cast<unsigned char>(c) >= 0x80;
}

bool is_space(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f' ||
         c == '\v';
}

// Directives without strings that a program shows.
bool is_skipped_directive(std::string_view word) {
  constexpr std::string_view kSkipped[] = {
      "error", "ident",  "import", "include", "include_next",
      "line",  "pragma", "sccs",   "warning"};
  return std::binary_search(std::begin(kSkipped), std::end(kSkipped), word);
}

// Adjacent literals, as bytes of UTF-8.
class Literal {
 public:
  Literal(const std::string& file, LocatedText& out) : file_(file), out_(out) {}

  void add_byte(char byte, int line, bool is_escaped) {
    bytes_ += byte;
    lines_.push_back(line);
    is_written_ = is_written_ ||
                  (!is_escaped && static_cast<unsigned char>(byte) >= 0x80);
  }

  void add_escape(const Escape& escape, bool is_wide, int line) {
    if (escape.is_unit && !is_wide) {
      add_byte(static_cast<char>(escape.value), line, true);
      return;
    }
    for (const char byte : to_utf8(escape.value)) {
      add_byte(byte, line, true);
    }
  }

  // Ends the literal at the next token.
  void end() {
    LocatedText found;
    std::string_view rest = bytes_;
    while (!rest.empty()) {
      const int line = lines_[bytes_.size() - rest.size()];
      const auto c = read_utf8(rest);
      if (!c && is_written_) {
        refuse(file_, line,
               "the string is not UTF-8; save the source as UTF-8");
      }
      if (!c) {
        found.clear();
        break;
      }
      if (is_shown(*c)) {
        found.push_back({*c, line});
      }
    }
    out_.insert(out_.end(), found.begin(), found.end());
    bytes_.clear();
    lines_.clear();
    is_written_ = false;
  }

 private:
  const std::string& file_;
  LocatedText& out_;
  std::string bytes_;
  std::vector<int> lines_;   // of each byte
  bool is_written_ = false;  // has bytes above ASCII that are not escapes
};

// Scans a source token by token.
class Scanner {
 public:
  Scanner(std::string_view source, const std::string& file, LocatedText& out)
      : source_(source), literal_(file, out) {
    join_lines();
  }

  void scan() {
    while (at_ < text_.size()) {
      if (!skip_blank()) {
        scan_token();
      }
    }
    literal_.end();
  }

 private:
  // Joins lines that end with a backslash with the next one.
  void join_lines() {
    int line = 1;
    for (size_t i = 0; i < source_.size(); ++i) {
      const std::string_view rest = source_.substr(i);
      const size_t joined = rest.substr(0, 2) == "\\\n"     ? 2
                            : rest.substr(0, 3) == "\\\r\n" ? 3
                                                            : 0;
      if (joined != 0) {
        i += joined - 1;
        ++line;
        continue;
      }
      text_ += source_[i];
      lines_.push_back(line);
      origins_.push_back(i);
      line += source_[i] == '\n' ? 1 : 0;
    }
  }

  bool starts_with(std::string_view what) const {
    return std::string_view(text_).substr(at_, what.size()) == what;
  }

  void skip_to_end_of_line() {
    at_ = std::min(text_.find('\n', at_), text_.size());
  }

  // Skips spaces, comments and directives; false if a token follows.
  bool skip_blank() {
    if (is_space(text_[at_])) {
      is_line_empty_ = is_line_empty_ || text_[at_] == '\n';
      ++at_;
      return true;
    }
    if (starts_with("//")) {
      skip_to_end_of_line();
      return true;
    }
    if (starts_with("/*")) {
      const size_t end = text_.find("*/", at_ + 2);
      at_ = end == std::string::npos ? text_.size() : end + 2;
      return true;
    }
    return is_line_empty_ && text_[at_] == '#' && skip_directive();
  }

  bool skip_directive() {
    size_t begin = at_ + 1;
    while (begin < text_.size() &&
           (text_[begin] == ' ' || text_[begin] == '\t')) {
      ++begin;
    }
    size_t end = begin;
    while (end < text_.size() && is_letter(text_[end])) {
      ++end;
    }
    literal_.end();
    if (!is_skipped_directive(
            std::string_view(text_).substr(begin, end - begin))) {
      at_ = end;
      is_line_empty_ = false;
      return true;
    }
    skip_to_end_of_line();
    return true;
  }

  void scan_token() {
    is_line_empty_ = false;
    const char c = text_[at_];
    if (c == '"') {
      scan_string(false);
    } else if (is_letter(c)) {
      scan_word();
    } else {
      literal_.end();
      const bool is_number =
          is_digit(c) ||
          (c == '.' && at_ + 1 < text_.size() && is_digit(text_[at_ + 1]));
      if (is_number) {
        skip_number();
      } else if (c == '\'') {
        skip_constant();
      } else {
        ++at_;
      }
    }
  }

  // An identifier, or the prefix of a literal.
  void scan_word() {
    const size_t begin = at_;
    while (at_ < text_.size() &&
           (is_letter(text_[at_]) || is_digit(text_[at_]))) {
      ++at_;
    }
    std::string_view word = std::string_view(text_).substr(begin, at_ - begin);
    const char next = at_ < text_.size() ? text_[at_] : '\0';
    const bool is_raw = next == '"' && word.back() == 'R';
    if (is_raw) {
      word.remove_suffix(1);
    }
    const bool is_wide = word == "L" || word == "u" || word == "U";
    const bool is_prefix = is_wide || word == "u8";
    if (next == '"' && is_raw && (is_prefix || word.empty())) {
      scan_raw_string();
    } else if (next == '"' && is_prefix) {
      scan_string(is_wide);
    } else {
      // The quote of a constant with a prefix is scanned next.
      literal_.end();
    }
  }

  void skip_number() {
    while (at_ < text_.size()) {
      const char c = text_[at_];
      const bool is_separator =
          c == '\'' && at_ + 1 < text_.size() &&
          (is_letter(text_[at_ + 1]) || is_digit(text_[at_ + 1]));
      if (!is_letter(c) && !is_digit(c) && c != '.' && !is_separator) {
        return;
      }
      ++at_;
    }
  }

  void skip_constant() {
    ++at_;
    while (at_ < text_.size() && text_[at_] != '\'' && text_[at_] != '\n') {
      at_ += text_[at_] == '\\' ? 2u : 1u;
    }
    at_ = std::min(at_ + 1, text_.size());
  }

  void scan_string(bool is_wide) {
    ++at_;
    while (at_ < text_.size() && text_[at_] != '"' && text_[at_] != '\n') {
      const int line = lines_[at_];
      if (text_[at_] != '\\') {
        literal_.add_byte(text_[at_++], line, false);
        continue;
      }
      std::string_view rest = std::string_view(text_).substr(at_ + 1);
      if (const auto escape = read_escape(rest)) {
        literal_.add_escape(*escape, is_wide, line);
        at_ = text_.size() - rest.size();
      } else {
        ++at_;
      }
    }
    at_ = std::min(at_ + 1, text_.size());
  }

  // Raw strings are read from the source, as their lines are not joined.
  void scan_raw_string() {
    const size_t quote = origins_[at_];
    const size_t open = std::min(source_.find('(', quote), source_.size());
    const std::string end =
        ")" + std::string(source_.substr(quote + 1, open - quote - 1)) + "\"";
    const size_t close = std::min(source_.find(end, open), source_.size());
    int line = lines_[at_];
    for (size_t i = open + 1; i < close; ++i) {
      literal_.add_byte(source_[i], line, false);
      line += source_[i] == '\n' ? 1 : 0;
    }
    const size_t end_of_literal = std::min(close + end.size(), source_.size());
    at_ = static_cast<size_t>(
        std::lower_bound(origins_.begin(), origins_.end(), end_of_literal) -
        origins_.begin());
  }

  std::string_view source_;
  Literal literal_;
  std::string text_;             // of joined lines
  std::vector<int> lines_;       // of each byte of text_
  std::vector<size_t> origins_;  // of each byte of text_, in source_
  size_t at_ = 0;
  bool is_line_empty_ = true;  // up to here
};

}  // namespace

LocatedText literal_characters(std::string_view source,
                               const std::string& file) {
  LocatedText out;
  Scanner(source, file, out).scan();
  return out;
}

}  // namespace inkcell::gen
