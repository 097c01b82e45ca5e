// In Arduino.h.
#include "Arduino.h"
