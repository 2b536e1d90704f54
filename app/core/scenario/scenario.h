// Scenario files: a world, a start, timed actions and expectations, in readable TOML. Parsing only; scenario_run.h runs
// them. docs/scenarios.md describes the format.
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

namespace handrail::core {

struct TapCommand {
    Command command;
    double for_s = 0.1;
    int times = 1;
};  // press = "forward", for_s = 0, times = 3: like a typed count
struct HoldCommand {
    Command command;
    double for_s;
};  // hold = "forward", for_s = 3
struct TapKey {
    std::string key;
};  // key = "Down": a key by name, for an open list or question; otherwise for the command that it stands for
struct TypeText {
    std::string text;
};  // type = "stairs": typed characters
struct TypeLine {
    std::string line;
};  // line = "library": a terminal line, for an open list or question
struct Wait {
    double for_s;
};  // wait_s = 1
struct MoveHand {
    Vec3 to_m;
    double speed_m_per_s;
    bool relative;
};  // move_to / move_by: exact world metres; speed of the hand
struct MoveInDevice {
    // The exact offset in device metres: from the device's middle, or, if a control on the present page of the desk is
    // named, to the right of, in front of and above the place where the proxy touches it.
    std::string control;
    Vec3 to_m{0.0};
    double speed_m_per_s;
};  // hand_to, or control with right_mm, off_mm and up_mm; a negative off_mm presses into the control
struct PushHand {
    Vec3 force_n;
    double for_s;
};  // push_n, for_s: pushes a free hand, device axes
struct RestHand {
    Vec3 at_m;
    double for_s;
};  // rest_at, for_s: a spring pulls the hand to a world place
struct ScenarioTrouble {
    std::string kind;
    double for_s;
};  // trouble = "nan" | "jump" | "freeze" | "unplug" | "late" | "hot" | "error"
struct DeviceButton {
    bool down;
};  // button = true: presses the device's first button and keeps it pressed
struct KeyboardFocus {
    bool here;
};  // focus = false: the window loses the keyboard
struct PlaceWalker {
    Vec3 feet_m;
    double heading_rad;
};  // place, heading_deg: moves the walker there
struct ChangeSetting {
    std::string key, value;
};  // set = "workspace.scale=30": restarts the world at the same place
struct AddThing {
    std::string name;
    Vec3 box_m{0.0};              // side lengths for add with box; zero: add with model
    std::filesystem::path model;  // for add with model: the world file, after the search
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
};  // send = "crate": slides there in a straight line while the scenario continues

using ScenarioStep = std::variant<TapCommand, HoldCommand, TapKey, TypeText, TypeLine, Wait, MoveHand, MoveInDevice,
                                  PushHand, RestHand, ScenarioTrouble, DeviceButton, KeyboardFocus, PlaceWalker,
                                  ChangeSetting, AddThing, RemoveThing, SendThing>;

struct ScenarioAction {
    std::string name;  // for after/before; may be empty
    ScenarioStep step = Wait{0.0};
    std::optional<double> at_s;  // none: when the previous action ends
    bool meanwhile = false;      // starts together with the previous action
    bool left = false;           // whose = "left": for the left hand
    int line = 0;
};

// A moment: seconds, or the start or end of a named action.
struct Moment {
    std::string action;  // empty: `offset_s` counts from the scenario's start
    bool at_end = false;
    double offset_s = 0.0;
};

enum class Check {
    Say,           // say: words in this order in one line; `times` exactly, or at least once
    NotSay,        // not_say
    SayInOrder,    // say_in_order: each part between bars in its own line, in this order; other lines may come between
    NothingTwice,  // nothing_twice_s: no line is repeated within this many seconds
    SoundFaster,   // sound_faster: repeats, each time after a shorter pause
    Sound,         // sound, material; latency_ms: from event to start
    NotSound,
    Force,       // force_n = [min, max] of the magnitude, or along `direction`
    ForceStep,   // force_step_n: largest change between ticks
    ForceSpike,  // force_spike: never more than this factor times the previous tick, or times the begin of the window
    ForceLine,   // force_line_n with hz: amplitude at that frequency
    ForceBand,   // force_band_n with from_hz, to_hz: largest amplitude of any line in that band
    ForceAngle,  // force_angle_deg, direction: angle of the force to that direction, wherever the force is above 0.05 N
    Depth,       // depth_mm: largest distance between hand and proxy, at the hand
    ForceRising,  // force_rising = true: never falls by more than 1e-9 N between ticks
    BodyAt,
    HipAt,
    ProxyAt,
    Heading,
    Penetration,  // penetration_m: deepest overlap of proxy and solids
    Touching,     // touching: name of the touched feature
    Free,         // free = true: nothing is touched, force zero
    SlideRatio,  // slide_mu = [low, high] with direction: ratio of the force across the direction to the force along it
    // Key strongest_line_hz = [low, high] with from_hz, to_hz, at_least_n: frequency of the strongest line of the
    // force.
    StrongestLine,
    ToldApart,     // told_apart = true: no two materials of the world feel the same
    NotToldApart,  // not_told_apart: the named pair feels the same, and the report names it
    SoundRising,   // sound_rising = "wall tone": its loudness grows and never falls
};

struct Expectation {
    Check check = Check::Say;
    std::string text;                                 // words, sound name, feature name
    std::string material;                             // sounds
    std::optional<std::array<double, 2>> muffled_db;  // sounds: lost to obstacles, from and to
    std::optional<std::array<double, 2>> pitch;       // sounds: factor, from and to
    std::optional<int> times;
    double low = 0.0, high = 0.0;  // force range, limits
    Vec3 vector{0.0};              // direction or place; NaN components are ignored
    bool has_vector = false;
    double tolerance = 0.0;
    double from_hz = 0.0, to_hz = 0.0;
    bool always = true;  // in the whole window; false: at least once
    bool left = false;   // whose = "left": measures the left hand
    Moment from, to;
    bool has_to = false;
    int line = 0;
};

struct Scenario {
    std::string title;
    std::filesystem::path file;
    WorldRequest world;  // world: the file, after the search; building, unit_m, map_scale_m_per_unit: how to read it
    std::string device = "none", left_device = "none";
    ActsBy acts_by = ActsBy::WindowKeys;  // acts_by: how sentences name keys
    bool has_start = false;
    Vec3 start_feet_m{0.0};
    double start_heading_rad = 0.0;
    std::map<std::string, std::string> settings;
    std::vector<ScenarioAction> actions;
    std::vector<Expectation> expectations;
    double tail_s = 1.0;  // time after the last action
};

// An action `sweep_at` in the file becomes moves. For each of `angles` headings from from_deg to to_deg, the hand
// starts reach_m away from the place in that direction, moves straight through the place to depth_m behind it, and
// back.

// Reads one file. Worlds are searched for next to the file, below its folder, then in `world_folders`. Any mistake,
// such as an unknown key, a wrong type or an unknown action name, fails with its line; nothing is read partially.
// read_scenario_text: reads `text` as if it were the content of `file`.
Result<Scenario> read_scenario_text(const std::string& text, const std::filesystem::path& file,
                                    const std::vector<std::filesystem::path>& world_folders);
Result<Scenario> read_scenario(const std::filesystem::path& file,
                               const std::vector<std::filesystem::path>& world_folders);

}  // namespace handrail::core
