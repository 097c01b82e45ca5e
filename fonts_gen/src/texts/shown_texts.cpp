#include "texts/shown_texts.hpp"

#include <algorithm>
#include <string_view>

#include "base/error.hpp"
#include "source/char_set.hpp"
#include "texts/c_literals.hpp"
#include "texts/csv_file.hpp"
#include "texts/json_texts.hpp"
#include "texts/language_name.hpp"
#include "texts/po_file.hpp"

namespace inkcell::gen {
namespace {

// A file of Qt Linguist, Android or Flutter; a .ts may be a source, too.
bool is_unread_kind(std::string_view ending, std::string_view content) {
  const size_t at =
      std::min(content.find_first_not_of(" \t\r\n"), content.size());
  return ending == ".xml" || ending == ".arb" ||
         (ending == ".ts" && content.substr(at, 1) == "<");
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
  if (is_unread_kind(ending, content)) {
    throw Error(name + ": translations in " + ending +
                " are not read; convert the file to .po or .csv");
  }
  LanguageText shown;
  if (ending == ".po" || ending == ".pot") {
    shown.language = read_po_file(content, name, shown.text);
  } else if (ending == ".json") {
    read_json_file(content, name, shown.text);
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
