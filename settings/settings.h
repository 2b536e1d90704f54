// Defines all settings as typed values with units, ranges and defaults. Plain data for the app thread; other threads
// receive copies of the values that they need. The names and ranges of the fields are in one table (table.cpp), which
// files and the command line use.
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

enum class ForceCeiling { Light, Normal, Full };  // the greatest force: 1.2 N, 2.5 N, or all that the device can render
inline constexpr double kLightCeiling_n = 1.2, kNormalCeiling_n = 2.5;
enum class FrameChoice { Map, Walk };  // Map: north is up; Walk: the workspace turns with the walker
enum class SpeechThrough { Auto, ScreenReader, SpeechDispatcher, Embedded, Text };
enum class HoldingHand { Right, Left };
// The hand that is on the keyboard; the other hand holds the grip of the device.
enum class KeyboardHand { Both, Left, Right };
// The colours of the window. High contrast uses black, white and yellow only. Colour-safe replaces red and green.
enum class ColourSet { Dark, Light, HighContrast, ColourSafe };
// How directions are announced: "30 degrees left", "at 11 o'clock", "north".
enum class DirectionChoice { Sides, Clock, Compass };
// Where the spotlight shines, outside which nothing sounds: straight ahead, or from the walker towards the hand.
enum class SpotlightChoice { Off, Ahead, Hand };
// How the virtual cane is swept: the tip stays on the ground, or touches it at both ends of the arc, or goes out to the
// wall or edge at one side.
enum class CaneTechnique { ConstantContact, TwoPoint, Shoreline };

// The results of `handrail calibrate` for one device and the person who uses the device. The settings file has them as
// [profile."falcon a9001"]. An empty value was not measured.
struct DeviceProfile {
    // The strongest force that is comfortable for the person, in N, 0.5 to 40. The smaller of this force and
    // haptic.ceiling is effective.
    std::optional<double> ceiling_n;
    std::optional<double> gentlest_n;                   // the weakest force that the person noticed, in N, 0.02 to 2
    std::optional<HoldingHand> hand;                    // the hand in which the person holds the device
    std::optional<double> scale;                        // the value of workspace.scale for this person and device
    std::optional<double> offset_ahead_m, offset_up_m;  // the values of the workspace fields with these names
    // Size of the space that the hand reaches comfortably, in hand metres, 0.01 to 1.
    std::optional<double> width_m, depth_m, height_m;
};

