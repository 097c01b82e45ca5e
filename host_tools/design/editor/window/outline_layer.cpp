#include "editor/window/outline_layer.hpp"

#include <algorithm>
#include <cmath>

#include "bitmap/bitmap.hpp"
#include "editor/parts.hpp"
#include "editor/segments.hpp"
#include "editor/snapping.hpp"
#include "editor/strokes.hpp"
#include "model/error.hpp"
#include "model/sources.hpp"
#include "shape/shape.hpp"

namespace inkcell::design::editor {
namespace {

constexpr float kHandleReach = 44;  // of the pointer that shows handles

constexpr int kRowsOfPixel = 4;  // whose spans a pixel's coverage adds up

float to_float(double value) {
  return static_cast<float>(value);
}

ImU32 with_opacity(ImU32 colour, float part) {
  const ImU32 alpha = (colour >> IM_COL32_A_SHIFT) & 0xff;
  const auto scaled =
      static_cast<ImU32>(std::lround(part * static_cast<float>(alpha)));
  return (colour & ~IM_COL32_A_MASK) | (scaled << IM_COL32_A_SHIFT);
}

// The covered parts of a row of pixels, as sums of spans.
class CoverageRow {
 public:
  explicit CoverageRow(size_t pixels) : steps_(pixels + 2) {}

  // Adds `part` between two places, in pixels.
  void add(double from, double to, float part) {
    step(from, part);
    step(to, -part);
  }

  // Calls draw(from, to, part) for runs of equal pixels that are not empty, and
  // clears the row.
  template <typename Draw>
  void take(const Draw& draw) {
    constexpr float kLeast = 1.0f / 512;
    float sum = 0;
    float part = 0;  // of the run that began at `from`
    size_t from = 0;
    for (size_t i = 0; i < steps_.size(); ++i) {
      sum += steps_[i];
      steps_[i] = 0;
      if (std::fabs(sum - part) < kLeast) {
        continue;
      }
      if (part > kLeast) {
        draw(from, i, std::min(part, 1.0f));
      }
      part = sum;
      from = i;
    }
  }

 private:
  // Pixels right of `at` are covered, its own one on the right of it.
  void step(double at, float part) {
    const auto pixels = static_cast<double>(steps_.size() - 2);
    const double place = std::clamp(at, 0.0, pixels);
    const auto i = static_cast<size_t>(place);
    const float beyond = to_float(place - static_cast<double>(i));
    steps_[i] += part * (1 - beyond);
    steps_[i + 1] += part * beyond;
  }

