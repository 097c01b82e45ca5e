// Filters, from distance to coverage, as in inkcell/filter.hpp.
//
// A program links what paints the filters that it names: a run-time filter
// needs all painters of distances, a preset its own.
//
// Made by port/c/make_api.py from port/c/api.txt: edit that instead.
#pragma once

#include "inkcell/c/font.h"
#include "inkcell/c/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/// A filter by its table. Opaque. Styles keep the table, and not the filter
/// itself.
typedef struct INKCELL_SHARED inkcell_filter_t {
  const void* table;
} inkcell_filter_t;

/// The table of a filter that is made at run time, 268 bytes. Opaque. It must
/// outlive the filter and its styles, unchanged.
typedef struct INKCELL_SHARED inkcell_filter_table_t {
  const void* painter;
  uint16_t numbers[132];
} inkcell_filter_table_t;

/// -0.5 to 0.5 px: right weight at text sizes.
extern const inkcell_filter_t inkcell_filter_text;

/// -0.6 to 0.625 px: calm, for type that moves.
extern const inkcell_filter_t inkcell_filter_motion;

/// -0.75 to 0.75 px, exponent 1.1: the paper's choice for display type.
extern const inkcell_filter_t inkcell_filter_paper_display;

/// -0.5 to 0.625 px, exponent 1.1: the paper's choice for body type.
extern const inkcell_filter_t inkcell_filter_paper_body;

/// Exact coverage, of outlines; fields take the ramp of a straight edge.
extern const inkcell_filter_t inkcell_filter_area;

/// How coverage rises from cutoff to cutoff.
enum {
  INKCELL_PROFILE_LINEAR = 0,
  INKCELL_PROFILE_GAUSSIAN = 1,
  INKCELL_PROFILE_SIGMOID = 2
};

/// Which of text and background is the lighter.
enum { INKCELL_LIGHT_ON_DARK = 0, INKCELL_DARK_ON_LIGHT = 1 };

/// Coverage is 0 at `outside_q10` and below, 255 at `inside_q10` and above, and
/// between them the profile raised to the exponent. Values out of range are
/// clamped; exponent, contrast and gamma of 0 mean 1.
typedef struct inkcell_filter_spec_t {
  int16_t outside_q10;   // within +-4 px; positive distances are inside
  int16_t inside_q10;    // the same, above outside by at least 1/8 px
  uint16_t exponent_q8;  // 1/4 to 4
  uint16_t contrast_q8;  // slope at half coverage, 1/4 to 4
  uint16_t gamma_q8;     // of the display, 1 to 4
  uint8_t profile;
  uint8_t polarity;  // which gamma corrects for
} inkcell_filter_spec_t;

/// Fills in `table`, which costs some thousand products: once a filter.
void inkcell_filter_make(const inkcell_filter_spec_t* spec,
                         inkcell_filter_table_t* table,
                         inkcell_filter_t* out);

/// The same filter with edges moved outwards by `weight_q10` px, inwards if
/// negative; cutoffs are clamped to +-4 px. Of `area`: that of `text`.
void inkcell_filter_with_weight(const inkcell_filter_t* filter,
                                int16_t weight_q10,
                                inkcell_filter_table_t* table,
                                inkcell_filter_t* out);

/// A soft edge: a Gaussian from `reach_q10` px, up to 4, outside to as far
/// inside. Draw a shadow first, in its own style and colour, moved; then the
/// text.
void inkcell_filter_shadow(int16_t reach_q10,
                           inkcell_filter_table_t* table,
                           inkcell_filter_t* out);

/// Full from the edge inwards, and less and less up to `reach_q10` px outside.
void inkcell_filter_glow(int16_t reach_q10,
                         inkcell_filter_table_t* table,
                         inkcell_filter_t* out);

/// BEYOND_BAND: at `size_q6` px/em a cutoff of the filter is farther from the
/// edge than the font's distances are good. Those of outlines are good
/// everywhere.
inkcell_status_t inkcell_filter_check_reach(const inkcell_filter_t* filter,
                                            const inkcell_font_range_t* range,
                                            int32_t size_q6);

#ifdef __cplusplus
}
#endif
