// The command that makes the curves of a glyph anew, from its field.
#include "model/command_table.hpp"
#include "model/contours.hpp"
#include "trace/field_outline.hpp"

namespace inkcell::design {
namespace {

// The field is this true at 8 to 64 px/em, as in `roundtrip`. [1/255]
constexpr int kTolerance = 4;

Change curves_of_field(const Project& project, const Arguments& arguments) {
  FieldOutlineOptions options;
  options.tolerance_u = arguments.number("fit", options.tolerance_u);
  if (!(options.tolerance_u >= 0.05 && options.tolerance_u <= 16)) {
    arguments.refuse("\"fit\" is 0.05 to 16, in 1/1024 em");
  }
  return edited(project, arguments, [&](Glyph& glyph) {
    Glyph own = glyph;
    own.components.clear();
    const gen::Shape shape(outline_of(project, own));
    if (shape.empty()) {
      arguments.refuse("the glyph has no closed contours of its own");
    }
    gen::Target target;
    target.coding = gen::Coding::field;
    target.tolerance = kTolerance;
    const ShapeField field(shape, target);
    glyph.contours = in_direction_of(
        project, glyph,
        contours_of(project, outline_of(field.field(), options),
                    arguments.number("grid", 1)));
  });
}

}  // namespace

void add_field_commands(CommandTable& table) {
  table["curves_of_field"] = curves_of_field;
}

}  // namespace inkcell::design
