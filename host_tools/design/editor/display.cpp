// Text as a display shows it.
#include <cmath>

#include "canvas.hpp"
#include "editor/preview.hpp"
#include "inkcell/painter.hpp"
#include "look.hpp"
#include "rom_file.hpp"

namespace inkcell::design::editor {
namespace {

constexpr uint32_t kBlack = 0x000000;
constexpr uint32_t kWhite = 0xffffff;
constexpr int kMargin = 2;  // around the ink, as inkcell-render leaves [px]

// One direction of the picture. [px]
int side_of(double low, double high) {
  return static_cast<int>(std::ceil(kMargin - std::floor(low) + high) +
                          kMargin);
}

}  // namespace

const std::vector<Display>& preview_displays() {
  static const std::vector<Display> list = {Display::mono, Display::grey2,
                                            Display::grey4, Display::rgb565,
                                            Display::lcd};
  return list;
}

tools::Image draw_on_display(const std::vector<uint8_t>& rom,
                             const std::string& text,
                             double px,
                             Display display,
                             bool dark,
                             const GlyphPainter& paint) {
  const tools::RomFile file(rom, "preview");
  const Font& font = file.font();
  tools::LookOptions options;
  tools::suit_display(display, options);
  options.hint = "display";
  const tools::Look look(options, font, px, 0, tools::Use::text);
  const std::vector<tools::Line> lines =
      tools::lay_out_lines(font, text, tools::Kerning::font, look.style());
  const tools::InkBox ink = tools::ink_box(font, lines, look.style());
  tools::DisplayMemory memory(display, side_of(ink.x0, ink.x1),
                              side_of(ink.y0, ink.y1));
  const inkcell::Point origin = tools::make_point(kMargin - std::floor(ink.x0),
                                                  kMargin - std::floor(ink.y0));
  memory.show(memory.height(), [&](const Strip& strip) {
    tools::DisplayPaper strip_paper(display, strip);
    const scenes::Paper paper = strip_paper.paper();
    paper.fill(dark ? kBlack : kWhite);
    const Sink& sink = paper.with(dark ? kWhite : kBlack);
    for (const tools::Line& line : lines) {
      if (!paint) {
        Painter(sink).glyphs(font, look.style(), origin,
                             {line.glyphs.data(), line.glyphs.size()});
        continue;
      }
      for (const PositionedGlyph& glyph : line.glyphs) {
        paint(glyph, look.style(), origin, sink);
      }
    }
  });
  return memory.picture();
}

}  // namespace inkcell::design::editor
