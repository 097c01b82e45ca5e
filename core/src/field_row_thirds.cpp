// Rows of points in threes.
#include "field_row.hpp"

namespace inkcell {
namespace detail {

// Fields as they are at a leaf's first point, from where a value takes one
// product, four if it is bent.
class FieldRow::NearValues {
 public:
  explicit NearValues(const FieldRow& row) noexcept : row_(row) {}

  void begin(uint32_t count, uint32_t x_q8) noexcept {
    first_q8_ = x_q8;
    for (uint32_t i = 0; i < count; ++i) {
      const uint32_t place = fields.place[i];
      set_up_term(terms_[i], row_.field_, place >> 1 | (place & 1) << 15, x_q8,
                  row_.y_q8_, row_.scale_);
    }
  }

  int32_t far_q22() const noexcept { return row_.thirds_reach_q22(); }

  template <typename Distance>
  int32_t* put(uint32_t x_q8,
               int32_t* out,
               const Distance& distance) const noexcept {
    constexpr uint32_t kThird = kThirdQ8;
    const int32_t middle = distance(x_q8);
    const bool is_near = middle > -far_q22() && middle < far_q22();
    out[0] = is_near ? distance(x_q8 - kThird) : middle;
    out[1] = middle;
    out[2] = is_near ? distance(x_q8 + kThird) : middle;
    return out + 3;
  }

  // FieldTerm::value_q22. [px]
  int32_t distance(uint32_t i, uint32_t x_q8) const noexcept {
    const FieldTerm& term = terms_[i];
    const uint32_t way_q8 = x_q8 - first_q8_;
    uint32_t value = term.plane_q22 + times(term.nx_q14, way_q8);
    if (term.bend != 0) {
      const auto along = static_cast<uint32_t>(
          wrapped(term.along_q22 - times(term.ny_q14, way_q8)) >> 14);
      const auto slope = static_cast<uint32_t>(
          wrapped(times(term.bend, along)) >> row_.bend_shift_);
      value += static_cast<uint32_t>(wrapped(slope * along) >> 1);
    }
    return wrapped(value);
  }

  Fields fields;

 private:
  const FieldRow& row_;
  uint32_t first_q8_ = 0;
  FieldTerm terms_[3];
};

void FieldRow::take_thirds(RowPoint at,
                           int32_t* out,
                           int32_t count) const noexcept {
  take_with<NearValues>(at, out, count);
}

}  // namespace detail
}  // namespace inkcell
