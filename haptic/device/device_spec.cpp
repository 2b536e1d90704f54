#include "haptic/device/device_spec.h"
