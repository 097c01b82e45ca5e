#include "svg/path_data.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <string>

#include "base/error.hpp"
#include "base/number.hpp"
#include "shape/points.hpp"
#include "svg/arc.hpp"

namespace inkcell::gen {
namespace {

// Angle from a to b, -pi..pi.
double turn(const Point& a, const Point& b) {
  return std::atan2(cross(a, b), dot(a, b));
}

class PathReader {
 public:
  explicit PathReader(std::string_view data) : data_(data) {}

  SvgPath run() {
    for (skip(); at_ < data_.size(); skip()) {
      const char letter = data_[at_];
      if (std::isalpha(static_cast<unsigned char>(letter)) == 0) {
        refuse("a letter of a command");
      }
      if (command_ == 0 && std::toupper(letter) != 'M') {
        refuse("M, with which a path begins");
      }
      ++at_;
      command_ = letter;
      do {
        step();
        skip();
      } while (command_ != 'Z' && command_ != 'z' && begins_number());
    }
    end(false);
    return std::move(path_);
  }

 private:
  [[noreturn]] void refuse(const char* wanted) const {
    throw Error("path data, character " + std::to_string(at_ + 1) + ": '" +
                std::string(data_.substr(at_, 12)) + "' is not " + wanted);
  }

  void skip() {
    while (at_ < data_.size() &&
           (data_[at_] == ',' ||
            std::isspace(static_cast<unsigned char>(data_[at_])) != 0)) {
      ++at_;
    }
  }

  bool begins_number() const {
    return at_ < data_.size() &&
           std::string_view("+-.0123456789").find(data_[at_]) !=
               std::string_view::npos;
  }

  double number() {
    skip();
    std::string_view rest = data_.substr(at_);
    const std::optional<double> value = take_number(rest);
    if (!value) {
      refuse("a number");
    }
    at_ = data_.size() - rest.size();
    return *value;
  }

  bool flag() {
    skip();
    if (at_ >= data_.size() || (data_[at_] != '0' && data_[at_] != '1')) {
      refuse("0 or 1");
    }
    return data_[at_++] == '1';
  }

  bool is_relative() const { return command_ >= 'a'; }

  Point pair() {
    const double x = number();
    const double y = number();
    return is_relative() ? current_ + Point{x, y} : Point{x, y};
  }

  void step() {
    const char kind = static_cast<char>(std::toupper(command_));
    const char before = before_;
    before_ = kind;
    switch (kind) {
      case 'M':
        end(false);
        current_ = start_ = pair();
        // Further pairs of coordinates are lines.
        command_ = is_relative() ? 'l' : 'L';
        break;
      case 'L':
        line(pair());
        break;
      case 'H':
        line({number() + (is_relative() ? current_.x : 0), current_.y});
        break;
      case 'V':
        line({current_.x, number() + (is_relative() ? current_.y : 0)});
        break;
      case 'C':
        cubic_from(pair());
        break;
      case 'S':
        cubic_from(before == 'C' || before == 'S' ? mirrored() : current_);
        break;
      case 'Q':
        quadratic_over(pair());
        break;
      case 'T':
        quadratic_over(before == 'Q' || before == 'T' ? mirrored() : current_);
        break;
      case 'A':
        arc();
        break;
      case 'Z':
        if (subpath_.segments.empty()) {
          line(start_);  // "M1 2Z" is a dot if caps are round
        }
        end(true);
        break;
      default:
        --at_;
        refuse("a command of SVG: M, L, H, V, C, S, Q, T, A or Z");
    }
  }

  Point mirrored() const { return 2.0 * current_ - handle_; }

  void add(Segment::Kind kind,
           const Point& p1,
           const Point& p2 = {},
           const Point& p3 = {}) {
    Segment segment;
    segment.kind = kind;
    segment.p[0] = current_;
    segment.p[1] = p1;
    segment.p[2] = p2;
    segment.p[3] = p3;
    subpath_.segments.push_back(segment);
  }

  void line(const Point& to) {
    add(Segment::Kind::line, to);
    current_ = to;
  }

