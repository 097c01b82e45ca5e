#include "judge/moved_area.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "shape/area_gains.hpp"
#include "shape/difference.hpp"
#include "shape/points.hpp"

namespace inkcell::gen {
namespace {

// Room for the pieces of most glyphs.
constexpr size_t kPieces = 1 << 14;

// A pixel is so many cells wide. One that begins within a cell touches one
// more, and holds all but two of them.
constexpr int kCells = 32;
constexpr double kPixel = kCells * kCells;  // [cells]

// Of a cell. [cells]
struct Areas {
  double gained = 0;
  double lost = 0;

  double most() const { return std::max(gained, lost); }
  Areas& operator+=(const Areas& other) {
    gained += other.gained;
    lost += other.lost;
    return *this;
  }
};

// A square of the size of a pixel.
struct Block {
  Areas sum;
  size_t last = 0;  // of its pieces, counted from 1; 0: none
};

// What a polygon has of a cell of a block.
struct Piece {
  size_t before;  // the piece before it in the same block
  int x;
  int y;
  Areas areas;
};

// Where the areas of a polygon go.
enum class Role { gained, lost, either };

// Areas in the cells of a plane.
class Cells {
 public:
  Cells(const Box& box, int px) : scale_(kCells * px / 1024.0), box_(box) {
    columns_ = static_cast<int>((box.x1 - box.x0) * px / 1024) + 1;
    rows_ = static_cast<int>((box.y1 - box.y0) * px / 1024) + 1;
    blocks_.resize(static_cast<size_t>(columns_) * static_cast<size_t>(rows_));
    pieces_.reserve(kPieces);
  }

  int columns() const { return columns_; }
  int rows() const { return rows_; }

  // Empty beyond the plane.
  Block block(int column, int row) const {
    const bool is_there =
        column >= 0 && row >= 0 && column < columns_ && row < rows_;
    return is_there ? blocks_[index(column, row)] : Block();
  }

  // Calls `take(piece)` for each piece of a block.
  template <typename Take>
  void for_pieces(const Block& block, const Take& take) const {
    for (size_t i = block.last; i != 0; i = pieces_[i - 1].before) {
      take(pieces_[i - 1]);
    }
  }

  Point u_of(double x, double y) const {
    return {box_.x0 + x / scale_, box_.y0 + y / scale_};
  }

  void add(const std::vector<Point>& polygon, Role role) {
    corners_.clear();
    for (const Point& p : polygon) {
      corners_.push_back({(p.x - box_.x0) * scale_, (p.y - box_.y0) * scale_});
    }
    find_spans();
    for_parts([&](int row, const Point& low, const Point& high, bool is_up) {
      const Span& span = span_of(row);
      add_gains(low, high, is_up, gains_.data() + (span.begin - span.first));
    });
    for (size_t i = 0; i < spans_.size(); ++i) {
      const Span& span = spans_[i];
      double sum = 0;
      for (int x = span.first; x <= span.last; ++x) {
        sum += gains_[static_cast<size_t>(span.begin + x - span.first)];
        if (sum != 0) {
          add_cell(x, first_row_ + static_cast<int>(i), sum, role);
        }
      }
    }
  }

 private:
  // Cells of a row that a polygon touches, and one more for what add_gains()
  // adds behind them.
  struct Span {
    int first = 0;
    int last = -1;
    ptrdiff_t begin = 0;
  };

  size_t index(int column, int row) const {
    return static_cast<size_t>(row) * static_cast<size_t>(columns_) +
           static_cast<size_t>(column);
  }

  Span& span_of(int row) {
    return spans_[static_cast<size_t>(row - first_row_)];
  }

  template <typename Part>
  void for_parts(const Part& part) const {
    for (size_t i = 0; i < corners_.size(); ++i) {
      for_rows_of(corners_[i], corners_[(i + 1) % corners_.size()], part);
    }
  }

  void find_spans() {
    const auto [low, high] = std::minmax_element(
        corners_.begin(), corners_.end(),
        [](const Point& a, const Point& b) { return a.y < b.y; });
    first_row_ = static_cast<int>(low->y);
    const int rows = static_cast<int>(high->y) - first_row_ + 1;
    spans_.assign(static_cast<size_t>(rows), Span());
    for_parts([&](int row, const Point& a, const Point& b, bool) {
      Span& span = span_of(row);
      const auto first = static_cast<int>(std::min(a.x, b.x));
      const auto last = static_cast<int>(std::max(a.x, b.x)) + 1;
      const bool is_new = span.last < span.first;
      span.first = is_new ? first : std::min(span.first, first);
      span.last = is_new ? last : std::max(span.last, last);
    });
    ptrdiff_t size = 0;
    for (Span& span : spans_) {
      span.begin = size;
      size += span.last - span.first + 1;
    }
    gains_.assign(static_cast<size_t>(size), 0);
  }

  void add_cell(int x, int y, double area, Role role) {
    const int column = std::min(x / kCells, columns_ - 1);
    const int row = std::min(y / kCells, rows_ - 1);
    Areas areas;
    if (role == Role::lost || (role == Role::either && area < 0)) {
      areas.lost = role == Role::lost ? area : -area;
    } else {
      areas.gained = area;
    }
    Block& block = blocks_[index(column, row)];
    pieces_.push_back({block.last, std::min(x - column * kCells, kCells - 1),
                       std::min(y - row * kCells, kCells - 1), areas});
    block.last = pieces_.size();
    block.sum += areas;
  }

