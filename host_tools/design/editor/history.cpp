// Undo, redo and the history, which say what they took back.
#include "editor/editor.hpp"

namespace inkcell::design::editor {

bool Editor::undo() {
  tool_->cancel(*this);
  const bool done = session_->undo();
  follow_change();
  if (done) {
    message = {"Undone: " + session_->history()[session_->done()].title};
  }
  return done;
}

bool Editor::redo() {
  tool_->cancel(*this);
  const bool done = session_->redo();
  follow_change();
  if (done) {
    message = {"Redone: " + session_->history()[session_->done() - 1].title};
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
