// Defines scenario files in readable TOML: a world, a start, timed actions and expectations. This code only parses
// them, and scenario_run.h runs them. docs/scenarios.md describes the format.
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
};  // press = "forward", for_s = 0, times = 3: the same as if the person had typed the count
struct HoldCommand {
    Command command;
    double for_s;
};  // hold = "forward", for_s = 3
struct TapKey {
    std::string key;
};  // key = "Down": presses a key by name; an open list or question gets it, otherwise the command of that key
struct TypeText {
    std::string text;
};  // type = "stairs": characters typed on the keyboard
struct TypeLine {
    std::string line;
};  // line = "library": a line typed in a terminal; an open list or question gets it first
struct Wait {
    double for_s;
};  // wait_s = 1
struct MoveHand {
    Vec3 to_m;
    double speed_m_per_s;
    bool relative;
};  // move_to or move_by: exact world metres, with the speed of the hand
struct MoveInDevice {
    // `to_m` is an exact offset in device metres. If `control` is empty, the offset starts at the device's middle.
    // Otherwise it starts where the proxy touches that control of the present desk page, and its axes are to the right
    // of, in front of and above that place.
    std::string control;
    Vec3 to_m{0.0};
    double speed_m_per_s;
};  // hand_to; or control with right_mm, off_mm and up_mm, where a negative off_mm presses into the control
struct PushHand {
    Vec3 force_n;
    double for_s;
};  // push_n, for_s: a force that pushes a free hand, in device axes
struct RestHand {
    Vec3 at_m;
    double for_s;
};  // rest_at, for_s: a spring pulls the hand to a place in the world
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
};  // place, heading_deg: moves the walker to a place
struct ChangeSetting {
    std::string key, value;
};  // set = "workspace.scale=30": starts the world again at the same place
struct AddThing {
    std::string name;
    Vec3 box_m{0.0};              // for `add` with a box: side lengths; zero: the action adds a model
    std::filesystem::path model;  // for `add` with a model: the world file that was found
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
};  // send = "crate": the crate slides to a place in a straight line while the scenario continues

using ScenarioStep = std::variant<TapCommand, HoldCommand, TapKey, TypeText, TypeLine, Wait, MoveHand, MoveInDevice,
                                  PushHand, RestHand, ScenarioTrouble, DeviceButton, KeyboardFocus, PlaceWalker,
                                  ChangeSetting, AddThing, RemoveThing, SendThing>;

struct ScenarioAction {
    std::string name;  // name that `after` and `before` use; may be empty
    ScenarioStep step = Wait{0.0};
    std::optional<double> at_s;  // start of the action; none: when the previous action ends
    bool meanwhile = false;      // true: the action starts together with the previous one
    bool left = false;           // whose = "left": the action is for the left hand
    int line = 0;
};

// A moment: `offset_s` after the start of the scenario, or after the start or end of a named action.
struct Moment {
    std::string action;  // empty: the offset is from the start of the scenario
    bool at_end = false;
    double offset_s = 0.0;
};

enum class Check {
    Say,     // say: a line contains these words in this order, exactly `times` times or at least once
    NotSay,  // not_say: no line contains these words in this order
    // say_in_order: each part between bars is in a line of its own, in this order; other lines may come between.
    SayInOrder,
    NothingTwice,  // nothing_twice_s: no line is repeated within this many seconds
    SoundFaster,   // sound_faster: the sound repeats, and each pause is shorter than the previous one
    Sound,         // sound, material; latency_ms: time from the event to the start of the sound
    NotSound,
    Force,      // force_n = [min, max]: magnitude of the force, or its component along `direction`
    ForceStep,  // force_step_n: largest change of the force between two ticks
    // force_spike: the force never exceeds this factor times the force of the previous tick, or of the beginning of the
    // time window.
    ForceSpike,
    ForceLine,  // force_line_n with hz: amplitude of the force at that frequency
    ForceBand,  // force_band_n with from_hz, to_hz: largest amplitude of any spectral line between the two frequencies
    // force_angle_deg, direction: largest angle between the force and that direction, in all ticks with a force above
    // 0.05 N.
    ForceAngle,
    Depth,        // depth_mm: largest distance between the hand and the proxy, in hand metres
    ForceRising,  // force_rising = true: the force never falls by more than 1e-9 N between two ticks
    BodyAt,
    HipAt,
    ProxyAt,
    Heading,
    Penetration,  // penetration_m: deepest overlap of the proxy with a solid
    Touching,     // touching: name of the feature that the hand touches
    Free,         // free = true: the hand touches nothing, and the force is zero
    SlideRatio,   // slide_mu = [low, high] with direction: force across the direction, divided by the force along it
    // strongest_line_hz = [low, high] with from_hz, to_hz, at_least_n: frequency of the strongest spectral line of the
    // force.
    StrongestLine,
    Distinct,  // told_apart = true: no two materials of the world feel the same
    // not_told_apart: the named pair of materials feels the same, and the report on materials names the pair.
    NotDistinct,
    SoundRising,  // sound_rising = "wall tone": the loudness of the sound grows and never falls
};

struct Expectation {
    Check check = Check::Say;
    std::string text;                                 // words, or the name of a sound or feature
    std::string material;                             // material of the object, for sounds
    std::optional<std::array<double, 2>> muffled_db;  // for sounds: least and greatest loss by obstacles
    std::optional<std::array<double, 2>> pitch;       // for sounds: least and greatest factor of the pitch
    std::optional<int> times;
    double low = 0.0, high = 0.0;  // range of a force, or a limit
    Vec3 vector{0.0};              // a direction or a place; components that are NaN are ignored
    bool has_vector = false;
    double tolerance = 0.0;
    double from_hz = 0.0, to_hz = 0.0;
    bool always = true;  // true: the condition must hold in the whole window; false: at least once in the window
    bool left = false;   // whose = "left": measures the left hand
    Moment from, to;
    bool has_to = false;
    int line = 0;
};

struct Scenario {
    std::string title;
    std::filesystem::path file;
    WorldRequest world;  // world: the file that was found; building, unit_m, map_scale_m_per_unit: how to read it
    std::string device = "none", left_device = "none";
    ActsBy acts_by = ActsBy::WindowKeys;  // acts_by: how sentences for the person name the keys
    bool has_start = false;
    Vec3 start_feet_m{0.0};
    double start_heading_rad = 0.0;
    std::map<std::string, std::string> settings;
    std::vector<ScenarioAction> actions;
    std::vector<Expectation> expectations;
    double tail_s = 1.0;  // how long the scenario continues after the end of the last action
};

// The key `sweep_at` in the file makes moves. There is one series of moves for each of `angles` directions from
// from_deg to to_deg. The hand starts at the distance reach_m from the place in that direction. It moves straight
// through the place to depth_m behind it, and returns.

// Read a scenario file. They search for worlds next to the file, then below its folder, then in `world_folders`. Any
// mistake, such as an unknown key, a wrong type or an unknown name of an action, is an error with its line. In that
// case, nothing is returned. read_scenario_text() reads `text` as if it were the content of `file`.
Result<Scenario> read_scenario_text(const std::string& text, const std::filesystem::path& file,
                                    const std::vector<std::filesystem::path>& world_folders);
Result<Scenario> read_scenario(const std::filesystem::path& file,
                               const std::vector<std::filesystem::path>& world_folders);

}  // namespace handrail::core
