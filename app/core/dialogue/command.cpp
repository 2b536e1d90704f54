#include "app/core/dialogue/command.h"

#include <array>
#include <string>

#include "worlds/base/contract.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail::core {
namespace {

// The keys for the arrows, PageUp, PageDown, F, Home and Escape come from the walking demo of a plugin that preceded
// Handrail. Their meanings never change.
constexpr std::array kCommands{
    // The following commands walk and learn a place.
    CommandInfo{Command::Forward, "forward", "Up", true},
    CommandInfo{Command::Back, "back", "Down", true},
    CommandInfo{Command::TurnLeft, "left", "Left", true},
    CommandInfo{Command::TurnRight, "right", "Right", true},
    CommandInfo{Command::SideLeft, "side-left", "Alt+A", true},
    CommandInfo{Command::SideRight, "side-right", "Alt+D", true},
    CommandInfo{Command::TiltUp, "tilt-up", "PageUp", true},
    CommandInfo{Command::TiltDown, "tilt-down", "PageDown", true},
    // The following commands change force, frame, scale and workspace.
    CommandInfo{Command::ToggleForces, "forces", "F Grave", false},
    CommandInfo{Command::SwitchFrame, "frame", "F4", false},
    CommandInfo{Command::ScaleBuilding, "building", "F5", false},
    CommandInfo{Command::ScaleFloor, "floor", "F6", false},
    CommandInfo{Command::ScaleRoom, "room", "F7", false},
    CommandInfo{Command::ScaleDetail, "detail", "F8", false},
    CommandInfo{Command::WorkspaceForward, "workspace-forward", "W", true},
    CommandInfo{Command::WorkspaceBack, "workspace-back", "S", true},
    CommandInfo{Command::WorkspaceLeft, "workspace-left", "A", true},
    CommandInfo{Command::WorkspaceRight, "workspace-right", "D", true},
    CommandInfo{Command::WorkspaceUp, "workspace-up", "T", true},
    CommandInfo{Command::WorkspaceDown, "workspace-down", "B", true},
    CommandInfo{Command::WorkspaceTurnLeft, "workspace-turn-left", "Comma", false},
    CommandInfo{Command::WorkspaceTurnRight, "workspace-turn-right", "Period", false},
    CommandInfo{Command::WorkspaceCentre, "workspace-centre", "N", false},
    CommandInfo{Command::Grab, "grab", "M", false},
    // The following commands ask questions.
    CommandInfo{Command::WhereAmI, "where", "F2 1", false},
    CommandInfo{Command::Heading, "heading", "C", false},
    CommandInfo{Command::AroundMe, "around", "2", false},
    CommandInfo{Command::AheadOfMe, "ahead", "3", false},
    CommandInfo{Command::Spotlight, "spotlight", "Alt+3", false},
    CommandInfo{Command::Lost, "lost", "Shift+F2", false},
    CommandInfo{Command::Describe, "describe", "Shift+F3", false},
    CommandInfo{Command::Overview, "overview", "Shift+F5", false},
    CommandInfo{Command::Storeys, "storeys", "Shift+F6", false},
    CommandInfo{Command::AboveBelow, "above-below", "Shift+F7", false},
    CommandInfo{Command::Places, "places", "Alt+4", false},
    CommandInfo{Command::LookNext, "look", "5", false},
    CommandInfo{Command::LookBefore, "look-back", "Shift+5", false},
    CommandInfo{Command::ScaleBar, "scale-bar", "6", false},
    CommandInfo{Command::Simplified, "simplified", "Shift+6", false},
    CommandInfo{Command::Understood, "understood", "Shift+8", false},
    CommandInfo{Command::Faults, "faults", "Alt+8", false},
    CommandInfo{Command::Coordinates, "coordinates", "Shift+C", false},
    CommandInfo{Command::WhatIsThis, "what", "E", false},
    CommandInfo{Command::Repeat, "repeat", "Space Q", false},
    CommandInfo{Command::HistoryBack, "history", "Shift+Q", false},
    CommandInfo{Command::HistoryForward, "history-forward", "Alt+Q", false},
    CommandInfo{Command::StopSpeech, "quiet", "Control", false},
    CommandInfo{Command::StopEverything, "stop", "F12", false},
    CommandInfo{Command::Home, "home", "Home", false},
    CommandInfo{Command::BringOut, "out", "G", false},
    CommandInfo{Command::LastPlace, "last-place", "Control+0", false},
    // The following commands concern rooms, routes and movable things.
    CommandInfo{Command::Use, "use", "Enter", false},
    CommandInfo{Command::PutBack, "put-back", "Alt+Backspace", false},
    CommandInfo{Command::DropMark, "mark", "Insert Shift+M", false},
    CommandInfo{Command::DeleteMark, "delete-mark", "Delete", false},
    CommandInfo{Command::Marks, "marks", "4", false},
    CommandInfo{Command::SetBeacon, "beacon", "Y", false},
    CommandInfo{Command::MuteBeacon, "beacon-off", "Shift+Y", false},
    CommandInfo{Command::TakeMe, "take-me", "H", false},
    CommandInfo{Command::Find, "find", "Shift+H", false},
    CommandInfo{Command::CrossLines, "lines", "Slash", false},
    CommandInfo{Command::Exits, "exits", "X", false},
    CommandInfo{Command::UnvisitedExits, "unvisited", "Shift+X", false},
    CommandInfo{Command::Routes, "routes", "Shift+4", false},
    CommandInfo{Command::RepeatLeg, "leg", "R", false},
    CommandInfo{Command::NextLeg, "next-leg", "Shift+R", false},
    CommandInfo{Command::RestOfRoute, "rest-of-way", "Alt+R", false},
    CommandInfo{Command::FaceRoute, "face-way", "Shift+Z", false},
    CommandInfo{Command::NameRoom, "name-room", "Control+N", false},
    CommandInfo{Command::AskHere, "ask-here", "", false},
    CommandInfo{Command::Quiz, "quiz", "", false},
    CommandInfo{Command::Groups, "groups", "", false},
    CommandInfo{Command::Diary, "diary", "", false},
    CommandInfo{Command::Label, "label", "Alt+E", false},
    CommandInfo{Command::KeptRoutes, "ways", "Control+7", false},
    CommandInfo{Command::KeepRoute, "keep-way", "Control+8", false},
    CommandInfo{Command::PlanView, "plan", "F3", false},
    CommandInfo{Command::FullScreen, "full-screen", "Control+F11", false},
    // The following commands concern help and settings.
    CommandInfo{Command::Menu, "menu", "Tab", false},
    CommandInfo{Command::Help, "help", "F1", false},
    CommandInfo{Command::InputHelp, "input-help", "Shift+F1", false},
    CommandInfo{Command::Lessons, "lessons", "Shift+F9", false},
    CommandInfo{Command::FirstMinutes, "welcome", "", false},
    CommandInfo{Command::Task, "task", "Alt+F9", false},
    CommandInfo{Command::TaskDone, "done", "Alt+Enter", false},
    CommandInfo{Command::Learners, "learners", "", false},
    CommandInfo{Command::Language, "language", "", false},
    CommandInfo{Command::Presets, "preset", "", false},
    CommandInfo{Command::Devices, "devices", "", false},
    CommandInfo{Command::NextSound, "sounds", "F11", false},
    CommandInfo{Command::LastSound, "sounds-back", "Shift+F11", false},
    CommandInfo{Command::VerbosityCycle, "verbosity", "V", false},
    CommandInfo{Command::TrailLeft, "trail-left", "Shift+Left", true},
    CommandInfo{Command::TrailRight, "trail-right", "Shift+Right", true},
    CommandInfo{Command::TrailOn, "trail-on", "Shift+Up", false},
    CommandInfo{Command::TrailBack, "trail-back", "Shift+Down", false},
    CommandInfo{Command::SquareUp, "square", "Z", false},
    CommandInfo{Command::LeapNext, "leap-next", "Control+Up", false},
    CommandInfo{Command::LeapLast, "leap-last", "Control+Down", false},
    CommandInfo{Command::UndoLeap, "undo", "Shift+Home", false},
    CommandInfo{Command::Retrace, "retrace", "Backspace", true},
    CommandInfo{Command::FreeLeft, "free-left", "Alt+Left", true},
    CommandInfo{Command::FreeRight, "free-right", "Alt+Right", true},
    CommandInfo{Command::Callouts, "callouts", "Minus", false},
    CommandInfo{Command::Cane, "cane", "Alt+C", false},
    CommandInfo{Command::CaneTechnique, "cane-technique", "Alt+T", false},
    CommandInfo{Command::CaneLeft, "cane-left", "Control+Left", true},
    CommandInfo{Command::CaneRight, "cane-right", "Control+Right", true},
    CommandInfo{Command::Unexplored, "unexplored", "7", false},
    CommandInfo{Command::ProgressReport, "progress", "8", false},
    CommandInfo{Command::LearnPlace, "learn", "9", false},
    CommandInfo{Command::LearntRooms, "learnt", "Shift+9", false},
    CommandInfo{Command::Hunt, "hunt", "0", false},
    CommandInfo{Command::Labyrinth, "labyrinth", "Alt+0", false},
    CommandInfo{Command::Calibrate, "calibrate", "F9", false},
    CommandInfo{Command::Leave, "leave", "Escape", false},
    CommandInfo{Command::HandForward, "hand-forward", "I", true},
    CommandInfo{Command::HandBack, "hand-back", "K", true},
    CommandInfo{Command::HandLeft, "hand-left", "J", true},
    CommandInfo{Command::HandRight, "hand-right", "L", true},
    CommandInfo{Command::HandUp, "hand-up", "U", true},
    CommandInfo{Command::HandDown, "hand-down", "O", true},
    CommandInfo{Command::HandCentre, "hand-centre", "P", false},
    CommandInfo{Command::Desk, "desk", "F10", false},
};

}  // namespace