  double scale_;
  Box box_;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<Block> blocks_;
  std::vector<Piece> pieces_;
  // Of the current polygon:
  std::vector<Point> corners_;
  int first_row_ = 0;
  std::vector<Span> spans_;
  std::vector<double> gains_;
};

// Of four blocks the sums of the cells before each corner.
class Sums {
 public:
  Sums(const Cells& cells, int column, int row) {
    for (int i = 0; i < 4; ++i) {
      cells.for_pieces(
          cells.block(column + i % 2, row + i / 2), [&](const Piece& piece) {
            sums_[index(piece.x + i % 2 * kCells + 1,
                        piece.y + i / 2 * kCells + 1)] += piece.areas;
          });
    }
    for (int y = 1; y < kSide; ++y) {
      Areas row_sum;
      for (int x = 1; x < kSide; ++x) {
        Areas& sum = sums_[index(x, y)];
        row_sum += sum;
        sum = row_sum;
        sum += sums_[index(x, y - 1)];
      }
    }
  }

  // The most that a pixel that begins in a cell can gain or lose.
  double most_at(int x, int y) const {
    const Areas most = within(x, y, x + kCells + 1, y + kCells + 1);
    const Areas least = within(x + 1, y + 1, x + kCells, y + kCells);
    return std::max(most.gained - least.lost, most.lost - least.gained);
  }

 private:
  static constexpr int kSide = 2 * kCells + 1;

  static size_t index(int x, int y) {
    return static_cast<size_t>(y * kSide + x);
  }
  Areas within(int x0, int y0, int x1, int y1) const {
    const Areas& a = sums_[index(x0, y0)];
    const Areas& b = sums_[index(x1, y0)];
    const Areas& c = sums_[index(x0, y1)];
    const Areas& d = sums_[index(x1, y1)];
    return {d.gained - c.gained - b.gained + a.gained,
            d.lost - c.lost - b.lost + a.lost};
  }

  std::array<Areas, kSide * kSide> sums_{};
};

// A block in which pixels begin. They lie in four blocks, which hold `most`.
struct Beginning {
  double most;
  int column;
  int row;
};

std::vector<Beginning> beginnings_in(const Cells& cells) {
  std::vector<Beginning> found;
  for (int row = -1; row < cells.rows(); ++row) {
    for (int column = -1; column < cells.columns(); ++column) {
      Areas sum;
      for (int i = 0; i < 4; ++i) {
        sum += cells.block(column + i % 2, row + i / 2).sum;
      }
      if (sum.most() > 0) {
        found.push_back({sum.most(), column, row});
      }
    }
  }
  std::stable_sort(
      found.begin(), found.end(),
      [](const Beginning& a, const Beginning& b) { return a.most > b.most; });
  return found;
}

MovedPixel worst_in(const Cells& cells, const Beginning& block) {
  const Sums sums(cells, block.column, block.row);
  MovedPixel worst;
  for (int y = 0; y < kCells; ++y) {
    for (int x = 0; x < kCells; ++x) {
      const double most = sums.most_at(x, y);
      if (most > worst.share) {
        constexpr double kHalf = (kCells + 1) / 2.0;
        worst = {most, cells.u_of(block.column * kCells + x + kHalf,
                                  block.row * kCells + y + kHalf)};
      }
    }
  }
  worst.share /= kPixel;
  return worst;
}

void stretch(const Polygons& polygons, Box& box) {
  for (const std::vector<Point>& polygon : polygons) {
    for (const Point& p : polygon) {
      box.add(p);
    }
  }
}

void add_all(const Polygons& polygons, Role role, Cells& cells) {
  for (const std::vector<Point>& polygon : polygons) {
    cells.add(polygon, role);
  }
}

}  // namespace

MovedArea::MovedArea(const Shape& source, const Shape& drawn)
    : gained_(difference(drawn, source)), lost_(difference(source, drawn)) {}

MovedPixel MovedArea::worst_pixel(int px,
                                  const std::vector<Polygons>& strays,
                                  double limit,
                                  const MovedPixel& known,
                                  std::vector<MovedPixel>& beyond) const {
  Box box = kNoBox;
  stretch(gained_, box);
  stretch(lost_, box);
  for (const Polygons& some : strays) {
    stretch(some, box);
  }
  if (box.x1 < box.x0) {
    return known;
  }
  MovedPixel worst = known;
  Cells moved(box, px);
  add_all(gained_, Role::gained, moved);
  add_all(lost_, Role::lost, moved);
  for (const Polygons& some : strays) {
    Cells cells = moved;
    add_all(some, Role::either, cells);
    for (const Beginning& block : beginnings_in(cells)) {
      if (block.most <= kPixel * std::min(worst.share, limit)) {
        break;
      }
      const MovedPixel pixel = worst_in(cells, block);
      if (pixel.share > worst.share) {
        worst = pixel;
      }
      if (pixel.share > limit) {
        beyond.push_back(pixel);
      }
    }
  }
  return worst;
}

}  // namespace inkcell::gen