struct Settings {
    struct Workspace {
        double scale = 60.0;  // world metres per hand metre, 1 to 500
        // Distance from the body to the middle of the workspace, in hand metres, -0.1 to 0.1. If it is positive, the
        // workspace extends farther in front of the walker than behind.
        double offset_ahead_m = 0.01;
        // Distance by which the middle of the workspace is raised, in hand metres, -0.1 to 0.1.
        double offset_up_m = 0.0;
        double hand_height_m = 1.0;  // height of the middle of the workspace above the soles, in world metres, 0 to 2
        FrameChoice frame = FrameChoice::Map;
        double turn_deg = 0.0;     // clockwise turn of the workspace relative to its frame, -180 to 180
        bool follows_walk = true;  // the workspace moves with the walker
        bool rim = true;           // pushing the proxy past the rim of the workspace scrolls the workspace
        // Device button that grabs the world: while it is held, the world moves with the hand; 0 to 8, 0 is none.
        int grab_button = 1;
        // Values for single devices by their names, as [workspace.device."falcon"] in the file. If a field is empty,
        // the value for all devices applies.
        struct Override {
            std::optional<double> scale, offset_ahead_m, offset_up_m, hand_height_m;
        };
        std::map<std::string, Override> devices;
    } workspace;
    struct Haptic {
        // Stiffness of surfaces that state none, as a fraction of the device's rating, 0 to 1.
        double stiffness_fraction = 0.8;
        double friction_mu = 0.3;       // friction of surfaces that state none, 0 to 2
        double damping_ns_per_m = 5.0;  // damping of surfaces that state none, in N per m/s of the hand, 0 to 20
        double ball_diameter_mm = 4.0;  // diameter of the proxy as felt by the hand at scale 60, 1 to 10
        // Radius of convex edges as felt by the hand, 0 to 3. Below a workspace scale of 30, edges are sharp.
        double edge_rounding_mm = 1.5;
        bool simplify = true;  // narrow doorways feel wider, and things too small to feel are left out
        // Greatest error, as felt by the hand, when dense meshes are simplified, 0 to 1; 0: meshes are not simplified.
        double mesh_tolerance_mm = 0.1;
        ForceCeiling ceiling = ForceCeiling::Normal;
        bool button_to_feel = false;  // Handrail renders force only while a device button is held
        std::string device = "auto";  // "auto", "none", or the name of a device
        // A second device, for the left hand: "none", or the name or serial number of a device.
        std::string left_device = "none";
    } haptic;
    struct Walk {
        double step_length_m = 0.7;   // length of one step, 0.2 to 1.5
        double speed_m_per_s = 1.0;   // walking speed, 0.2 to 3
        double turn_deg = 22.5;       // turn for one press of Left or Right, 1 to 90
        double body_radius_m = 0.25;  // radius of the walker, 0.1 to 0.6
        bool callouts = true;         // stairs, drops, ramps and openings are announced automatically
        bool stop_at_drops = true;    // the walker stops at an edge until the person presses the key again
    } walk;
    struct Speech {
        // The speech output to use. If it is not available, Handrail uses the next one in the order of the enumeration.
        SpeechThrough through = SpeechThrough::Auto;
        int rate_wpm = 175;              // speed of speech in words per minute, 80 to 450
        int verbosity = 2;               // how much is announced, 0 to 4
        std::string language = "auto";   // the spoken language; "auto": that of the environment, or else English
        std::string voice = "auto";      // an espeak-ng voice or language; "auto": that of the spoken language
        bool distances_in_steps = true;  // distances are announced in steps; false: in metres
        DirectionChoice directions = DirectionChoice::Sides;
        // Distances and directions are announced rounded; false: exact to a decimetre and a degree.
        bool rounded = true;
        bool rooms = true;    // the name of a room is announced when the walker enters it
        bool braille = true;  // announcements are also shown on a braille display
        // The built-in voice is heard from the direction of the object or part of a route that it names.
        bool from_places = false;
        bool crowding_hint = false;  // entering a world announces where many materials are close together
    } speech;
    struct Sound {
        double volume = 1.0;  // volume of all sounds, 0 to 1; alarms never go below 0.2
        double speech_volume = 1.0;
        double contact_volume = 0.8;
        double footstep_volume = 0.6;
        double wall_tone_volume = 0.5;
        double world_volume = 0.7;
        double earcon_volume = 1.0;
        double beacon_volume = 0.8;
        double reverberation = 0.15;  // strength of the reverberation of rooms, 0 to 1
        // Number of periods of 256 samples that the sound device buffers, 2 to 8; takes effect at the next start.
        int periods = 2;
        std::string hrtf = "auto";  // OpenAL Soft's name of the HRTF data set; takes effect at the next start
        std::string pack = "none";  // folder of a sound pack, or "none"; takes effect at the next start
        // Sound for headphones, filtered with an HRTF; false: plain stereo; takes effect at the next start.
        bool headphones = true;
        bool mono = false;  // plays everything in the middle, for one loudspeaker or one ear
        // Additional cues for sounds that are behind the walker, and for those above or below.
        bool behind = true, height = true;
        // Each of these switches one cue on or off. Alarms, and sounds that the person requests by name (the sound
        // dictionary), are always audible.
        bool wall_tone = true, contact = true, slide = true, splash = true, door = true, footstep = true, bump = true,
             world = true, denied = true, forces = true, turn = true, frame = true, arrived = true;
        // Further cues: `corner` for corners and openings, `drop` for edges, `ways` for doors and stairs ahead.
        bool corner = true, drop = true, ways = true;
        bool swap_sides = false;  // exchanges left and right, for headphones that are worn or wired the wrong way round
        // Handrail describes every cue in a few words of text, for people who read instead of listening.
        bool as_text = false;
        bool workspace = true;  // a cue: scrolling at the rim, or moving with the grip, begins or ends
        bool desk = true;       // a cue: clicks at the wall of the desk and at its controls
        bool marks = true;      // a cue: marks, landmarks and clues nearby
        bool beacon = true;     // a cue: the beacon, and the sounds "warmer" and "colder"
        bool guide = true;      // a cue: a sound when leading the hand begins or ends
        SpotlightChoice spotlight = SpotlightChoice::Off;
        double spotlight_deg = 60.0;  // width of the spotlight, 10 to 180
        // Greatest number of the world's sounds at once, and of landmarks and clues that sound nearby, 1 to 8.
        int most_at_once = 3;
    } sound;
    struct Cane {
        CaneTechnique technique = CaneTechnique::ConstantContact;
        double length_m = 1.3;  // length of the virtual cane, 0.9 to 1.8
    } cane;
    struct Desk {
        // The hand gets to the desk if the person pulls it through a wall towards the body, or presses the desk's key.
        bool use = true;
    } desk;
    // Objects that can be pushed and lifted.
    struct Dynamics {
        // Greatest force in N that the hand, or the keys, exert on movable objects. A heavier body cannot be lifted.
        double strength_n = 50.0;
    } dynamics;
    // Devices in addition to the haptic one: game pads and the SpaceMouse.
    struct Pads {
        bool use = true;        // Handrail looks for these devices, which steer the walker and render cues
        bool triggers = true;   // triggers of game pads resist, vibrate and click
        bool rumble = true;     // game pads give a jolt at bumps and vibrate with materials
        double strength = 1.0;  // strength of all cues of the pads, 0 to 1
    } pads;
    struct Marks {
        bool ask_name = true;  // Handrail asks for the name of a new mark
        int button = 2;        // device button that sets a mark; 0 to 8, 0 is none
    } marks;
    // Leading the hand. Handrail does this only when the person requests it.
    struct Guidance {
        bool pull = true;       // "take me there" pulls the hand; false: the command sets the beacon instead
        double strength = 1.0;  // share of the force limits that may be used, 0.1 to 1
        bool fades = true;      // Handrail reduces the help with each repetition as the person makes fewer errors
        bool grooves = false;   // the floor has grooves along the planned route and through doorways
        // The beacon, the sounds "warmer" and "colder", and the drawn lines follow the walking route. False: they lead
        // straight to the destination.
        bool along_way = true;
    } guidance;
    struct Keyboard {
        KeyboardHand hand = KeyboardHand::Both;
    } keyboard;
    // The picture in the window.
    struct Display {
        double text_size = 1.0;  // 1: a line of the newest message is a twelfth of the window's height; 0.5 to 1.5
        ColourSet colours = ColourSet::Dark;
        double outline_width = 1.0;   // width of outlines and lines as a multiple of the usual width, 0.5 to 3
        bool reduced_motion = false;  // the picture changes at most twice a second
        bool full_screen = false;
        // Where the window was when it was closed, as "1280x720+100+50"; "screen": as large as the screen.
        std::string place = "screen";

