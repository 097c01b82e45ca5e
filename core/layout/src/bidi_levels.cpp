// Over 400 lines: the rules of one algorithm, which share a paragraph's cells.
#include "bidi_levels.hpp"

namespace inkcell::detail {
namespace {

using Class = BidiClass;

constexpr uint8_t kMaxLevel = 125;

constexpr Class direction_of(uint32_t level) noexcept {
  return level % 2 != 0 ? Class::r : Class::l;
}

// What a class up to `an` is to neutrals.
constexpr Class side_of(Class c) noexcept {
  return c == Class::l ? Class::l : Class::r;
}

constexpr bool opens_isolate(Class c) noexcept {
  return c == Class::lri || c == Class::rli || c == Class::fsi;
}

// White space and controls that rule L1 takes back to the paragraph's level.
constexpr bool is_blank(Class c) noexcept {
  return c == Class::ws || c == Class::bn || c >= Class::lre;
}

}  // namespace

// The directional status stack of rules X1 to X8. Levels on it only rise, so
// that there is an entry for each level.
class BidiLevels::Stack {
 public:
  explicit Stack(uint8_t level) noexcept : level_(level) {
    __builtin_memset(entries_, 0, sizeof entries_);
    entries_[level] = kPresent;
    bottom_ = level;
  }

  uint8_t level() const noexcept { return level_; }
  // The class that an override gives, or the one that is given.
  Class overridden(Class own) const noexcept {
    const uint32_t entry = entries_[level_];
    return (entry & kLeft) != 0    ? Class::l
           : (entry & kRight) != 0 ? Class::r
                                   : own;
  }

  void push_embedding(bool is_right, Class override_with) noexcept {
    if (push(is_right, override_with == Class::l   ? kLeft
                       : override_with == Class::r ? kRight
                                                   : 0)) {
      return;
    }
    if (overflow_isolates_ == 0) {
      ++overflow_embeddings_;
    }
  }
  void push_isolate(bool is_right) noexcept {
    if (push(is_right, kIsolate)) {
      ++isolates_;
    } else {
      ++overflow_isolates_;
    }
  }
  void pop_embedding() noexcept {
    if (overflow_isolates_ != 0) {
      return;
    }
    if (overflow_embeddings_ != 0) {
      --overflow_embeddings_;
    } else if ((entries_[level_] & kIsolate) == 0 && level_ != bottom_) {
      pop();
    }
  }
  void pop_isolate() noexcept {
    if (overflow_isolates_ != 0) {
      --overflow_isolates_;
    } else if (isolates_ != 0) {
      overflow_embeddings_ = 0;
      while ((entries_[level_] & kIsolate) == 0) {
        pop();
      }
      pop();
      --isolates_;
    }
  }

 private:
  enum Entry : uint8_t { kPresent = 1, kIsolate = 2, kLeft = 4, kRight = 8 };

  bool push(bool is_right, uint32_t flags) noexcept {
    const uint32_t level =
        (level_ + 2u - (is_right ? 1 : 0)) / 2 * 2 + (is_right ? 1 : 0);
    if (level > kMaxLevel || overflow_isolates_ != 0 ||
        overflow_embeddings_ != 0) {
      return false;
    }
    level_ = static_cast<uint8_t>(level);
    entries_[level_] = static_cast<uint8_t>(flags | kPresent);
    return true;
  }
  void pop() noexcept {
    entries_[level_] = 0;
    do {
      --level_;
    } while (entries_[level_] == 0);
  }

