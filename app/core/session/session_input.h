// All input of a session, one value for each kind; only Session::apply applies it. Window, terminal, scenarios, tests
// and replays all use it. Plain data.
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

namespace handrail::core {

// The key of a command is pressed and released.
struct CommandDown {
    Command command;
    int times = 1;  // for steps and turns, as when a count was typed; otherwise 1
};
struct CommandUp {
    Command command;
};
// Input to lists, questions and whatever waits for a key (dialogue.h): a key by name, characters, a terminal line, or a
// screen reader's action on an item of the open list. If none of them uses it, apply() returns false and the caller
// treats it as a command. They never take a key that stops force, sound or speech.
struct KeyTapped {
    std::string key;
};
struct TextTyped {
    std::string utf8;
};
struct LineTyped {
    std::string line;
};
// Leaves the open list and all lists under it silently, down to a text question. Not used if no list is open.
struct ListsLeft {};
struct ItemActed {
    ItemAct act;
};
// Sticks act in addition to keys, until the next value or until the keyboard focus is lost. Values that are not finite
// count as rest.
struct Steered {
    Steering steering;
};
// The window lost or regained the keyboard. While it is lost, no key counts as held and force fades out.
struct FocusChanged {
    bool focused;
};
// Number of presses of the stop key, from whatever sees the key before the app does (ServoSwitches::stops). It is
// reported before the keys of each frame. The servo has stopped already; this makes the rest follow.
struct Stopped {
    std::uint32_t count;
};
// Moves the target of the simulated hand, device frame; clamped to its workspace.
struct HandMoved {
    Vec3 by_m;
};
// Changes one setting of any key, as a list, the desk or a command does. It is effective at once and returned by
// Session::take_setting_changes. Not used if the value is invalid.
struct SettingSet {
    std::string key, value;
};
// New settings from outside; the world stays. Force ramps in again if the workspace changes.
struct SettingsChanged {
    settings::Settings settings;
};
// Replaces the device by another one, or by none. The settings come from outside, as in SettingsChanged.
struct HandChanged {
    HandFacts hand;
    settings::Settings settings;
    bool for_want_of_one = false;  // simulated because there is no device: lessons then speak of walking
};
// A second device in the left hand, or none. It has its own proxy and force ceiling in the same workspace, at the scale
// of the first. If one hand moves the workspace, the other moves along.
struct LeftHandChanged {
    HandFacts hand;
};
// A usable device has been plugged in. It is announced, and the next press of the force key takes it.
struct HandOffered {
    std::string spoken_name;
};
// Enters a world: the walker is placed at the world's start, and that place is announced.
// additions: what the person added to that world, and its file; none: additions stay in memory and are lost with the
// world.
// request: the file and how it was read, for whoever reads it again.
// settings: the person's settings from now on, with those of this world and without those of the previous one; none:
// unchanged.
struct WorldEntered {
    EnteringWorld world;
    std::optional<SideFile> additions = {};
    WorldRequest request = {};
    std::optional<settings::Settings> settings = {};
};
// Moves the walker to another place in this world; the workspace moves along.
struct Placed {
    Vec3 feet_m;
    double heading_rad = 0.0;
};
// A sentence from outside (problems while loading, device news).
struct Told {
    std::string text;
    cues::SpeechClass speech_class = cues::SpeechClass::Answer;
};
// Lines about these were cut, and now nothing is said or pressed: what is still true is said anew.
struct LinesOwed {
    cues::SpeechTopics topics;
};
// The first minutes, before a world is entered or in one. who_speaks: "speech-dispatcher"; owner_sets_up: the owner
// runs the set-up by voice when requests() has it, else that part is left out.
struct FirstMinutesBegun {
    std::string who_speaks;
    bool owner_sets_up = false;
};
// The first minutes are not wanted or can no longer be answered. The world then greets as usual.
struct LessonLeft {};
// The requested set-up is over or was left.
struct SetUpOver {};
// The last place of a session that crashed. The LastPlace command requests that the owner continue there: it reads that
// world if necessary and then sends WentOnAt.
struct LastPlaceKnown {
    LastPlace place;
};
// Moves the walker to that place in the present world, or next to what is there now, and announces it. If the place is
// no longer in the world, nobody is moved.
struct WentOnAt {
    LastPlace place;
};
// What is known of an earlier session that crashed: the file with the report, and its lines.
struct CrashReportKnown {
    std::string file;
    std::vector<std::string> lines;
};
// Every error in the settings files, one sentence each; the menu lists them.
struct SettingsFaultsKnown {
    std::vector<std::string> faults;
};
// The connected devices, one sentence each, after the session has requested them from its owner. Opened as a list.
struct DevicesFound {
    std::vector<std::string> sentences;
};
// What the list of worlds offers.
struct WorldsKnown {
    WorldShelf shelf;
};

using SessionInput =
    std::variant<CommandDown, CommandUp, KeyTapped, TextTyped, LineTyped, ListsLeft, ItemActed, Steered, FocusChanged,
                 Stopped, HandMoved, SettingSet, SettingsChanged, HandChanged, LeftHandChanged, HandOffered,
                 WorldEntered, Placed, Told, LinesOwed, FirstMinutesBegun, LessonLeft, SetUpOver, LastPlaceKnown,
                 WentOnAt, CrashReportKnown, SettingsFaultsKnown, DevicesFound, WorldsKnown, TeacherActed>;

}  // namespace handrail::core
