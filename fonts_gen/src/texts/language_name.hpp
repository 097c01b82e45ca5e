// Names of languages in files of translations.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace inkcell::gen {

/// A name such as de, pt_BR or zh-Hans-CN as a tag of BCP 47: pt-BR. Empty if
/// it is none.
std::string language_tag(std::string_view name);

/// The language that a path says: of the end of its name, app_pt_BR.po, or of
/// its folders, de/strings.json and de/LC_MESSAGES/app.po. Empty if it says
/// none.
std::string language_of_path(const std::filesystem::path& file);

}  // namespace inkcell::gen
