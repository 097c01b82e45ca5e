// Undo, redo and the history, which say what they took back.
#include "editor/editor.hpp"

#include <algorithm>

namespace inkcell::design::editor {

// After undo or redo: the glyph that changed, so that nothing changes unseen.
void Editor::show_step(const char* done, const Step& step) {
  follow_change();
  const std::vector<GlyphChange>& glyphs = step.change.glyphs;
  const bool is_shown = std::any_of(
      glyphs.begin(), glyphs.end(),
      [this](const GlyphChange& glyph) { return glyph.name == glyph_; });
  if (!is_shown && !glyphs.empty() &&
      project().find(glyphs.front().name) != nullptr) {
    show(glyphs.front().name);
  }
  message = {done + step.title};
}

bool Editor::undo() {
  tool_->cancel(*this);
  const bool done = session_->undo();
  if (done) {
    show_step("Undone: ", session_->history()[session_->done()]);
  }
  return done;
}

bool Editor::redo() {
  tool_->cancel(*this);
  const bool done = session_->redo();
  if (done) {
    show_step("Redone: ", session_->history()[session_->done() - 1]);
  }
  return done;
}

void Editor::step_glyph(bool is_redo) {
  tool_->cancel(*this);
  const auto title = session_->step_glyph(master(), glyph_, is_redo);
  follow_change();
  const std::string what = is_redo ? "redo" : "undo";
  message = {title ? (is_redo ? "Redone: " : "Undone: ") + *title
                   : "There is nothing to " + what + " in " + glyph_};
}

void Editor::go_to(size_t done) {
  while (session_->done() > done && undo()) {
  }
  while (session_->done() < done && redo()) {
  }
}

}  // namespace inkcell::design::editor