  std::vector<float> steps_;  // of the sum from pixel to pixel
};

}  // namespace

OutlineLayer::OutlineLayer(Panels& panels, ImVec2 origin)
    : panels_(panels),
      origin_(origin),
      view_(panels.editor.view),
      glyph_(panels.editor.glyph()),
      list_(*ImGui::GetWindowDrawList()) {}

ImVec2 OutlineLayer::map(double x, double y) const {
  const Point p = view_.to_canvas({x, y});
  return {origin_.x + to_float(p.x), origin_.y + to_float(p.y)};
}

void OutlineLayer::draw_zones() const {
  const float right = origin_.x + to_float(view_.width);
  // The heights of labels, which keep apart, and of the heading.
  std::vector<float> labels = {origin_.y + px(9) + ImGui::GetFontSize()};
  for (const Zone& zone : zones_of(panels_.editor.project())) {
    const float at = std::round(map(0, zone.y).y);
    list_.AddRectFilled({origin_.x, at}, {right, at + 1},
                        zone.y == 0 ? colour::faint : colour::zone);
    const bool fits = std::none_of(labels.begin(), labels.end(), [at](float y) {
      return std::fabs(y - at) < ImGui::GetFontSize();
    });
    if (!fits) {
      continue;
    }
    labels.push_back(at);
    char text[64];
    std::snprintf(text, sizeof text, "%s %g", zone.label, zone.y);
    list_.AddText({origin_.x + px(8), at - ImGui::GetFontSize() - px(1)},
                  colour::faint, text);
  }
  if (panels_.editor.tool_kind() == ToolKind::spacing) {
    return;
  }
  for (const double x : {0.0, glyph_->width}) {
    const float at = std::round(map(x, 0).x);
    list_.AddRectFilled({at, origin_.y},
                        {at + 1, origin_.y + to_float(view_.height)},
                        colour::zone);
  }
}

void OutlineLayer::draw_guides() const {
  const double reach = (view_.width + view_.height) / view_.scale;
  for (size_t i = 0; i < glyph_->guidelines.size(); ++i) {
    const gen::Segment line = line_of(glyph_->guidelines[i]);
    const double dx = line.p[1].x - line.p[0].x;
    const double dy = line.p[1].y - line.p[0].y;
    // The part next to the middle of the view.
    const double middle =
        dx * (view_.x - line.p[0].x) + dy * (view_.y - line.p[0].y);
    const Point at = {line.p[0].x + middle * dx, line.p[0].y + middle * dy};
    list_.AddLine(map(at.x - reach * dx, at.y - reach * dy),
                  map(at.x + reach * dx, at.y + reach * dy),
                  panels_.editor.guide == i ? colour::selected : colour::guide);
  }
}

void OutlineLayer::draw_layers() const {
  const Project& project = panels_.editor.project();
  if (const auto mixed = panels_.editor.glyph_between()) {
    for (const PointContour& contour : mixed->contours) {
      outline(contour, colour::tool);
    }
  }
  if (!panels_.editor.shows_layers) {
    return;
  }
  for (size_t i = 0; i < project.layers.size(); ++i) {
    const GlyphPointer other = project.find(glyph_->name, i);
    if (other == nullptr || i == panels_.editor.master()) {
      continue;
    }
    for (const PointContour& contour : other->contours) {
      outline(contour, colour::layer);
    }
  }
}

// The decoded picture; null if there is none or it cannot be shown.
std::shared_ptr<const tools::Image> OutlineLayer::background() const {
  const std::string& file = glyph_->image->file;
  const Images& images = panels_.editor.project().font->images;
  const auto found = images.find(file);
  const ImageBytes bytes = found == images.end() ? nullptr : found->second;
  BackgroundPicture& kept = panels_.background;
  if (kept.file == file && kept.bytes == bytes) {
    return kept.image;
  }
  kept = {file, bytes, nullptr};
  attempt(panels_.editor, [&] {
    if (bytes == nullptr) {
      throw Error("images/" + file + " of glyph '" + glyph_->name +
                  "' is missing");
    }
    const Bitmap bitmap = parse_png(*bytes, "images/" + file);
    auto image = std::make_shared<tools::Image>(bitmap.width, bitmap.height);
    std::transform(bitmap.ink.begin(), bitmap.ink.end(), image->pixels.begin(),
                   [](uint8_t ink) { return static_cast<uint8_t>(ink / 3); });
    kept.image = std::move(image);
  });
  return kept.image;
}

// A pixel is a font unit before the matrix, the lower left corner the origin.
void OutlineLayer::draw_background() const {
  const auto image = glyph_->image ? background() : nullptr;
  if (image == nullptr) {
    return;
  }
  const ImTextureID texture = panels_.textures.of(image, image.get(), *image);
  if (texture == nullptr) {
    return;
  }
  const auto corner = [&](int x, int y) {
    const Point at = glyph_->image->matrix.map(x, y);
    return map(at.x, at.y);
  };
  list_.AddImageQuad(texture, corner(0, image->height),
                     corner(image->width, image->height),
                     corner(image->width, 0), corner(0, 0), {0, 0}, {1, 0},
                     {1, 1}, {0, 1}, colour::ink);
}

// Row by row, as the union of all contours, with the covered part of each pixel
// as its opacity.
void OutlineLayer::fill(const gen::Shape& shape,
                        double scale,
                        ImU32 colour,
                        double x) const {
  const auto column = [&](double u) {
    return view_.to_canvas({x + u / scale, 0}).x;
  };
  const gen::Box& box = shape.box();
  const double left = std::max(0.0, std::floor(column(box.x0)));
  const double right = std::min(view_.width, column(box.x1));
  const double top =
      std::max(0.0, std::floor(view_.to_canvas({0, box.y1 / scale}).y));
  const double bottom =
      std::min(view_.height, view_.to_canvas({0, box.y0 / scale}).y);
  if (left >= right) {
    return;
  }
  CoverageRow covered(static_cast<size_t>(std::ceil(right - left)));
  std::vector<double> places;
  for (double row = top; row < bottom; ++row) {
    for (int i = 0; i < kRowsOfPixel; ++i) {
      const double y = row + (i + 0.5) / kRowsOfPixel;
      shape.crossings(scale * view_.to_font({0, y}).y, places);
      for (size_t k = 0; k + 1 < places.size(); k += 2) {
        covered.add(column(places[k]) - left, column(places[k + 1]) - left,
                    1.0f / kRowsOfPixel);
      }
    }
    const float at = origin_.y + to_float(row);
    covered.take([&](size_t from, size_t to, float part) {
      const float start = origin_.x + to_float(left);
      list_.AddRectFilled({start + static_cast<float>(from), at},
                          {start + static_cast<float>(to), at + 1},
                          with_opacity(colour, part));
    });
  }
}

void OutlineLayer::draw_ink(ImU32 ink) const {
  if (panels_.filled != glyph_) {
    panels_.filled = glyph_;
    panels_.shape.reset();
    attempt(panels_.editor, [this] {
      Glyph own = *glyph_;
      own.components.clear();
      panels_.shape = std::make_shared<const gen::Shape>(
          outline_of(panels_.editor.project(), own));
    });
  }
  if (panels_.shape != nullptr && !panels_.shape->empty()) {
    fill(*panels_.shape, gen::kUPerEm / panels_.editor.project().units_per_em(),
         ink);
  }
}

void OutlineLayer::draw_black() const {
  draw_ink(colour::ink);
  const Project project = panels_.editor.shown_project();
  for (const ComponentUse& use : glyph_->components) {
    Glyph part;
    append_component(project, 0, use, part.contours);
    const gen::Shape shape(outline_of(project, part));
    if (!shape.empty()) {
      fill(shape, gen::kUPerEm / project.units_per_em(), colour::ink);
    }
  }
}

void OutlineLayer::draw_components() const {
  const Project project = panels_.editor.shown_project();
  for (size_t i = 0; i < glyph_->components.size(); ++i) {
    Glyph part;
    try {
      append_component(project, 0, glyph_->components[i], part.contours);
    } catch (const std::exception& error) {
      panels_.editor.message = {error.what(), true};
      continue;
    }
    const gen::Shape shape(outline_of(project, part));
    if (!shape.empty()) {
      fill(shape, gen::kUPerEm / project.units_per_em(), colour::component);
    }
    for (const PointContour& contour : part.contours) {
      outline(contour, panels_.editor.component == i ? colour::selected
                                                     : colour::handle);
    }
  }
}

void OutlineLayer::draw_parts() const {
  const std::vector<Value> parts = parts_of(*glyph_);
  const Project project = panels_.editor.shown_project();
  attempt(panels_.editor, [&] {
    for (size_t i = 0; i < parts.size(); ++i) {
      const bool is_selected = panels_.editor.part == i;
      for (const PointContour& contour : contours_of_part(project, parts[i])) {
        outline(contour, is_selected ? colour::selected : colour::guide);
      }
    }
  });
}

void OutlineLayer::draw_cells() const {
  if (!panels_.editor.preview.cells || panels_.preview == nullptr) {
    return;
  }
  for (const CellBox& cell : panels_.preview->cells) {
    const ImU32 colour = cell.is_saturated ? IM_COL32(120, 130, 144, 60)
                                           : IM_COL32(70, 80, 96, 150);
    list_.AddRect(map(cell.x0, cell.y0 + cell.side),
                  map(cell.x0 + cell.side, cell.y0), colour);
  }
}

void OutlineLayer::outline(const PointContour& contour, ImU32 colour) const {
  const float width = px(1.4f);
  for (const gen::Segment& s : segments_of(contour)) {
    const auto at = [&](int i) { return map(s.p[i].x, s.p[i].y); };
    if (s.kind == gen::Segment::Kind::line) {
      list_.AddLine(at(0), at(1), colour, width);
    } else if (s.kind == gen::Segment::Kind::quadratic) {
      list_.AddBezierQuadratic(at(0), at(1), at(2), colour, width);
    } else {
      list_.AddBezierCubic(at(0), at(1), at(2), at(3), colour, width);
    }
  }
}

void OutlineLayer::draw_contours() const {
  for (const PointContour& contour : glyph_->contours) {
    outline(contour, colour::ink);
    for (const gen::Segment& segment : segments_of(contour)) {
      if (segment.kind == gen::Segment::Kind::line &&
          is_nearly_level(segment.p[0], segment.p[1])) {
        list_.AddLine(map(segment.p[0].x, segment.p[0].y),
                      map(segment.p[1].x, segment.p[1].y), colour::warning,
                      px(3));
      }
    }
  }
}

// Whether a handle is shown: it or a point next to it is selected, or the
// pointer is near.
bool OutlineLayer::shows_handle(size_t contour, size_t point) const {
  const Selection& selection = panels_.editor.selection;
  const std::vector<GlyphPoint>& points = glyph_->contours[contour].points;
  const size_t count = points.size();
  const double reach = px(kHandleReach) / view_.scale;
  for (size_t i = 0; i < 5; ++i) {
    const size_t at = (point + count + i - 2) % count;
    const GlyphPoint& p = points[at];
    const Point hover = panels_.editor.hover;
    if ((i == 2 || p.on_curve()) &&
        (selection.count({contour, at}) != 0 ||
         std::hypot(p.x - hover.x, p.y - hover.y) < reach)) {
      return true;
    }
  }
  return false;
}

// Lines from handles that are shown to their points.
void OutlineLayer::handles(size_t contour) const {
  const PointContour& drawn = glyph_->contours[contour];
  const std::vector<GlyphPoint>& points = drawn.points;
  for (size_t i = 0; i < points.size(); ++i) {
    const size_t next = (i + 1) % points.size();
    const GlyphPoint& a = points[i];
    const GlyphPoint& b = points[next];
    const bool is_closing = i + 1 == points.size();
    if (a.on_curve() != b.on_curve() && !(is_closing && drawn.open()) &&
        shows_handle(contour, a.on_curve() ? next : i)) {
      list_.AddLine(map(a.x, a.y), map(b.x, b.y), colour::handle);
    }
  }
}

void OutlineLayer::draw_points() const {
  const Selection& selection = panels_.editor.selection;
  const float half = px(3);
  const size_t with_points = has_tree(*glyph_) ? 0 : own_contours(*glyph_);
  for (size_t c = 0; c < with_points; ++c) {
    handles(c);
    const std::vector<GlyphPoint>& points = glyph_->contours[c].points;
    for (size_t i = 0; i < points.size(); ++i) {
      const GlyphPoint& point = points[i];
      const ImVec2 at = map(point.x, point.y);
      const bool is_selected = selection.count({c, i}) != 0;
      const ImU32 colour = is_selected         ? colour::selected
                           : !point.on_curve() ? colour::handle
                           : point.smooth      ? colour::smooth
                                               : colour::corner;
      if (!point.on_curve()) {
        if (shows_handle(c, i)) {
          list_.AddCircleFilled(at, half, is_selected ? colour : colour::paper);
          list_.AddCircle(at, half, colour, 0, px(1.3f));
        }
      } else if (point.smooth) {
        list_.AddCircleFilled(at, half + px(0.8f), colour);
      } else {
        list_.AddRectFilled({at.x - half, at.y - half},
                            {at.x + half, at.y + half}, colour);
      }
    }
  }
  for (const Anchor& anchor : glyph_->anchors) {
    const ImVec2 at = map(anchor.x, anchor.y);
    list_.AddNgonFilled(at, half + px(1), colour::tool, 4);
    list_.AddText({at.x + px(7), at.y - px(8)}, colour::tool,
                  anchor.name.c_str());
  }
}

void OutlineLayer::draw_marks() const {
  const Marks marks = panels_.editor.tool().marks(panels_.editor);
  for (const auto& [a, b] : marks.lines) {
    list_.AddLine(map(a.x, a.y), map(b.x, b.y), colour::tool, px(1.4f));
  }
  for (const auto& [a, b] : marks.levels) {
    list_.AddLine(map(a.x, a.y), map(b.x, b.y), colour::selected);
    list_.AddCircle(map(a.x, a.y), px(5), colour::selected);
  }
  if (marks.box) {
    const ImVec2 a = map(marks.box->first.x, marks.box->first.y);
    const ImVec2 b = map(marks.box->second.x, marks.box->second.y);
    const ImVec2 low = {std::min(a.x, b.x), std::min(a.y, b.y)};
    const ImVec2 high = {std::max(a.x, b.x), std::max(a.y, b.y)};
    list_.AddRectFilled(low, high, IM_COL32(30, 110, 214, 28));
    list_.AddRect(low, high, colour::tool);
  }
  for (const Point dot : marks.dots) {
    list_.AddCircleFilled(map(dot.x, dot.y), px(3.2f), colour::tool);
  }
  for (const auto& [at, text] : marks.labels) {
    const ImVec2 place = map(at.x, at.y);
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const ImVec2 low = {std::round(place.x + px(8)), std::round(place.y)};
    list_.AddRectFilled({low.x - px(4), low.y - px(2)},
                        {low.x + size.x + px(4), low.y + size.y + px(2)},
                        colour::paper, px(3));
    list_.AddText(low, colour::tool, text.c_str());
  }
}

}  // namespace inkcell::design::editor