  void cubic_from(const Point& first) {
    const Point second = pair();
    const Point to = pair();
    add(Segment::Kind::cubic, first, second, to);
    handle_ = second;
    current_ = to;
  }

  void quadratic_over(const Point& handle) {
    const Point to = pair();
    add(Segment::Kind::quadratic, handle, to);
    handle_ = handle;
    current_ = to;
  }

  // From end points to centre: SVG 1.1, appendix F.6.5.
  void arc() {
    double rx = std::fabs(number());
    double ry = std::fabs(number());
    const double slope = number() * kDegree;
    const bool is_large = flag();
    const bool is_positive = flag();
    const Point to = pair();
    if (rx == 0 || ry == 0 || to == current_) {
      line(to);
      return;
    }
    const double c = std::cos(slope);
    const double s = std::sin(slope);
    const Point half = 0.5 * (current_ - to);
    const Point p = {c * half.x + s * half.y, c * half.y - s * half.x};
    const double need = p.x * p.x / (rx * rx) + p.y * p.y / (ry * ry);
    if (need > 1) {
      rx *= std::sqrt(need);
      ry *= std::sqrt(need);
    }
    const double off = std::sqrt(std::max(0.0, 1 / std::min(need, 1.0) - 1)) *
                       (is_large == is_positive ? -1 : 1);
    // On the unit circle.
    const Point centre = {off * p.y / ry, -off * p.x / rx};
    const Point a = {p.x / rx - centre.x, p.y / ry - centre.y};
    const Point b = {-p.x / rx - centre.x, -p.y / ry - centre.y};
    double sweep = turn(a, b);
    if (is_positive && sweep < 0) {
      sweep += 2 * kPi;
    } else if (!is_positive && sweep > 0) {
      sweep -= 2 * kPi;
    }
    const double begin = std::atan2(a.y, a.x);
    const Point middle = 0.5 * (current_ + to);
    const auto place = [&](const Point& q) {
      const double x = rx * (q.x + centre.x);
      const double y = ry * (q.y + centre.y);
      return middle + Point{c * x - s * y, s * x + c * y};
    };
    const int pieces = arc_pieces(sweep);
    const double k = arc_handle(sweep / pieces);
    for (int i = 0; i < pieces; ++i) {
      const double t0 = begin + sweep * i / pieces;
      const double t1 = begin + sweep * (i + 1) / pieces;
      const Point q0 = {std::cos(t0), std::sin(t0)};
      const Point q1 = {std::cos(t1), std::sin(t1)};
      const Point end = i + 1 == pieces ? to : place(q1);
      add(Segment::Kind::cubic, place(q0 + k * Point{-q0.y, q0.x}),
          place(q1 - k * Point{-q1.y, q1.x}), end);
      current_ = end;
    }
  }

  // Ends the subpath. Without M the next one begins at the same point.
  void end(bool is_closed) {
    if (!subpath_.segments.empty()) {
      subpath_.is_closed = is_closed;
      path_.push_back(std::move(subpath_));
      subpath_ = {};
    }
    current_ = is_closed ? start_ : current_;
  }

  std::string_view data_;
  size_t at_ = 0;
  char command_ = 0;
  char before_ = 0;
  Point current_;
  Point start_;
  Point handle_;  // of the last curve
  Subpath subpath_;
  SvgPath path_;
};

}  // namespace

SvgPath parse_path_data(std::string_view data) {
  return PathReader(data).run();
}

Outline contours_of(const SvgPath& path) {
  Outline outline;
  for (const Subpath& subpath : path) {
    Contour contour;
    const Point first = subpath.segments.front().p[0];
    Point pen = first;
    const auto add = [&](const Segment& segment) {
      bool moves = false;
      for (int i = 1; i <= degree_of(segment); ++i) {
        moves |= !(segment.p[i] == segment.p[0]);
      }
      if (moves) {
        contour.segments.push_back(segment);
        pen = end_of(segment);
      }
    };
    for (const Segment& segment : subpath.segments) {
      add(segment);
    }
    add(line_segment(pen, first));
    if (!contour.segments.empty()) {
      outline.contours.push_back(std::move(contour));
    }
  }
  return outline;
}

}  // namespace inkcell::gen
