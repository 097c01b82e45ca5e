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
