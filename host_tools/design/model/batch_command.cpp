// Several commands as one step.
#include "model/command_table.hpp"

namespace inkcell::design {
namespace {

// Adds the changes of `next` to `sum`, which comes before it.
void append(const Change& next, Change& sum) {
  for (const GlyphChange& glyph : next.glyphs) {
    bool is_new = true;
    for (GlyphChange& known : sum.glyphs) {
      if (known.layer == glyph.layer && known.name == glyph.name) {
        known.after = glyph.after;
        is_new = false;
      }
    }
    if (is_new) {
      sum.glyphs.push_back(glyph);
    }
  }
  if (next.font_after != nullptr) {
    if (sum.font_before == nullptr) {
      sum.font_before = next.font_before;
    }
    sum.font_after = next.font_after;
  }
}

Change batch(const Project& project, const Arguments& arguments) {
  arguments.text("title", "");  // of the history
  Project state = project;
  Change sum;
  for (const Value& command : arguments.array("commands")) {
    const Change change = own_change_of(state, command);
    state.apply(change);
    append(change, sum);
  }
  return sum;
}

}  // namespace

void add_batch_command(CommandTable& table) {
  table["batch"] = batch;
}

}  // namespace inkcell::design
