#include "changing_bytes.hpp"

#include <signal.h>
#include <string.h>
#include <sys/mman.h>
#include <ucontext.h>
#include <unistd.h>

#include "exercise.hpp"
#include "random.hpp"

namespace hostile {
namespace {

constexpr greg_t kTrapFlag = 0x100;
constexpr size_t kWord = 8;  // bytes that change at a load

uint8_t* inner = nullptr;
size_t inner_bytes = 0;
uint32_t one_change_in = 1;
Random random_bytes(1);
int64_t loads = 0;
int64_t changes = 0;

uint8_t kept[kWord];
size_t kept_at = 0;
bool has_kept = false;

void protect(int protection) {
  if (mprotect(inner, inner_bytes, protection) != 0) {
    _exit(3);
  }
}

// At a load of the copy: lets one instruction run on changed bytes.
void on_load(int, siginfo_t* info, void* context) {
  auto* const at = static_cast<uint8_t*>(info->si_addr);
  if (at < inner || at >= inner + inner_bytes) {
    signal(SIGSEGV, SIG_DFL);  // ends the program at the faulty access
    return;
  }
  ++loads;
  protect(PROT_READ | PROT_WRITE);
  has_kept = random_bytes.below(one_change_in) == 0;
  if (has_kept) {
    ++changes;
    kept_at = static_cast<size_t>(at - inner) / kWord * kWord;
    memcpy(kept, inner + kept_at, kWord);
    const uint32_t kind = random_bytes.below(3);
    for (size_t i = 0; i < kWord; ++i) {
      const auto noise = static_cast<uint8_t>(random_bytes.byte());
      inner[kept_at + i] = kind == 0   ? noise
                           : kind == 1 ? uint8_t{0xff}
                                       : uint8_t(kept[i] ^ (1u << noise % 8));
    }
  }
  static_cast<ucontext_t*>(context)->uc_mcontext.gregs[REG_EFL] |= kTrapFlag;
}

// After that instruction.
void on_step(int, siginfo_t*, void* context) {
  if (has_kept) {
    memcpy(inner + kept_at, kept, kWord);
    has_kept = false;
  }
  protect(PROT_NONE);
  static_cast<ucontext_t*>(context)->uc_mcontext.gregs[REG_EFL] &= ~kTrapFlag;
}

void handle(int number, void (*function)(int, siginfo_t*, void*)) {
  struct sigaction action = {};
  action.sa_sigaction = function;
  action.sa_flags = SA_SIGINFO | SA_NODEFER;
  require(sigaction(number, &action, nullptr) == 0, "signals are handled");
}

}  // namespace

ChangingBytes::ChangingBytes(inkcell::Span<const uint8_t> content,
                             bool is_at_end)
    : page_(static_cast<size_t>(sysconf(_SC_PAGESIZE))) {
  inner_size_ = (content.size + page_ - 1) / page_ * page_;
  void* const mapped =
      mmap(nullptr, inner_size_ + 2 * page_, PROT_READ | PROT_WRITE,
           MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  require(mapped != MAP_FAILED, "memory for a font");
  pages_ = static_cast<uint8_t*>(mapped);
  uint8_t* const first =
      pages_ + page_ + (is_at_end ? inner_size_ - content.size : 0);
  memcpy(first, content.data, content.size);
  bytes_ = {first, content.size};
  require(mprotect(pages_, page_, PROT_NONE) == 0 &&
              mprotect(pages_ + page_ + inner_size_, page_, PROT_NONE) == 0,
          "pages that nobody may touch");
}

ChangingBytes::~ChangingBytes() {
  munmap(pages_, inner_size_ + 2 * page_);
}

void ChangingBytes::start(uint32_t seed, uint32_t one_in) {
  inner = pages_ + page_;
  inner_bytes = inner_size_;
  one_change_in = one_in;
  random_bytes = Random(seed * 0x9e3779b9u);  // small seeds begin small
  handle(SIGSEGV, on_load);
  handle(SIGTRAP, on_step);
  protect(PROT_NONE);
}

void ChangingBytes::stop() {
  protect(PROT_READ | PROT_WRITE);
  signal(SIGSEGV, SIG_DFL);
  signal(SIGTRAP, SIG_DFL);
}

int64_t ChangingBytes::load_count() {
  return loads;
}
int64_t ChangingBytes::change_count() {
  return changes;
}

}  // namespace hostile
