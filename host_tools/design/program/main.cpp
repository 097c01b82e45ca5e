// inkcell-design: designs type from the command line.
#include "program.hpp"
#include "program/commands.hpp"

int main(int argc, char** argv) {
  using namespace inkcell::design;
  CLI::App app(
      "Designs type: projects in UFO 3, strokes, curves, components, bitmap "
      "masters; from outlines to fields and back.");
  app.require_subcommand(1);
  Work work;
  add_export(app, work);
  add_import(app, work);
  add_import_svg(app, work);
  add_replay(app, work);
  add_roundtrip(app, work);
  add_script(app, work);
  add_trace(app, work);
  return inkcell::tools::run_program(app, argc, argv, [&work] {
    work();
    return 0;
  });
}
