// The example of docs/PORTING.md.
#ifndef PORTING_H
#define PORTING_H

#include <stdbool.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Two labels on the active screen; false if the ROM is no font. */
bool porting_example(const void* rom, size_t rom_bytes);

#ifdef __cplusplus
}
#endif

#endif /* PORTING_H */
