// A page of a pixel font that has all of Unicode's first plane: words of many
// scripts, and signs.
#pragma once

namespace inkcell::demo {

inline constexpr char kScripts[] =
    u8"\u03a9\u03bc\u03ad\u03b3\u03b1 \u0416\u0438\u0437\u043d\u044c "
    u8"\u0540\u0561\u0575 \u10e5\u10d0\u10e0\u10d7 \u1200\u1208\u1210 "
    u8"\u05e9\u05dc\u05d5\u05dd \u3072\u3089 \u30ab\u30ca "
    u8"\ud55c\uad6d\uc5b4 \u6f22\u5b57 \u16a0\u16b1 \u13a3\u13b9 "
    u8"\u2192\u2211\u2318\u2602\u265e\u283f\u253c\u2588\ua500\uff21";

}  // namespace inkcell::demo
