// Which drawings become icons, and with which code points.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace inkcell::gen {

/// One icon to be.
struct IconFile {
  std::filesystem::path file;
  char32_t code_point = 0;
  /// As constants name it: wifi-off.svg gives WifiOff.
  std::string name;
};

/// The icons of `files`, such as "wifi.svg=0xE001", and of `folders`, in
/// ascending order of code points.
///
/// A folder gives all of its *.svg, or those that its file `codepoints` lists
/// ("wifi E001" on each line, hexadecimal). Without that file, an icon has the
/// code point with which its name begins: "U+E001-wifi.svg", "0xE001-wifi.svg",
/// "uE001-wifi.svg", or "E001.svg" alone, the latter two with a decimal digit
/// in it, so that feed.svg is a name. All others take, in the order of their
/// names, the first ones from U+E000 on that no icon has.
///
/// Throws Error, also for two icons with one code point or one name.
std::vector<IconFile> find_icons(
    const std::vector<std::string>& files,
    const std::vector<std::filesystem::path>& folders);

/// The lists of code points of `folders`, as far as there are any.
std::vector<std::filesystem::path> icon_lists(
    const std::vector<std::filesystem::path>& folders);

}  // namespace inkcell::gen
