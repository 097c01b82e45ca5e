// Filters that are made at run time.
#include "inkcell/c/filter.h"

#include "inkcell/shadow.hpp"
#include "mirror.hpp"

using namespace inkcell;
using c::code;

INKCELL_SAME_VALUE(INKCELL_PROFILE_LINEAR, FilterProfile::linear);
INKCELL_SAME_VALUE(INKCELL_PROFILE_GAUSSIAN, FilterProfile::gaussian);
INKCELL_SAME_VALUE(INKCELL_PROFILE_SIGMOID, FilterProfile::sigmoid);
INKCELL_SAME_VALUE(INKCELL_LIGHT_ON_DARK, Polarity::light_on_dark);
INKCELL_SAME_VALUE(INKCELL_DARK_ON_LIGHT, Polarity::dark_on_light);

namespace {

Fixed<uint16_t, 8> number_or_one(uint16_t value_q8) noexcept {
  return Fixed<uint16_t, 8>::from_raw(value_q8 == 0 ? 1 << 8 : value_q8);
}

}  // namespace

void inkcell_filter_make(const inkcell_filter_spec_t* spec,
                         inkcell_filter_table_t* table,
                         inkcell_filter_t* out) {
  FilterSpec made;
  made.outside_px.raw = spec->outside_q10;
  made.inside_px.raw = spec->inside_q10;
  made.exponent = number_or_one(spec->exponent_q8);
  made.profile = static_cast<FilterProfile>(spec->profile);
  made.contrast = number_or_one(spec->contrast_q8);
  made.gamma = number_or_one(spec->gamma_q8);
  made.polarity = static_cast<Polarity>(spec->polarity);
  new (c::place(table)) Filter(make_filter(made));
  *out = {table};
}

void inkcell_filter_with_weight(const inkcell_filter_t* filter,
                                int16_t weight_q10,
                                inkcell_filter_table_t* table,
                                inkcell_filter_t* out) {
  new (c::place(table))
      Filter(with_weight(c::filter_of(filter), Q6_10::from_raw(weight_q10)));
  *out = {table};
}

void inkcell_filter_shadow(int16_t reach_q10,
                           inkcell_filter_table_t* table,
                           inkcell_filter_t* out) {
  new (c::place(table)) Filter(shadow_filter(Q6_10::from_raw(reach_q10)));
  *out = {table};
}

void inkcell_filter_glow(int16_t reach_q10,
                         inkcell_filter_table_t* table,
                         inkcell_filter_t* out) {
  new (c::place(table)) Filter(glow_filter(Q6_10::from_raw(reach_q10)));
  *out = {table};
}

inkcell_status_t inkcell_filter_check_reach(const inkcell_filter_t* filter,
                                            const inkcell_font_range_t* range,
                                            int32_t size_q6) {
  return code(check_reach(*reinterpret_cast<const FontRange*>(range),
                          Q26_6::from_raw(size_q6), c::filter_of(filter)));
}
