#include "haptic/compile/compile_haptic.h"
