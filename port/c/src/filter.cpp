// clang-format off
// Made by port/c/make_api.py from port/c/api.txt: edit that instead.
#include "mirror.hpp"

using namespace inkcell;
using namespace inkcell::c;

const inkcell_filter_t inkcell_filter_text = {&kFilterText};;

const inkcell_filter_t inkcell_filter_motion = {&kFilterMotion};;

const inkcell_filter_t inkcell_filter_paper_display = {&kFilterPaperDisplay};;

const inkcell_filter_t inkcell_filter_paper_body = {&kFilterPaperBody};;

const inkcell_filter_t inkcell_filter_area = {&kFilterArea};;

void inkcell_filter_make(const inkcell_filter_spec_t* spec,
                         inkcell_filter_table_t* table,
                         inkcell_filter_t* out) {
  FilterSpec made;
  made.outside_px.raw = spec->outside_q10;
  made.inside_px.raw = spec->inside_q10;
  made.exponent.raw = value_or(spec->exponent_q8, uint16_t{1 << 8});
  made.profile = static_cast<FilterProfile>(spec->profile);
  made.contrast.raw = value_or(spec->contrast_q8, uint16_t{1 << 8});
  made.gamma.raw = value_or(spec->gamma_q8, uint16_t{1 << 8});
  made.polarity = static_cast<Polarity>(spec->polarity);
  new (into(table)) Filter(make_filter(made));
  *out = {table};
}

void inkcell_filter_with_weight(const inkcell_filter_t* filter,
                                int16_t weight_q10,
                                inkcell_filter_table_t* table,
                                inkcell_filter_t* out) {
  new (into(table)) Filter(with_weight(filter_of(filter),
      Q6_10::from_raw(weight_q10)));
  *out = {table};
}

void inkcell_filter_shadow(int16_t reach_q10,
                           inkcell_filter_table_t* table,
                           inkcell_filter_t* out) {
  new (into(table)) Filter(shadow_filter(Q6_10::from_raw(reach_q10)));
  *out = {table};
}

void inkcell_filter_glow(int16_t reach_q10,
                         inkcell_filter_table_t* table,
                         inkcell_filter_t* out) {
  new (into(table)) Filter(glow_filter(Q6_10::from_raw(reach_q10)));
  *out = {table};
}

inkcell_status_t inkcell_filter_check_reach(const inkcell_filter_t* filter,
                                            const inkcell_font_range_t* range,
                                            int32_t size_q6) {
  return code(check_reach(*reinterpret_cast<const FontRange*>(range),
      Q26_6::from_raw(size_q6), filter_of(filter)));
}
