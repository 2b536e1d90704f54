// Everything a person can request, by key, terminal line, scenario or device button. There is one list, so every kind
// of input can do everything.
#pragma once

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace handrail::core {

enum class Command : std::uint8_t {
    // Walking and learning a place.
    Forward,
    Back,  // a tap is one step, a held key walks
    TurnLeft,
    TurnRight,
    SideLeft,  // steps to the side, facing as before
    SideRight,
    TiltUp,
    TiltDown,
    // Force, frame, scale and workspace.
    ToggleForces,
    SwitchFrame,  // Map <-> Walk
    ScaleBuilding,
    ScaleFloor,
    ScaleRoom,
    ScaleDetail,
    WorkspaceForward,  // the workspace moves while the key is held
    WorkspaceBack,
    WorkspaceLeft,
    WorkspaceRight,
    WorkspaceUp,
    WorkspaceDown,
    WorkspaceTurnLeft,
    WorkspaceTurnRight,
    WorkspaceCentre,  // back to the walker
    Grab,             // the world moves along with the hand until the key is pressed again
    // Questions.
    WhereAmI,
    Heading,
    AroundMe,   // one thing for each quarter of the circle
    AheadOfMe,  // up to four things, by distance
    Lost,       // turns to the nearest wall; announces the room and the route to the last known place
    Describe,   // list of rooms; for the chosen one: size, exits, things by wall
    Overview,   // the building in three sentences
    Storeys,    // list of storeys; the lift or the route to the chosen one
    LookNext,   // what is along the next of 16 directions, or where the hand points
    LookBefore,
    ScaleBar,     // the scale, and north
    Simplified,   // list of what is too small at this scale and therefore rendered differently
    Understood,   // list of what was understood of the world's file, and of what should be checked
    Faults,       // list of what should be corrected in this world
    Coordinates,  // with the height above the floor
    WhatIsThis,   // what the hand touches
    Repeat,
    HistoryBack,  // back through earlier announcements
    HistoryForward,
    StopSpeech,
    StopEverything,  // F12: stops all force and sound
    Home,
    BringOut,   // out of the solid that contains the hand or the walker
    LastPlace,  // where a session that ended without being left had been
    // Rooms, routes and movable things.
    Use,  // opens or shuts the door, or presses the button, that the hand touches or the walker stands before
    PutBack,
    DropMark,
    DeleteMark,  // chosen from a list
    Marks,       // list of marks, with the beacon and guidance to the chosen one
    SetBeacon,   // on what the hand touches, on what is ahead, or on a chosen mark
    MuteBeacon,
    TakeMe,  // guides the hand to what was chosen; a second press ends that
    Find,    // list of everything with a name, with the ways to find the chosen one
    CrossLines,
    Exits,           // exits of this room, clockwise
    UnvisitedExits,  // exits to places where the person has not been
    Routes,          // list of rooms; directions to the chosen one, and guidance along the route
    RepeatLeg,       // the present leg of the followed route, from where the walker is
    NextLeg,
    RestOfWay,
    FaceWay,   // turns the walker towards the announced leg
    NameRoom,  // the person types another name for the present room
    Ways,      // list of the saved routes
    KeepWay,   // saves the last planned or walked route under a name
    PlanView,
    // Help and settings.
    Menu,  // list of everything that can be done
    Help,
    InputHelp,  // explains keys instead of acting on them
    Lessons,
    FirstMinutes,  // the introduction of the first start
    Task,          // the task in an instructor's lesson; without a lesson, a list to begin or prepare one
    TaskDone,      // the task is done, or its question is answered by facing or pointing there
    Learners,      // list of learners, requested from the owner of the session
    Language,
    Devices,  // list of the connected devices and their uses
    NextSound,
    LastSound,  // with NextSound, steps through the sound dictionary, which names and plays one sound at a time
    VerbosityCycle,
    // Moving by ear.
    TrailLeft,
    TrailRight,
    TrailOn,
    TrailBack,
    SquareUp,
    LeapNext,
    LeapLast,
    UndoLeap,
    Retrace,
    FreeLeft,
    FreeRight,
    Callouts,
    // Learning a place.
    Unexplored,
    ProgressReport,
    LearnPlace,
    LearntRooms,  // list of rooms with how much of each is learnt; the route to the chosen one
    Hunt,
    Labyrinth,  // the state of the game, in a world that is a labyrinth
    Calibrate,  // the set-up by voice, run by the owner of the device
    Leave,      // Escape: asks for confirmation at the top level
    // Without a device, the keyboard moves the target of the simulated hand.
    HandForward,
    HandBack,
    HandLeft,
    HandRight,
    HandUp,
    HandDown,
    HandCentre,
    Desk,  // the controls of the person's desk, by keys
};

// A row of the key table: a command with its word for terminals and scenarios, its default keys, and a line of help
// (settings/languages).
struct CommandInfo {
    Command command;
    std::string_view word;     // "where", typed in a terminal
    std::string_view key;      // default keys by name, separated by a blank: "F2 1"
    bool hold;                 // acts while the key is down
    std::string help() const;  // one sentence, in the language spoken now
};

std::span<const CommandInfo> command_table();  // in the order of Command
const CommandInfo* find_command(std::string_view word);
const CommandInfo& info(Command command);

constexpr bool is_one_of(Command command, std::initializer_list<Command> commands) {
    return std::find(commands.begin(), commands.end(), command) != commands.end();
}

// True for one step or one notch of a turn.
bool steps_or_turns(Command command);

// What happens to a command while a list is open.
enum class InList : std::uint8_t {
    Waits,     // must wait until the list is closed
    Answered,  // a question, answered while the list stays open
    Always,    // acts even while a list is open
};
InList in_list(Command command);

}  // namespace handrail::core
