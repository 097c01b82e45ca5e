// The hashes of the test sheet: written by regenerate.py.
#pragma once

namespace golden {

inline constexpr const char* kSheetHash =
    "fb7581ffc166d0e81c879ab0a7054fa45b4592134f2ccdee54dc5cbe9d457edd";
inline constexpr const char* kPageHashes[] = {
    "c6f6d8fcf19b447fb271cda14b774035b2014d31081d7bbcde408815c7c25724",
    "7422d887ebad2b8514ff9732c428c344f3414e44856a6374ac49c254e2e6f61e",
    "b22313c609387ed81fc8d4204cc751ebb703fee5bd753e05952bde4b8a16b1a5",
    "2fcfebc2fbb73f21dfefbeeecb251ab2990114b5033058f904f21353e942de5e",
    "2253c7ad4c28d9741829008d5d109480e6848733ff33083a855e66216ecb1738",
    "6db2c16991565f8e1beda9f14fad253a2dc0a88c45f67c588ed2feb15ce0a0ca",
    "ebce087d1ee45913b3cefb89c61ca39baf2fdf89c8dde5960b0d05abf07ca805",
    "bebb014203f4ed9a63ba82df076920d96ceb7d69267f1483d6a909694d7c712b",
    "8c326fb4ac719a2ed195fd1ee1482b47cae8f97fd2de509e65732654bcd64c01",
    "b5a94a335b96b8779a1d2ee2677512694eb8c76614d7554c8e5a4515c7edeafe",
    "867a5673fd14908209409c163b8da5056eda4db27f2f0f94b3278a1c1d22cc8d",
    "f9365bf16bf4625cf834ebedd3bcb1f510fe117f4d40b555f522cdbcd3ec6ce2",
    "d8c3bc85991e42d6adc2565cda376e59ad0ad33058ea02211c9fd18b2865bfe2",
    "ac2bdec3dc1b752ce50b9914340db0480099ec777fed4ebe3d4be7d6997d4c5f",
};

}  // namespace golden
