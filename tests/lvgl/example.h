// Examples: of C, and that of docs/DRAW.md.
#ifndef INKCELL_TESTS_LVGL_EXAMPLE_H
#define INKCELL_TESTS_LVGL_EXAMPLE_H

#include <stdbool.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Two labels on the active screen; false if the ROM is no font. */
bool show_example(const void* rom, size_t rom_bytes);

/** One label; false if its font is none. */
bool show_kitchen(void);

#ifdef __cplusplus
}
#endif

#endif /* INKCELL_TESTS_LVGL_EXAMPLE_H */
