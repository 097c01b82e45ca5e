// Where tests find files and programs. Apart, so that a compiler cache knows
// the other sources in every folder.
#pragma once

namespace inkcell::gen::test {

extern const char* const kSourceFolder;  // of the project
extern const char* const kFontgen;
extern const char* const kCoreLibrary;
extern const char* const kCxxFlags;  // of this build

}  // namespace inkcell::gen::test
