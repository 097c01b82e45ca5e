#include "source/icon_files.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>
#include <string_view>

#include "base/error.hpp"
#include "source/char_set.hpp"
#include "source/shape_script.hpp"

namespace inkcell::gen {
namespace {

constexpr char32_t kFirstFree = 0xe000;  // the private use area begins here
constexpr const char* kList = "codepoints";

bool is_of(char c, int (*kind)(int)) {
  return kind(static_cast<unsigned char>(c)) != 0;
}

std::optional<char32_t> parse_hex(std::string_view digits) {
  uint32_t value = 0;
  const char* end = digits.data() + digits.size();
  const auto [at, error] = std::from_chars(digits.data(), end, value, 16);
  return error == std::errc() && at == end ? std::optional<char32_t>(value)
                                           : std::nullopt;
}

// "wifi-off 24" gives WifiOff24; characters of other scripts are dropped.
std::string name_of(std::string_view stem, char32_t code_point) {
  std::string name;
  bool begins = true;
  for (const char c : stem) {
    const bool is_good =
        static_cast<unsigned char>(c) < 0x80 && is_of(c, std::isalnum);
    if (is_good) {
      name +=
          begins
              ? static_cast<char>(std::toupper(static_cast<unsigned char>(c)))
              : c;
    }
    begins = !is_good;
  }
  if (name.empty()) {
    char code[16];
    std::snprintf(code, sizeof code, "U%04X",
                  static_cast<unsigned>(code_point));
    name = code;
  }
  return name;
}

// A file name without the code point at its start.
struct Stem {
  std::optional<char32_t> code_point;
  std::string_view rest;
};

Stem split_stem(std::string_view stem) {
  const std::string_view two = stem.substr(0, 2);
  const size_t prefix = two == "U+" || two == "u+" || two == "0x" || two == "0X"
                            ? 2
                        : !stem.empty() && stem[0] == 'u' ? 1
                                                          : 0;
  size_t end = prefix;
  bool has_decimal = false;
  while (end < stem.size() && is_of(stem[end], std::isxdigit)) {
    has_decimal |= is_of(stem[end], std::isdigit);
    ++end;
  }
  const size_t digits = end - prefix;
  const bool ends_well = end == stem.size() ||
                         (prefix > 0 && (stem[end] == '-' || stem[end] == '_'));
  if (digits < 4 || digits > 6 || !ends_well || (prefix < 2 && !has_decimal)) {
    return {std::nullopt, stem};
  }
  return {parse_hex(stem.substr(prefix, digits)),
          stem.substr(std::min(end + 1, stem.size()))};
}

// The emoji that a file name such as "1f468-200d-1f469" is of; empty: none.
std::u32string emoji_of(std::string stem) {
  constexpr std::string_view kNoto = "emoji_u";
  if (stem.compare(0, kNoto.size(), kNoto) == 0) {
    stem.erase(0, kNoto.size());
  }
  std::u32string emoji;
  bool is_emoji_name = false;
  std::replace(stem.begin(), stem.end(), '_', '-');
  std::istringstream parts(stem);
  for (std::string part; std::getline(parts, part, '-');) {
    const auto c = parse_hex(part);
    const bool is_key = part.size() == 2 && emoji.empty();
    if (!c || part.size() > 6 || (part.size() < 4 && !is_key)) {
      return {};
    }
    is_emoji_name = is_emoji_name || is_emoji(*c);
    if (*c != 0xfe0f) {
      emoji += *c;
    }
  }
  return is_emoji_name ? emoji : std::u32string();
}

IconFile make_icon(const std::filesystem::path& file, char32_t code_point) {
  const std::string stem = file.stem().string();
  const Stem parts = split_stem(stem);
  return {file, code_point, {}, name_of(parts.rest, code_point)};
}

// "wifi.svg=0xE001".
IconFile parse_icon(const std::string& text) {
  const size_t equals = text.rfind('=');
  CharSet code_points;
  if (equals != std::string::npos && equals > 0) {
    try {
      add_ranges(text.substr(equals + 1), code_points);
    } catch (const Error&) {
      code_points.clear();
    }
  }
  if (code_points.size() != 1) {
    throw Error("--svg: '" + text +
                "' is not FILE=CODE with one printable code point, such as "
                "wifi.svg=0xE001");
  }
  return make_icon(text.substr(0, equals), *code_points.begin());
}

std::vector<IconFile> listed_icons(const std::filesystem::path& folder) {
  std::vector<IconFile> icons;
  const std::filesystem::path list = folder / kList;
  std::ifstream in(list);
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    std::istringstream words(line.substr(0, line.find('#')));
    std::string name;
    std::string code;
    if (!(words >> name)) {
      continue;
    }
    words >> code;
    const auto code_point = parse_hex(code);
    std::string more;
    if (!code_point || words >> more) {
      throw Error(list.string() + ":" + std::to_string(number) + ": '" + line +
                  "' is not a name and a hexadecimal code point, such as "
                  "wifi E001");
    }
    icons.push_back(make_icon(folder / (name + ".svg"), *code_point));
  }
  if (icons.empty()) {
    throw Error(list.string() +
                ": lists no icon; write lines such as wifi "
                "E001, or remove the file");
  }
  return icons;
}

// The drawings of a folder; those without a code point have 0.
std::vector<IconFile> icons_of_folder(const std::filesystem::path& folder,
                                      bool has_emoji) {
  std::error_code error;
  if (!std::filesystem::is_directory(folder, error)) {
    throw Error(folder.string() + ": is no folder; check the --svg-dir");
  }
  if (std::filesystem::exists(folder / kList, error)) {
    return listed_icons(folder);
  }
  std::vector<IconFile> icons;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".svg") {
      const std::string stem = entry.path().stem().string();
      const std::u32string emoji =
          has_emoji ? emoji_of(stem) : std::u32string();
      icons.push_back(make_icon(entry.path(),
                                emoji.size() == 1
                                    ? emoji.front()
                                    : split_stem(stem).code_point.value_or(0)));
      if (emoji.size() > 1) {
        icons.back().sequence = emoji;
      }
    }
  }
  if (icons.empty()) {
    throw Error(folder.string() + ": holds no file *.svg; check the --svg-dir");
  }
  std::sort(icons.begin(), icons.end(), [](auto& a, auto& b) {
    return a.file.filename() < b.file.filename();
  });
  return icons;
}

