// Translations in XML: files of Qt Linguist (.ts), and strings of Android.
#pragma once

#include <string>
#include <string_view>

#include "texts/located_text.hpp"

namespace inkcell::gen {

/// What a file of Qt Linguist shows, and its language, or nothing. Messages
/// without a translation are shown as their source. Throws Error.
std::string read_qt_file(std::string_view content,
                         const std::string& file,
                         LocatedText& out);

/// What the strings, plurals and arrays of strings of Android's resources show.
/// Throws Error.
void read_android_file(std::string_view content,
                       const std::string& file,
                       LocatedText& out);

}  // namespace inkcell::gen