        bool operator==(const Display&) const = default;
    } display;
    struct Welcome {
        bool done = false;  // the introduction, which runs at the first start, is finished
        int step = 0;       // the step at which the introduction continues after a restart, 0 to 20
    } welcome;
    std::map<std::string, DeviceProfile> profiles;  // profiles by their profile_key()
    // Profiles in the person's file that are damaged and therefore not used. Their devices get the light force ceiling.
    std::set<std::string> damaged_profiles;
    // The key names of commands, by command name. Contains only the commands whose keys differ from the built-in table.
    std::map<std::string, std::string> keys;
};

// The sources of a value, from the weakest to the strongest. If a stronger source sets a value for all devices, it also
// overrides a value that a weaker source sets for one device ([workspace.device] or [profile]).
enum class SettingSource { Default, UserFile, World, CommandLine, Live };

struct SettingRow {
    std::string key;      // full key: "workspace.scale"
    std::string value;    // the value as TOML text
    std::string unit;     // the unit in the spoken language, "world metres per hand metre", or empty
    std::string range;    // the legal values: "1 to 500"
    std::string meaning;  // one sentence that says what the setting does
    SettingSource source = SettingSource::Default;
    std::string origin;  // where the value comes from: file and line, "--set", or empty
};

// Stores all settings with the source of each value. Every source has its own layer, and the strongest layer wins,
// regardless of the order of loading. So when the person leaves a world, clearing the layer of the world restores what
// the world had changed. App thread only. Reading a file takes a few hundred microseconds; values() costs nothing.
class SettingsStore {
public:
    // `command_words` are the names allowed in [keys]. If it is empty, all names are allowed.
    explicit SettingsStore(std::vector<std::string> command_words = {});
    ~SettingsStore();
    SettingsStore(SettingsStore&&) noexcept;
    SettingsStore& operator=(SettingsStore&&) noexcept;

