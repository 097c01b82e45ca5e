// Ends the compilation below C++17, with the remedy. In PlatformIO that is
// `build_unflags = -std=gnu++11` and `build_flags = -std=gnu++17`; in CMake,
// target_compile_features(app PRIVATE cxx_std_17); in the Arduino IDE, a newer
// core of the board.
#pragma once

#if __cplusplus < 201703L
#  error "Inkcell needs C++17: compile your sources with -std=gnu++17"
#endif
