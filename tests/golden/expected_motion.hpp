// The hashes of scenes, as golden_motion and golden_simulation print them.
#pragma once

namespace golden {

inline constexpr const char* kPathHash =
    "e2a52bd714740004fe7a77af1e14bfec9406ba67d40590ddff4d887ad436a3ca";
inline constexpr const char* kClockHash =
    "2b4625732c634b5a0bfe4c3bbf83b84f96dae041bcc086eb7a06ab4b75e75fb8";
inline constexpr const char* kParticlesHash =
    "3b2cc5d0edd5661f193e73d95c49b720dd2bfa4c4a9062122ad13f1a1f42bfbb";
inline constexpr const char* kFigure13Hash =
    "1f85ed7f62c56ee8348381d0d2f8aa4fffcddbe60cc23761684fcf5528d9ef4c";
inline constexpr const char* kFigure14Hash =
    "e426b0d74548182176897fa9d1133449aa105b92a0a0026c681302e842b540e2";
inline constexpr const char* kFigure15Hash =
    "9d97eb7f2e49e0b1d504ccb96ca064ef321adbe68f743b1d0d2e0ebcd3a7b8dd";
inline constexpr const char* kMeltHash =
    "ec5689c53aac77f15169c5af9f6c5b4efe5d3ec336f4fbeb648da64ed6a03cf7";
inline constexpr const char* kPrintHash =
    "24af9f13e9a115bfbeb84084efbfe2374020926c2b57ddea830fe1ad3ecba182";
inline constexpr const char* kCountHash =
    "2827741345884f95684b255e8e49fb610a8ec8d540fef0ee81c87cfa0364d90a";
inline constexpr const char* kTickerHash =
    "d80947ae405686e400062a1ec07f8a91eec4e81362b1ac40afa83d7cff7d5665";
inline constexpr const char* kTypewriterHash =
    "4cde5008fd3dda76171123246b2bb43e3155c55407bdbcd0207c45d9b2eeaf02";
inline constexpr const char* kWipeHash =
    "bd1a786212124e3242505d1a079e2511971d63b5ecd18d68001a437281277e98";
inline constexpr const char* kBounceHash =
    "3195fcaf0b054760bf0f7670160e169a1f0ce2be75974661bcb9cd269cefede9";
inline constexpr const char* kSplashHash =
    "cae51b9889c41aee6878419eef4896280c93b73430927a2239b556d1a5deafd0";

}  // namespace golden
