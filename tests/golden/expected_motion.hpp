// The hashes of scenes, as `unit_tests golden_motion` prints them.
#pragma once

namespace golden {

inline constexpr const char* kPathHash =
    "68d621669914c93bdcd19f8345ae9d8296a176ffc4d53b51bf30d99e896467ba";
inline constexpr const char* kClockHash =
    "1d7dfd90e786cb57aec6d94dc2f4b9e3a8ac91723f46fb37f6921b223b5b068d";
inline constexpr const char* kParticlesHash =
    "a574f3b0698d64aaf12f672165ccf1599edac14ab7a2ecf1ad2576c4f5fa6d17";
inline constexpr const char* kFigure13Hash =
    "43ac71af53c7543ea27d46933853ccc575d939927e517c01bdf6edba57c53aed";
inline constexpr const char* kFigure14Hash =
    "21c5eb55fa5cbfd1cf13bfd25ce8905158269d4aad80873bbe9f0c9ef0eac61f";
inline constexpr const char* kFigure15Hash =
    "91f3ef443db1307d60fefbf5bde818bf28f52b1ceae9f0fe93f3781e90b16f4c";
inline constexpr const char* kPrintHash =
    "463b8f81f909adead4a4a390cb996758e6cf339c834bcd58e00faf166b0162c4";

}  // namespace golden
