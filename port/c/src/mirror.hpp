// The library's types, in the memory of those of C.
//
// A type of C has the size and the alignment of the one that it stands for.
// Members that a program may touch lie at the same places: each source says so
// of its own types. Types of C may alias any other.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "inkcell/c/draw.h"
#include "inkcell/c/types.h"
#include "inkcell/geometry.hpp"
#include "inkcell/strip.hpp"
#include "inkcell/text.hpp"
#include "inkcell/workspace.hpp"

/// The member `c_member` of the type `C` is `cpp_member` of what it stands for.
#define INKCELL_SAME_PLACE(C, c_member, cpp_member)                         \
  static_assert(offsetof(C, c_member) ==                                    \
                        offsetof(inkcell::c::CppOf<C>::Type, cpp_member) && \
                    sizeof(C::c_member) ==                                  \
                        sizeof(inkcell::c::CppOf<C>::Type::cpp_member),     \
                "members differ")

/// A constant of C has the value of an enumerator.
#define INKCELL_SAME_VALUE(constant, enumerator)                            \
  static_assert(static_cast<int>(constant) == static_cast<int>(enumerator), \
                "values differ")

namespace inkcell {
namespace c {

/// What a type of C stands for: `Type`.
template <typename C>
struct CppOf;
template <>
struct CppOf<inkcell_rect_t> {
  using Type = Rect;
};
template <>
struct CppOf<inkcell_workspace_t> {
  using Type = Workspace;
};
template <>
struct CppOf<inkcell_font_t> {
  using Type = Font;
};
template <>
struct CppOf<inkcell_filter_table_t> {
  using Type = Filter;
};
template <>
struct CppOf<inkcell_style_t> {
  using Type = Style;
};
template <>
struct CppOf<inkcell_strip_t> {
  using Type = Strip;
};
template <>
struct CppOf<inkcell_sink_t> {
  using Type = Sink;
};
template <>
struct CppOf<inkcell_positioned_glyph_t> {
  using Type = PositionedGlyph;
};
template <>
struct CppOf<inkcell_face_t> {
  using Type = Face;
};

template <typename C>
constexpr bool is_alike() noexcept {
  using Cpp = typename CppOf<C>::Type;
  return sizeof(C) == sizeof(Cpp) && alignof(C) == alignof(Cpp);
}

/// An object, or the first one of several, as what it stands for.
template <typename C>
typename CppOf<C>::Type* cpp(C* object) noexcept {
  static_assert(is_alike<C>(), "sizes differ");
  return reinterpret_cast<typename CppOf<C>::Type*>(object);
}
template <typename C>
const typename CppOf<C>::Type* cpp(const C* object) noexcept {
  static_assert(is_alike<C>(), "sizes differ");
  return reinterpret_cast<const typename CppOf<C>::Type*>(object);
}

/// Memory of C: `new (place(out)) Filter(make_filter(spec))` makes a filter
/// there, and no copy on the stack.
struct Place {
  void* memory;
};
template <typename C>
Place place(C* object) noexcept {
  static_assert(is_alike<C>(), "sizes differ");
  return {object};
}

inline const Filter& filter_of(const inkcell_filter_t* filter) noexcept {
  return *static_cast<const Filter*>(filter->table);
}

/// Words that an object of C has for one of C++.
template <typename Cpp, size_t kWords>
Place memory(const void* (&words)[kWords]) noexcept {
  static_assert(
      sizeof(Cpp) <= sizeof(words) && alignof(Cpp) <= alignof(const void*),
      "too few words");
  return {words};
}

inline inkcell_status_t code(Status status) noexcept {
  return static_cast<inkcell_status_t>(status);
}

inline Text text_of(const char* text, size_t size) noexcept {
  return size == INKCELL_TERMINATED ? Text(text) : Text(text, size);
}

inline Point point_of(int32_t x_q6, int32_t y_q6) noexcept {
  return {Q26_6::from_raw(x_q6), Q26_6::from_raw(y_q6)};
}

inline Workspace workspace_of(const inkcell_workspace_t* ram) noexcept {
  return ram == nullptr ? Workspace() : *cpp(ram);
}

}  // namespace c
}  // namespace inkcell

inline void* operator new(size_t, inkcell::c::Place place) noexcept {
  return place.memory;
}
