#include "app/core/view.h"
