// Finds the drawings that become icons, and their code points.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace inkcell::gen {

/// An icon to make.
struct IconFile {
  std::filesystem::path file;
  char32_t code_point = 0;
  /// Instead of a code point: an emoji of several, without variation selectors.
  std::u32string sequence;
  /// The name in constants: wifi-off.svg gives WifiOff.
  std::string name;
};

/// The icons of `files`, such as "wifi.svg=0xE001", and of `folders`, in
/// ascending order of code points.
///
/// A folder gives all of its *.svg, or those listed in its file `codepoints`
/// ("wifi E001" on each line, hexadecimal). Without that file, a code point at
/// the start of the name is used: "U+E001-wifi.svg", "0xE001-wifi.svg",
/// "uE001-wifi.svg", or just "E001.svg". The last two need a decimal digit, so
/// that feed.svg is a name. The others get the first free code points from
/// U+E000 on, in the order of their names.
///
/// With `has_emoji` a name of several code points, such as
/// "1f468-200d-1f469.svg" or "emoji_u1f468_200d_1f469.svg", is an emoji of
/// several; these are the last, in the order of their code points.
///
/// Throws Error, also for two icons with one code point or one name.
std::vector<IconFile> find_icons(
    const std::vector<std::string>& files,
    const std::vector<std::filesystem::path>& folders,
    bool has_emoji = false);

/// The existing `codepoints` files of `folders`.
std::vector<std::filesystem::path> icon_lists(
    const std::vector<std::filesystem::path>& folders);

}  // namespace inkcell::gen
