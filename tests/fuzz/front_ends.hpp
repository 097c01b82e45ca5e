// The front ends of a fuzz target, which includes this file once:
//
//   libFuzzer     clang++ -fsanitize=fuzzer -DINKCELL_LIBFUZZER=1 (run.sh)
//   files         fuzz_font FILE...: what CTest runs over the corpus
//   stdin         fuzz_font < FILE: for other fuzzers, and to look at a crash
#pragma once

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <vector>

/// The target: any bytes.
void run(const uint8_t* data, size_t size);

#if INKCELL_LIBFUZZER

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  run(data, size);
  return 0;
}

#else

inline std::vector<uint8_t> read_all(FILE* file) {
  std::vector<uint8_t> bytes;
  for (int c = getc(file); c != EOF; c = getc(file)) {
    bytes.push_back(static_cast<uint8_t>(c));
  }
  return bytes;
}

int main(int argc, char** argv) {
  if (argc == 1) {
    const std::vector<uint8_t> input = read_all(stdin);
    run(input.data(), input.size());
    return 0;
  }
  for (int i = 1; i < argc; ++i) {
    FILE* file = fopen(argv[i], "rb");
    if (file == nullptr) {
      fprintf(stderr, "%s: cannot open %s\n", argv[0], argv[i]);
      return 2;
    }
    const std::vector<uint8_t> input = read_all(file);
    fclose(file);
    run(input.data(), input.size());
  }
  printf("%d inputs passed\n", argc - 1);
  return 0;
}

#endif