void check(const IconFile& icon) {
  const char32_t c = icon.code_point;
  const bool is_control = c < 0x20 || (c >= 0x7f && c < 0xa0);
  if (is_control || c > 0x10ffff || (c >= 0xd800 && c <= 0xdfff)) {
    throw Error(icon.file.string() + ": " + describe(c) +
                " is no printable code point; take one of the private use "
                "area, such as 0xE001");
  }
}

}  // namespace

std::vector<IconFile> find_icons(
    const std::vector<std::string>& files,
    const std::vector<std::filesystem::path>& folders,
    bool has_emoji) {
  std::vector<IconFile> icons;
  std::map<std::u32string, IconFile> sequences;
  for (const std::string& text : files) {
    icons.push_back(parse_icon(text));
  }
  for (const std::filesystem::path& folder : folders) {
    for (const IconFile& icon : icons_of_folder(folder, has_emoji)) {
      if (icon.sequence.empty()) {
        icons.push_back(icon);
      } else if (const auto [found, is_new] =
                     sequences.emplace(icon.sequence, icon);
                 !is_new) {
        throw Error(icon.file.string() + ": is the emoji of " +
                    found->second.file.string() + " already; remove one");
      }
    }
  }
  std::map<char32_t, const IconFile*> by_code;
  const auto add = [&](const IconFile& icon) {
    check(icon);
    const auto [found, is_new] = by_code.emplace(icon.code_point, &icon);
    if (!is_new) {
      throw Error(icon.file.string() + ": " + describe(icon.code_point) +
                  " is that of " + found->second->file.string() +
                  " already; choose another");
    }
  };
  for (const IconFile& icon : icons) {
    if (icon.code_point != 0) {
      add(icon);
    }
  }
  char32_t next = kFirstFree;
  std::map<std::string, const IconFile*> by_name;
  for (IconFile& icon : icons) {
    if (icon.code_point == 0) {
      while (by_code.count(next) != 0) {
        ++next;
      }
      icon = make_icon(icon.file, next);
      add(icon);
    }
    const auto [found, is_new] = by_name.emplace(icon.name, &icon);
    if (!is_new) {
      throw Error(icon.file.string() + ": its constant would be k" + icon.name +
                  ", as that of " + found->second->file.string() +
                  "; rename one of them");
    }
  }
  std::sort(icons.begin(), icons.end(),
            [](auto& a, auto& b) { return a.code_point < b.code_point; });
  for (const auto& [sequence, icon] : sequences) {
    icons.push_back(icon);
  }
  return icons;
}

std::vector<std::filesystem::path> icon_lists(
    const std::vector<std::filesystem::path>& folders) {
  std::vector<std::filesystem::path> lists;
  for (const std::filesystem::path& folder : folders) {
    std::error_code error;
    if (std::filesystem::exists(folder / kList, error)) {
      lists.push_back(folder / kList);
    }
  }
  return lists;
}

}  // namespace inkcell::gen
