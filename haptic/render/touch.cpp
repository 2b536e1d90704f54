#include "haptic/render/touch.h"
