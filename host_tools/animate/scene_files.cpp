#include "scene_files.hpp"

namespace inkcell::tools {

const char* const kSceneIcons =
    INKCELL_SOURCE_FOLDER "/boards/common/scenes/icons";
const char* const kSceneFigures = INKCELL_SOURCE_FOLDER "/docs/ANIMATING.md";

}  // namespace inkcell::tools
