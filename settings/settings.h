// Every setting as a typed value with unit, range and default. Plain data, app thread; other threads get what they need
// by value. Names, ranges and sentences of each field stand in one table (settings.cpp); files and the command line go
// through it.
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

namespace handrail {

enum class ForceCeiling { Light, Normal, Full };  // 1.2 N, 2.5 N, the device's own
inline constexpr double kLightCeiling_n = 1.2, kNormalCeiling_n = 2.5;
enum class FrameChoice { Map, Walk };  // north up, or turning with the body
enum class SpeechThrough { Auto, ScreenReader, SpeechDispatcher, Embedded, Text };
enum class HoldingHand { Right, Left };
enum class KeyboardHand { Both, Left, Right };         // which hand has the keyboard while the other holds the grip
enum class DirectionChoice { Sides, Clock, Compass };  // "30 degrees left", "at 11 o'clock", "north"

// What `handrail calibrate` found out about one device and the person who holds it, as [profile."falcon a9001"] in the
// file. Empty: not measured.
struct DeviceProfile {
    std::optional<double>
        ceiling_n;  // strongest comfortable force, 0.5 to 40; the smaller of this and haptic.ceiling counts
    std::optional<double> gentlest_n;                   // the least that was noticed, 0.02 to 2
    std::optional<HoldingHand> hand;                    // that holds it
    std::optional<double> scale;                        // as workspace.scale
    std::optional<double> offset_ahead_m, offset_up_m;  // as in workspace
    std::optional<double> width_m, depth_m, height_m;   // of the comfortable reach, hand metres, 0.01 to 1
};

struct Settings {
    struct Workspace {
        double scale = 60.0;           // world metres per hand metre, 1 to 500
        double offset_ahead_m = 0.01;  // hand metres the workspace's middle lies ahead of the body, -0.1 to 0.1:
                                       // further in front than behind
        double offset_up_m = 0.0;      // hand metres, -0.1 to 0.1
        double hand_height_m = 1.0;    // world metres of the workspace's middle above the soles, 0 to 2
        FrameChoice frame = FrameChoice::Map;
        double turn_deg = 0.0;     // of the workspace against its frame, clockwise, -180 to 180
        bool follows_walk = true;  // the workspace goes where the body walks
        bool rim = true;           // pressing past the rim of the reach scrolls it
        int grab_button = 1;  // of the device: the world goes along with the hand while it is held; 0 to 8, 0 is none
        // Overrides by device name, as [workspace.device."falcon"] in the file; empty fields keep the values above.
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
        ForceCeiling ceiling = ForceCeiling::Normal;
        bool button_to_feel = false;       // force only while a button of the device is held
        std::string device = "auto";       // auto, none, or a device name
        std::string left_device = "none";  // a second device, in the left hand: none, a device name or a serial number
    } haptic;
    struct Walk {
        double step_length_m = 0.7;   // 0.2 to 1.5
        double speed_m_per_s = 1.0;   // 0.2 to 3
        double turn_deg = 22.5;       // one press of Left or Right; 1 to 90
        double body_radius_m = 0.25;  // 0.1 to 0.6
        bool callouts = true;         // stairs, drops, ramps and openings are told without being asked for
        bool stop_at_drops = true;    // the body stops at an edge until the key is pressed again
    } walk;
    struct Speech {
        SpeechThrough through =
            SpeechThrough::Auto;         // who speaks; where that one is missing, the next in this order does
        int rate_wpm = 175;              // 80 to 450
        int verbosity = 2;               // 0 to 4
        std::string language = "auto";   // what is said; "auto": the environment's, else English
        std::string voice = "auto";      // espeak-ng voice name or language; "auto": that of what is said
        bool distances_in_steps = true;  // else metres
        DirectionChoice directions = DirectionChoice::Sides;
        bool rounded = true;         // distances and directions; else as exact as they are known
        bool rooms = true;           // the name of a room one comes into is told
        bool braille = true;         // what is said goes to a braille display too
        bool crowding_hint = false;  // told on entering where many materials lie close together
    } speech;
    struct Sound {
        double volume = 1.0;  // 0 to 1, everything but alarms below 0.2
        double speech_volume = 1.0;
        double contact_volume = 0.8;
        double footstep_volume = 0.6;
        double wall_tone_volume = 0.5;
        double world_volume = 0.7;
        double earcon_volume = 1.0;
        double beacon_volume = 0.8;
        double reverberation = 0.15;  // of rooms, 0 to 1
        int periods = 2;         // of 256 samples that the sound device holds, 2 to 8; takes effect at the next start
        bool headphones = true;  // filtered for the ears; else plain stereo, from the next start on
        bool mono = false;       // everything from the middle, for one loudspeaker or one ear
        bool behind = true, height = true;  // second cues for what is behind, above and below
        // Every cue on or off; alarms and what is asked for by name (the sound dictionary) always sound.
        bool wall_tone = true, contact = true, slide = true, splash = true, door = true, footstep = true, bump = true,
             world = true, denied = true, forces = true, turn = true, frame = true, arrived = true;
        bool corner = true, drop = true,
             ways = true;         // cues as those above: corners and openings; edges; doors and stairs ahead
        bool swap_sides = false;  // left and right ear are exchanged, for headphones worn or wired the other way round
        bool as_text = false;     // every cue is told in a few words of text, for who reads instead of hearing
        bool workspace = true;    // a cue as those above: rim and grip
        bool desk = true;         // likewise: what clicks at the desk
        bool marks = true;        // likewise: marks, landmarks and clues that are near
        bool beacon = true;       // likewise: beacon, warmer and colder
        bool guide = true;        // likewise: the hand begins or ends to be led
    } sound;
    struct Desk {
        bool use = true;  // behind a wall towards the body, and by its key
    } desk;
    // What can be pushed and lifted.
    struct Dynamics {
        double strength_n = 50.0;  // of the hand and of the keys in the world; a body that weighs more is not lifted
    } dynamics;
    // Devices beside the hand: game pads and SpaceMouse.
    struct Pads {
        bool use = true;        // they are looked for, walk and give cues
        bool triggers = true;   // resist, tremble and click
        bool rumble = true;     // knocks and grain
        double strength = 1.0;  // of all their cues, 0 to 1
    } pads;
    struct Marks {
        bool ask_name = true;  // a new mark's name may be typed at once
        int button = 2;        // of the device, that sets a mark; 0 to 8, 0 is none
    } marks;
    // Being led by the hand, which happens only when it is asked for.
    struct Guidance {
        bool pull = true;       // "take me there" pulls the hand; else it sets the beacon
        double strength = 1.0;  // of its limits, 0.1 to 1
        bool fades = true;      // less help lap by lap as errors fall
        bool grooves = false;   // the floor has grooves along the planned way and through doorways
        bool along_way = true;  // beacon, warmer and lines lead along the way on foot; else straight to the thing
    } guidance;
    struct Keyboard {
        KeyboardHand hand = KeyboardHand::Both;
    } keyboard;
    struct Welcome {
        bool done = false;  // the first minutes, which a first start begins with
        int step = 0;       // where they go on, 0 to 20
    } welcome;
    std::map<std::string, DeviceProfile> profiles;  // by profile_key()
    std::set<std::string>
        damaged_profiles;  // found in the person's file and set aside; their devices get the light ceiling
    std::map<std::string, std::string>
        keys;  // command name -> key name, only where they differ from the built-in table
};

// Where a value came from, weakest first. What a stronger source says of a setting also counts more than what a weaker
// one says of it for one device ([workspace.device] or [profile]).
enum class SettingSource { Default, UserFile, World, CommandLine, Live };

struct SettingRow {
    std::string key;      // "workspace.scale"
    std::string value;    // as TOML writes it
    std::string unit;     // "world metres per hand metre" in the language spoken, or empty
    std::string range;    // "1 to 500"
    std::string meaning;  // one sentence
    SettingSource source = SettingSource::Default;
    std::string origin;  // file and line, "--set", or empty
};

// Settings with their provenance. Every source keeps its own layer and the strongest one wins, whatever the order of
// loading; so leaving a world gives back what it had changed. App thread only. Costs: reading a file is a few hundred
// microseconds; values() is free.
class SettingsStore {
public:
    // command_words: what [keys] may name; any name is taken when there are none.
    explicit SettingsStore(std::vector<std::string> command_words = {});
    ~SettingsStore();
    SettingsStore(SettingsStore&&) noexcept;
    SettingsStore& operator=(SettingsStore&&) noexcept;

