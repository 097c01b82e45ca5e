// Where the drawings of scene `icons` are. Apart, so that a compiler cache
// knows the other sources in every folder.
#pragma once

namespace inkcell::tools {

extern const char* const kSceneIcons;

}  // namespace inkcell::tools
