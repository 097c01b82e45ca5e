// The driver of SD cards, over a model of a card: what a card does, byte by
// byte, and what it may do wrong.
#include "sd_card.hpp"

#include "check.hpp"

namespace {

using namespace inkcell;
using board::SdCard;

enum class Kind : uint8_t { version_1, standard, high_capacity };

enum class Fault : uint8_t {
  none,
  no_card,
  other_condition,  // does not send back what was sent
  no_memory_card,   // knows no ACMD41
  never_ready,
  pulled_out,  // no answer any more
  no_token,    // the block never begins
  error_token,
  changed_bit,
};
constexpr uint32_t kModelBlocks = 40;

uint8_t byte_of_card(uint32_t at) {
  return static_cast<uint8_t>(at * 13 ^ at >> 9);
}

// The remainder of a polynomial division, bit by bit as in the specification.
uint32_t remainder(const uint8_t* bytes,
                   uint32_t count,
                   uint32_t polynomial,
                   uint32_t degree) {
  uint32_t rest = 0;
  for (uint32_t i = 0; i != 8 * count + degree; ++i) {
    const uint32_t bit = i < 8 * count ? bytes[i / 8] >> (7 - i % 8) & 1u : 0u;
    rest = rest << 1 | bit;
    if ((rest >> degree & 1) != 0) {
      rest ^= polynomial;
    }
  }
  return rest;
}

struct Model {
  Kind kind = Kind::high_capacity;
  Fault fault = Fault::none;
  bool is_selected = false;
  bool is_ready = false;
  bool has_started = false;  // CMD0 came
  bool is_next_app = false;  // CMD55 came
  uint32_t clocks = 0;       // while it was not selected
  uint32_t tries = 0;        // of ACMD41
  uint32_t block_length = 0;
  uint8_t command[6] = {};
  uint32_t received = 0;
  uint8_t answer[540] = {};
  uint32_t answer_size = 0;
  uint32_t answered = 0;

  void say(uint8_t byte) { answer[answer_size++] = byte; }
  void say_word(uint32_t word) {
    for (uint32_t i = 0; i != 4; ++i) {
      say(static_cast<uint8_t>(word >> (24 - 8 * i)));
    }
  }

  void execute() {
    const uint32_t number = command[0] & 63u;
    const uint32_t argument = uint32_t{command[1]} << 24 |
                              uint32_t{command[2]} << 16 |
                              uint32_t{command[3]} << 8 | command[4];
    CHECK_EQ(command[5], remainder(command, 5, 0x89, 7) << 1 | 1);
    answer_size = answered = 0;
    if (fault == Fault::pulled_out || clocks < 74) {
      return;
    }
    say(0xff);
    const bool is_app = is_next_app;
    is_next_app = number == 55;
    const uint8_t idle = is_ready ? 0 : 1;
    if (number == 0) {
      has_started = true;
      is_ready = false;
      say(1);
      CHECK_EQ(command[5], 0x95);
    } else if (!has_started) {
      say(4);
    } else if (number == 8 && kind != Kind::version_1) {
      CHECK_EQ(command[5], 0x87);
      say(idle);
      say_word(fault == Fault::other_condition ? 0x1ff : argument);
    } else if (number == 55) {
      say(idle);
    } else if (number == 41 && is_app && fault != Fault::no_memory_card) {
      const bool says_high = (argument & 1u << 30) != 0;
      CHECK_EQ(says_high, kind != Kind::version_1);
      is_ready = ++tries >= 5 && fault != Fault::never_ready;
      say(is_ready ? 0 : 1);
    } else if (number == 58 && is_ready) {
      say(0);
      say_word(kind == Kind::high_capacity ? 0xc0ff8000 : 0x80ff8000);
    } else if (number == 16 && is_ready) {
      block_length = argument;
      say(0);
    } else if (number == 17 && is_ready) {
      say_block(argument);
    } else {
      say(static_cast<uint8_t>(4 | idle));
    }
  }

