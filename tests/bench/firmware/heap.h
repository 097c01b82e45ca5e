// A heap that knows how much of it was in use at the most, in C.
#pragma once

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

// The most since heap_forget(), in bytes asked for, without what the heap adds.
// malloc(), realloc(), calloc() and free() are as in the standard.
size_t heap_most(void);
void heap_forget(void);

#ifdef __cplusplus
}
#endif
