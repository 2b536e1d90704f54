#include "worlds/scene/scene.h"