  uint8_t level_;
  uint8_t bottom_;
  uint32_t isolates_ = 0;
  uint32_t overflow_isolates_ = 0;
  uint32_t overflow_embeddings_ = 0;
  uint8_t entries_[kMaxLevel + 1];
};

void BidiLevels::set(uint32_t at, Class value) noexcept {
  cells_[at] = static_cast<uint16_t>((cells_[at] & ~BidiCell::kClassMask) |
                                     static_cast<uint32_t>(value));
}

void BidiLevels::set_level(uint32_t at, uint32_t value) noexcept {
  cells_[at] = static_cast<uint16_t>((cells_[at] & ~BidiCell::kLevelMask) |
                                     value << BidiCell::kClassBits);
}

uint32_t BidiLevels::code_point(uint32_t at) const noexcept {
  Text rest(text_ + at, count_ - at);
  return next_code_point(rest);
}

// Before all rules.
Class BidiLevels::first_class(uint32_t at) const noexcept {
  return bidi_class(code_point(at));
}

uint32_t BidiLevels::next(uint32_t at) const noexcept {
  do {
    ++at;
  } while (at < count_ && has(at, BidiCell::kFollows));
  return at;
}

// Rule X9 removes some characters, by their class.
uint32_t BidiLevels::next_kept(uint32_t at) const noexcept {
  do {
    at = next(at);
  } while (at < count_ && is_removed(at));
  return at;
}

uint32_t BidiLevels::previous_kept(uint32_t at) const noexcept {
  while (at != 0) {
    --at;
    if (!has(at, BidiCell::kFollows) && !is_removed(at)) {
      return at;
    }
  }
  return count_;
}

// The partner of what opens an isolate (BD9).
uint32_t BidiLevels::end_of_isolate(uint32_t at) const noexcept {
  uint32_t depth = 0;
  // Other bytes than the first of a character have neither flag.
  while (++at < count_) {
    if (has(at, BidiCell::kOpensIsolate)) {
      ++depth;
    } else if (has(at, BidiCell::kClosesIsolate)) {
      if (depth == 0) {
        break;
      }
      --depth;
    }
  }
  return at;
}

bool BidiLevels::has_start_of_isolate(uint32_t at) const noexcept {
  uint32_t depth = 0;
  while (at != 0) {
    --at;
    if (has(at, BidiCell::kFollows)) {
      continue;
    }
    if (has(at, BidiCell::kClosesIsolate)) {
      ++depth;
    } else if (has(at, BidiCell::kOpensIsolate)) {
      if (depth == 0) {
        return true;
      }
      --depth;
    }
  }
  return false;
}

uint32_t BidiLevels::next_in_sequence(uint32_t at) const noexcept {
  const uint32_t following = next_kept(at);
  if (following < count_ && level(following) == level(at)) {
    return following;
  }
  return has(at, BidiCell::kOpensIsolate) ? end_of_isolate(at) : count_;
}

// The first l, r or al outside isolates, to the end of the paragraph or of the
// isolate; on if there is none.
Class BidiLevels::first_strong(uint32_t at, bool is_isolate) const noexcept {
  uint32_t depth = 0;
  for (; at < count_; at = next(at)) {
    if (has(at, BidiCell::kOpensIsolate)) {
      ++depth;
    } else if (has(at, BidiCell::kClosesIsolate)) {
      if (depth == 0 && is_isolate) {
        break;
      }
      depth -= depth != 0 ? 1 : 0;
    } else if (depth == 0 && get(at) <= Class::al) {
      return get(at);
    }
  }
  return Class::on;
}

uint32_t BidiLevels::read() noexcept {
  Text rest(text_, count_);
  uint32_t at = 0;
  bool is_end = false;
  while (rest.size != 0 && !is_end) {
    const Class c = bidi_class(next_code_point(rest));
    const auto end = static_cast<uint32_t>(count_ - rest.size);
    const uint32_t flags = opens_isolate(c)  ? BidiCell::kOpensIsolate
                           : c == Class::pdi ? BidiCell::kClosesIsolate
                                             : 0;
    cells_[at] = static_cast<uint16_t>(static_cast<uint32_t>(c) | flags);
    while (++at != end) {
      cells_[at] = BidiCell::kFollows;
    }
    is_end = c == Class::b;
  }
  count_ = at;
  return at;
}

uint8_t BidiLevels::base_level() const noexcept {
  const Class c = first_strong(0, false);
  return c == Class::r || c == Class::al ? 1 : 0;
}

void BidiLevels::put(uint32_t at, const Stack& stack) noexcept {
  set_level(at, stack.level());
  set(at, stack.overridden(get(at)));
}

// Rules X1 to X9.
void BidiLevels::set_explicit() noexcept {
  Stack stack(base_level_);
  for (uint32_t at = 0; at < count_; at = next(at)) {
    const Class c = get(at);
    switch (c) {
      case Class::lre:
      case Class::rle:
      case Class::lro:
      case Class::rlo:
        stack.push_embedding(c == Class::rle || c == Class::rlo,
                             c == Class::lro   ? Class::l
                             : c == Class::rlo ? Class::r
                                               : Class::on);
        set(at, Class::bn);
        break;
      case Class::pdf:
        stack.pop_embedding();
        set(at, Class::bn);
        break;
      case Class::lri:
      case Class::rli:
      case Class::fsi: {
        set(at, Class::on);
        put(at, stack);
        const Class first =
            c == Class::fsi ? first_strong(next(at), true) : Class::on;
        stack.push_isolate(c == Class::rli || first == Class::r ||
                           first == Class::al);
        break;
      }
      case Class::pdi:
        stack.pop_isolate();
        set(at, Class::on);
        put(at, stack);
        break;
      case Class::b:
        set_level(at, base_level_);
        break;
      case Class::bn:
        break;
      default:
        put(at, stack);
    }
  }
}

// Rule X10.
BidiLevels::Sequence BidiLevels::sequence_from(uint32_t first) const noexcept {
  const uint8_t own = level(first);
  const uint32_t before = previous_kept(first);
  uint32_t last = first;
  for (uint32_t at = first; at < count_; at = next_in_sequence(at)) {
    last = at;
  }
  const uint32_t after =
      has(last, BidiCell::kOpensIsolate) ? count_ : next_kept(last);
  const uint8_t level_before = before < count_ ? level(before) : base_level_;
  const uint8_t level_after = after < count_ ? level(after) : base_level_;
  return {first, own, direction_of(own > level_before ? own : level_before),
          direction_of(own > level_after ? own : level_after)};
}

// Rules W1 to W4.
void BidiLevels::resolve_weak(const Sequence& sequence) noexcept {
  Class strong = sequence.before;
  Class previous = sequence.before;
  for (uint32_t at = sequence.first; at < count_; at = next_in_sequence(at)) {
    Class c = get(at);
    if (c == Class::nsm) {
      c = previous;  // W1
    }
    if (c <= Class::al) {
      strong = c;
    }
    if (c == Class::en && strong == Class::al) {
      c = Class::an;  // W2
    }
    if (c == Class::es || c == Class::cs) {
      const uint32_t following = next_in_sequence(at);
      Class number = following < count_ ? get(following) : Class::on;
      if (number == Class::en && strong == Class::al) {
        number = Class::an;
      }
      if (number == previous &&
          (number == Class::en || (number == Class::an && c == Class::cs))) {
        c = number;  // W4
      }
    }
    set(at, c == Class::al ? Class::r : c);  // W3
    previous = c;
  }
}

// Rules W5 to W7.
void BidiLevels::resolve_separators(const Sequence& sequence) noexcept {
  Class strong = sequence.before;
  Class previous = Class::on;
  Class of_terminators = Class::on;
  for (uint32_t at = sequence.first; at < count_; at = next_in_sequence(at)) {
    const Class c = get(at);
    Class result = c;
    if (c == Class::et) {
      if (previous == Class::en) {
        of_terminators = Class::en;
      } else if (previous != Class::et) {
        uint32_t end = at;
        while (end < count_ && get(end) == Class::et) {
          end = next_in_sequence(end);
        }
        of_terminators =
            end < count_ && get(end) == Class::en ? Class::en : Class::on;
      }
      result = of_terminators;
    } else if (c == Class::es || c == Class::cs) {
      result = Class::on;
    } else if (c == Class::l || c == Class::r) {
      strong = c;
    }
    // Terminators that became numbers are as good as these.
    previous = c == Class::et && result == Class::en ? Class::en : c;
    if (result == Class::en && strong == Class::l) {
      result = Class::l;
    }
    set(at, result);
  }
}

// Rules BD16: brackets whose partner is in the sequence.
void BidiLevels::pair_brackets(const Sequence& sequence) noexcept {
  // The two that are canonically equivalent to others.
  const auto normal = [](uint32_t code) noexcept {
    return code == 0x2329 || code == 0x232a ? code - 0x2329 + 0x3008 : code;
  };
  constexpr uint32_t kMost = 63;
  uint16_t open[kMost];
  uint32_t depth = 0;
  for (uint32_t at = sequence.first; at < count_; at = next_in_sequence(at)) {
    if (get(at) != Class::on) {
      continue;
    }
    const Mirror mirror = mirror_of(code_point(at));
    if (mirror.kind == Mirror::opens) {
      if (depth == kMost) {
        break;
      }
      open[depth++] = static_cast<uint16_t>(at);
    } else if (mirror.kind == Mirror::closes) {
      uint32_t i = depth;
      while (i != 0 &&
             normal(code_point(open[i - 1])) != normal(mirror.image)) {
        --i;
      }
      if (i != 0) {
        depth = i - 1;
        cells_[open[depth]] |= BidiCell::kPaired;
        cells_[at] |= BidiCell::kPaired;
      }
    }
  }
}

// With the marks that follow it.
void BidiLevels::set_bracket(uint32_t at, Class value) noexcept {
  set(at, value);
  for (at = next_in_sequence(at); at < count_ && first_class(at) == Class::nsm;
       at = next_in_sequence(at)) {
    set(at, value);
  }
}

// Rule N0 for a pair; `before` is the last direction before it.
void BidiLevels::resolve_pair(uint32_t opening,
                              const Sequence& sequence,
                              Class before) noexcept {
  const Class own = direction_of(sequence.level);
  bool has_own = false;
  bool has_other = false;
  uint32_t depth = 0;
  uint32_t at = next_in_sequence(opening);
  for (; at < count_; at = next_in_sequence(at)) {
    if (has(at, BidiCell::kPaired)) {
      const bool opens = mirror_of(code_point(at)).kind == Mirror::opens;
      if (!opens && depth == 0) {
        break;
      }
      depth = opens ? depth + 1 : depth - 1;
    }
    const Class c = get(at);
    if (c <= Class::an) {
      has_own |= side_of(c) == own;
      has_other |= side_of(c) != own;
    }
  }
  if (at < count_ && (has_own || has_other)) {
    const Class result = has_own || before == own ? own : before;
    set_bracket(opening, result);
    set_bracket(at, result);
  }
}

void BidiLevels::resolve_brackets(const Sequence& sequence) noexcept {
  Class before = sequence.before;
  for (uint32_t at = sequence.first; at < count_; at = next_in_sequence(at)) {
    if (get(at) == Class::on && has(at, BidiCell::kPaired) &&
        mirror_of(code_point(at)).kind == Mirror::opens) {
      resolve_pair(at, sequence, before);
    }
    const Class c = get(at);
    if (c <= Class::an) {
      before = side_of(c);
    }
  }
}

// Rules N1 and N2.
void BidiLevels::resolve_neutrals(const Sequence& sequence) noexcept {
  Class before = sequence.before;
  Class of_neutrals = Class::on;
  bool is_neutral = false;
  for (uint32_t at = sequence.first; at < count_; at = next_in_sequence(at)) {
    const Class c = get(at);
    if (c <= Class::an) {
      before = side_of(c);
      is_neutral = false;
      continue;
    }
    if (!is_neutral) {
      uint32_t end = at;
      while (end < count_ && get(end) > Class::an) {
        end = next_in_sequence(end);
      }
      const Class after = end == count_ ? sequence.after : side_of(get(end));
      of_neutrals = before == after ? before : direction_of(sequence.level);
      is_neutral = true;
    }
    set(at, of_neutrals);
  }
}

void BidiLevels::resolve_sequences() noexcept {
  for (uint32_t at = 0; at < count_; at = next(at)) {
    if (is_removed(at)) {
      continue;
    }
    const uint32_t before = previous_kept(at);
    const bool begins_run = before == count_ || level(before) != level(at);
    if (!begins_run ||
        (has(at, BidiCell::kClosesIsolate) && has_start_of_isolate(at))) {
      continue;
    }
    const Sequence sequence = sequence_from(at);
    resolve_weak(sequence);
    resolve_separators(sequence);
    pair_brackets(sequence);
    resolve_brackets(sequence);
    resolve_neutrals(sequence);
  }
}

// Rules I1 and I2. Removed characters go with what stands before them.
void BidiLevels::set_implicit() noexcept {
  uint32_t previous = base_level_;
  for (uint32_t at = 0; at < count_; at = next(at)) {
    const Class c = get(at);
    if (c != Class::bn) {
      previous = level(at);
      if (previous % 2 != 0) {
        previous += c == Class::r ? 0 : 1;
      } else {
        previous += c == Class::l ? 0 : c == Class::r ? 1 : 2;
      }
    }
    set_level(at, previous);
  }
}

// Rule L1.
void BidiLevels::reset_spaces() noexcept {
  bool is_reset = true;
  for (uint32_t at = count_; at != 0;) {
    --at;
    if (has(at, BidiCell::kFollows)) {
      continue;
    }
    const Class c = first_class(at);
    is_reset = c == Class::b || c == Class::s || (is_reset && is_blank(c));
    if (is_reset) {
      set_level(at, base_level_);
    }
  }
}

void BidiLevels::resolve(uint8_t base_level) noexcept {
  base_level_ = base_level;
  set_explicit();
  resolve_sequences();
  set_implicit();
  reset_spaces();
}

}  // namespace inkcell::detail
