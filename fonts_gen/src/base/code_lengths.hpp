// The lengths of code words, and the entropy of what they code.
#pragma once

#include <cstdint>
#include <vector>

namespace inkcell::gen {

/// The lengths of a prefix code with the fewest bits and words of at most
/// `most` bits (package-merge). A count of 0 counts as 1. A single symbol gets
/// a word of one bit; two or more make the code complete.
///
/// `counts` has at most 2^most entries.
std::vector<int> limited_lengths(const std::vector<uint64_t>& counts, int most);

/// n log2(n) [Q8], in integers so that all machines agree.
uint64_t n_log_n_q8(uint64_t n);

}  // namespace inkcell::gen
