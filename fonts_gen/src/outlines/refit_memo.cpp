#include "outlines/refit_memo.hpp"

#include <cstring>

namespace inkcell::gen {
namespace {

// The finalizer of SplitMix64 (Steele, Lea and Flood 2014): each bit of the
// word changes half of the result's.
uint64_t mix(uint64_t word) {
  word = (word ^ word >> 30) * 0xbf58476d1ce4e5b9;
  word = (word ^ word >> 27) * 0x94d049bb133111eb;
  return word ^ word >> 31;
}

}  // namespace

void Fingerprint::add(uint64_t word) {
  a_ = mix(a_ + 0x9e3779b97f4a7c15 + word);
  b_ = mix(b_ + 0xd1b54a32d192ed03 + (word ^ a_));
}

void Fingerprint::add(double number) {
  uint64_t word = 0;
  static_assert(sizeof word == sizeof number);
  std::memcpy(&word, &number, sizeof word);
  add(word);
}

void Fingerprint::add(const Point& point) {
  add(point.x);
  add(point.y);
}

void Fingerprint::add(const Fingerprint& other) {
  add(other.a_);
  add(other.b_);
}

}  // namespace inkcell::gen
