// Which commands lay the hand's workspace: its scale, where it is and how it is turned. App thread only.
#pragma once

#include "app/core/dialogue/command.h"

namespace handrail {

bool lays_workspace(Command command);

}  // namespace handrail
