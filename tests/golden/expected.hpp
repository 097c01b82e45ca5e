// The hashes of the test sheet: written by regenerate.py.
#pragma once

namespace golden {

inline constexpr const char* kSheetHash =
    "cd056bebb72ea309b989316b2495358da952d4e2253203b06faf27bba40747cf";
inline constexpr const char* kPageHashes[] = {
    "1d78765fd4a31eb6f060c2eaa78f2132d8d4900c186d9041e34e668aca8d9eb7",
    "b5da73db52c92aebc0d435fa9b331e1eddf1812e9a8d587dd5e0e07fab862d82",
    "55059e82457e0c9e9a77731cccb7ebc2ed2faace3e9b0599ddc9d599202b3905",
    "f20f1e89f8cb7624204987e46d0d8fdd92cfeecc0ae56910bf33434933283a4c",
    "a635da5347054a1a53f210f047abdaf4b8246565f7320d093e4103b5f47c9fd4",
    "87b5ce8007d8b64cb02f4e123b1fd580cf7705bd4e48d7edd270eafaa5703918",
    "8f6458ff909af2390408f94c1ce338f28cfbe45b0b3a0b3bcb4e91ca9ff52d37",
    "a92a3dfcd1828c81966bd9dfb82b43bff43c0b5c69b6d58cb15b3912270485ba",
    "aa939ad5f50fcab4cd07da660f0ca34cc8f8d1dd658f81acee5a36fd3fc9d795",
    "420c2f91c9c8baecea04b4b2b9ecb5177df42e9e3127d6758dca9309907276b1",
    "e2db1c9f1b0e0b27370efe96d781f15c6bd45f3de60ee619acc495f3098f0ebe",
    "d00533a62dc3729ccfef97e13e5b7b034cc5e0e60abb97351952f52feff09b4f",
    "52b49bf747b75baf04089bc795b029843080cf0ceee83d24a12458a68d61c276",
    "9c959503dbd57a7551b13efa9f374bd8faddd2881992a2c07c964c6cb680a49e",
};

}  // namespace golden
