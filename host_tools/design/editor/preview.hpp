// Previews of the device's pictures: by the generator in memory, the device's
// library, and the sinks of displays.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "display.hpp"
#include "image.hpp"
#include "inkcell/geometry.hpp"
#include "inkcell/strip.hpp"
#include "inkcell/style.hpp"
#include "inkcell/text.hpp"
#include "model/project.hpp"
#include "pipeline/built_glyphs.hpp"
#include "target/target.hpp"

namespace inkcell::design::editor {

using tools::Display;

/// The displays that can be chosen.
const std::vector<Display>& preview_displays();

struct PreviewSettings {
  Display display = Display::grey4;
  bool dark = true;
  double glyph_px = 24;                        // [px/em]
  std::vector<double> text_px = {12, 16, 24};  // [px/em]
  std::string text = "Hamburg 012";
  bool cells = false;  // of the glyph as a font of fields has it
};

struct PreviewJob {
  Project project;  // only the glyphs that are needed
  std::string glyph;
  char32_t character = 0;  // of the glyph in `project`
  std::string missing;     // characters of the text that the font lacks
  std::string undrawn;     // and those whose glyphs are empty
  PreviewSettings settings;
};

/// A leaf of the quadtree. [font units]
struct CellBox {
  double x0 = 0;
  double y0 = 0;
  double side = 0;
  bool is_saturated = false;
};

struct TextPicture {
  double px = 0;
  tools::Image image;
};

struct Preview {
  std::string error;  // why the preview is otherwise empty
  std::string glyph_name;
  bool is_exact = false;  // pictures only: exact_preview.hpp
  std::vector<uint8_t> rom;
  size_t glyph_bytes = 0;
  size_t glyph_points = 0;
  double worst_error = 0;  // of the glyph's pixels [1/255]
  int worst_px = 0;
  double seconds = 0;
  tools::Image glyph;
  std::vector<TextPicture> lines;
  std::string missing;  // characters of the text that the font lacks
  std::string undrawn;  // and those whose glyphs are empty
  std::vector<CellBox> cells;
  size_t cell_bytes = 0;  // of the glyph's record of cells
};

/// A job for `glyph` and the text of `settings`. Throws Error.
PreviewJob make_job(const Project& project,
                    const std::string& glyph,
                    const PreviewSettings& settings);

/// Makes the preview. `error` says what failed. `glyphs`, if given, holds the
/// glyphs of the previous preview, which are not built again, and gets those of
/// this one.
Preview draw_preview(const PreviewJob& job, gen::BuiltGlyphs* glyphs = nullptr);

/// Draws one glyph of a line that begins at `origin`.
using GlyphPainter = std::function<void(const PositionedGlyph& glyph,
                                        const Style& style,
                                        inkcell::Point origin,
                                        const Sink& sink)>;

/// Draws a line of text as a display shows it, in 3 channels. `paint`, if
/// given, draws the glyphs. Throws std::runtime_error.
tools::Image draw_on_display(const std::vector<uint8_t>& rom,
                             const std::string& text,
                             double px,
                             Display display,
                             bool dark,
                             const GlyphPainter& paint = {});

}  // namespace inkcell::design::editor
