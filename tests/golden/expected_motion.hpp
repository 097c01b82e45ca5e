// The hashes of scenes, as unit_golden_motion prints them.
#pragma once

namespace golden {

inline constexpr const char* kPathHash =
    "68d621669914c93bdcd19f8345ae9d8296a176ffc4d53b51bf30d99e896467ba";
inline constexpr const char* kClockHash =
    "1d7dfd90e786cb57aec6d94dc2f4b9e3a8ac91723f46fb37f6921b223b5b068d";
inline constexpr const char* kParticlesHash =
    "c7c789729318afdf8b5fe9eaee6493f1cd57c7712b45e9bf15c51686347a6bc8";
inline constexpr const char* kFigure13Hash =
    "84dae1a3e2bfab3bd446354530a7e46cc2004aadb67061ed8d6e9d1d2ff27bb7";
inline constexpr const char* kFigure15Hash =
    "0b6a1d83da8e603d6008e9bbcfff4e51e734181d73f39dbfecef4ab2c7e3d2ed";

}  // namespace golden
