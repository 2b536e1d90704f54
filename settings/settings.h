// All settings as typed values with units, ranges and defaults. Plain data, app thread; other threads receive copies of
// the values they need. The names, ranges and sentences of the fields are in one table (settings.cpp), which files and
// the command line use.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "settings/toml_value.h"
#include "worlds/base/result.h"

namespace handrail::settings {

enum class ForceCeiling { Light, Normal, Full };  // 1.2 N, 2.5 N, or all that the device can give
inline constexpr double kLightCeiling_n = 1.2, kNormalCeiling_n = 2.5;
enum class FrameChoice { Map, Walk };  // north up, or turning with the body
enum class SpeechThrough { Auto, ScreenReader, SpeechDispatcher, Embedded, Text };
enum class HoldingHand { Right, Left };
enum class KeyboardHand { Both, Left, Right };  // the hand on the keyboard; the other hand holds the device's grip
enum class DirectionChoice { Sides, Clock, Compass };  // "30 degrees left", "at 11 o'clock", "north"

// The results of `handrail calibrate` for one device and the person who holds it, as [profile."falcon a9001"] in the
// file. Empty: not measured.
struct DeviceProfile {
    // The strongest comfortable force in N, 0.5 to 40. The smaller of this and haptic.ceiling is effective.
    std::optional<double> ceiling_n;
    std::optional<double> gentlest_n;                   // the smallest force that the person noticed in N, 0.02 to 2
    std::optional<HoldingHand> hand;                    // the hand that holds the device
    std::optional<double> scale;                        // like workspace.scale
    std::optional<double> offset_ahead_m, offset_up_m;  // like the fields of workspace
    std::optional<double> width_m, depth_m, height_m;   // size of the comfortable reach, hand metres, 0.01 to 1
};

struct Settings {
    struct Workspace {
        double scale = 60.0;  // world metres per hand metre, 1 to 500
        // Hand metres from the body to the middle of the workspace, -0.1 to 0.1. Positive: it extends farther in front
        // than behind.
        double offset_ahead_m = 0.01;
        double offset_up_m = 0.0;    // raises the middle of the workspace; hand metres, -0.1 to 0.1
        double hand_height_m = 1.0;  // height of the middle of the workspace above the soles, world metres, 0 to 2
        FrameChoice frame = FrameChoice::Map;
        double turn_deg = 0.0;     // turn of the workspace relative to its frame, clockwise, -180 to 180
        bool follows_walk = true;  // the workspace moves with the walker
        bool rim = true;           // pressing past the rim of the workspace scrolls it
        int grab_button = 1;       // while this device button is held, the world moves with the hand; 0 to 8, 0 is none
        // Overrides by device name, as [workspace.device."falcon"] in the file. Empty fields keep the values above.
        struct Override {
            std::optional<double> scale, offset_ahead_m, offset_up_m, hand_height_m;
        };
        std::map<std::string, Override> devices;
    } workspace;
    struct Haptic {
        double stiffness_fraction = 0.8;  // of the device's rating, 0 to 1; for surfaces that name none
        double friction_mu = 0.3;         // 0 to 2
        double damping_ns_per_m = 5.0;    // of hand speed, 0 to 20
        double ball_diameter_mm = 4.0;    // felt, at scale 60, 1 to 10
        double edge_rounding_mm = 1.5;    // of convex edges, felt, 0 to 3; finer than scale 30 edges are sharp
        bool simplify = true;             // narrow doorways are felt wider and things too small to feel are left out
        double mesh_tolerance_mm = 0.1;   // felt, 0 to 1: how far dense meshes may be off; 0: not simplified
        ForceCeiling ceiling = ForceCeiling::Normal;
        bool button_to_feel = false;       // force only while a device button is held
        std::string device = "auto";       // auto, none, or a device name
        std::string left_device = "none";  // a second device, in the left hand: none, a device name or a serial number
    } haptic;
    struct Walk {
        double step_length_m = 0.7;   // 0.2 to 1.5
        double speed_m_per_s = 1.0;   // 0.2 to 3
        double turn_deg = 22.5;       // for one press of Left or Right; 1 to 90
        double body_radius_m = 0.25;  // 0.1 to 0.6
        bool callouts = true;         // stairs, drops, ramps and openings are announced automatically
        bool stop_at_drops = true;    // the walker stops at an edge until the key is pressed again
    } walk;
    struct Speech {
        // The speech output; if it is not available, the next one in the order of the enumeration is used.
        SpeechThrough through = SpeechThrough::Auto;
        int rate_wpm = 175;              // 80 to 450
        int verbosity = 2;               // 0 to 4: how much is announced
        std::string language = "auto";   // the spoken language; "auto": that of the environment, else English
        std::string voice = "auto";      // an espeak-ng voice or language; "auto": that of the spoken language
        bool distances_in_steps = true;  // false: in metres
        DirectionChoice directions = DirectionChoice::Sides;
        bool rounded = true;         // distances and directions; else as exact as they are known
        bool rooms = true;           // the name of a room one comes into is told
        bool braille = true;         // what is said goes to a braille display too
        bool from_places = false;    // the built-in voice comes from what a name or a leg of a route is about
        bool crowding_hint = false;  // told on entering where many materials lie close together
    } speech;
    struct Sound {
        double volume = 1.0;  // 0 to 1, of everything; alarms stay at 0.2 or above
        double speech_volume = 1.0;
        double contact_volume = 0.8;
        double footstep_volume = 0.6;
        double wall_tone_volume = 0.5;
        double world_volume = 0.7;
        double earcon_volume = 1.0;
        double beacon_volume = 0.8;
        double reverberation = 0.15;  // of rooms, 0 to 1
        int periods = 2;  // of 256 samples that the sound device holds, 2 to 8; takes effect at the next start
        std::string hrtf = "auto";  // the set of filters for the ears, as OpenAL Soft calls it; from the next start on
        bool headphones = true;     // filtered for the ears; else plain stereo, from the next start on
        bool mono = false;          // everything from the middle, for one loudspeaker or one ear
        bool behind = true, height = true;  // second cues for what is behind, above and below
        // Every cue on or off; alarms and what is asked for by name (the sound dictionary) always sound.
        bool wall_tone = true, contact = true, slide = true, splash = true, door = true, footstep = true, bump = true,
             world = true, denied = true, forces = true, turn = true, frame = true, arrived = true;
        bool corner = true, drop = true,
             ways = true;         // further cues: corners and openings; edges; doors and stairs ahead
        bool swap_sides = false;  // exchanges left and right, for headphones that are worn or wired the other way round
        bool as_text = false;   // describes every cue in a few words of text, for people who read instead of listening
        bool workspace = true;  // a cue: the rim and the grip start or stop moving the workspace
        bool desk = true;       // a cue: clicks at the desk
        bool marks = true;      // a cue: marks, landmarks and clues nearby
        bool beacon = true;     // a cue: the beacon, and warmer and colder sounds
        bool guide = true;      // a cue: leading the hand begins or ends
    } sound;
    struct Desk {
        bool use = true;  // the desk can be reached through a wall towards the body, and by its key
    } desk;
    // Things that can be pushed and lifted.
    struct Dynamics {
        // Greatest force in N of the hand, and of the keys, on movable things. A heavier body cannot be lifted.
        double strength_n = 50.0;
    } dynamics;
    // Devices in addition to the haptic one: game pads and SpaceMouse.
    struct Pads {
        bool use = true;        // Handrail looks for them; they steer the walker and give cues
        bool triggers = true;   // the triggers resist, tremble and click
        bool rumble = true;     // pads knock at bumps and tremble with materials
        double strength = 1.0;  // strength of all their cues, 0 to 1
    } pads;
    struct Marks {
        bool ask_name = true;  // asks for the name of a new mark
        int button = 2;        // device button that sets a mark; 0 to 8, 0 is none
    } marks;
    // Leading the hand, which happens only when the person requests it.
    struct Guidance {
        bool pull = true;       // "take me there" pulls the hand; false: it sets the beacon
        double strength = 1.0;  // share of the force limits, 0.1 to 1
        bool fades = true;      // reduces the help with each repetition as errors decrease
        bool grooves = false;   // the floor has grooves along the planned route and through doorways
        // Beacon, warmer sounds and lines follow the walking route; false: they lead straight to the thing.
        bool along_way = true;
    } guidance;
    struct Keyboard {
        KeyboardHand hand = KeyboardHand::Both;
    } keyboard;
    struct Welcome {
        bool done = false;  // true once the introduction, which runs at the first start, is finished
        int step = 0;       // the step at which the introduction continues, 0 to 20
    } welcome;
    std::map<std::string, DeviceProfile> profiles;  // keyed by profile_key()
    // Profiles in the person's file that are damaged and not used; their devices get the light force ceiling.
    std::set<std::string> damaged_profiles;
    // Command name -> key name. Contains only the commands whose keys differ from the built-in table.
    std::map<std::string, std::string> keys;
};

// The sources of a value, the weakest first. A stronger source that sets a value for all devices also overrides a
// weaker one that sets it for one device ([workspace.device] or [profile]).
enum class SettingSource { Default, UserFile, World, CommandLine, Live };

struct SettingRow {
    std::string key;      // "workspace.scale"
    std::string value;    // as TOML writes it
    std::string unit;     // "world metres per hand metre" in the spoken language, or empty
    std::string range;    // "1 to 500"
    std::string meaning;  // one sentence
    SettingSource source = SettingSource::Default;
    std::string origin;  // file and line, "--set", or empty
};

// Settings with the source of each value. Every source has its own layer, and the strongest one wins, whatever the
// order of loading. So leaving a world restores what it had changed. App thread only. Costs: reading a file takes a few
// hundred microseconds; values() is free.
class SettingsStore {
public:
    // command_words: the names allowed in [keys]; if empty, all names are.
    explicit SettingsStore(std::vector<std::string> command_words = {});
    ~SettingsStore();
    SettingsStore(SettingsStore&&) noexcept;
    SettingsStore& operator=(SettingsStore&&) noexcept;

