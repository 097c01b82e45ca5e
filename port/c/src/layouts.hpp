// What types of layout.h stand for.
#pragma once

#include "inkcell/c/layout.h"
#include "inkcell/layout/layout.hpp"
#include "mirror.hpp"

namespace inkcell {
namespace c {

template <>
struct CppOf<inkcell_bidi_t> {
  using Type = Bidi;
};
template <>
struct CppOf<inkcell_layout_t> {
  using Type = LayoutOptions;
};
template <>
struct CppOf<inkcell_line_t> {
  using Type = TextLine;
};

}  // namespace c
}  // namespace inkcell
