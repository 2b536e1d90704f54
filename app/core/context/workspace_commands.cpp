#include "app/core/context/workspace_commands.h"

namespace handrail::core {

bool lays_workspace(Command command) {
    return is_one_of(command, {Command::ScaleBuilding, Command::ScaleFloor, Command::ScaleRoom, Command::ScaleDetail,
                               Command::WorkspaceTurnLeft, Command::WorkspaceTurnRight, Command::WorkspaceCentre,
                               Command::Grab}) ||
           pushes_workspace(command);
}

bool pushes_workspace(Command command) {
    return is_one_of(command, {Command::WorkspaceForward, Command::WorkspaceBack, Command::WorkspaceLeft,
                               Command::WorkspaceRight, Command::WorkspaceUp, Command::WorkspaceDown});
}

}  // namespace handrail::core
