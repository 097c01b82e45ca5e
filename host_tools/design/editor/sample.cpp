#include "editor/sample.hpp"

#include <sstream>

#include "editor/glyph_set.hpp"
#include "model/commands.hpp"

namespace inkcell::design::editor {

Project sample_project() {
  Project project;
  FontData font;
  font.info = {{"familyName", "Sample"}, {"styleName", "Regular"},
               {"unitsPerEm", 1000},     {"ascender", 800},
               {"descender", -200},      {"xHeight", 500},
               {"capHeight", 700}};
  project.font = std::make_shared<const FontData>(std::move(font));
  project.apply(change_of(project, add_glyphs(project, "0x20,b,d,l,n,o")));
  std::istringstream lines(kSampleCommands);
  for (std::string line; std::getline(lines, line);) {
    project.apply(change_of(project, Value::parse(line)));
  }
  return project;
}

}  // namespace inkcell::design::editor
