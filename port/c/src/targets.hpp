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
  using Type = port::detail::A8Pixels;
};
template <>
struct CppOf<inkcell_grey8_target_t> {
  using Type = port::detail::Grey8Pixels;
};
template <>
struct CppOf<inkcell_grey4_target_t> {
  using Type = port::detail::Grey4Pixels;
};
template <>
struct CppOf<inkcell_grey2_target_t> {
  using Type = port::detail::Grey2Pixels;
};
template <>
struct CppOf<inkcell_mono_rows_target_t> {
  using Type = port::detail::MonoRowsPixels;
};
template <>
struct CppOf<inkcell_mono_pages_target_t> {
  using Type = port::detail::MonoPagesPixels;
};
template <>
struct CppOf<inkcell_rgb565_target_t> {
  using Type = port::detail::Rgb565Pixels;
};
template <>
struct CppOf<inkcell_rgb888_target_t> {
  using Type = port::detail::Rgb888Pixels;
};
template <>
struct CppOf<inkcell_xrgb8888_target_t> {
  using Type = port::detail::Xrgb8888Pixels;
};

/// The sink of a target; one that takes nothing if that is wrong.
template <typename Target>
inkcell_status_t make_sink(Target* target, inkcell_sink_t* out) noexcept {
  using Pixels = typename CppOf<Target>::Type;
  Pixels& pixels = *cpp(target);
  *cpp(out) = Sink();
  const Status status =
      port::detail::check_layout(pixels.strip, Pixels::kKind.layout);
  return code(status != Status::ok
                  ? status
                  : port::detail::open_sink(pixels.strip, Pixels::kKind, target,
                                            *cpp(out)));
}

/// The same of a target of grey, 0 to `most`, or of 1 bit.
template <typename Target>
inkcell_status_t make_grey_sink(Target* target,
                                uint8_t most,
                                inkcell_sink_t* out) noexcept {
  if (target->level > most) {
    *cpp(out) = Sink();
    return INKCELL_BAD_ARGUMENT;
  }
  return make_sink(target, out);
}
template <typename Target>
inkcell_status_t make_mono_sink(Target* target, inkcell_sink_t* out) noexcept {
  if (target->threshold == 0) {
    *cpp(out) = Sink();
    return INKCELL_BAD_ARGUMENT;
  }
  return make_grey_sink(target, 1, out);
}

}  // namespace c
}  // namespace inkcell
