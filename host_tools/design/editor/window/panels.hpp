// The parts of the window. Each draws itself and calls the editor.
#pragma once

#include <imgui.h>

#include <memory>
#include <string>
#include <vector>

#include "editor/editor.hpp"
#include "editor/lua_run.hpp"
#include "editor/preview.hpp"
#include "shape/shape.hpp"
#include "window/textures.hpp"
#include "window/theme.hpp"
#include "window/widgets.hpp"

namespace inkcell::design::editor {

namespace colour = tools::colour;
using tools::choice;
using tools::panel;
using tools::px;
using tools::Textures;
using tools::tooltip;

/// The picture behind a glyph, decoded once.
struct BackgroundPicture {
  std::string file;
  ImageBytes bytes;
  std::shared_ptr<const tools::Image> image;  // null: it cannot be shown
};

/// The shape of a glyph in the line of the Spacing tool.
struct LineShape {
  GlyphPointer glyph;
  std::shared_ptr<const gen::Shape> shape;
};

/// What the sliders of weight and offset say. [font units]
struct WeightValues {
  bool is_offset = false;
  float by = 0;
  float bars = 0;
  float counters = 100;  // [%] kept
  bool keeps_advance = false;
  int side = 0;  // outside, inside, both
};

/// Shared state of the panels, beside the editor.
struct Panels {
  Panels(Editor& shown, Textures& kept) : editor(shown), textures(kept) {}

  Editor& editor;
  Textures& textures;
  bool dark_theme = false;  // as it was set last
  LuaRun lua;               // the program whose sliders are shown
  std::string search;       // in the grid of glyphs
  std::shared_ptr<const Preview> preview;  // what is shown, may be null
  bool preview_is_busy = false;
  bool wants_quit = false;
  std::string dialog;  // the one that is open: its name; "" if none is
  std::vector<std::string> dialog_values;
  std::string dialog_problem;  // of the values, shown in the dialog
  struct {
    float x = 100;  // [%]
    float y = 100;
    float slant = 0;  // [degrees]
    float turn = 0;
  } transform;
  WeightValues weight;
  std::string followed;  // the glyph that the grid has scrolled to
  // The filled shape on the canvas: the glyph without components.
  GlyphPointer filled;
  std::shared_ptr<const gen::Shape> shape;
  std::vector<LineShape> line_shapes;
  BackgroundPicture background;
};

/// Runs `work`; an exception becomes the editor's message.
template <typename Work>
void attempt(Editor& editor, const Work& work) {
  try {
    work();
  } catch (const std::exception& error) {
    editor.message = {error.what(), true};
  }
}

/// Draws the whole window.
void draw_window(Panels& panels);

void draw_menu(Panels& panels);
void draw_toolbar(Panels& panels);
void draw_glyph_grid(Panels& panels);
/// The glyphs whose name or character has `text`, exact ones first; those that
/// can be a part have ink, or are exact.
std::vector<std::string> found_glyphs(const Project& project,
                                      const std::string& text,
                                      bool is_part = false);
/// Pictures of the glyphs that found_glyphs() returns, the first one marked.
/// Returns the name of one that is clicked; else nothing.
std::string draw_picker(Panels& panels, const std::string& text);
void draw_canvas(Panels& panels);
void draw_preview_panel(Panels& panels);
void draw_inspector(Panels& panels);
/// The operators and parts of a glyph made of others.
void draw_tree(Editor& editor);
void draw_lua(Panels& panels);
void draw_status(Panels& panels);
void draw_dialogs(Panels& panels);

/// The dialog for a program in Lua.
inline constexpr const char* kScript = "Run script";

/// Scale, slant and turn by sliders.
inline constexpr const char* kTransform = "Scale, slant and turn";
void draw_transform(Panels& panels);

/// Weight and offset by sliders.
inline constexpr const char* kWeight = "Weight and offset";
void draw_weight(Panels& panels);

/// The buttons of a dialog whose sliders propose a command: makes it or drops
/// it, and ends the dialog.
void draw_apply_or_cancel(Panels& panels);

/// Opens a dialog by its name, with the values that it proposes.
void open_dialog(Panels& panels, const char* name);
/// Ends the program; with changes that are not saved it asks first.
void quit(Panels& panels);

}  // namespace inkcell::design::editor
