// What targets of C stand for: of pixel.h.
#pragma once

#include "inkcell/c/pixel.h"
#include "inkcell/port/a8.hpp"
#include "inkcell/port/grey2.hpp"
#include "inkcell/port/grey4.hpp"
#include "inkcell/port/grey8.hpp"
#include "inkcell/port/mono_pages.hpp"
#include "inkcell/port/mono_rows.hpp"
#include "inkcell/port/rgb565.hpp"
#include "inkcell/port/rgb888.hpp"
#include "inkcell/port/xrgb8888.hpp"
#include "mirror.hpp"

namespace inkcell {
namespace c {

template <>
struct CppOf<inkcell_a8_target_t> {
  using Type = port::A8Target;
};
template <>
struct CppOf<inkcell_grey8_target_t> {
  using Type = port::Grey8Target;
};
template <>
struct CppOf<inkcell_grey4_target_t> {
  using Type = port::Grey4Target;
};
template <>
struct CppOf<inkcell_grey2_target_t> {
  using Type = port::Grey2Target;
};
template <>
struct CppOf<inkcell_mono_rows_target_t> {
  using Type = port::MonoRowsTarget;
};
template <>
struct CppOf<inkcell_mono_pages_target_t> {
  using Type = port::MonoPagesTarget;
};
template <>
struct CppOf<inkcell_rgb565_target_t> {
  using Type = port::Rgb565Target;
};
template <>
struct CppOf<inkcell_rgb888_target_t> {
  using Type = port::Rgb888Target;
};
template <>
struct CppOf<inkcell_xrgb8888_target_t> {
  using Type = port::Xrgb8888Target;
};

}  // namespace c
}  // namespace inkcell
