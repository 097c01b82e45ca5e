// Side bearings and kerning by dragging in a line of text.
#include <cmath>

#include "editor/edits.hpp"
#include "editor/spacing.hpp"
#include "editor/tool.hpp"
#include "export/tables.hpp"
#include "model/bearings.hpp"
#include "model/error.hpp"

namespace inkcell::design::editor {
namespace {

class SpacingTool : public Tool {
 public:
  void press(Editor& editor, const Pointer& pointer) override {
    const auto line = line_of_text(editor.project(), editor.preview.text);
    Part part = Part::none;
    double nearest = pointer.reach;
    size_t hit = 0;
    for (size_t i = 0; i < line.size(); ++i) {
      const double end = line[i].x + line[i].glyph->width;
      if (part == Part::none && pointer.at.x >= line[i].x &&
          pointer.at.x < end) {
        hit = i;
        part = Part::kern;
      }
      for (const auto& [side, x] :
           {std::pair(Part::left, line[i].x), std::pair(Part::right, end)}) {
        // Of two edges that coincide, that of the glyph under the pointer.
        const bool is_inside =
            side == Part::left ? pointer.at.x >= x : pointer.at.x <= x;
        const double d = std::abs(pointer.at.x - x) + (is_inside ? 0 : 1e-9);
        if (d < nearest) {
          nearest = d;
          hit = i;
          part = side;
        }
      }
    }
    if (part == Part::none) {
      return;
    }
    editor.show(line[hit].name);  // ends another press
    part_ = part;
    start_ = pointer.at;
    name_ = line[hit].name;
    before_ = hit == 0 ? "" : line[hit - 1].name;
    kern_ = line[hit].kern;
  }

  void drag(Editor& editor, const Pointer& pointer) override {
    if (part_ == Part::none) {
      return;
    }
    const double dx = std::round(pointer.at.x - start_.x);
    const Value command =
        dx == 0 ? Value() : command_of(editor, dx, pointer.alt);
    editor.propose(command);
    label_ = {pointer.at, command.is_null() ? "" : label_of(editor, dx)};
  }

  void release(Editor& editor, const Pointer&) override {
    part_ = Part::none;
    label_.reset();
    editor.commit();
  }

  void cancel(Editor& editor) override {
    part_ = Part::none;
    label_.reset();
    editor.propose(nullptr);
  }

  Marks marks(const Editor&) const override {
    Marks marks;
    if (label_ && !label_->second.empty()) {
      marks.labels.push_back(*label_);
    }
    return marks;
  }

 private:
  enum class Part { none, left, right, kern };

  // The space left of the ink shrinks if its edge moves to the right.
  Value command_of(const Editor& editor, double dx, bool alt) const {
    const Project& project = editor.project();
    if (part_ == Part::kern) {
      if (before_.empty()) {
        throw Error("kerning is between two glyphs; drag another one");
      }
      return set_kern(project, before_, name_, kern_ + dx, alt);
    }
    const size_t master = editor.master(name_);
    const GlyphPointer glyph = project.find(name_, master);
    const auto now = bearings_of(project, *glyph, master);
    if (!now) {
      const double sign = part_ == Part::left ? -1 : 1;
      return in_master(editor, name_,
                       {{"do", "set_advance"},
                        {"width", std::max(0.0, glyph->width + sign * dx)}});
    }
    Value command = in_master(editor, name_, {{"do", "set_bearings"}});
    if (part_ == Part::left) {
      command["left"] = now->left - dx;
    } else {
      command["right"] = now->right + dx;
    }
    return command;
  }

  std::string label_of(const Editor& editor, double dx) const {
    const Project shown = editor.shown_project();
    char text[128];
    if (part_ == Part::kern) {
      const KerningLookup kerning(*shown.font);
      std::snprintf(text, sizeof text, "%s  %g",
                    kern_text(kerning.entry(before_, name_)).c_str(),
                    kern_ + dx);
      return text;
    }
    const GlyphPointer glyph = shown.find(name_);
    const Bearings now =
        bearings_of(shown, *glyph).value_or(Bearings{0, glyph->width});
    std::snprintf(text, sizeof text, "left %g  right %g  advance %g", now.left,
                  now.right, glyph->width);
    return text;
  }

  Part part_ = Part::none;
  Point start_;
  std::string name_;
  std::string before_;  // the glyph before it; "" at the start of the line
  double kern_ = 0;
  std::optional<std::pair<Point, std::string>> label_;
};

}  // namespace

std::unique_ptr<Tool> make_spacing_tool() {
  return std::make_unique<SpacingTool>();
}

}  // namespace inkcell::design::editor
