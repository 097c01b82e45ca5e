#include "texts/po_file.hpp"

#include <algorithm>
#include <cstddef>

#include "base/trimmed.hpp"
#include "texts/language_name.hpp"

namespace inkcell::gen {
namespace {

// A string of several lines in the file.
struct PoString {
  struct Part {
    std::string bytes;
    int line;
  };
  std::vector<Part> parts;
  std::string text() const {
    std::string all;
    for (const Part& part : parts) {
      all += part.bytes;
    }
    return all;
  }
};

struct PoMessage {
  std::vector<PoString> ids;           // msgid and msgid_plural
  std::vector<PoString> translations;  // msgstr, or msgstr[0] and so on
  bool has_context = false;
  bool is_fuzzy = false;
  int line = 0;
};

// The value of a line of the header.
std::string header_value(const std::string& header, const std::string& name) {
  size_t begin = header.find(name);
  if (begin == std::string::npos) {
    return "";
  }
  begin += name.size();
  const std::string_view value = std::string_view(header).substr(
      begin, header.find_first_of("\n;", begin) - begin);
  return std::string(trimmed(value));
}

std::string lower(std::string text) {
  for (char& c : text) {
    c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return text;
}

class PoReader {
 public:
  PoReader(const std::string& file, LocatedText& out)
      : file_(file), out_(out) {}

  std::string read(std::string_view content) {
    while (!content.empty()) {
      const size_t end = std::min(content.find('\n'), content.size());
      const std::string_view line = content.substr(0, end);
      content.remove_prefix(std::min(end + 1, content.size()));
      ++line_;
      read_line(trimmed(line));
    }
    end_message();
    return language_;
  }

 private:
  void read_line(std::string_view line) {
    if (line.empty()) {
      return;
    }
    if (line[0] == '#') {
      // Comments are before a message.
      if (!message_.translations.empty()) {
        end_message();
      }
      if (line.substr(0, 2) == "#," &&
          line.find("fuzzy") != std::string_view::npos) {
        message_.is_fuzzy = true;
      }
      return;
    }
    if (line[0] != '"') {
      read_keyword(line);
    }
    if (string_ == nullptr) {
      refuse(file_, line_,
             "a string without msgid or msgstr before it; write one there");
    }
    string_->parts.push_back({unquoted(line, file_, line_), line_});
  }

  // Takes the keyword off, and opens a string.
  void read_keyword(std::string_view& line) {
    const size_t end = std::min(line.find('"'), line.size());
    const std::string_view word = trimmed(line.substr(0, end));
    line.remove_prefix(end);
    if (word == "msgctxt" || word == "msgid") {
      if (!message_.translations.empty()) {
        end_message();
      }
      if (!message_.ids.empty()) {
        refuse(file_, message_.line,
               "a msgid without msgstr; write msgstr \"\" after it");
      }
    }
    if (word == "msgctxt") {
      message_.has_context = true;
      string_ = &(context_ = PoString());
    } else if (word == "msgid" || word == "msgid_plural") {
      message_.line = word == "msgid" ? line_ : message_.line;
      string_ = &message_.ids.emplace_back();
    } else if (word == "msgstr" || word.substr(0, 7) == "msgstr[") {
      if (message_.ids.empty()) {
        refuse(file_, line_,
               "a msgstr without msgid; write its msgid before it");
      }
      string_ = &message_.translations.emplace_back();
    } else {
      refuse(file_, line_,
             "'" + std::string(word.substr(0, 20)) +
                 "' is no keyword of gettext; write msgctxt, msgid, "
                 "msgid_plural, msgstr or # before a comment");
    }
    if (line.empty()) {
      refuse(file_, line_,
             "'" + std::string(word) +
                 "' has no text; write \"\" for an empty one");
    }
  }

  void end_message() {
    string_ = nullptr;
    PoMessage message;
    std::swap(message, message_);
    if (message.ids.empty()) {
      return;
    }
    if (message.translations.empty()) {
      refuse(file_, message.line,
             "a msgid without msgstr; write msgstr \"\" after it");
    }
    if (!message.has_context && message.ids[0].text().empty()) {
      read_header(message);
      return;
    }
    const bool is_translated =
        !message.is_fuzzy &&
        std::any_of(message.translations.begin(), message.translations.end(),
                    [](const PoString& s) { return !s.text().empty(); });
    for (const PoString& string :
         is_translated ? message.translations : message.ids) {
      add(string);
    }
  }

  void add(const PoString& string) {
    for (const PoString::Part& part : string.parts) {
      add_shown(part.bytes, part.line, file_, out_);
    }
  }

  void read_header(const PoMessage& message) {
    const std::string header = "\n" + message.translations[0].text();
    language_ = language_tag(header_value(header, "\nLanguage:"));
    const std::string charset = lower(header_value(header, "charset="));
    if (charset != "" && charset != "charset" && charset != "utf-8" &&
        charset != "utf8" && charset != "ascii" && charset != "us-ascii") {
      refuse(file_, message.line,
             "the charset is " + charset +
                 ", only UTF-8 is read; convert the file: msgconv -t UTF-8");
    }
  }

  const std::string& file_;
  LocatedText& out_;
  std::string language_;
  PoMessage message_;
  PoString context_;            // which is not shown
  PoString* string_ = nullptr;  // that goes on
  int line_ = 0;
};

}  // namespace

std::string read_po_file(std::string_view content,
                         const std::string& file,
                         LocatedText& out) {
  return PoReader(file, out).read(content);
}

}  // namespace inkcell::gen