    const Settings& values() const;
    // Reads a TOML file with `toml` and replaces the layer `source` with it. A damaged or unreadable file changes
    // nothing. An unknown key, a wrong type or a value out of range gives a diagnostic with the nearest key or the
    // legal range; the other values apply. A missing file is no error. A profile with an impossible value is not used
    // at all, which one sentence reports. A world may set only what world_may_set() allows: never a force or a speech
    // setting.
    std::vector<Diagnostic> load_file(const std::filesystem::path& path, SettingSource source,
                                      const TomlReader& toml = toml_of);
    // Sets one value, from the command line, a world's own key or a live change. Fails with the nearest key or the
    // legal range.
    Result<void> set(std::string_view key, std::string_view value, SettingSource source);
    // Sets "workspace.scale=40", the form of --set.
    Result<void> set_assignment(std::string_view assignment, SettingSource source);
    // Removes all values of one source, for example when the person leaves a world.
    void clear(SettingSource source);
    // Replaces the layer of this source with that of `other`, which was read elsewhere, for example while a world was
    // loading.
    void take_layer(SettingSource source, SettingsStore other);
    // All settings in table order, then the entries of [workspace.device], [profile] and [keys].
    std::vector<SettingRow> explain() const;
    // Saves live changes into the person's file and keeps everything else in it, including unknown keys and comments.
    // Does nothing if there are no live changes. A file that cannot be read or understood is never replaced.
    Result<void> save_user_file();
    // The same in two steps, so that another thread can write the file: returns what save_user_file() would write now;
    // empty if the file has it already.
    struct ToSave {
        std::filesystem::path file;
        std::string text;
    };
    Result<std::optional<ToSave>> to_save() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

// setting_text returns the value of one setting in a plain Settings as TOML text; it knows only keys of the table.
// change_setting changes a value of any key, like SettingsStore::set. Both fail with the nearest key, and
// change_setting also with the legal range.
Result<std::string> setting_text(const Settings& settings, std::string_view key);
Result<void> change_setting(Settings& settings, std::string_view key, std::string_view value);

// The file for a world's own settings: house.settings.toml next to house.map. Empty if the world has no file.
std::filesystem::path settings_beside(const std::filesystem::path& world);
// True if a world file may set this key.
bool world_may_set(std::string_view key);

// The name of a device's profile in lower case: "falcon a9001", or "sim-t" if the device has no serial number.
std::string profile_key(std::string_view device_name, std::string_view serial);

// "default", "world", ...
std::string source_name(SettingSource source);

// $XDG_CONFIG_HOME/handrail/settings.toml, else ~/.config/handrail/settings.toml; empty if neither is known.
std::filesystem::path user_settings_path();

}  // namespace handrail::settings
