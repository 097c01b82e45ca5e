// The state of the editor and all of its operations, independent of the window:
// scripts use it, too.
#pragma once

#include <cmath>
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

/// The part of the plane on the canvas.
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
  /// Zooms with the font's point at `at` [px] fixed.
  void zoom(double factor, Point at);
};

/// The pen for strokes. [font units, degrees]
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
  bool is_problem = false;  // shown until the next change
};

/// The clipboard: of the program alone unless a window sets it.
struct Clipboard {
  std::function<std::string()> read;
  std::function<void(const std::string&)> write;
};

class Editor;

/// A command on a glyph of the edited master.
Value in_master(const Editor& editor, const std::string& glyph, Value command);
/// A command on the shown glyph, unless it names one, and so for each of a
/// batch.
Value for_glyph(const Editor& editor, Value command);

class Editor {
 public:
  Editor();
  ~Editor();

  /// Opens a UFO, or converts a TTF or OTF to `project`, by default a folder
  /// with the font's name in the working directory. `chars` selects the
  /// characters of a font. Throws Error or gen::Error.
  void open(const std::filesystem::path& file,
            std::filesystem::path project = {},
            const std::vector<std::string>& chars = {});
  /// Makes a project, a folder that does not exist, with `info` of fontinfo and
  /// the glyphs of a list (add_glyphs()), and opens it. Throws Error.
  void create(const std::filesystem::path& folder,
              const Value& info,
              const std::string& glyphs);
  /// Opens the sample project, which is made in the current folder unless it is
  /// there.
  void open_sample();
  void save();
  /// Saves as another project, which does not exist, and continues there; the
  /// old one stays as it was saved last. Throws Error.
  void save_as(const std::filesystem::path& folder);
  /// Drops all changes since the project was saved.
  void revert();
  /// revert() before the program ends.
  void discard() { session_->close(); }
  /// Writes a copy: .ufo, .ttf or .bin. Throws Error.
  void export_to(const std::filesystem::path& file);

  bool is_open() const { return session_ != nullptr; }
  /// Only if is_open().
  const Session& session() const { return *session_; }
  const Project& project() const { return session_->project(); }
  /// Whether a glyph differs from what was saved.
  bool is_changed(const std::string& glyph) const;

  void select_nothing();
  /// Adds all points of a contour to the selection.
  void select_contour(size_t contour);

  /// Shows a glyph by its name or its character. Throws Error.
  void show(const std::string& glyph);
  /// Shows the next or the previous glyph, in the order of the font.
  void step(int by);
  const std::string& glyph_name() const { return glyph_; }
  /// With the proposed change; null if no glyph is shown.
  GlyphPointer glyph() const;
  /// Without it; only if a glyph is shown.
  GlyphPointer stored() const { return project().find(glyph_, master()); }
  /// The project with the proposed change, for previews; its default layer has
  /// the glyphs of the edited master.
  Project shown_project() const;

  /// The layer that is edited; the default one if the chosen one lacks the
  /// glyph.
  size_t master(const std::string& glyph) const;
  size_t master() const { return master(glyph_); }
  void choose_master(size_t layer);
  /// Saves the project with another master, a layer with the glyphs of the
  /// default one, which is edited from now on; with stems that are wider by
  /// `bolder` (change_weight). [font units] Throws Error.
  void add_master(const std::string& name, double bolder = 0);
  /// Saves the project without a master other than the default one, and without
  /// its axes. Throws Error.
  void remove_master(const std::string& name);
  /// The glyph at `part_between`; nothing at 0, and if the masters do not
  /// correspond.
  std::optional<Glyph> glyph_between() const;

  /// Runs a command on the shown glyph; "glyph" is filled in. Ends a press of
  /// the pointer. Throws Error, and sets `pending` if strokes or a tree would
  /// be lost.
  void run(Value command);
  /// Shows a change without running it; null removes it.
  void propose(Value command);
  /// Runs the proposal, if there is one.
  void commit();
  /// Both show a glyph that changed, if it was not on the screen.
  bool undo();
  bool redo();
  /// Takes back the last change of the shown glyph alone, or such an undo.
  void step_glyph(bool is_redo);
  /// Undoes or redoes until `done` steps of the history are done.
  void go_to(size_t done);
  /// Drops the strokes or the tree of the glyph: its points can be moved. Then
  /// runs the pending command, in the same step.
  void make_outline();

  void set_tool(ToolKind kind);
  ToolKind tool_kind() const { return tool_kind_; }
  Tool& tool() { return *tool_; }
  const Tool& tool() const { return *tool_; }

  void fit_view();

  /// The job for a preview of the device's picture, for draw_preview().
  PreviewJob preview_job() const;

  Selection selection;
  Selection knots;  // of the glyph's strokes: numbers of stroke and point
  std::optional<size_t> component;  // the selected one
  std::optional<size_t> guide;      // likewise
  std::optional<size_t> part;       // of the glyph's tree, in order
  /// A command that was refused, since its glyph would no longer be made of
  /// strokes or parts. make_outline() runs it.
  std::optional<Value> pending;
  Clipboard clipboard;
  View view;
  Point hover = {INFINITY, INFINITY};  // the pointer's last place on the canvas
  NibSettings nib;
  PreviewSettings preview;
  bool dark_theme = false;
  double part_between = 0;   // the way to the other master, 0..1, of previews
  bool shows_black = false;  // the glyph alone, as Space does
  bool shows_layers = true;  // other layers, behind the default one
  Message message;
  std::string imported;  // what the last import left out; cleared when read

 private:
  // A change that is shown but not run.
  struct Proposal {
    Value command;
    Change change;
    GlyphPointer glyph;  // null: unchanged
  };

  void begin(const std::filesystem::path& folder);
  std::string usual_text() const;
  void ask_before_loss(const Value& command, const Change& change);
  void follow_change();
  void write_layers(const Project& changed);
  void show_step(const char* done, const Step& step);
  void drop_lost_selection();

  std::unique_ptr<Session> session_;
  std::string glyph_;
  size_t layer_ = 0;         // the chosen master
  bool had_source_ = false;  // strokes or a tree, before the last change
  std::optional<Proposal> proposal_;
  ToolKind tool_kind_ = ToolKind::select;
  std::unique_ptr<Tool> tool_;
};

}  // namespace inkcell::design::editor
