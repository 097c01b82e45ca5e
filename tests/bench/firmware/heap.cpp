// First fit in one block of memory: a few instructions a call, so that what is
// counted is the engine and not its allocator.
#include "heap.h"

#include <stdint.h>

namespace {

constexpr size_t kBytes = 256 << 10;

// Before each piece. Pieces follow one another without gaps.
struct Piece {
  size_t size;   // without this header, a multiple of 8
  size_t asked;  // 0: free
};

alignas(8) uint8_t memory[kBytes];
size_t in_use = 0;
size_t most = 0;

Piece* piece_at(size_t offset) {
  return reinterpret_cast<Piece*>(memory + offset);
}

Piece* piece_of(void* data) {
  return reinterpret_cast<Piece*>(data) - 1;
}

Piece* next_of(Piece* piece) {
  return reinterpret_cast<Piece*>(reinterpret_cast<uint8_t*>(piece + 1) +
                                  piece->size);
}

Piece* end() {
  return piece_at(kBytes);
}

// Joins a free piece with the free ones behind it.
void join(Piece* piece) {
  for (Piece* next = next_of(piece); next != end() && next->asked == 0;
       next = next_of(piece)) {
    piece->size += sizeof(Piece) + next->size;
  }
}

Piece* find(size_t size) {
  for (Piece* piece = piece_at(0); piece != end(); piece = next_of(piece)) {
    if (piece->asked == 0) {
      join(piece);
      if (piece->size >= size) {
        return piece;
      }
    }
  }
  return nullptr;
}

}  // namespace

extern "C" {

size_t heap_most() {
  return most;
}

void heap_forget() {
  most = in_use;
}

void* malloc(size_t asked) {
  if (piece_at(0)->size == 0) {
    piece_at(0)->size = kBytes - sizeof(Piece);
  }
  if (asked == 0 || asked > kBytes) {
    return nullptr;
  }
  const size_t size = (asked + 7) & ~size_t{7};
  Piece* const piece = find(size);
  if (piece == nullptr) {
    return nullptr;
  }
  if (piece->size - size > sizeof(Piece)) {
    const size_t rest = piece->size - size - sizeof(Piece);
    piece->size = size;
    *next_of(piece) = {rest, 0};
  }
  piece->asked = asked;
  in_use += asked;
  most = in_use > most ? in_use : most;
  return piece + 1;
}

void free(void* data) {
  if (data != nullptr) {
    in_use -= piece_of(data)->asked;
    piece_of(data)->asked = 0;
  }
}

void* calloc(size_t count, size_t size) {
  void* const data = malloc(count * size);
  if (data != nullptr) {
    __builtin_memset(data, 0, count * size);
  }
  return data;
}

void* realloc(void* data, size_t asked) {
  if (data == nullptr) {
    return malloc(asked);
  }
  void* const moved = malloc(asked);
  if (moved != nullptr) {
    const size_t old = piece_of(data)->asked;
    __builtin_memcpy(moved, data, old < asked ? old : asked);
    free(data);
  }
  return moved;
}

}  // extern "C"
