// Whether the compiler was asked for small code.
#pragma once

namespace inkcell::detail {

#if defined(__OPTIMIZE_SIZE__)
inline constexpr bool kIsSmall = true;
#else
inline constexpr bool kIsSmall = false;
#endif

}  // namespace inkcell::detail
