// Defines all input of a session, with one type for each kind of input. Only Session::apply applies input. Window,
// terminal, scenarios, tests and replays make it. Plain data.
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

// A key was pressed or released. The key is given as its command.
struct CommandDown {
    Command command;
    int times = 1;  // number of steps or turns if the person typed a count; otherwise 1
};
struct CommandUp {
    Command command;
};
// Input to lists, questions and anything else that waits for a key (dialogue.h). The input is a key by name,
// characters, a terminal line, or an action of a screen reader on an item of the open list. If none of the receivers
// uses the input, apply() returns false, and the caller treats the input as a command. The receivers never use a key
// that stops force, sound or speech.
struct KeyTapped {
    std::string key;
};
struct TextTyped {
    std::string utf8;
};
struct LineTyped {
    std::string line;
};
// Silently closes the open list and all lists under it, down to a text question. apply() returns false if no list is
// open.
struct ListsLeft {};
struct ItemActed {
    ItemAct act;
};
// The position of the sticks, which act in addition to keys until the next value or until the keyboard focus is lost. A
// value that is not finite is replaced by the rest position.
struct Steered {
    Steering steering;
};
// The window has lost or regained the keyboard focus. When the focus is lost, all held keys are released, and the force
// fades out.
struct FocusChanged {
    bool focused;
};
// The number of presses of the stop key, counted by the part that sees the key before the app thread does
// (ServoSwitches::stops). This input comes before the keys of each frame. The servo has already stopped, and this input
// stops everything else.
struct Stopped {
    std::uint32_t count;
};
// Moves the target of the simulated hand by a vector in the device frame. The target stays in the workspace.
struct HandMoved {
    Vec3 by_m;
};
// Changes the setting with this key, as a list, the desk or a command does. The change is effective at once, and
// Session::take_setting_changes returns it. apply() returns false if the value is invalid.
struct SettingSet {
    std::string key, value;
};
// New settings from outside the session. The world stays the same. If the workspace changes, the force rises again from
// zero.
struct SettingsChanged {
    settings::Settings settings;
};
// Another device for the only or right hand, or no device. The settings come from outside the session, as in
// SettingsChanged.
struct HandChanged {
    HandFacts hand;
    settings::Settings settings;
    // True: the hand is simulated because there is no device, so lessons explain walking instead of touching.
    bool for_want_of_one = false;
};
// A second device for the left hand, or no device. The left hand has its own proxy and its own force ceiling, but the
// same workspace and the same scale as the right hand. If one hand moves the workspace, the other hand's proxy moves
// with it.
struct LeftHandChanged {
    HandFacts hand;
};
// A usable device has been plugged in. The session announces the device, and the next press of the force key switches
// to it.
struct HandOffered {
    std::string spoken_name;
};
// Moves the walker, and the workspace with the walker, to another place in this world.
struct Placed {
    Vec3 feet_m;
    double heading_rad = 0.0;
    std::string name = {};  // name of the place, such as "Kitchen", if it is known
};
// Enters a world. The walker is placed at the start of the world, and the session announces that place.
// - additions: what the person added to the world, with the side file; none: additions stay in memory and are lost
//   with the world.
// - request: the file and how it was read, so that the world can be read again.
// - settings: the person's settings from now on. They include the settings of this world instead of the previous one.
//   none: the settings stay the same.
// - begins_at: where the walker is placed instead of the start, which stays the base; none: at the start.
struct WorldEntered {
    EnteringWorld world;
    std::optional<SideFile> additions = {};
    WorldRequest request = {};
    std::optional<settings::Settings> settings = {};
    std::optional<Placed> begins_at = {};
};
// A sentence to announce from outside the session, such as a problem while loading or news about a device.
struct Announcement {
    std::string text;
    cues::SpeechClass speech_class = cues::SpeechClass::Answer;
};
// Lines about these topics were cut off. Now speech is silent and no key is pressed, so the session says again what is
// still true.
struct LinesOwed {
    cues::SpeechTopics topics;
};
// Begins the first minutes, before a world is entered or in a world. `who_speaks` names the speech program, such as
// "speech-dispatcher". `owner_sets_up`: the owner runs the set-up by voice when requests() contains that request;
// otherwise the step is skipped.
struct FirstMinutesBegun {
    std::string who_speaks;
    bool owner_sets_up = false;
};
// Ends the first minutes, because the person does not want them or can no longer answer. The session then greets the
// person in the world as usual.
struct LessonLeft {};
// The set-up that the session requested has ended, or the person has left it.
struct SetUpOver {};
// The last place of a session that crashed. With the command LastPlace, the person requests to continue there. The
// owner then reads the world of that place if necessary and sends WentOnAt.
struct LastPlaceKnown {
    LastPlace place;
};
// Moves the walker to `place` in the present world, and announces the place. If a solid is there now, the walker is
// placed next to it. If the place is no longer in the world, the walker is not moved.
struct WentOnAt {
    LastPlace place;
};
// What is known of an earlier session that crashed: the file of the report, and the lines of that report.
struct CrashReportKnown {
    std::string file;
    std::vector<std::string> lines;
};
// All errors in the settings files, one sentence each. The menu lists them.
struct SettingsFaultsKnown {
    std::vector<std::string> faults;
};
// The connected devices, one sentence each. The owner sends them at the request of the session, which opens them as a
// list.
struct DevicesFound {
    std::vector<std::string> sentences;
};
// The worlds that the list of worlds offers.
struct WorldsKnown {
    WorldShelf shelf;
};

using SessionInput = std::variant<CommandDown, CommandUp, KeyTapped, TextTyped, LineTyped, ListsLeft, ItemActed,
                                  Steered, FocusChanged, Stopped, HandMoved, SettingSet, SettingsChanged, HandChanged,
                                  LeftHandChanged, HandOffered, WorldEntered, Placed, Announcement, LinesOwed,
                                  FirstMinutesBegun, LessonLeft, SetUpOver, LastPlaceKnown, WentOnAt, CrashReportKnown,
                                  SettingsFaultsKnown, DevicesFound, WorldsKnown, TeacherActed>;

}  // namespace handrail::core
