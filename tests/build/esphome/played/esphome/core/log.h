// What a font needs of ESPHome's log, which is printed.
#pragma once

#include <stdio.h>

#define ESP_LOGE(tag, ...) \
  (printf("%s: ", tag), printf(__VA_ARGS__), printf("\n"))
