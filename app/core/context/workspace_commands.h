// Which commands lay the hand's workspace: its scale, where it is and how it is turned. App thread only.
#pragma once

#include "app/core/dialogue/command.h"

namespace handrail {

bool lays_workspace(Command command);
// Of these, what pushes it in one of six directions.
bool pushes_workspace(Command command);

}  // namespace handrail
