#include "app/core/command.h"

#include <array>
#include <string>

#include "worlds/base/text.h"

namespace handrail {
namespace {

// The keys of arrows, PageUp and PageDown, F, Home and Escape are those of the walking demo of the plugin that Handrail succeeds; they never change meaning.
constexpr std::array kCommands{
    // Walking and learning a place.
    CommandInfo{Command::Forward, "forward", "Up", true, "One step forward; held, walk."},
    CommandInfo{Command::Back, "back", "Down", true, "One step back; held, walk backwards."},
    CommandInfo{Command::TurnLeft, "left", "Left", true, "Turn left by one notch."},
    CommandInfo{Command::TurnRight, "right", "Right", true, "Turn right by one notch."},
    CommandInfo{Command::TiltUp, "tilt-up", "PageUp", true, "Look further up; for the picture only."},
    CommandInfo{Command::TiltDown, "tilt-down", "PageDown", true, "Look further down; for the picture only."},
    // Marks and guidance, after force and frame.
    CommandInfo{Command::ToggleForces, "forces", "F Grave", false, "Forces on or off. On again also confirms after a fault."},
    CommandInfo{Command::SwitchFrame, "frame", "F4", false, "Change between Map, north up, and Walk, turning with you."},
    CommandInfo{Command::ScaleBuilding, "building", "F5", false, "All of the building within the hand's reach."},
    CommandInfo{Command::ScaleFloor, "floor", "F6", false, "A floor at a time: 1 to 120."},
    CommandInfo{Command::ScaleRoom, "room", "F7", false, "A room at a time: 1 to 60."},
    CommandInfo{Command::ScaleDetail, "detail", "F8", false, "Things in detail: 1 to 15."},
    CommandInfo{Command::WorkspaceForward, "workspace-forward", "W", true, "Move the hand's workspace forward."},
    CommandInfo{Command::WorkspaceBack, "workspace-back", "S", true, "Move the hand's workspace back."},
    CommandInfo{Command::WorkspaceLeft, "workspace-left", "A", true, "Move the hand's workspace to the left."},
    CommandInfo{Command::WorkspaceRight, "workspace-right", "D", true, "Move the hand's workspace to the right."},
    CommandInfo{Command::WorkspaceUp, "workspace-up", "T", true, "Move the hand's workspace up."},
    CommandInfo{Command::WorkspaceDown, "workspace-down", "B", true, "Move the hand's workspace down."},
    CommandInfo{Command::WorkspaceTurnLeft, "workspace-turn-left", "Comma", false, "Turn the workspace under the hand to the left by one notch."},
    CommandInfo{Command::WorkspaceTurnRight, "workspace-turn-right", "Period", false, "Turn the workspace under the hand to the right by one notch."},
    CommandInfo{Command::WorkspaceCentre, "workspace-centre", "N", false, "Bring the workspace back to you."},
    CommandInfo{Command::Grab, "grab", "M", false, "Take the world along with the hand; again to let go."},
    // Questions.
    CommandInfo{Command::WhereAmI, "where", "F2 1", false, "Where am I, which way do I face, what is around."},
    CommandInfo{Command::Heading, "heading", "C", false, "Which way do I face."},
    CommandInfo{Command::AroundMe, "around", "2", false, "What is around me: the nearest thing ahead, right, behind and left."},
    CommandInfo{Command::AheadOfMe, "ahead", "3", false, "What is ahead of me: up to four things, nearest first."},
    CommandInfo{Command::LookNext, "look", "5", false, "Look straight ahead or where the hand points; again for the next of 16 directions."},
    CommandInfo{Command::LookBefore, "look-back", "Shift+5", false, "Look along the direction before."},
    CommandInfo{Command::ScaleBar, "scale-bar", "6", false, "How long five steps are under the hand, and where north is."},
    CommandInfo{Command::Coordinates, "coordinates", "Shift+C", false, "Where I am in metres, and the height above the floor."},
    CommandInfo{Command::WhatIsThis, "what", "E", false, "What is the hand touching; again for its size."},
    CommandInfo{Command::Repeat, "repeat", "Space Q", false, "Say the last thing again."},
    CommandInfo{Command::HistoryBack, "history", "Shift+Q", false, "Step back through the last 50 messages."},
    CommandInfo{Command::HistoryForward, "history-forward", "Alt+Q", false, "Step forward again through the last messages."},
    CommandInfo{Command::StopSpeech, "quiet", "Control", false, "Stop speaking."},
    CommandInfo{Command::StopEverything, "stop", "F12", false, "Stop all force and all sound at once. F brings force back."},
    CommandInfo{Command::Home, "home", "Home", false, "Go back to the base, where you started."},
    CommandInfo{Command::BringOut, "out", "G", false, "Bring my hand and me out of anything we are inside."},
    // Rooms, routes and what moves.
    CommandInfo{Command::Use, "use", "Enter", false, "Open or close the door, or press the button, that I touch or stand before."},
    CommandInfo{Command::DropMark, "mark", "Insert", false, "Set a mark where my hand is, or where I stand."},
    CommandInfo{Command::DeleteMark, "delete-mark", "Delete", false, "Delete a mark, chosen from a list."},
    CommandInfo{Command::Marks, "marks", "4", false, "List of marks, with the beacon and the help on the way."},
    CommandInfo{Command::SetBeacon, "beacon", "Y", false, "Set the beacon on what I touch, or on what is ahead."},
    CommandInfo{Command::MuteBeacon, "beacon-off", "Shift+Y", false, "Beacon off, and on again."},
    CommandInfo{Command::TakeMe, "take-me", "H", false, "Take me there, to what was chosen; again to let go."},
    CommandInfo{Command::Find, "find", "Shift+H", false, "List of everything that has a name, and ways to find it."},
    CommandInfo{Command::CrossLines, "lines", "Slash", false, "Lines that the hand can feel, crossing at what was chosen; again to end."},
    CommandInfo{Command::Exits, "exits", "X", false, "The exits of this room, clockwise."},
    CommandInfo{Command::UnvisitedExits, "unvisited", "Shift+X", false, "The exits that lead where I have not been."},
    CommandInfo{Command::Routes, "routes", "Shift+4", false, "Choose a room; the way there, step by step."},
    CommandInfo{Command::PlanView, "plan", "F3", false, "Change the picture between first person and plan."},
    // Help and settings.
    CommandInfo{Command::Menu, "menu", "Tab", false, "What I can do, worlds, settings, keys and sounds, in lists."},
    CommandInfo{Command::Help, "help", "F1", false, "Say the keys."},
    CommandInfo{Command::InputHelp, "input-help", "Shift+F1", false, "Say what keys do without doing it, until pressed again."},
    CommandInfo{Command::Lessons, "lessons", "Shift+F9", false, "Short lessons: walls, corners, doors, where am I, forces."},
    CommandInfo{Command::FirstMinutes, "welcome", "", false, "The first minutes again, as at the first start."},
    CommandInfo{Command::Language, "language", "", false, "Choose the language."},
    CommandInfo{Command::NextSound, "sounds", "F11", false, "Name and play the next sound of the sound dictionary."},
    CommandInfo{Command::LastSound, "sounds-back", "Shift+F11", false, "Name and play the sound before."},
    CommandInfo{Command::VerbosityCycle, "verbosity", "V", false, "How much is said: level 0 to 4."},
    CommandInfo{Command::TrailLeft, "trail-left", "Shift+Left", true, "Trail the wall on your left: a step along it; held, go on."},
    CommandInfo{Command::TrailRight, "trail-right", "Shift+Right", true, "Trail the wall on your right: a step along it; held, go on."},
    CommandInfo{Command::TrailOn, "trail-on", "Shift+Up", false, "Trail on to the next corner, door, opening or thing."},
    CommandInfo{Command::TrailBack, "trail-back", "Shift+Down", false, "Turn round and trail the same wall back to the last of these."},
    CommandInfo{Command::SquareUp, "square", "Z", false, "Turn square to the nearest wall."},
    CommandInfo{Command::LeapNext, "leap-next", "Control+Up", false, "Leap to the next door, landmark or clue in sight."},
    CommandInfo{Command::LeapLast, "leap-last", "Control+Down", false, "Leap to the one before."},
    CommandInfo{Command::UndoLeap, "undo", "Shift+Home", false, "Back to where you were before Home, a leap or being brought out."},
    CommandInfo{Command::Retrace, "retrace", "Backspace", true, "Go back the way you came."},
    CommandInfo{Command::FreeLeft, "free-left", "Alt+Left", true, "Turn left a little, without notches; held, turn on."},
    CommandInfo{Command::FreeRight, "free-right", "Alt+Right", true, "Turn right a little, without notches; held, turn on."},
    CommandInfo{Command::Callouts, "callouts", "Minus", false, "Tell stairs, drops and openings unasked, or not."},
    CommandInfo{Command::Unexplored, "unexplored", "7", false, "Where the nearest wall or floor is that I do not know yet."},
    CommandInfo{Command::ProgressReport, "progress", "8", false, "How much of this place I know: walls, floor, doors, time."},
    CommandInfo{Command::LearnPlace, "learn", "9", false, "Learn this place: walls one after another, then lanes; again to end."},
    CommandInfo{Command::Hunt, "hunt", "0", false, "Hunt a hidden clock; again for a hint."},
    CommandInfo{Command::Calibrate, "calibrate", "F9", false, "Set up headphones, device, force and reach, led by voice."},
    CommandInfo{Command::Leave, "leave", "Escape", false, "Leave; asks for a second press."},
    CommandInfo{Command::HandForward, "hand-forward", "I", true, "Simulated hand away from you."},
    CommandInfo{Command::HandBack, "hand-back", "K", true, "Simulated hand towards you."},
    CommandInfo{Command::HandLeft, "hand-left", "J", true, "Simulated hand to the left."},
    CommandInfo{Command::HandRight, "hand-right", "L", true, "Simulated hand to the right."},
    CommandInfo{Command::HandUp, "hand-up", "U", true, "Simulated hand up."},
    CommandInfo{Command::HandDown, "hand-down", "O", true, "Simulated hand down."},
    CommandInfo{Command::HandCentre, "hand-centre", "P", false, "Simulated hand back to the middle of its reach."},
    CommandInfo{Command::Desk, "desk", "F10", false, "Your desk: volumes, speech, force and scale, to hear and to change."},
};

}  // namespace

std::span<const CommandInfo> command_table() { return kCommands; }

const CommandInfo* find_command(std::string_view word) {
    const std::string lower = lower_ascii(word);
    for (const CommandInfo& row : kCommands)
        if (row.word == lower) return &row;
    return nullptr;
}

const CommandInfo& info(Command command) { return kCommands[static_cast<std::size_t>(command)]; }

}  // namespace handrail
