// Filters in ROM: a program links those that it uses.
#include "inkcell/filter.hpp"

#include "inkcell/c/filter.h"

using namespace inkcell;

const inkcell_filter_t inkcell_filter_text = {&kFilterText};
const inkcell_filter_t inkcell_filter_motion = {&kFilterMotion};
const inkcell_filter_t inkcell_filter_paper_display = {&kFilterPaperDisplay};
const inkcell_filter_t inkcell_filter_paper_body = {&kFilterPaperBody};
const inkcell_filter_t inkcell_filter_area = {&kFilterArea};