std::span<const CommandInfo> command_table() { return kCommands; }

const CommandInfo* find_command(std::string_view word) {
    const std::string lower = lower_ascii(word);
    for (const CommandInfo& row : kCommands)
        if (row.word == lower) return &row;
    return nullptr;
}

std::string CommandInfo::help() const { return phrase("command." + std::string(word)); }

const CommandInfo& info(Command command) {
    contract_pre(static_cast<std::size_t>(command) < std::size(kCommands));
    return kCommands[static_cast<std::size_t>(command)];
}

InList in_list(Command command) {
    if (is_one_of(command, {Command::StopEverything, Command::StopSpeech, Command::ToggleForces}))
        return InList::Always;
    return is_one_of(command, {Command::WhereAmI, Command::Heading, Command::AroundMe, Command::AheadOfMe,
                               Command::LookNext, Command::LookBefore, Command::AboveBelow, Command::ScaleBar,
                               Command::Coordinates, Command::WhatIsThis, Command::Exits, Command::UnvisitedExits,
                               Command::RepeatLeg, Command::RestOfRoute, Command::Repeat, Command::HistoryBack,
                               Command::HistoryForward, Command::Leave})
               ? InList::Answered
               : InList::Waits;
}

bool steps_or_turns(Command command) {
    return is_one_of(command, {Command::Forward, Command::Back, Command::TurnLeft, Command::TurnRight,
                               Command::SideLeft, Command::SideRight});
}

}  // namespace handrail::core
