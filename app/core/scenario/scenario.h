// Scenario files: a world, a start, actions in time and what must come of them, in TOML that people can read. Parsing
// only; the runner stands in scenario_run.h. The format is described in docs/scenarios.md.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/core/dialogue/command.h"
#include "app/core/kept/world_request.h"
#include "worlds/base/result.h"
#include "worlds/base/typist.h"
#include "worlds/base/vec.h"
#include "worlds/geometry/placement.h"

namespace handrail {

struct TapCommand {
    Command command;
    double for_s = 0.1;
    int times = 1;
};  // press = "forward", for_s = 0, times = 3: as when a count was typed
struct HoldCommand {
    Command command;
    double for_s;
};  // hold = "forward", for_s = 3
struct TapKey {
    std::string key;
};  // key = "Down": by its name, to an open list or question, else the command it stands for
struct TypeText {
    std::string text;
};  // type = "stairs": characters, one after the other
struct TypeLine {
    std::string line;
};  // line = "library": as a terminal has it, to an open list or question
struct Wait {
    double for_s;
};  // wait_s = 1
struct MoveHand {
    Vec3 to_m;
    double speed_m_per_s;
    bool relative;
};  // move_to / move_by: world metres, exactly; speed of the hand
struct MoveInDevice {
    std::string control;  // of the desk's page: to_m is right of, off and above the place where the ball touches it;
                          // empty: of the device's middle
    Vec3 to_m{0.0};
    double speed_m_per_s;
};  // hand_to: metres in the device's own frame, exactly; control, off_mm, right_mm, up_mm: before (below 0: pressed
    // into) a control of the desk
struct PushHand {
    Vec3 force_n;
    double for_s;
};  // push_n, for_s: on a free hand, device axes
struct RestHand {
    Vec3 at_m;
    double for_s;
};  // rest_at, for_s: a hand that springs to a world place
struct ScenarioTrouble {
    std::string kind;
    double for_s;
};  // trouble = "nan" | "jump" | "freeze" | "unplug" | "late" | "hot" | "error"
struct DeviceButton {
    bool down;
};  // button = true: the device's first button goes down and stays there
struct KeyboardFocus {
    bool here;
};  // focus = false: the window loses the keyboard
struct PlaceBody {
    Vec3 feet_m;
    double heading_rad;
};  // place, heading_deg: the body is somewhere else
struct ChangeSetting {
    std::string key, value;
};  // set = "workspace.scale=30": restarts the world at the same place
struct AddThing {
    std::string name;
    Vec3 box_m{0.0};              // add, box: its sides; zero: the model
    std::filesystem::path model;  // add, model: a world file, as found
    Placement at;
    std::string material;
};  // add = "crate"
struct RemoveThing {
    std::string name;
};  // remove = "crate"
struct SendThing {
    std::string name;
    std::optional<Vec3> to_m;
    std::optional<Rotation> rotation;
    std::optional<double> scale;
    double speed_m_per_s;
};  // send = "crate": slides there in a straight line while everything goes on

using ScenarioStep = std::variant<TapCommand, HoldCommand, TapKey, TypeText, TypeLine, Wait, MoveHand, MoveInDevice,
                                  PushHand, RestHand, ScenarioTrouble, DeviceButton, KeyboardFocus, PlaceBody,
                                  ChangeSetting, AddThing, RemoveThing, SendThing>;

struct ScenarioAction {
    std::string name;  // for after/before; may be empty
    ScenarioStep step = Wait{0.0};
    std::optional<double> at_s;  // else when the action before it ends
    bool meanwhile = false;      // starts together with the action before it
    bool left = false;           // whose = "left": it is the left hand's
    int line = 0;
};

// A moment: seconds, or the start or end of a named action.
struct Moment {
    std::string action;  // empty: `offset_s` counts from the scenario's start
    bool at_end = false;
    double offset_s = 0.0;
};

enum class Check {
    Say,           // say: words in order in one line; times (exact) or at least once
    NotSay,        // not_say
    SayInOrder,    // say_in_order: of the parts between bars each in a line of its own, in this order, other lines
                   // between
    NothingTwice,  // nothing_twice_s: no line is said again within so many seconds
    SoundFaster,   // sound_faster: it comes again and again, each time sooner
    Sound,         // sound, material; latency_ms: from event to start
    NotSound,
    Force,       // force_n = [min, max] of the magnitude, or along `direction`
    ForceStep,   // force_step_n: largest change between ticks
    ForceSpike,  // force_spike: never more than so many times what it was a tick before, nor than at the window's begin
    ForceLine,   // force_line_n with hz: amplitude at that frequency
    ForceBand,   // force_band_n with from_hz, to_hz: largest amplitude of any line there
    ForceAngle,  // force_angle_deg, direction: the force looks there, wherever it is above 0.05 N
    Depth,       // depth_mm: largest distance of hand and ball, felt
    ForceRising,  // force_rising = true: never falls by more than 1e-9 N between ticks
    BodyAt,
    HipAt,
    ProxyAt,
    Heading,
    Penetration,    // penetration_m: deepest overlap of ball and solids
    Touching,       // touching: name of what is touched
    Free,           // free = true: nothing is touched, force zero
    SlideRatio,     // slide_mu = [low, high] with direction: the force across it over the force along it
    StrongestLine,  // strongest_line_hz = [low, high] with from_hz, to_hz, at_least_n: where the strongest line of the
                    // force lies
    ToldApart,      // told_apart = true: no two materials of the world feel alike
    NotToldApart,   // not_told_apart: this pair does, and is named
    SoundRising,    // sound_rising = "wall tone": its loudness never falls and grows
};

struct Expectation {
    Check check = Check::Say;
    std::string text;                                 // words, sound name, feature name
    std::string material;                             // sounds
    std::optional<std::array<double, 2>> muffled_db;  // sounds: lost on the way, from and to
    std::optional<std::array<double, 2>> pitch;       // sounds: factor, from and to
    std::optional<int> times;
    double low = 0.0, high = 0.0;  // force range, limits
    Vec3 vector{0.0};              // direction or place; NaN components are not looked at
    bool has_vector = false;
    double tolerance = 0.0;
    double from_hz = 0.0, to_hz = 0.0;
    bool always = true;  // in the whole window; else at least once
    bool left = false;   // whose = "left": what the left hand touches and feels
    Moment from, to;
    bool has_to = false;
    int line = 0;
};

struct Scenario {
    std::string title;
    std::filesystem::path file;
    WorldRequest world;  // world: the file, as found; building, unit_m, map_scale_m_per_unit: how it is read
    std::string device = "none", left_device = "none";
    ActsBy acts_by = ActsBy::WindowKeys;  // acts_by: what sentences call keys
    bool has_start = false;
    Vec3 start_feet_m{0.0};
    double start_heading_rad = 0.0;
    std::map<std::string, std::string> settings;
    std::vector<ScenarioAction> actions;
    std::vector<Expectation> expectations;
    double tail_s = 1.0;  // time after the last action
};

// An action `sweep_at` in the file stands for moves: for each of `angles` headings from from_deg to to_deg the hand
// starts reach_m away from the place in that direction, goes straight through the place to depth_m behind it, and back.

// Reads one file. World names are looked for beside the file, below it, then in `world_folders`. Any mistake - an
// unknown key, a wrong type, a name that no action has - fails with its line; nothing is half read.
// read_scenario_text: of what would stand in `file`.
Result<Scenario> read_scenario_text(const std::string& text, const std::filesystem::path& file,
                                    const std::vector<std::filesystem::path>& world_folders);
Result<Scenario> read_scenario(const std::filesystem::path& file,
                               const std::vector<std::filesystem::path>& world_folders);

}  // namespace handrail
