// What functions of C make of their parameters.
//
// A type of C has the size and the alignment of the one that it stands for.
// Members lie at the same places: checks.cpp says so. It may alias any other.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "twins.hpp"

namespace inkcell::c {

template <typename C>
struct CppOf<const C> {
  using Type = const typename CppOf<C>::Type;
};

/// An object, or the first one of several, as what it stands for.
template <typename C>
typename CppOf<C>::Type* cpp(C* object) noexcept {
  using Cpp = typename CppOf<C>::Type;
  static_assert(sizeof(C) == sizeof(Cpp) && alignof(C) == alignof(Cpp),
                "sizes differ");
  return reinterpret_cast<Cpp*>(object);
}
template <typename C>
typename CppOf<C>::Type& ref(C* object) noexcept {
  return *cpp(object);
}

/// Memory of C: `new (into(out)) Filter(make_filter(spec))` makes a filter
/// there, and no copy on the stack.
struct Place {
  void* memory;
};
template <typename C>
Place into(C* object) noexcept {
  return {cpp(object)};
}

/// An effect in words that an object of C has for it.
template <typename Made, size_t kWords, typename... What>
const Made& made(const void* (&words)[kWords], What... what) noexcept {
  static_assert(
      sizeof(Made) <= sizeof(words) && alignof(Made) <= alignof(const void*),
      "too few words");
  return *new (Place{words}) Made(what...);
}

inline const Filter& filter_of(const inkcell_filter_t* filter) noexcept {
  return *static_cast<const Filter*>(filter->table);
}

inline inkcell_status_t code(Status status) noexcept {
  return static_cast<inkcell_status_t>(status);
}

inline Text text_of(const char* text, size_t size) noexcept {
  return size == INKCELL_TERMINATED ? Text(text) : Text(text, size);
}

inline const char* put_text(Text text, char* out) noexcept {
  __builtin_memcpy(out, text.data, text.size);
  out[text.size] = 0;
  return out;
}

inline Point point_of(int32_t x_q6, int32_t y_q6) noexcept {
  return {Q26_6::from_raw(x_q6), Q26_6::from_raw(y_q6)};
}

/// That of a null pointer draws nothing. In painter_of.cpp.
Painter painter_of(const inkcell_painter_t* painter) noexcept;

static_assert(INKCELL_MAX_SPAN == kMaxSpan, "values differ");
static_assert(INKCELL_STORED_TRUETYPE_BYTES(3, 9) ==
                  StoredTrueType::ram_bytes(3, 9),
              "values differ");

/// Options that are 0 have their default.
template <typename T>
T value_or(T value, T otherwise) noexcept {
  return value == 0 ? otherwise : value;
}

/// A style if its stretches are in range, else one that draws nothing.
template <typename... What>
static inkcell_status_t make_style(inkcell_style_t* out,
                                   bool is_allowed,
                                   const What&... what) noexcept {
  if (!is_allowed) {
    *out = {};
    return INKCELL_BAD_ARGUMENT;
  }
  *cpp(out) = Style(what...);
  return INKCELL_OK;
}

inline bool is_size(int32_t size_q6) noexcept {
  return size_q6 >= kMinSize.raw && size_q6 <= kMaxSize.raw;
}

/// Whether the length is 1 within 1/1000.
inline bool is_unit(int64_t cosine_q30, int64_t sine_q30) noexcept {
  constexpr int64_t kOne = int64_t{1} << 30;
  cosine_q30 >>= 1;
  sine_q30 >>= 1;
  const int64_t squared = (cosine_q30 * cosine_q30 + sine_q30 * sine_q30) >> 28;
  return squared >= kOne - kOne / 500 && squared <= kOne + kOne / 500;
}

/// Opens a TrueType file in the room of C, for a font that points into it.
inline Status open_truetype(Span<const uint8_t> file,
                            const Coding& coding,
                            uint32_t face,
                            inkcell_truetype_t* room,
                            Font& out) noexcept {
  TrueTypeFont& opened = ref(room);
  INKCELL_TRY(opened.open(file, coding, face));
  out = opened.font();
  return Status::ok;
}

/// `draw` or `flush` of a loop of C as that of C++, and `wait`.
template <auto kFunction, auto kContext>
Status strip_by(void* loop_of_c, const Strip& strip) noexcept {
  const auto& loop = *static_cast<const inkcell_strip_loop_t*>(loop_of_c);
  return static_cast<Status>((loop.*kFunction)(
      loop.*kContext, reinterpret_cast<const inkcell_strip_t*>(&strip)));
}
inline Status wait_by(void* loop_of_c) noexcept {
  const auto& loop = *static_cast<const inkcell_strip_loop_t*>(loop_of_c);
  return static_cast<Status>(loop.wait(loop.display));
}

/// Whether the colour of a target is in range.
template <typename Target>
bool has_colour(const Target&) noexcept {
  return true;
}
inline bool has_colour(const inkcell_grey4_target_t& target) noexcept {
  return target.level <= 15;
}
inline bool has_colour(const inkcell_grey2_target_t& target) noexcept {
  return target.level <= 3;
}
inline bool has_colour(const inkcell_mono_rows_target_t& target) noexcept {
  return target.threshold != 0 && target.level <= 1;
}
inline bool has_colour(const inkcell_mono_pages_target_t& target) noexcept {
  return target.threshold != 0 && target.level <= 1;
}

/// The sink of a target; one that takes nothing if that is wrong.
template <typename Target>
static Status make_sink(Target* target, inkcell_sink_t* out) noexcept {
  using Pixels = typename CppOf<Target>::Type;
  Pixels& pixels = *cpp(target);
  *cpp(out) = Sink();
  if (!has_colour(*target)) {
    return Status::bad_argument;
  }
  const Status status =
      port::detail::check_layout(pixels.strip, Pixels::kKind.layout);
  return status != Status::ok
             ? status
             : port::detail::open_sink(pixels.strip, Pixels::kKind, target,
                                       *cpp(out));
}

}  // namespace inkcell::c

inline void* operator new(size_t, inkcell::c::Place place) noexcept {
  return place.memory;
}
