// What files of a program show: sources and translations, told apart by their
// names.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "texts/located_text.hpp"

namespace inkcell::gen {

/// What a file shows, language by language. Its ending says what it is:
///
///   .po .pot      gettext
///   .json         JSON whose strings are shown
///   .csv          a column a language
///   others        C and C++ sources, of no language
///
/// A language is what the file says, or else its name and folders; or else the
/// name itself. Throws Error, which names `option` if the file cannot be read;
/// also for Qt's .ts, Android's .xml and .arb.
std::vector<LanguageText> shown_texts(const std::filesystem::path& file,
                                      const std::string& option);

}  // namespace inkcell::gen