    const Settings& values() const;
    // Reads a TOML file by `toml` as the layer `source`, in place of what that layer held. A damaged or unreadable file
    // changes nothing; an unknown key, a wrong type or a value out of range is a diagnostic naming the nearest key or
    // legal range, and the rest applies. A missing file is no problem. A profile with a value that cannot be is set
    // aside as a whole, with one sentence. A world may set only what world_may_set() allows: never a force or a speech
    // setting.
    std::vector<Diagnostic> load_file(const std::filesystem::path& path, SettingSource source,
                                      const TomlReader& toml = toml_of);
    // One setting, from the command line, a world's own key, or a live change. Fails naming the nearest key or the
    // legal range.
    Result<void> set(std::string_view key, std::string_view value, SettingSource source);
    // "workspace.scale=40", as --set takes it.
    Result<void> set_assignment(std::string_view assignment, SettingSource source);
    // Forgets what one source said, as when a world is left.
    void clear(SettingSource source);
    // What `other` has of that source, in place of what there was: read elsewhere, as beside a world that is loading.
    void take_layer(SettingSource source, SettingsStore other);
    // Every setting in table order, then the entries of [workspace.device], [profile] and [keys].
    std::vector<SettingRow> explain() const;
    // Saves live changes into the person's file, which keeps everything else it holds, unknown keys and comments too.
    // Does nothing when there were no live changes. A file that cannot be read or understood is never replaced.
    Result<void> save_user_file();
    // The same in two steps, for who writes on another thread: what save_user_file() would write now; nothing where the
    // file says it already.
    struct ToSave {
        std::filesystem::path file;
        std::string text;
    };
    Result<std::optional<ToSave>> to_save() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

// One setting of plain Settings: its value as TOML writes it, for rows of the table only, and a change of any key like
// SettingsStore::set. Both fail naming the nearest key, a change also the legal range.
Result<std::string> setting_text(const Settings& settings, std::string_view key);
Result<void> change_setting(Settings& settings, std::string_view key, std::string_view value);

// The file with a world's own settings: house.settings.toml next to house.map. Empty for a world that has no file.
std::filesystem::path settings_beside(const std::filesystem::path& world);
// True if a world file may set this key.
bool world_may_set(std::string_view key);

// The name that a device's profile goes by: "falcon a9001", or "sim-t" where there is no serial number. Lower case.
std::string profile_key(std::string_view device_name, std::string_view serial);

// "default", "world", ...
std::string source_name(SettingSource source);

// $XDG_CONFIG_HOME/handrail/settings.toml, else ~/.config/handrail/settings.toml; empty when neither is known.
std::filesystem::path user_settings_path();

}  // namespace handrail
