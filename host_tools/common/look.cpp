// Sets brushes up as people ask for them.
#include "look.hpp"

#include "canvas.hpp"
#include "filters.hpp"

namespace inkcell::tools {
namespace {

const Filter& filter_for(const std::string& name, Use use) {
  if (name.empty()) {
    return use == Use::moving ? kFilterMotion : kFilterText;
  }
  return filter_of(name);
}

}  // namespace

void add_look_options(CLI::App& app, LookOptions& options) {
  app.add_option("--filter", options.filter,
                 "text, motion, paper_display or paper_body [text; motion for "
                 "jobs of kind anim]");
}

Look::Look(const LookOptions& options,
           const Font& /*font*/,
           double px,
           double angle,
           Use use)
    : brush_(make_brush(px, angle, filter_for(options.filter, use))) {}

}  // namespace inkcell::tools
