// The hashes of scenes, as `unit_tests golden_motion` prints them.
#pragma once

namespace golden {

inline constexpr const char* kPathHash =
    "47791fd540e8c51828f7e6ddb3b1fe1db778ce08faede0b30cb6485785101da5";
inline constexpr const char* kClockHash =
    "c87df48638149623a3a48648e53e3bcc2e32297ff1a25ff74cdf174ea5e74470";
inline constexpr const char* kParticlesHash =
    "81632e7bcd602c9d2dd111c49727bac91632716a7720ce5ad236f5a75ef67732";
inline constexpr const char* kFigure13Hash =
    "13c3e9f7d969d0f568c38e6197a432d0aed7467b237246c43e84077d96225405";
inline constexpr const char* kFigure14Hash =
    "26d3c49228ca7964d8ce462c951cc0af0e9a114c320e50f82ac2ee4240300fe9";
inline constexpr const char* kFigure15Hash =
    "f2dff531685a27d673efc0e61ebf2db49c89ef5a94d68bebcf7a27524846b739";
inline constexpr const char* kPrintHash =
    "95ded1a7360002f8ce0eff9af268199279e2dc42071e59550a2354192ab26bde";

}  // namespace golden