    const Settings& values() const;
    // Reads a TOML file with `toml` and replaces the layer `source` with its content. A damaged or unreadable file
    // changes nothing, and a missing file is not an error. An unknown key, a wrong type or a value out of range gives a
    // diagnostic with the nearest key or the legal range; the other values apply. A profile with an impossible value is
    // not used at all, which one diagnostic reports. A world may set only what world_may_set() allows, which excludes
    // forces and speech.
    std::vector<Diagnostic> load_file(const std::filesystem::path& path, SettingSource source,
                                      const TomlReader& toml = toml_of);
    // Sets one value that was given on the command line, in a world, or by a live change. If the key or the value is
    // illegal, the error names the nearest key or the legal range.
    Result<void> set(std::string_view key, std::string_view value, SettingSource source);
    // Sets a value from text in the form of --set: "workspace.scale=40".
    Result<void> set_assignment(std::string_view assignment, SettingSource source);
    // Removes all values of one source, for example when the person leaves a world.
    void clear(SettingSource source);
    // Replaces the layer of this source with that of `other`, for example if `other` was read in the background while a
    // world was loading.
    void take_layer(SettingSource source, SettingsStore other);
    // Returns all settings in table order, then the entries of [workspace.device], [profile] and [keys].
    std::vector<SettingRow> explain() const;
    // Saves live changes into the person's file. Everything else in that file stays, including unknown keys and
    // comments. Does nothing if there are no live changes. A file that cannot be read or understood is never replaced.
    Result<void> save_user_file();
    // Prepares save_user_file() on the app thread, so that another thread can write the file. Returns what
    // save_user_file() would write now, or nothing if the file already has this content.
    struct ToSave {
        std::filesystem::path file;
        std::string text;
    };
    Result<std::optional<ToSave>> to_save() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

// setting_text returns the value of one setting in a plain Settings as TOML text; it accepts only keys of the table.
// change_setting changes the value of any key, as SettingsStore::set does. If the key is unknown, both fail with the
// nearest key. If the value is illegal, change_setting fails with the legal range.
Result<std::string> setting_text(const Settings& settings, std::string_view key);
Result<void> change_setting(Settings& settings, std::string_view key, std::string_view value);

// Returns the path of the file with a world's own settings: house.settings.toml for house.map. Returns an empty path if
// `world` is empty.
std::filesystem::path settings_next_to(const std::filesystem::path& world);
// Returns true if a world's settings file may set this key.
bool world_may_set(std::string_view key);

// Returns the name of a device's profile in lower case: "falcon a9001", or "sim-t" if the device has no serial number.
std::string profile_key(std::string_view device_name, std::string_view serial);

// Returns the name of a source: "default", "world", ...
std::string source_name(SettingSource source);

// Returns $XDG_CONFIG_HOME/handrail/settings.toml, or else ~/.config/handrail/settings.toml. Empty if neither is known.
std::filesystem::path user_settings_path();

}  // namespace handrail::settings
