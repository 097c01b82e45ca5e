// Contracts that a caller must keep, checked in builds that ask for it.
#pragma once

#include "inkcell/cpp17.hpp"

/// 1: a broken contract ends the program with a trap, at the line that states
/// it. 0, the default: contracts are neither evaluated nor compiled, so that
/// objects are as without them. One value for the library and the program:
/// headers state contracts, too. The CMake option of this name sets both.
///
/// Contracts are for mistakes of the program. Fonts, texts and other data that
/// a program cannot know are answered by Status and never end it.
#ifndef INKCELL_ASSERTIONS
#  define INKCELL_ASSERTIONS 0
#endif

/// States that `condition` holds here. It must have no effect.
#if INKCELL_ASSERTIONS
#  define INKCELL_ASSERT(condition) \
    ((condition) ? static_cast<void>(0) : __builtin_trap())
#else
#  define INKCELL_ASSERT(condition) static_cast<void>(0)
#endif
