#include "texts/shown_texts.hpp"

#include <string_view>

#include "source/char_set.hpp"
#include "texts/c_literals.hpp"
#include "texts/csv_file.hpp"
#include "texts/json_texts.hpp"
#include "texts/language_name.hpp"
#include "texts/po_file.hpp"
#include "texts/xml_texts.hpp"

namespace inkcell::gen {
namespace {

bool begins_with_tag(std::string_view content) {
  const size_t at = content.find_first_not_of(" \t\r\n");
  return at != std::string_view::npos && content[at] == '<';
}

}  // namespace

std::vector<LanguageText> shown_texts(const std::filesystem::path& file,
                                      const std::string& option) {
  const std::string bytes = read_text_file(file, option);
  const std::string_view content = without_byte_order_mark(bytes);
  const std::string name = file.string();
  const std::string ending = file.extension().string();
  if (ending == ".csv") {
    return read_csv_file(content, name);
  }
  LanguageText shown;
  if (ending == ".po" || ending == ".pot") {
    shown.language = read_po_file(content, name, shown.text);
  } else if (ending == ".ts" && begins_with_tag(content)) {
    shown.language = read_qt_file(content, name, shown.text);
  } else if (ending == ".xml") {
    read_android_file(content, name, shown.text);
  } else if (ending == ".arb" || ending == ".json") {
    shown.language =
        read_json_file(content, name, ending == ".arb", shown.text);
  } else {
    shown.text = literal_characters(content, name);
    return {shown};
  }
  if (shown.language.empty()) {
    shown.language = language_of_path(file);
  }
  if (shown.language.empty()) {
    shown.language = file.filename().string();
  }
  return {shown};
}

}  // namespace inkcell::gen
