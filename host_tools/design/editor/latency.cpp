#include "editor/latency.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>

#include "editor/edits.hpp"
#include "editor/exact_preview.hpp"
#include "editor/strokes.hpp"
#include "model/contours.hpp"
#include "model/error.hpp"
#include "model/sources.hpp"
#include "shape/points.hpp"
#include "shape/shape.hpp"
#include "trace/field_outline.hpp"

namespace inkcell::design::editor {
namespace {

constexpr double kFieldScale = 4;
constexpr int kStrokePoints = 24;
constexpr double kTurn = 6.283185307179586;

template <typename Work>
Latency time_of(int runs, const Work& work) {
  std::vector<double> times;
  std::vector<double> cpu;
  for (int i = 0; i < runs; ++i) {
    const std::clock_t cpu_begin = std::clock();
    const auto begin = std::chrono::steady_clock::now();
    work(i);
    const std::chrono::duration<double, std::milli> time =
        std::chrono::steady_clock::now() - begin;
    times.push_back(time.count());
    cpu.push_back(1000.0 * static_cast<double>(std::clock() - cpu_begin) /
                  CLOCKS_PER_SEC);
  }
  std::sort(times.begin(), times.end());
  std::sort(cpu.begin(), cpu.end());
  return {times[times.size() / 2], times.back(), cpu[cpu.size() / 2]};
}

// Distances around the ink, kFieldScale to a pixel at `px` px/em.
std::vector<double> distances(const gen::Shape& shape, double px) {
  const double step = gen::kUPerEm / (kFieldScale * px);
  const gen::Box& box = shape.box();
  std::vector<double> all;
  for (double y = box.y0 - step; y < box.y1 + step; y += step) {
    for (double x = box.x0 - step; x < box.x1 + step; x += step) {
      all.push_back(shape.distance(x, y));
    }
  }
  return all;
}

// Adds or removes a point of a wave as wide as the advance.
Value stroke_command(const Editor& editor, int points) {
  const double width = editor.glyph()->width;
  Value path = Value::array();
  for (int i = 0; i < points; ++i) {
    const double part = static_cast<double>(i) / points;
    path.push_back({std::round(width * part),
                    std::round(width * std::sin(kTurn * part) / 2)});
  }
  const Value stroke = {{"nib", editor.nib.text()}, {"points", path}};
  return {{"do", "set_strokes"}, {"strokes", Value::array({stroke})}};
}

// What is seen while the first knot moves, and while its nib turns and widens.
template <typename Show>
void measure_knots(const Glyph& glyph,
                   int runs,
                   const Show& show,
                   Latencies& result) {
  const Nib nib = nibs_of(strokes_of(glyph).at(0)).at(0);
  result.knot = time_of(runs, [&](int i) {
    show(move_knots(glyph, {{0, 0}}, i + 1, 0));
  });
  result.nib = time_of(runs, [&](int i) {
    Nib turned = nib;
    turned.width += i + 1;
    turned.angle += gen::kDegree * (i + 1);
    show(set_nib(glyph, {0, 0}, turned));
  });
}

Preview device_preview(const Editor& editor, gen::BuiltGlyphs& glyphs) {
  Preview preview = draw_preview(editor.preview_job(), &glyphs);
  if (!preview.error.empty()) {
    throw Error(preview.error);
  }
  return preview;
}

}  // namespace

Latencies measure_latencies(Editor& editor, int runs) {
  if (editor.glyph()->contours.empty()) {
    throw Error("glyph '" + editor.glyph_name() + "' has no points to drag");
  }
  gen::BuiltGlyphs glyphs;  // as in the window's worker
  const Preview first = device_preview(editor, glyphs);
  const auto show = [&](const Value& command) {
    editor.propose(command);
    draw_exact_preview(first, editor.preview_job());
  };
  const auto drag = [](int step) {
    return Value{
        {"do", "move_points"},
        {"points", Value::array({Value::array({size_t{0}, size_t{0}})})},
        {"dx", step + 1},
        {"dy", 0}};
  };
  const auto shape = [&editor] {
    return gen::Shape(outline_of(editor.shown_project(), *editor.glyph()));
  };
  const std::vector<double>& sizes = editor.preview.text_px;
  const double px = sizes.empty()
                        ? editor.preview.glyph_px
                        : *std::max_element(sizes.begin(), sizes.end());
  Latencies result;
  result.drag = time_of(runs, [&](int i) {
    show(drag(i));
    distances(shape(), px);
  });
  result.device = time_of(runs, [&](int i) {
    editor.propose(drag(i));
    device_preview(editor, glyphs);
  });
  result.stroke = time_of(runs, [&](int i) {
    editor.propose(stroke_command(editor, kStrokePoints + i));
    gen::Target target;
    target.coding = gen::Coding::field;
    const ShapeField field(shape(), target);
    draw_exact_preview(first, editor.preview_job());
  });
  result.weight = time_of(runs, [&](int i) {
    show({{"do", "change_weight"}, {"by", 1 + i % 40}});
  });
  const GlyphPointer glyph = editor.stored();
  if (has_strokes(*glyph)) {
    measure_knots(*glyph, runs, show, result);
  }
  if (has_source(*glyph)) {
    result.to_outline =
        time_of(runs, [&](int) { show(batch(without_source(*glyph))); });
    result.back = time_of(runs, [&](int) { show(nullptr); });
  }
  editor.propose(nullptr);
  return result;
}

}  // namespace inkcell::design::editor
