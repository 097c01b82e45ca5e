#include "scene_icons.hpp"

namespace inkcell::tools {

const char* const kSceneIcons = INKCELL_SCENE_ICONS;

}  // namespace inkcell::tools