  void say_block(uint32_t argument) {
    uint32_t block = argument;
    if (kind != Kind::high_capacity) {
      CHECK_EQ(block_length, 512u);
      CHECK_EQ(argument % 512, 0u);
      block = argument / 512;
    }
    if (block >= kModelBlocks) {
      say(0x40);
      return;
    }
    say(0);
    if (fault == Fault::no_token) {
      return;
    }
    for (uint32_t i = 0; i != 7; ++i) {
      say(0xff);
    }
    if (fault == Fault::error_token) {
      say(8);
      return;
    }
    say(0xfe);
    const uint32_t begin = answer_size;
    for (uint32_t i = 0; i != 512; ++i) {
      say(byte_of_card(block * 512 + i));
    }
    const uint32_t crc = remainder(answer + begin, 512, 0x11021, 16);
    say(static_cast<uint8_t>(crc >> 8));
    say(static_cast<uint8_t>(crc));
    if (fault == Fault::changed_bit) {
      answer[begin + block * 7 % 514] ^= 0x20;
    }
  }

  uint8_t exchange(uint8_t sent) {
    if (fault == Fault::no_card || !is_selected) {
      clocks += is_selected ? 0 : 8;
      return 0xff;
    }
    if (received != 0 || (sent & 0xc0) == 0x40) {
      command[received++] = sent;
      if (received == 6) {
        received = 0;
        execute();
      }
      return 0xff;
    }
    CHECK_EQ(sent, 0xff);
    return answered < answer_size ? answer[answered++] : uint8_t{0xff};
  }
};

Model model;

constexpr board::CardBus kBus = {
    [](uint8_t sent) { return model.exchange(sent); },
    [](bool is_selected) {
      model.is_selected = is_selected;
      model.received = 0;
    }};

constexpr Kind kKinds[] = {Kind::version_1, Kind::standard,
                           Kind::high_capacity};

uint8_t bytes[512];

}  // namespace

TEST(cards_of_each_kind_are_read) {
  for (const Kind kind : kKinds) {
    model = Model();
    model.kind = kind;
    SdCard card;
    CHECK_EQ(card.read_block(0, bytes), Status::read_failed);
    CHECK_OK(card.open(kBus));
    CHECK(!model.is_selected);
    for (uint32_t block = 0; block < kModelBlocks; block += 3) {
      CHECK_OK(card.read_block(block, bytes));
      CHECK(!model.is_selected);
      for (uint32_t i = 0; i != 512; ++i) {
        CHECK_EQ(bytes[i], byte_of_card(block * 512 + i));
      }
    }
    // Behind the end, and where bytes cannot be counted any more.
    CHECK_EQ(card.read_block(kModelBlocks, bytes), Status::read_failed);
    CHECK_EQ(card.read_block(1u << 23, bytes), Status::read_failed);
    CHECK_OK(card.read_block(1, bytes));
  }
}

TEST(cards_that_do_not_start_are_refused) {
  const struct {
    Fault fault;
    Status status;
  } cases[] = {{Fault::no_card, Status::read_failed},
               {Fault::pulled_out, Status::read_failed},
               {Fault::never_ready, Status::read_failed},
               {Fault::other_condition, Status::unsupported},
               {Fault::no_memory_card, Status::unsupported}};
  for (const auto& wrong : cases) {
    model = Model();
    model.fault = wrong.fault;
    SdCard card;
    CHECK_EQ(card.open(kBus), wrong.status);
    CHECK(!model.is_selected);
    CHECK_EQ(card.read_block(0, bytes), Status::read_failed);
    // Another card.
    model = Model();
    CHECK_OK(card.open(kBus));
    CHECK_OK(card.read_block(0, bytes));
  }
}

TEST(blocks_that_do_not_arrive_whole_are_refused) {
  constexpr Fault kFaults[] = {Fault::pulled_out, Fault::no_token,
                               Fault::error_token, Fault::changed_bit};
  for (const Fault fault : kFaults) {
    model = Model();
    SdCard card;
    CHECK_OK(card.open(kBus));
    for (uint32_t block = 0; block < 3; ++block) {
      model.fault = fault;
      CHECK_EQ(card.read_block(block, bytes), Status::read_failed);
      CHECK(!model.is_selected);
      model.fault = Fault::none;
      CHECK_OK(card.read_block(block, bytes));
    }
  }
}
