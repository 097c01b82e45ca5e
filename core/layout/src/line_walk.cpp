#include "line_walk.hpp"

namespace inkcell {
namespace detail {

uint32_t LineWalk::take(Cell& cell) noexcept {
  Text following = rest();
  cell.begin = at_;
  const uint32_t code_point = next_code_point(following);
  at_ = static_cast<uint32_t>(text_.size - following.size);
  cell.end = at_;
  return code_point;
}

}  // namespace detail
}  // namespace inkcell
