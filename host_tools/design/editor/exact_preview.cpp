#include "editor/exact_preview.hpp"

#include <algorithm>
#include <cmath>

#include "canvas.hpp"
#include "inkcell/filter.hpp"
#include "inkcell/painter.hpp"
#include "look.hpp"
#include "model/contours.hpp"
#include "rom_file.hpp"
#include "shape/shape.hpp"

namespace inkcell::design::editor {
namespace {

constexpr double kQ10 = 1024;
constexpr double kQ6 = 64;
constexpr double kFarPx = 16;  // farther pixels are all ink or none

// A glyph's exact ink at one size.
class ExactGlyph {
 public:
  ExactGlyph(const gen::Shape& shape, double px, const Sink& sink)
      : shape_(shape), px_per_u_(px / gen::kUPerEm), sink_(sink) {}

  // With the glyph's origin at (x, y). [px, y down]
  void draw(double x, double y) const {
    if (shape_.empty()) {
      return;
    }
    const gen::Box& box = shape_.box();
    const Rect& window = sink_.window;
    const auto low = [](double at) {
      return static_cast<int32_t>(std::floor(at)) - 1;
    };
    const int32_t x0 = std::max(window.x0, low(x + box.x0 * px_per_u_));
    const int32_t x1 = std::min(window.x1, low(x + box.x1 * px_per_u_) + 3);
    const int32_t y0 = std::max(window.y0, low(y - box.y1 * px_per_u_));
    const int32_t y1 = std::min(window.y1, low(y - box.y0 * px_per_u_) + 3);
    for (int32_t row = y0; row < y1; ++row) {
      for (int32_t at = x0; at < x1; at += kMaxSpan) {
        span(at, row, std::min(kMaxSpan, x1 - at), x, y);
      }
    }
  }

 private:
  void span(
      int32_t first, int32_t row, int32_t count, double x, double y) const {
    const bool has_stripes = sink_.coverage_rgb != nullptr;
    const int32_t parts = has_stripes ? 3 : 1;
    uint8_t ink[3 * kMaxSpan];
    for (int32_t i = 0; i < parts * count; ++i) {
      const double at = first + (i + 0.5) / parts;
      const double d = px_per_u_ * shape_.distance((at - x) / px_per_u_,
                                                   (y - row - 0.5) / px_per_u_);
      ink[i] = kFilterText.coverage(static_cast<int32_t>(
          std::lround(kQ10 * std::clamp(d, -kFarPx, kFarPx))));
    }
    (has_stripes ? sink_.coverage_rgb : sink_.coverage)(sink_.context, first,
                                                        row, ink, count);
  }

  const gen::Shape& shape_;
  double px_per_u_;
  const Sink& sink_;
};

double px_of(Q26_6 value) {
  return value.raw / kQ6;
}

}  // namespace

std::shared_ptr<const Preview> draw_exact_preview(const Preview& last,
                                                  const PreviewJob& job) {
  if (last.rom.empty() || last.glyph_name != job.glyph) {
    return nullptr;
  }
  const tools::RomFile file(last.rom, "preview");
  const Font& font = file.font();
  uint16_t changed = 0;
  if (font.glyph_of(job.character, changed) != Status::ok) {
    return nullptr;
  }
  const gen::Shape shape(
      outline_of(job.project, *job.project.glyph(job.glyph)));
  const auto picture = [&](const std::string& text, double px) {
    return draw_on_display(
        last.rom, text, px, job.settings.display, job.settings.dark,
        [&](const PositionedGlyph& glyph, const Style& style,
            inkcell::Point origin, const Sink& sink) {
          if (glyph.glyph != changed) {
            Painter(sink).glyphs(font, style, origin, {&glyph, 1});
            return;
          }
          ExactGlyph(shape, px, sink)
              .draw(px_of(origin.x) + px_of(to_px(font, style, glyph.x)),
                    px_of(origin.y));
        });
  };
  auto preview = std::make_shared<Preview>();
  preview->rom = last.rom;
  preview->glyph_name = last.glyph_name;
  preview->missing = job.missing;
  preview->undrawn = job.undrawn;
  preview->is_exact = true;
  preview->glyph =
      picture(tools::to_utf8(job.character), job.settings.glyph_px);
  for (const double px : job.settings.text_px) {
    preview->lines.push_back({px, picture(job.settings.text, px)});
  }
  return preview;
}

}  // namespace inkcell::design::editor
