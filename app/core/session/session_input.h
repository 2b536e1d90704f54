// The one way in: everything that reaches a session from outside, as one value each, applied by Session::apply alone.
// Window, terminal, scenarios, tests and whatever plays a session again use the same. Plain data.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/core/context/cues.h"
#include "app/core/context/hands_state.h"
#include "app/core/context/teacher_act.h"
#include "app/core/dialogue/command.h"
#include "app/core/dialogue/dialogue.h"
#include "app/core/kept/last_place.h"
#include "app/core/kept/side_file.h"
#include "app/core/kept/world_request.h"
#include "app/core/kept/world_shelf.h"
#include "app/core/walking/steering.h"
#include "app/core/world/entering.h"
#include "settings/settings.h"

namespace handrail {

// A command's key goes down, and up again.
struct CommandDown {
    Command command;
    int times = 1;  // of steps and turns, as when a count was typed; else once
};
struct CommandUp {
    Command command;
};
// To lists, questions and whatever waits for a key (dialogue.h): a key by name, characters, a line of a terminal, a
// screen reader's action on an item of the open list. Each is a command only where nothing took it: apply() is false
// then. A key that stops force, sound or speech is never taken.
struct KeyTapped {
    std::string key;
};
struct TextTyped {
    std::string utf8;
};
struct LineTyped {
    std::string line;
};
// Leaves the open list and all lists under it, up to a question for a text, without a word. False: no list is open.
struct ListsLeft {};
struct ItemActed {
    ItemAct act;
};
// Sticks act until told otherwise or the keyboard is lost, beside the keys. What is not finite counts as rest.
struct Steered {
    Steering steering;
};
// The window lost or regained the keyboard: nothing stays held and force fades away while it is lost.
struct FocusChanged {
    bool focused;
};
// How often the stop key was pressed, from whoever sees it before the app does (ServoSwitches::stops): told before the
// keys of each frame. The servo has stopped already; this makes the rest follow.
struct Stopped {
    std::uint32_t count;
};
// Moves the simulated hand's target, device frame; clamped to its reach.
struct HandMoved {
    Vec3 by_m;
};
// One setting of any key, as a list, the desk or a command changes it: in force at once, and told by
// Session::take_setting_changes. Not taken where it cannot be.
struct SettingSet {
    std::string key, value;
};
// New settings from outside; the world stays. Force ramps in again where the workspace changes.
struct SettingsChanged {
    Settings settings;
};
// Another device, or none, in place of the one there was; the settings are those of outside, as in SettingsChanged.
struct HandChanged {
    HandFacts hand;
    Settings settings;
    bool for_want_of_one = false;  // simulated since there is no real one: lessons speak of walking
};
// A second device in the left hand, or none: its own ball and ceiling in the same workspace, with the scale of the
// first. What one hand does to the workspace the other goes along with.
struct LeftHandChanged {
    HandFacts hand;
};
// A device that could be used has been plugged in: says so, and the force key takes it the next time.
struct HandOffered {
    std::string spoken_name;
};
// The body is put where the world says and one is told where one is. The additions are what the person added to that
// world and where it is kept; without them they are forgotten with the world.
// request: the file it was read from, and how, for whoever reads it again. settings: those of the person from now on,
// with what this world brings and without what the one before brought; none: they stay.
struct WorldEntered {
    EnteringWorld world;
    std::optional<SideFile> additions = {};
    WorldRequest request = {};
    std::optional<Settings> settings = {};
};
// Puts the body somewhere else in this world; the workspace jumps with it.
struct Placed {
    Vec3 feet_m;
    double heading_rad = 0.0;
};
// A sentence from outside (problems while loading, device news).
struct Told {
    std::string text;
    SpeechClass speech_class = SpeechClass::Answer;
};
// The first minutes, before a world is entered or in one. who_speaks: "speech-dispatcher"; owner_sets_up: the owner
// runs the set-up by voice when requests() has it, else that part is left out.
struct FirstMinutesBegun {
    std::string who_speaks;
    bool owner_sets_up = false;
};
// Nobody will answer them any more, or they are not wanted: the world greets as it does otherwise.
struct LessonLeft {};
// The set-up that was asked for is over, or left.
struct SetUpOver {};
// Where a session that was never left had come to. The command asks the owner to go on there: to read that world where
// it is another one, and then to tell WentOnAt.
struct LastPlaceKnown {
    LastPlace place;
};
// At the place in the world that is entered, or beside what stands there by now; where the world is no longer, nobody
// is moved. Says where one is.
struct WentOnAt {
    LastPlace place;
};
// What is known of a session before this one that broke off: line by line, and the file that holds the same.
struct CrashReportKnown {
    std::string file;
    std::vector<std::string> lines;
};
// Every fault of the settings files, each in a sentence; the menu lists them.
struct SettingsFaultsKnown {
    std::vector<std::string> faults;
};
// What is plugged in, in sentences, where the session had asked its owner for it: opened as a list.
struct DevicesFound {
    std::vector<std::string> sentences;
};
// What the chooser of worlds offers.
struct WorldsKnown {
    WorldShelf shelf;
};

using SessionInput =
    std::variant<CommandDown, CommandUp, KeyTapped, TextTyped, LineTyped, ListsLeft, ItemActed, Steered, FocusChanged,
                 Stopped, HandMoved, SettingSet, SettingsChanged, HandChanged, LeftHandChanged, HandOffered,
                 WorldEntered, Placed, Told, FirstMinutesBegun, LessonLeft, SetUpOver, LastPlaceKnown, WentOnAt,
                 CrashReportKnown, SettingsFaultsKnown, DevicesFound, WorldsKnown, TeacherActed>;

}  // namespace handrail
