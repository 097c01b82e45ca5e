#include "paths.hpp"

namespace inkcell::gen::test {

const char* const kSourceFolder = INKCELL_SOURCE_DIR;
const char* const kFontgen = INKCELL_FONTGEN;
const char* const kCoreLibrary = INKCELL_CORE_LIBRARY;
const char* const kCxxFlags = INKCELL_CXX_FLAGS;

}  // namespace inkcell::gen::test
