// What a window of the editor shows, and all that can be done to it. Knows no
// window: scripts use it in the same way.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "editor/preview.hpp"
#include "editor/tool.hpp"
#include "journal/session.hpp"
#include "model/contours.hpp"

namespace inkcell::design::editor {

/// A point of the glyph that is shown.
struct PointId {
  size_t contour = 0;
  size_t point = 0;
};
inline bool operator<(PointId a, PointId b) {
  return std::pair(a.contour, a.point) < std::pair(b.contour, b.point);
}
using Selection = std::set<PointId>;

/// The part of the plane that the canvas shows.
struct View {
  double x = 0;  // the canvas's centre [font units]
  double y = 0;
  double scale = 0.5;  // [px per font unit]
  double width = 900;  // of the canvas [px]
  double height = 700;

  Point to_canvas(Point p) const {
    return {width / 2 + (p.x - x) * scale, height / 2 - (p.y - y) * scale};
  }
  Point to_font(Point p) const {
    return {x + (p.x - width / 2) / scale, y - (p.y - height / 2) / scale};
  }
  /// Keeps the font's point at `at` where it is. [px]
  void zoom(double factor, Point at);
};

/// The pen that strokes are drawn with. [font units, degrees]
struct NibSettings {
  bool is_rectangle = false;
  double width = 120;
  double height = 60;
  double angle = 30;

  std::string text() const;
};

/// A line for the user, below the canvas.
struct Message {
  std::string text;
  bool is_problem = false;  // until the next change
};

/// Where copies go: of the program alone unless a window sets it.
struct Clipboard {
  std::function<std::string()> read;
  std::function<void(const std::string&)> write;
};

class Editor {
 public:
  Editor();
  ~Editor();

  /// Opens a UFO, or makes one of a TTF or OTF: `project`, by default a folder
  /// of the font's name in the current one. `chars` limits what is taken of a
  /// font. Throws Error or gen::Error.
  void open(const std::filesystem::path& file,
            std::filesystem::path project = {},
            const std::vector<std::string>& chars = {});
  void save();
  /// Writes a copy: .ufo, .ttf or .bin. Throws Error.
  void export_to(const std::filesystem::path& file) const;

  bool is_open() const { return session_ != nullptr; }
  /// Only if is_open().
  const Session& session() const { return *session_; }
  const Project& project() const { return session_->project(); }

  void select_nothing();
  /// Selects all points of a contour, besides those that are.
  void select_contour(size_t contour);

  /// Shows a glyph by its name or its character. Throws Error.
  void show(const std::string& glyph);
  /// The next one in the order of the font, or the one before.
  void step(int by);
  const std::string& glyph_name() const { return glyph_; }
  /// With the change that is under way; null if none is shown.
  GlyphPointer glyph() const;
  /// The project with that change, for previews.
  Project shown_project() const;

  /// Carries out a command; "glyph" is filled in. It ends a press of the
  /// pointer. Throws Error.
  void run(Value command);
  /// A change that is under way, shown but not carried out; null ends it.
  void propose(Value command);
  /// Carries out the proposal, if there is one.
  void commit();
  bool undo();
  bool redo();

  void set_tool(ToolKind kind);
  ToolKind tool_kind() const { return tool_kind_; }
  Tool& tool() { return *tool_; }
  const Tool& tool() const { return *tool_; }

  void fit_view();

  /// Picture of what the device would draw; `draw_preview(job)` makes it.
  PreviewJob preview_job() const;

  Selection selection;
  std::optional<size_t> component;  // the selected one
  std::optional<size_t> guide;      // likewise
  Clipboard clipboard;
  View view;
  NibSettings nib;
  PreviewSettings preview;
  bool shows_layers = true;  // those beside the default one, behind it
  Message message;

 private:
  // A change that is shown, of the project as it is.
  struct Proposal {
    Value command;
    Change change;
    GlyphPointer glyph;  // the shown one; null: it does not change
  };

  void begin(const std::filesystem::path& folder);
  void take_change();
  void drop_lost_selection();

  std::unique_ptr<Session> session_;
  std::string glyph_;
  std::optional<Proposal> proposal_;
  ToolKind tool_kind_ = ToolKind::select;
  std::unique_ptr<Tool> tool_;
};

}  // namespace inkcell::design::editor
