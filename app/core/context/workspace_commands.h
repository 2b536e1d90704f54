// Determines which commands change the hand's workspace: its scale, its position or its orientation. Use it on the app
// thread only.
#pragma once

#include "app/core/dialogue/command.h"

namespace handrail::core {

bool lays_workspace(Command command);
// Returns true for the commands that push the workspace in one of six directions.
bool pushes_workspace(Command command);

}  // namespace handrail::core
