// What the command line can do, one function per subcommand. Each returns the exit status: 0 ok, 1 the thing asked for
// failed, 2 wrong usage. Errors go to `err` as one sentence a person can act on. main.cpp only parses and dispatches;
// tests call these directly.
#pragma once

#include <filesystem>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "app/wizard/wizard.h"
#include "settings/settings.h"
#include "worlds/readers/reader.h"

namespace handrail {

// Options that every command takes.
struct CommonArguments {
    std::optional<double> map_scale_m_per_unit;  // --map-scale, default 1/32 for every .map
    std::optional<double> unit_m;                // --unit: of a file that states none

    ReadOptions read_options() const {
        ReadOptions options;
        if (map_scale_m_per_unit) options.map_metres_per_unit = *map_scale_m_per_unit;
        if (unit_m) options.map_metres_per_unit = options.obj_metres_per_unit = *unit_m;
        options.unit_is_known = map_scale_m_per_unit || unit_m;
        return options;
    }
    // The same, with what a person has said of this world before. See keep_unit.
    ReadOptions read_options(const std::filesystem::path& world) const;
};

struct InfoArguments {
    CommonArguments common;
    std::filesystem::path world;
    bool json = false;
    bool lint = false;  // --lint: only whether the materials can be told apart
    std::string scale;  // --scale: also what is felt otherwise at it, by its name or world metres per hand metre
};
int run_info(const InfoArguments& arguments, std::ostream& out, std::ostream& err);

struct TouchArguments {
    CommonArguments common;
    std::filesystem::path world, path_csv, out_csv;
    double radius_m = 0.005;                // --radius; 0 means 1e-5
    double scale_world_m_per_hand_m = 1.0;  // --scale
    std::optional<double> stiffness_n_per_m, damping_ns_per_m, friction_static, friction_kinetic;
    std::optional<std::string> device;  // --device
};
int run_touch(const TouchArguments& arguments, std::ostream& out, std::ostream& err);

struct ScenarioArguments {
    CommonArguments common;
    std::vector<std::filesystem::path> paths;          // files, or folders of *.toml
    std::optional<std::filesystem::path> junit;        // --junit
    std::optional<std::filesystem::path> transcripts;  // --transcripts: a folder; one text a scenario is written there
};
int run_scenarios(const ScenarioArguments& arguments, std::ostream& out, std::ostream& err);

// How fast and how exact the touch renderer is, beside others.
struct BenchArguments {
    bool json = false, quick = false;
    std::string scene;                        // --scene: only scenes and families named like this
    std::vector<std::filesystem::path> maps;  // --map: besides the worlds that ship with the program
    std::optional<std::filesystem::path> svg_folder, markdown, instructions;
    std::optional<double> seconds;     // --seconds of the servo thread; 60, or 1 with --quick
    std::optional<std::string> count;  // --count RENDERER: its ticks on the first scene alone, for callgrind
    bool list = false;                 // --list: the scenes' names
};
int run_bench_command(const BenchArguments& arguments, std::ostream& out, std::ostream& err);

struct SettingsArguments {
    bool explain = false;
};
int run_settings(const SettingsArguments& arguments, SettingsStore& settings, std::ostream& out, std::ostream& err);

struct DevicesArguments {
    bool json = false;
};
int run_devices(const DevicesArguments& arguments, std::ostream& out, std::ostream& err);

struct ExploreArguments {
    CommonArguments common;
    std::optional<std::filesystem::path> world;        // none: the bundled first world
    bool no_window = false;                            // --no-window
    std::optional<std::string> device;                 // --device NAME|SERIAL|none
    std::optional<std::string> left_device;            // --device once more
    std::optional<std::vector<WizardPart>> calibrate;  // `handrail calibrate`: these parts of the set-up and no world
    std::vector<Diagnostic> settings_problems;         // met while reading the settings; to be spoken, not only printed
};
int run_explore(const ExploreArguments& arguments, SettingsStore& settings, std::ostream& out, std::ostream& err);

}  // namespace handrail
