// Stands for libpng, which is not in this build: --preview is refused.
#pragma once
#include <stddef.h>
#include <stdint.h>

#define PNG_IMAGE_VERSION 1
#define PNG_FORMAT_GRAY 0
#define PNG_FORMAT_RGB 2
#define PNG_IMAGE_PNG_SIZE_MAX(image) 0
typedef uint32_t png_uint_32;
typedef size_t png_alloc_size_t;
typedef struct {
  uint32_t version, width, height, format;
  const char* message;
} png_image;

static inline int png_image_write_to_memory(png_image* image,
                                            void* memory,
                                            png_alloc_size_t* size,
                                            int convert,
                                            const void* pixels,
                                            int stride,
                                            const void* colormap) {
  (void)memory, (void)size, (void)convert, (void)pixels, (void)stride,
      (void)colormap;
  image->message = "this build has no libpng; leave --preview out";
  return 0;
}
