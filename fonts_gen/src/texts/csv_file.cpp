#include "texts/csv_file.hpp"

#include <algorithm>
#include <cstddef>

#include "base/trimmed.hpp"
#include "texts/c_escape.hpp"
#include "texts/language_name.hpp"

namespace inkcell::gen {
namespace {

// The separator of which the first line has most.
char separator_of(std::string_view content) {
  const std::string_view line = content.substr(0, content.find('\n'));
  const auto count = [line](char c) {
    return std::count(line.begin(), line.end(), c);
  };
  char most = ',';
  for (const char c : {';', '\t'}) {
    most = count(c) > count(most) ? c : most;
  }
  return most;
}

// Reads cell by cell.
class CsvReader {
 public:
  CsvReader(std::string_view content, const std::string& file)
      : rest_(content), file_(file), separator_(separator_of(content)) {}

  bool at_end() const { return rest_.empty(); }
  int line() const { return line_; }

  // The cells of a row.
  std::vector<std::string> next_row() {
    std::vector<std::string> cells(1);
    begins_ = {line_};
    while (!rest_.empty()) {
      read_cell(cells.back());
      const bool is_last = rest_.empty() || rest_[0] == '\n';
      if (!rest_.empty()) {
        rest_.remove_prefix(1);
      }
      if (is_last) {
        ++line_;
        break;
      }
      cells.emplace_back();
      begins_.push_back(line_);
    }
    return cells;
  }

  // The line in which a cell of the row begins.
  int line_of(size_t cell) const { return begins_[cell]; }

 private:
  // Up to the separator or line feed behind it.
  void read_cell(std::string& cell) {
    if (rest_[0] == '"') {
      read_quoted(cell);
      return;
    }
    const char ends[] = {separator_, '\n', '\0'};
    const size_t end = std::min(rest_.find_first_of(ends), rest_.size());
    cell = rest_.substr(0, end);
    rest_.remove_prefix(end);
  }

  void read_quoted(std::string& cell) {
    const int begin = line_;
    do {
      rest_.remove_prefix(1);
      const size_t end = rest_.find('"');
      if (end == std::string_view::npos) {
        refuse(file_, begin,
               "a cell begins with a quotation mark and has none at its end; "
               "add it, and write \"\" for one that is shown");
      }
      cell += rest_.substr(0, end);
      line_ += static_cast<int>(std::count(
          rest_.begin(), rest_.begin() + static_cast<long>(end), '\n'));
      rest_.remove_prefix(end + 1);
      if (!rest_.empty() && rest_[0] == '"') {
        cell += '"';  // two are one that is shown
      }
    } while (!rest_.empty() && rest_[0] == '"');
    if (!rest_.empty() && rest_[0] == '\r') {
      rest_.remove_prefix(1);
    }
    if (!rest_.empty() && rest_[0] != separator_ && rest_[0] != '\n') {
      refuse(file_, line_,
             "something follows the last quotation mark of a cell; write \"\" "
             "for one that is shown");
    }
  }

  std::string_view rest_;
  const std::string& file_;
  char separator_;
  int line_ = 1;
  std::vector<int> begins_;
};

// Names of columns as language_tag() reads them: PT-br is pt-BR, zh_hans is
// zh-Hans.
std::string in_usual_case(std::string_view name) {
  std::string usual;
  bool is_first_part = true;
  while (!name.empty()) {
    const size_t end = std::min(name.find_first_of("-_"), name.size());
    for (size_t i = 0; i < end; ++i) {
      const bool is_upper =
          !is_first_part && (end == 2 || (end == 4 && i == 0));
      const bool is_letter = (name[i] | 0x20) >= 'a' && (name[i] | 0x20) <= 'z';
      usual += static_cast<char>(!is_letter ? name[i]
                                 : is_upper ? name[i] & ~0x20
                                            : name[i] | 0x20);
    }
    usual += end < name.size() ? "-" : "";
    name.remove_prefix(std::min(end + 1, name.size()));
    is_first_part = false;
  }
  return usual;
}

// A backslash that begins no escape of C is one that is shown.
void add_cell(std::string_view cell,
              int line,
              const std::string& file,
              LocatedText& out) {
  std::string shown;
  while (!cell.empty()) {
    const char c = cell[0];
    cell.remove_prefix(1);
    const auto escape = c == '\\' ? read_escape(cell) : std::nullopt;
    shown += escape ? bytes_of(*escape) : std::string(1, c);
    if (c == '\n') {
      add_shown(shown, line++, file, out);
      shown.clear();
    }
  }
  add_shown(shown, line, file, out);
}

}  // namespace

std::vector<LanguageText> read_csv_file(std::string_view content,
                                        const std::string& file) {
  CsvReader reader(content, file);
  const std::vector<std::string> names = reader.next_row();
  std::vector<LanguageText> columns(names.size());
  bool has_language = false;
  for (size_t i = 1; i < names.size(); ++i) {
    columns[i].language = language_tag(in_usual_case(trimmed(names[i])));
    has_language = has_language || !columns[i].language.empty();
  }
  if (!has_language) {
    refuse(file, 1,
           "no column after the first has the name of a language; name the "
           "columns, as in key,de,zh-CN");
  }
  while (!reader.at_end()) {
    const std::vector<std::string> cells = reader.next_row();
    if (cells.size() > columns.size()) {
      refuse(file, reader.line_of(columns.size()),
             "the row has " + std::to_string(cells.size()) +
                 " cells, the first line " + std::to_string(columns.size()) +
                 "; put cells with separators into quotation marks");
    }
    for (size_t i = 0; i < cells.size(); ++i) {
      if (!columns[i].language.empty()) {
        add_cell(cells[i], reader.line_of(i), file, columns[i].text);
      }
    }
  }
  columns.erase(std::remove_if(columns.begin(), columns.end(),
                               [](const LanguageText& column) {
                                 return column.language.empty();
                               }),
                columns.end());
  return columns;
}

}  // namespace inkcell::gen
