#include "stroke/nib.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

#include "model/error.hpp"

namespace inkcell::design {
namespace {

constexpr int kLeastCorners = 16;
constexpr int kMostCorners = 512;
constexpr double kLargestNib_u = 4096;

}  // namespace

Nib parse_nib(const std::string& text) {
  const auto refuse = [&text] {
    throw Error("nib '" + text +
                "': write ellipse:WIDTH,HEIGHT,ANGLE or rectangle:WIDTH,"
                "HEIGHT,ANGLE, sizes in 1/1024 em up to 4096, the angle in "
                "degrees, such as ellipse:80,30,45");
  };
  const size_t colon = text.find(':');
  const std::string kind = text.substr(0, colon);
  if (colon == std::string::npos ||
      (kind != "ellipse" && kind != "rectangle")) {
    refuse();
  }
  std::vector<double> numbers;
  std::istringstream list(text.substr(colon + 1));
  std::string item;
  while (std::getline(list, item, ',')) {
    try {
      size_t used = 0;
      numbers.push_back(std::stod(item, &used));
      if (used != item.size()) {
        refuse();
      }
    } catch (const std::logic_error&) {
      refuse();
    }
  }
  if (numbers.empty() || numbers.size() > 3) {
    refuse();
  }
  Nib nib;
  nib.kind = kind == "ellipse" ? Nib::Kind::ellipse : Nib::Kind::rectangle;
  nib.width = numbers[0];
  nib.height = numbers.size() > 1 ? numbers[1] : numbers[0];
  nib.angle = numbers.size() > 2 ? numbers[2] * gen::kPi / 180 : 0;
  if (!(nib.width >= 0 && nib.width <= kLargestNib_u && nib.height >= 0 &&
        nib.height <= kLargestNib_u && std::isfinite(nib.angle))) {
    refuse();
  }
  return nib;
}

std::string text_of(const Nib& nib) {
  char buffer[96];
  std::snprintf(buffer, sizeof buffer, "%s:%.9g,%.9g,%.9g",
                nib.kind == Nib::Kind::rectangle ? "rectangle" : "ellipse",
                nib.width, nib.height, nib.angle / gen::kDegree);
  return buffer;
}

int corner_count(const Nib& nib, double bound) {
  if (nib.kind == Nib::Kind::rectangle) {
    return 4;
  }
  const double radius = std::max({nib.width, nib.height, kLeastNib_u}) / 2;
  // A chord over the angle a leaves the circle by r (1 - cos(a / 2)).
  const double half = std::acos(std::max(0.0, 1 - bound / radius));
  const int count = static_cast<int>(std::ceil(gen::kPi / half / 4)) * 4;
  return std::clamp(count, kLeastCorners, kMostCorners);
}

std::vector<Point> nib_polygon(const Nib& nib, int corners) {
  const double a = std::max(nib.width, kLeastNib_u) / 2;
  const double b = std::max(nib.height, kLeastNib_u) / 2;
  const Point along = {std::cos(nib.angle), std::sin(nib.angle)};
  const Point across = {-along.y, along.x};
  std::vector<Point> polygon;
  if (nib.kind == Nib::Kind::rectangle) {
    polygon = {-a * along - b * across, a * along - b * across,
               a * along + b * across, -a * along + b * across};
    return polygon;
  }
  for (int i = 0; i < corners; ++i) {
    const double t = 2 * gen::kPi * i / corners;
    polygon.push_back(a * std::cos(t) * along + b * std::sin(t) * across);
  }
  return polygon;
}

}  // namespace inkcell::design
