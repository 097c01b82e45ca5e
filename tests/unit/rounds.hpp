// Rounds of a random test: each has numbers of its own, so that a round that
// fails runs alone.
//
//   for (Random& random : Rounds(101, 20000)) {
//     CHECK(...);
//   }
//
// A failure names its round and how to run it again:
//
//   INKCELL_ROUND=steps_undo_the_matrix/17 unit_tests affine
//
// runs this test and this round only. What a test adds up over its rounds may
// then be too little. Boards have no environment; they name the round, too.
#pragma once

#include <stdint.h>

#include "check.hpp"
#include "random.hpp"

class Rounds {
 public:
  /// `seed` tells tests apart; 0 <= count.
  Rounds(uint32_t seed, int32_t count)
      : number(-1), random_(1), seed_(seed), count_(count) {}
  ~Rounds() { check::end_rounds(); }
  Rounds(const Rounds&) = delete;
  Rounds& operator=(const Rounds&) = delete;

  class Iterator {
   public:
    explicit Iterator(Rounds& rounds) : rounds_(rounds) {}
    Random& operator*() const { return rounds_.random_; }
    bool operator!=(const Iterator&) const { return !rounds_.has_ended_; }
    void operator++() { rounds_.has_ended_ = !rounds_.next(); }

   private:
    Rounds& rounds_;
  };
  /// Once.
  Iterator begin() {
    has_ended_ = !next();
    return end();
  }
  Iterator end() { return Iterator(*this); }

  int32_t number;  // of this round, from 0 on

 private:
  // Begins the next round. False behind the last one, and after one that has
  // failed.
  bool next() {
    do {
      ++number;
    } while (number < count_ && !check::begin_round(number));
    if (number >= count_ || check::failed()) {
      check::end_rounds();
      return false;
    }
    random_ = Random(seed_of(seed_, static_cast<uint32_t>(number)));
    return true;
  }

  // Neighbours differ in all bits (the finaliser of MurmurHash3); never 0.
  static uint32_t seed_of(uint32_t seed, uint32_t number) {
    uint32_t mixed = seed * 0x9e3779b9u + number;
    mixed = (mixed ^ mixed >> 16) * 0x85ebca6bu;
    mixed = (mixed ^ mixed >> 13) * 0xc2b2ae35u;
    mixed ^= mixed >> 16;
    return mixed != 0 ? mixed : 1;
  }

  Random random_;  // of this round
  bool has_ended_ = false;
  uint32_t seed_;
  int32_t count_;
};
