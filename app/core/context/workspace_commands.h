// Which commands change the hand's workspace: its scale, its place and its orientation. App thread only.
#pragma once

#include "app/core/dialogue/command.h"

namespace handrail::core {

bool lays_workspace(Command command);
// Those of them that push the workspace in one of six directions.
bool pushes_workspace(Command command);

}  // namespace handrail::core
