#include "texts/xml_texts.hpp"

#include <algorithm>
#include <cstddef>
#include <pugixml.hpp>

#include "source/char_set.hpp"
#include "texts/language_name.hpp"

namespace inkcell::gen {
namespace {

// A document, and where its texts are.
class XmlFile {
 public:
  XmlFile(std::string_view content, const std::string& file)
      : file_(file), content_(content) {
    const pugi::xml_parse_result result = document_.load_buffer(
        content.data(), content.size(),
        pugi::parse_default | pugi::parse_ws_pcdata, pugi::encoding_utf8);
    if (!result) {
      refuse(file,
             line_at(content, static_cast<size_t>(
                                  std::max<ptrdiff_t>(result.offset, 0))),
             "the XML ends or is wrong here: " +
                 std::string(result.description()) +
                 "; check tags, quotation marks and &amp; for &");
    }
  }

  // From the last node on that was asked for: most nodes follow it.
  int line_of(pugi::xml_node node) const {
    const auto at =
        static_cast<size_t>(std::max<ptrdiff_t>(node.offset_debug(), 0));
    if (at < known_at_) {
      known_at_ = 0;
      known_line_ = 1;
    }
    known_line_ += line_at(content_.substr(known_at_), at - known_at_) - 1;
    known_at_ = at;
    return known_line_;
  }

  // The root, which shall have this name.
  pugi::xml_node root(const char* name, const char* what) const {
    const pugi::xml_node root = document_.document_element();
    if (std::string_view(root.name()) != name) {
      refuse(file_, root ? line_of(root) : 1,
             std::string("the root is <") + root.name() + ">, that of " + what +
                 " is <" + name +
                 ">; give such a file, or text as --text-file");
    }
    return root;
  }

  // Calls `take(text, line)` with each line of the texts in an element and in
  // the elements there.
  template <typename Take>
  void lines_in(pugi::xml_node element, const Take& take) const {
    for (pugi::xml_node node = next_in(element, element); node;
         node = next_in(element, node)) {
      if (node.type() != pugi::node_pcdata && node.type() != pugi::node_cdata) {
        continue;
      }
      int line = line_of(node);
      std::string_view rest = node.value();
      while (!rest.empty()) {
        const size_t end = std::min(rest.find('\n'), rest.size());
        take(rest.substr(0, end), line++);
        rest.remove_prefix(std::min(end + 1, rest.size()));
      }
    }
  }

 private:
  // The node that follows in an element; null after the last.
  static pugi::xml_node next_in(pugi::xml_node element, pugi::xml_node node) {
    if (node.first_child()) {
      return node.first_child();
    }
    while (node != element && !node.next_sibling()) {
      node = node.parent();
    }
    return node == element ? pugi::xml_node() : node.next_sibling();
  }

  const std::string& file_;
  std::string_view content_;
  pugi::xml_document document_;
  mutable size_t known_at_ = 0;
  mutable int known_line_ = 1;
};

// Escapes of Android: a backslash and a character, or \u and four digits.
class AndroidText {
 public:
  AndroidText(const std::string& file, LocatedText& out)
      : file_(file), out_(out) {}

  void add(std::string_view text, int line) {
    while (!text.empty()) {
      const size_t end = std::min(text.find_first_of("\\\""), text.size());
      add_shown(text.substr(0, end), line, file_, out_);
      text.remove_prefix(end);
      if (text.empty()) {
        return;
      }
      const bool is_escape = text[0] == '\\';
      text.remove_prefix(1);  // quotation marks keep blanks, and are not shown
      if (is_escape && !text.empty()) {
        add_escape(text, line);
      }
    }
  }

 private:
  void add_escape(std::string_view& text, int line) {
    const char c = text[0];
    text.remove_prefix(1);
    if (c == 'u') {
      add_unit(take_unit(text, line), text, line);
      return;
    }
    if (std::string_view("nt'\"\\@?# ").find(c) == std::string_view::npos) {
      refuse(file_, line,
             "a backslash is followed by no escape sequence of Android; write "
             "\\\\ for a backslash");
    }
    if (c != 'n' && c != 't') {
      add_shown({&c, 1}, line, file_, out_);
    }
  }

  char32_t take_unit(std::string_view& text, int line) const {
    char32_t value = 0;
    for (size_t i = 0; i < 4; ++i) {
      const char c = text.empty() ? '\0' : text[0];
      const int digit = c >= '0' && c <= '9'   ? c - '0'
                        : c >= 'a' && c <= 'f' ? c - 'a' + 10
                        : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                               : -1;
      if (digit < 0) {
        refuse(file_, line, "\\u has four hexadecimal digits, as in \\u00e9");
      }
      value = value * 16 + static_cast<char32_t>(digit);
      text.remove_prefix(1);
    }
    return value;
  }

  // A unit of UTF-16, and a second one where it is half a character.
  void add_unit(char32_t unit, std::string_view& text, int line) {
    if (unit >= 0xd800 && unit < 0xdc00 && text.substr(0, 2) == "\\u") {
      text.remove_prefix(2);
      const char32_t low = take_unit(text, line);
      unit = low >= 0xdc00 && low < 0xe000
                 ? 0x10000 + ((unit - 0xd800) << 10) + (low - 0xdc00)
                 : 0xd800;
    }
    if (unit >= 0xd800 && unit < 0xe000) {
      refuse(file_, line,
             "\\u names half a character; write both halves, as in "
             "\\ud83d\\ude00");
    }
    add_shown(to_utf8(unit), line, file_, out_);
  }

  const std::string& file_;
  LocatedText& out_;
};

}  // namespace

std::string read_qt_file(std::string_view content,
                         const std::string& file,
                         LocatedText& out) {
  const XmlFile xml(content, file);
  const pugi::xml_node root = xml.root("TS", "Qt Linguist");
  const auto add = [&](std::string_view text, int line) {
    add_shown(text, line, file, out);
  };
  for (const pugi::xml_node context : root.children("context")) {
    for (const pugi::xml_node message : context.children("message")) {
      const pugi::xml_node translation = message.child("translation");
      const std::string_view type = translation.attribute("type").value();
      if (type == "vanished" || type == "obsolete") {
        continue;
      }
      bool is_translated = false;
      xml.lines_in(translation, [&](std::string_view text, int) {
        is_translated =
            is_translated || text.find_first_not_of(" \t\r") != text.npos;
      });
      xml.lines_in(is_translated ? translation : message.child("source"), add);
    }
  }
  return language_tag(root.attribute("language").value());
}

void read_android_file(std::string_view content,
                       const std::string& file,
                       LocatedText& out) {
  const XmlFile xml(content, file);
  AndroidText shown(file, out);
  const auto add = [&](pugi::xml_node element) {
    const std::string_view text = element.text().get();
    if (text.substr(0, 8) != "@string/") {  // that of another one
      xml.lines_in(element, [&](std::string_view part, int line) {
        shown.add(part, line);
      });
    }
  };
  for (const pugi::xml_node element :
       xml.root("resources", "Android's strings").children()) {
    const std::string_view name = element.name();
    if (name == "string") {
      add(element);
    } else if (name == "string-array" || name == "plurals") {
      for (const pugi::xml_node item : element.children("item")) {
        add(item);
      }
    }
  }
}

}  // namespace inkcell::gen
