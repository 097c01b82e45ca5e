// The hashes of scenes, as golden_motion and golden_simulation print them.
#pragma once

namespace golden {

inline constexpr const char* kPathHash =
    "e01d611536fdba7aa6150de279ed84f6ee273d3199d75731da445ca94bce6cc8";
inline constexpr const char* kClockHash =
    "1426408ac757a8f00895b89e85ed9cac3d043afcaa0a5a55a612e2dc5bbed323";
inline constexpr const char* kParticlesHash =
    "350b617bfba670f860ffbfec7bfd54614549f9b047649486ff11e1b2889f075f";
inline constexpr const char* kFigure13Hash =
    "5b26aa18d9a6c8a0e10fe9884b13a3495dbe9d43a905318fab37f6835f0630ad";
inline constexpr const char* kFigure14Hash =
    "aab8cfd9f59e222a955164150f9a5540ca27f7186e15ebff5b5568ccbae01dc0";
inline constexpr const char* kFigure15Hash =
    "26b9bab739d0d01fa4c43a92ee8561bf31b5fb698a443aedc585ac587a809e86";
inline constexpr const char* kMeltHash =
    "dc4c71d4ba33393e136d470decf0737ada9ad6f4628704da13c9999608d42a4b";
inline constexpr const char* kPrintHash =
    "24af9f13e9a115bfbeb84084efbfe2374020926c2b57ddea830fe1ad3ecba182";
inline constexpr const char* kCountHash =
    "ca0f00e70773326db7f67bfaab3070eabf79bad18a8dfbd247d0ce967802bb3b";
inline constexpr const char* kTickerHash =
    "7df0d8825b834b6faf46cefdb9af60d5a2ae3fcd20877b4ad20522cb5a98d281";
inline constexpr const char* kTypewriterHash =
    "4cde5008fd3dda76171123246b2bb43e3155c55407bdbcd0207c45d9b2eeaf02";
inline constexpr const char* kWipeHash =
    "c67a759fd9dbf72ac18a2f968dd436f225224b42a674bd8d96581199d6897496";
inline constexpr const char* kBounceHash =
    "9aec80e82eb71af7e6286db2e8cdad3942383a6ab0d9e1dc42d27fff6bb7af1d";
inline constexpr const char* kSplashHash =
    "43e34e982ba13a598c0a2906b82b99b4ccef990bed6f7a12ebe995b13c5ea7f7";

}  // namespace golden
