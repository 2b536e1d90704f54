#include "worlds/readers/reader.h"
