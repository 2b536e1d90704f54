// What a person can ask for, by key, terminal line, scenario or device button. One list, so that every way in can do
// everything.
#pragma once

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace handrail {

enum class Command : std::uint8_t {
    // Walking and learning a place.
    Forward,
    Back,  // a tap is one step; held, walking
    TurnLeft,
    TurnRight,
    SideLeft,  // steps to the side, facing as before
    SideRight,
    TiltUp,
    TiltDown,
    // Marks and guidance, after force and frame.
    ToggleForces,
    SwitchFrame,  // Map <-> Walk
    ScaleBuilding,
    ScaleFloor,
    ScaleRoom,
    ScaleDetail,
    WorkspaceForward,  // the workspace moves on while the key is held
    WorkspaceBack,
    WorkspaceLeft,
    WorkspaceRight,
    WorkspaceUp,
    WorkspaceDown,
    WorkspaceTurnLeft,
    WorkspaceTurnRight,
    WorkspaceCentre,  // back to the body
    Grab,             // the world goes along with the hand, until pressed again
    // Questions.
    WhereAmI,
    Heading,
    AroundMe,   // one thing per quarter
    AheadOfMe,  // up to four, by distance
    Lost,       // turns to the nearest wall; the room, and the way back to the last known place
    Describe,   // a list of rooms; the chosen one: size, exits, things by wall
    Overview,   // the building in three sentences
    Storeys,    // a list of storeys; the lift or the way to the chosen one
    LookNext,   // along the next of 16 directions, or where the hand points
    LookBefore,
    ScaleBar,     // and north
    Simplified,   // list of what is too small at this scale and felt otherwise
    Understood,   // list of what was understood of the file, and of what is to be checked
    Faults,       // list of what should be mended in this world
    Coordinates,  // and height above the floor
    WhatIsThis,   // what the hand touches
    Repeat,
    HistoryBack,  // through what was said
    HistoryForward,
    StopSpeech,
    StopEverything,  // F12: all force and sound
    Home,
    BringOut,   // out of whatever the hand or the body is inside
    LastPlace,  // where a session that was never left had come to
    // Rooms, routes and what moves.
    Use,  // opens or shuts the door, presses the button, that the hand touches or the body stands before
    PutBack,
    DropMark,
    DeleteMark,  // chosen from a list
    Marks,       // list of marks, with the beacon and the help on the way
    SetBeacon,   // on what the hand touches, or what is ahead, or chosen
    MuteBeacon,
    TakeMe,  // leads the hand to what was chosen; again lets go
    Find,    // list of everything that has a name, with the ways to find it
    CrossLines,
    Exits,           // of this room, clockwise
    UnvisitedExits,  // that lead where one has not been
    Routes,          // a list of rooms; the way to the chosen one in words, and along it
    RepeatLeg,       // of the way that is followed, from where one is
    NextLeg,
    RestOfWay,
    FaceWay,   // turns to the leg that is told
    NameRoom,  // another name for the room one is in, typed
    Ways,      // a list of the ways that were kept
    KeepWay,   // the one planned or walked last, under a name
    PlanView,
    // Help and settings.
    Menu,  // everything that can be done, in a list
    Help,
    InputHelp,  // keys are explained instead of done
    Lessons,
    FirstMinutes,  // as at the first start
    Task,          // of the lesson of an instructor; without one a list to begin or prepare one
    TaskDone,      // it is done, or the question is answered: by facing or pointing there
    Learners,      // list of who can be here, to be asked of whoever owns the session
    Language,
    Devices,  // list of what is plugged in, and what each is good for
    NextSound,
    LastSound,  // the sound dictionary: names and plays one sound after the other
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
    LearntRooms,  // list of rooms with how much of each is learnt; the way to the chosen one
    Hunt,
    Labyrinth,  // how the game stands, in a world that is one
    Calibrate,  // the set-up by voice, run by whoever owns the device
    Leave,      // Escape: asks once more at the top
    // The hand without a device: the simulated hand's target moves.
    HandForward,
    HandBack,
    HandLeft,
    HandRight,
    HandUp,
    HandDown,
    HandCentre,
    Desk,  // the controls of one's own desk by keys
};

// A row of the key table: the command, its word for terminals and scenarios, the default key and a line of help
// (settings/languages).
struct CommandInfo {
    Command command;
    std::string_view word;     // "where", typed in a terminal
    std::string_view key;      // default keys by name, separated by a blank: "F2 1"
    bool hold;                 // acts as long as the key is down
    std::string help() const;  // one sentence, in the language spoken
};

std::span<const CommandInfo> command_table();  // in the order of Command
const CommandInfo* find_command(std::string_view word);
const CommandInfo& info(Command command);

constexpr bool is_one_of(Command command, std::initializer_list<Command> commands) {
    return std::find(commands.begin(), commands.end(), command) != commands.end();
}

// One step or one notch of a turn.
bool steps_or_turns(Command command);

// What becomes of a command while a list is open.
enum class InList : std::uint8_t {
    Waits,     // the list is to be closed first
    Answered,  // what only asks; the list stays open
    Always,    // no list keeps it from acting
};
InList in_list(Command command);

}  // namespace handrail
