#include "editor/report.hpp"

#include "editor/masters.hpp"
#include "model/contours.hpp"
#include "model/sources.hpp"

namespace inkcell::design::editor {
namespace {

Value view_value(const View& view) {
  return {{"x", view.x},
          {"y", view.y},
          {"scale", view.scale},
          {"width", view.width},
          {"height", view.height}};
}

Value guides_value(const Glyph& glyph) {
  Value guides = Value::array();
  for (const Guideline& line : glyph.guidelines) {
    Value guide = Value::object();
    const auto add = [&guide](const char* key, std::optional<double> value) {
      if (value) {
        guide[key] = *value;
      }
    };
    add("x", line.x);
    add("y", line.y);
    add("angle", line.angle);
    guides.push_back(guide);
  }
  return guides;
}

// What the window says of the other master; null if there is none.
Value mismatches_value(const Editor& editor) {
  const auto other = other_master(editor);
  return other ? Value(mismatches(
                     *editor.glyph(),
                     *editor.project().find(editor.glyph_name(), *other),
                     master_name(editor.project(), *other)))
               : Value();
}

// The titles of what undo takes back, the last one at the end.
Value history_value(const Session& session) {
  Value titles = Value::array();
  for (size_t i = 0; i < session.done(); ++i) {
    titles.push_back(session.history()[i].title);
  }
  return titles;
}

Value latency_value(const Latency& latency) {
  return {{"median_ms", latency.median},
          {"worst_ms", latency.worst},
          {"cpu_ms", latency.cpu}};
}

}  // namespace

Value report_of(const Editor& editor, const Preview& preview) {
  const GlyphPointer glyph = editor.glyph();
  Value contours = Value::array();
  for (const PointContour& contour : glyph->contours) {
    contours.push_back(contour_value(contour));
  }
  return {{"glyph", glyph->name},
          {"width", glyph->width},
          {"contours", contours},
          {"own_contours", own_contours(*glyph)},
          {"components", glyph->components.size()},
          {"guides", guides_value(*glyph)},
          {"picture", glyph->image ? glyph->image->file : ""},
          {"tree", glyph->lib.value(kTreeKey, Value())},
          {"strokes", glyph->lib.value(kStrokesKey, Value())},
          {"selected", editor.selection.size() + editor.knots.size()},
          {"view", view_value(editor.view)},
          {"bytes", preview.glyph_bytes},
          {"points", preview.glyph_points},
          {"missing", preview.missing},
          {"undrawn", preview.undrawn},
          {"worst_error", preview.worst_error},
          {"cells", preview.cells.size()},
          {"master", master_name(editor.project(), editor.master())},
          {"mismatches", mismatches_value(editor)},
          {"history", history_value(editor.session())},
          {"message", editor.message.text}};
}

Value report_of(const Latencies& latencies) {
  Value report = {{"drag", latency_value(latencies.drag)},
                  {"device", latency_value(latencies.device)},
                  {"stroke", latency_value(latencies.stroke)},
                  {"weight", latency_value(latencies.weight)}};
  for (const auto& [name, latency] :
       {std::pair("knot", latencies.knot), std::pair("nib", latencies.nib),
        std::pair("to_outline", latencies.to_outline),
        std::pair("back", latencies.back)}) {
    if (latency) {
      report[name] = latency_value(*latency);
    }
  }
  return report;
}

}  // namespace inkcell::design::editor
