// Where the drawings of scene `icons` are, and the document with the figures of
// scenes. Apart, so that a compiler cache knows the other sources in every
// folder.
#pragma once

namespace inkcell::tools {

extern const char* const kSceneIcons;
extern const char* const kSceneFigures;

}  // namespace inkcell::tools
