// What the sample uses of Zephyr.
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct device {
  int unused;
};
extern const struct device chosen_zephyr_display;
#define DT_CHOSEN(name) chosen_##name
#define DEVICE_DT_GET(node) (&node)
bool device_is_ready(const struct device*);
