#include "app/core/context/workspace_commands.h"

namespace handrail {

bool lays_workspace(Command command) {
    switch (command) {
        case Command::ScaleBuilding:
        case Command::ScaleFloor:
        case Command::ScaleRoom:
        case Command::ScaleDetail:
        case Command::WorkspaceTurnLeft:
        case Command::WorkspaceTurnRight:
        case Command::WorkspaceCentre:
        case Command::Grab:
            return true;
        default:
            return pushes_workspace(command);
    }
}

bool pushes_workspace(Command command) {
    switch (command) {
        case Command::WorkspaceForward:
        case Command::WorkspaceBack:
        case Command::WorkspaceLeft:
        case Command::WorkspaceRight:
        case Command::WorkspaceUp:
        case Command::WorkspaceDown:
            return true;
        default:
            return false;
    }
}

}  // namespace handrail
