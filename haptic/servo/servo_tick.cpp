#include "haptic/servo/servo_tick.h"
