// The command that spaces letters by their distances.
//
// Beside a letter, on the upright line where the next glyph's space begins,
// each place is some distance from the ink. What letters of one case have in
// common is the mean of 1 / (distance + kClose)^2 along that line, from the
// baseline to the height of the case: near ink counts most.
#include <cmath>
#include <optional>

#include "model/bearings.hpp"
#include "model/command_table.hpp"
#include "model/contours.hpp"
#include "shape/shape.hpp"

namespace inkcell::design {
namespace {

constexpr int kPlaces = 24;    // on a line
constexpr int kHalvings = 24;  // of the range of bearings
constexpr double kClose_u = 20;
constexpr double kLeast_u = -160;  // bearings
constexpr double kMost_u = 320;

bool is_small(char32_t c) {
  return (c >= U'a' && c <= U'z') || (c >= 0xdf && c <= 0xff && c != 0xf7);
}

bool is_capital(char32_t c) {
  return (c >= U'A' && c <= U'Z') || (c >= 0xc0 && c <= 0xde && c != 0xd7);
}

double nearness(const gen::Shape& shape, double x, double top) {
  double sum = 0;
  for (int i = 0; i < kPlaces; ++i) {
    const double away = std::abs(shape.distance(x, (i + 0.5) / kPlaces * top));
    sum += 1 / ((away + kClose_u) * (away + kClose_u));
  }
  return sum / kPlaces;
}

// The place of the line beside the ink, `bearing` away from it. [u]
double line_at(const gen::Box& box, double bearing, bool is_left) {
  return is_left ? box.x0 - bearing : box.x1 + bearing;
}

double bearing_for(const gen::Shape& shape,
                   double top,
                   double wanted,
                   bool is_left) {
  double low = kLeast_u;
  double high = kMost_u;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (low + high) / 2;
    const double now =
        nearness(shape, line_at(shape.box(), middle, is_left), top);
    (now > wanted ? low : high) = middle;
  }
  return (low + high) / 2;
}

// The letters of one case: how high, and how near.
struct Case {
  double top = 0;
  double wanted = 0;
};

std::optional<Case> case_of(const Project& project,
                            size_t layer,
                            const char* flat,
                            const char* round) {
  const auto shape_of = [&](const char* name) {
    return gen::Shape(outline_of(project, *project.glyph(name, layer), layer));
  };
  if (project.find(flat, layer) == nullptr ||
      project.find(round, layer) == nullptr) {
    return std::nullopt;
  }
  Case result;
  result.top = shape_of(flat).box().y1;
  for (const char* name : {flat, round}) {
    result.wanted += nearness(shape_of(name), 0, result.top) / 2;
  }
  return result.top > 0 ? std::optional<Case>(result) : std::nullopt;
}

// What changes at both bearings; nothing if the glyph is no letter.
Value spaced(const Project& project,
             size_t layer,
             const Glyph& glyph,
             const std::optional<Case>& letters) {
  const auto now = bearings_of(project, glyph, layer);
  if (!letters || !now) {
    return nullptr;
  }
  const gen::Shape shape(outline_of(project, glyph, layer));
  const double scale = project.units_per_em() / gen::kUPerEm;
  const auto bearing = [&](bool is_left) {
    return std::round(
        scale * bearing_for(shape, letters->top, letters->wanted, is_left));
  };
  return {{"do", "set_bearings"},
          {"glyph", glyph.name},
          {"layer", project.layers[layer].name},
          {"left", bearing(true)},
          {"right", bearing(false)}};
}

Change space_letters(const Project& project, const Arguments& arguments) {
  const size_t layer = layer_of(project, arguments);
  const auto small = case_of(project, layer, "n", "o");
  const auto capital = case_of(project, layer, "H", "O");
  if (!small && !capital) {
    arguments.refuse(
        "n and o, or H and O, say how far letters are apart; draw them and set "
        "their left bearings");
  }
  Value commands = Value::array();
  for (const auto& [name, glyph] : project.layers[layer].glyphs) {
    if (glyph->unicodes.empty()) {
      continue;
    }
    const char32_t c = glyph->unicodes.front();
    Value command = is_small(c)     ? spaced(project, layer, *glyph, small)
                    : is_capital(c) ? spaced(project, layer, *glyph, capital)
                                    : Value();
    if (!command.is_null()) {
      commands.push_back(std::move(command));
    }
  }
  return own_change_of(project,
                       {{"do", "batch"}, {"commands", std::move(commands)}});
}

}  // namespace

void add_spacing_command(CommandTable& table) {
  table["space_letters"] = space_letters;
}

}  // namespace inkcell::design
