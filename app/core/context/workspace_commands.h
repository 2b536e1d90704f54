// Tells which commands change the hand's workspace: its scale, its position or its orientation. App thread only.
#pragma once

#include "app/core/dialogue/command.h"

namespace handrail::core {

bool lays_workspace(Command command);
// True for the commands that push the workspace in one of six directions.
bool pushes_workspace(Command command);

}  // namespace handrail::core
