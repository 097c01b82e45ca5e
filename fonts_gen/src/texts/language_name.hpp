// Names of languages in files of translations.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace inkcell::gen {

/// A name such as de, pt_BR, zh-Hans-CN, zh-rCN (Android) or b+sr+Latn as a tag
/// of BCP 47: pt-BR. Empty if it is none.
std::string language_tag(std::string_view name);

/// The language that a path says: of the end of its name, app_pt_BR.ts, or of
/// its folders, values-de/strings.xml and de/LC_MESSAGES/app.po. Empty if it
/// says none.
std::string language_of_path(const std::filesystem::path& file);

}  // namespace inkcell::gen
