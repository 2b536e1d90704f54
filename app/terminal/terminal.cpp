#include "app/core/command.h"
