// TrueType files without overlaps, in any style.
//
//   INKCELL_TRY(sans.open(file, kPlainTrueTypeCoding));
//   painter.text(sans.font(), Style(24_px, kFilterText), pen, "12:34");
#pragma once

#include "inkcell/coding.hpp"

namespace inkcell {

/// For TrueTypeFont::open(), where the caller vouches that no contours overlap,
/// and that each runs as TrueType says, filled areas to its right: others look
/// wrong. Takes less RAM and time than kTrueTypeCoding, and all filters and
/// effects.
extern const Coding kPlainTrueTypeCoding;

}  // namespace inkcell
