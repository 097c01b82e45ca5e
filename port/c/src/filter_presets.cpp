// Filters in ROM. Each names its painter: a program links those that it uses.
#include "filter_parts.hpp"
#include "inkcell/c/filter.h"

using namespace inkcell;

const inkcell_filter_t inkcell_filter_text = {
    {&kFilterText, &detail::kPaintPixelRamp}};
const inkcell_filter_t inkcell_filter_motion = {
    {&kFilterMotion, &detail::kPaintWideDistances}};
const inkcell_filter_t inkcell_filter_paper_display = {
    {&kFilterPaperDisplay, &detail::kPaintWideDistances}};
const inkcell_filter_t inkcell_filter_paper_body = {
    {&kFilterPaperBody, &detail::kPaintWideDistances}};
const inkcell_filter_t inkcell_filter_area = {
    {&kFilterText, &detail::kPaintAreas}};
