// Likewise.
#pragma once

#include "freertos/FreeRTOS.h"

typedef struct semaphore_t* SemaphoreHandle_t;
SemaphoreHandle_t xSemaphoreCreateBinary();
BaseType_t xSemaphoreTake(SemaphoreHandle_t, TickType_t);
BaseType_t xSemaphoreGiveFromISR(SemaphoreHandle_t, BaseType_t*);
