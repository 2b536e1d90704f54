// Lists everything that a person can request by key, terminal line, scenario or device button. All kinds of input use
// this one list, so each of them can request every command.
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
    // The following commands walk and learn a place.
    Forward,
    Back,  // a tap makes one step, and a held key keeps walking
    TurnLeft,
    TurnRight,
    SideLeft,  // steps to the side without turning
    SideRight,
    TiltUp,
    TiltDown,
    // The following commands change force, frame, scale and workspace.
    ToggleForces,
    SwitchFrame,  // switches between the Map frame and the Walk frame
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
    WorkspaceCentre,  // brings the workspace back to the walker
    Grab,             // the hand moves the world until the person presses the key again
    // The following commands ask questions.
    WhereAmI,
    Heading,
    AroundMe,    // announces one thing for each quarter of the circle
    AheadOfMe,   // announces up to four things, the nearest first
    Spotlight,   // makes only the things ahead sound, then only those towards the hand, then all
    Lost,        // turns to the nearest wall; announces the room and the route to the last known place
    Describe,    // opens a list of rooms; for the chosen one, announces size, exits and things by wall
    Overview,    // describes the building in three sentences
    Storeys,     // opens a list of storeys; for the chosen one, offers the lift or the route
    AboveBelow,  // announces the rooms straight above and below the person
    Places,      // opens a list of all places with kind, room and distance; typed, gives them as a table
    LookNext,    // announces what is in the next of 16 directions, or where the hand points
    LookBefore,
    ScaleBar,     // announces the scale and where north is
    Simplified,   // opens a list of what is too small to be rendered truly at this scale
    Understood,   // opens a list of what the reader understood of the world's file, and of what somebody should check
    Faults,       // opens a list of errors that somebody should correct in this world
    Coordinates,  // announces the position, with the height above the floor
    WhatIsThis,   // names what the hand touches
    Repeat,
    HistoryBack,  // repeats earlier announcements, from the latest back
    HistoryForward,
    StopSpeech,
    StopEverything,  // F12; stops all force and sound
    Home,
    BringOut,   // moves the hand or the walker out of the solid that contains it
    LastPlace,  // returns to the last known place of an earlier session that ended without the Leave command
    // The following commands concern rooms, routes and movable things.
    Use,  // opens or shuts a door, or presses a button, that the hand touches or the walker stands before
    PutBack,
    DropMark,
    DeleteMark,  // the person chooses the mark from a list
    Marks,       // opens a list of marks; offers a beacon and guidance for the chosen one
    SetBeacon,   // puts the beacon on what the hand touches, on what is ahead, or on a chosen mark
    MuteBeacon,
    TakeMe,  // guides the hand to the chosen thing; a second press ends the guidance
    Find,    // opens a list of everything with a name, and offers ways to find the chosen thing
    CrossLines,
    Exits,           // announces the exits of this room, clockwise
    UnvisitedExits,  // announces the exits to places where the person has not been
    Routes,          // opens a list of rooms; gives directions to the chosen one and guides along the route
    RepeatLeg,       // repeats the present leg of the followed route, from where the walker is
    NextLeg,
    RestOfRoute,
    FaceRoute,   // turns the walker to the direction of the announced leg
    NameRoom,    // the person types a name for the present room
    AskHere,     // sets a question of a quiz at this place
    Quiz,        // asks the questions that were set in this world
    Groups,      // opens a list of the groups of this world; the chosen one can be hidden or get a material
    Diary,       // opens a list of the rooms that the person visited, with dates and what was learnt
    Label,       // gives the thing under the hand, or ahead, another name, kind or material
    KeptRoutes,  // opens a list of the saved routes
    KeepRoute,   // saves the route planned or walked last under a name
    PlanView,    // chooses which pictures the window shows
    FullScreen,  // makes the window fill the screen, or not
    // The following commands concern help and settings.
    Menu,  // opens a list of everything that can be done
    Help,
    InputHelp,  // switches the mode in which a key announces its meaning and does nothing else
    Lessons,
    FirstMinutes,  // begins the introduction, which also runs at the first start of the program
    Task,      // repeats the task of the instructor's lesson; if no lesson runs, opens a list to begin or prepare one
    TaskDone,  // the learner reports that the task is done, or answers its question by facing or pointing there
    Learners,  // requests a list of learners from the owner of the session
    Language,
    Presets,  // opens a list of presets for walking and speech
    Devices,  // opens a list of the connected devices and their uses
    NextSound,
    LastSound,  // LastSound and NextSound step through the sound dictionary, which names and plays one sound at a time
    VerbosityCycle,
    // The following commands are for walking by ear.
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
    Cane,           // takes the virtual cane in the hand or puts it away
    CaneTechnique,  // chooses the next technique of sweeping the cane
    CaneLeft,       // sweeps the cane to the left; to be held
    CaneRight,
    // The following commands are for learning a place.
    Unexplored,
    ProgressReport,
    LearnPlace,
    LearntRooms,  // opens a list of rooms and how much of each is learnt; offers the route to the chosen one
    Hunt,
    Labyrinth,  // announces the state of the game, in a world that is a labyrinth
    Calibrate,  // begins the set-up by voice, which the owner of the device runs
    Leave,      // Escape; at the top level, asks the person to confirm
    // The following commands move the target of the simulated hand, if there is no device.
    HandForward,
    HandBack,
    HandLeft,
    HandRight,
    HandUp,
    HandDown,
    HandCentre,
    Desk,  // opens the controls of the person's desk as a list for keys
};

// A row of the key table: a command with its word for terminals and scenarios, and its default keys. The command's help
// text is in settings/languages.
struct CommandInfo {
    Command command;
    std::string_view word;     // the word that a person types: "where"
    std::string_view key;      // default keys by name, separated by a blank: "F2 1"
    bool hold;                 // true: the command acts while the key is down
    std::string help() const;  // returns one sentence in the language spoken now
};

std::span<const CommandInfo> command_table();  // the rows are in the order of the enum Command
const CommandInfo* find_command(std::string_view word);
const CommandInfo& info(Command command);

constexpr bool is_one_of(Command command, std::initializer_list<Command> commands) {
    return std::find(commands.begin(), commands.end(), command) != commands.end();
}

// Returns true for commands that make one step or one notch of a turn.
bool steps_or_turns(Command command);

// What a command does while a list is open.
enum class InList : std::uint8_t {
    Waits,     // the command does nothing until the list is closed
    Answered,  // a question, which is answered while the list stays open
    Always,    // the command acts even while a list is open
};
InList in_list(Command command);

}  // namespace handrail::core
