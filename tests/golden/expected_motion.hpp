// The hashes of scenes, as golden_motion and golden_simulation print them.
#pragma once

namespace golden {

inline constexpr const char* kPathHash =
    "700f241212c617e84ccb7a93dc2be2f717eee00c17839493297c76536748fd0e";
inline constexpr const char* kClockHash =
    "2b4625732c634b5a0bfe4c3bbf83b84f96dae041bcc086eb7a06ab4b75e75fb8";
inline constexpr const char* kParticlesHash =
    "69f34fbc9da58177efbb3bb018fd036bd7c869f78e67538e4d7dca496cdccccb";
inline constexpr const char* kFigure13Hash =
    "f4bdb4394e30669fd17afa6df8771124dc85e7ad80dde69dba894296e77eea81";
inline constexpr const char* kFigure14Hash =
    "e426b0d74548182176897fa9d1133449aa105b92a0a0026c681302e842b540e2";
inline constexpr const char* kFigure15Hash =
    "7c86ebe19f3219bc694f7b53ba14106b6cc4ce8c25598533cd565f1974d15b3b";
inline constexpr const char* kMeltHash =
    "d8f7bda588de1a65f5e53cc6a60d5c796a0078146ee0194b98a6d7fd792439dd";
inline constexpr const char* kPrintHash =
    "8964cf9b7fab2d531df67ee02515262fdc612748a305b49315758a1b917d1e9b";
inline constexpr const char* kCountHash =
    "fd46ed944924dc1b9cb3db51ef0a9fea5ff7c59197dc01273ce1125708e4eda5";
inline constexpr const char* kTickerHash =
    "9c2e36c758ed17b579dd6583e0e26f03996566a8ff46c4089a945608b20e3bcf";
inline constexpr const char* kTypewriterHash =
    "4cde5008fd3dda76171123246b2bb43e3155c55407bdbcd0207c45d9b2eeaf02";
inline constexpr const char* kWipeHash =
    "bd1a786212124e3242505d1a079e2511971d63b5ecd18d68001a437281277e98";
inline constexpr const char* kBounceHash =
    "3195fcaf0b054760bf0f7670160e169a1f0ce2be75974661bcb9cd269cefede9";
inline constexpr const char* kSplashHash =
    "53d8df6f6f870f56c241b77be1f1b82339a2f2800bab45f6da04764f5f2b6146";

}  // namespace golden
