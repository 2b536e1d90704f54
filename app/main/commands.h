// What the command line can do: one function per subcommand. Each returns the exit status: 0 for success, 1 if the
// request failed, 2 for wrong usage. Errors go to `err` as one sentence that a person can act on. main.cpp only parses
// and dispatches; tests call these functions directly. `progress` reports long work, except if the output is JSON.
#pragma once

#include <filesystem>
#include <istream>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "app/core/dialogue/words.h"
#include "app/core/kept/world_request.h"
#include "app/main/long_work.h"
#include "app/teaching/learner_name.h"
#include "app/wizard/wizard_part.h"
#include "settings/settings.h"
#include "worlds/readers/reader.h"

namespace handrail::teaching {
class TaughtWorld;
}

namespace handrail::program {

// Options that every command takes.
struct CommonArguments {
    std::optional<double> map_scale_m_per_unit;  // --map-scale, default 1/32 for every .map
    std::optional<double> unit_m;                // --unit, for a file that states none
    std::string building;                        // --building, for a file with several
    std::filesystem::path data_in;               // folder of the person's data; empty: user_data_folder()

    // A request for that world with these options.
    core::WorldRequest request(std::filesystem::path world) const {
        return {std::move(world), map_scale_m_per_unit, unit_m, building};
    }
    std::filesystem::path data_folder() const;
    // How a reader should read that world, including what a person has said about it before.
    readers::ReadOptions read_options(const std::filesystem::path& world) const;
};

struct InfoArguments {
    CommonArguments common;
    std::filesystem::path world;
    bool json = false;
    bool lint = false;      // --lint: checks only whether the materials can be told apart
    bool as_words = false;  // --as-words: writes the rooms as a text that can be read in again
    std::string language;   // --language, of that text; empty: the spoken one
    // --scale: also lists what is simplified at this scale, given by name or in world metres per hand metre.
    std::string scale;
};
int run_info(const InfoArguments& arguments, std::ostream& out, std::ostream& err, const LongWork& progress = {});

// Lists what an author or instructor should mend.
struct CheckArguments {
    CommonArguments common;
    std::filesystem::path world;
    bool json = false;
};
// Returns 1 also if a fault stops or misleads people.
int run_check(const CheckArguments& arguments, std::ostream& out, std::ostream& err, const LongWork& progress = {});

struct TouchArguments {
    CommonArguments common;
    std::filesystem::path world, path_csv, out_csv;
    double radius_m = 0.005;                // --radius; 0 means 1e-5
    double scale_world_m_per_hand_m = 1.0;  // --scale
    std::optional<double> stiffness_n_per_m, damping_ns_per_m, friction_static, friction_kinetic;
    std::optional<std::string> device;  // --device
};
int run_touch(const TouchArguments& arguments, std::ostream& out, std::ostream& err, const LongWork& progress = {});

struct ScenarioArguments {
    CommonArguments common;
    std::vector<std::filesystem::path> paths;          // files, or folders of *.toml
    std::optional<std::filesystem::path> junit;        // --junit
    std::optional<std::filesystem::path> transcripts;  // --transcripts: a folder; each scenario writes one text there
};
int run_scenarios(const ScenarioArguments& arguments, std::ostream& out, std::ostream& err,
                  const LongWork& progress = {});

// Writes a storey as something to touch on paper or as a printed model.
struct ExportArguments {
    CommonArguments common;
    std::filesystem::path world;
    std::optional<std::filesystem::path> swell;       // --swell: .svg, with a separate file for the key, or .pdf
    std::optional<std::filesystem::path> stl;         // --stl
    std::optional<std::filesystem::path> route_card;  // --route-card: .brf or .txt
    std::optional<std::string> from, to;  // --from, --to of the route card; none: from the base, to every room
    settings::Settings settings;          // the person's: steps or metres, what is announced on the way
    std::optional<int> storey;            // --storey, counted from 1; none: the one with the base
    std::string paper = "a4";             // --paper
    std::string braille;                  // --braille; empty: grade 1 of the spoken language
    bool sheets = false;  // --sheets: splits the plan into several sheets if one cannot meet its guarantees
    std::optional<std::string> around;  // --around: keeps only the sheets that show this room
    bool coarse = false;                // --coarse: leaves out things, and the signs of small rooms
    bool strip = false;                 // --strip: also writes samples to choose from
    bool force = false;                 // --force: replaces existing files
};
int run_export(const ExportArguments& arguments, std::ostream& out, std::ostream& err, const LongWork& progress = {});

// Measures how steadily the servo runs on this machine, and how long a tick takes, in one world.
struct BenchArguments {
    CommonArguments common;
    std::optional<std::filesystem::path> world;  // none: the house that comes with the program
    std::optional<double> seconds;               // --seconds; none: 10
    bool json = false;
};
int run_bench_command(const BenchArguments& arguments, std::ostream& out, std::ostream& err,
                      const LongWork& progress = {});

struct SettingsArguments {
    bool explain = false;
};
int run_settings(const SettingsArguments& arguments, settings::SettingsStore& settings, std::ostream& out,
                 std::ostream& err);

struct DevicesArguments {
    bool json = false;
};
int run_devices(const DevicesArguments& arguments, std::ostream& out, std::ostream& err);

// Plays back a recorded session, computes it again, or converts it.
struct ReplayArguments {
    std::optional<std::filesystem::path> folder;    // none: the newest in the data folder
    double speed = 1.0;                             // --speed, 0.5 to 4
    bool check = false;                             // --check
    std::optional<std::filesystem::path> csv;       // --csv: a folder for tables of the numbers themselves
    std::optional<std::filesystem::path> scenario;  // --scenario: a scenario file
};
// The newest folder in `folder`, judged by its name; empty if there is none.
std::filesystem::path newest_in(const std::filesystem::path& folder);
int run_replay(const ReplayArguments& arguments, const settings::Settings& settings, std::ostream& out,
               std::ostream& err, const LongWork& progress = {});

// `handrail learner`: who learns, and what they have agreed to.
struct LearnerArguments {
    std::string action = "list";           // list, new, show, consent, delete
    std::string name = {};                 // chosen name or id
    std::string give = {}, withdraw = {};  // purposes joined by commas
    std::string by = {}, until = {};       // of the consent that is given
    bool yes = false;                      // asks no questions
};
// Asks questions on `out` and reads the answers as lines from `in`. Returns 1 if the request failed, nothing was agreed
// to, or some data could not be deleted.
int run_learner(const LearnerArguments& arguments, std::istream& in, std::ostream& out, std::ostream& err,
                const LongWork& progress = {});

// `handrail report`: describes a recorded session.
struct ReportArguments {
    std::optional<std::filesystem::path> folder;           // none: the newest in the data folder
    std::optional<std::filesystem::path> html, csv, json;  // files to write
    std::string learner;  // --learner; without a folder: covers all sessions of that learner
    bool force = false;   // replaces existing files
};
// Returns 0 if the report is written. 1: the recording or its world cannot be read, or a file exists already. 2: no
// output was requested.
int run_report(const ReportArguments& arguments, std::ostream& out, std::ostream& err, const LongWork& progress = {});

// `handrail lesson`: runs a lesson that an instructor has written.
struct LessonArguments {
    std::filesystem::path file;          // "watch" opens the desk instead
    std::optional<std::size_t> session;  // --session, from 1; none: the next one for the learner, else the first
    std::string learner;                 // --learner
    bool check = false;                  // --check
    bool protocol = false;               // --protocol
};
// A lesson to be taught, with its world and its learner.
struct LessonToTeach {
    std::shared_ptr<teaching::TaughtWorld> world;
    std::size_t session = 0;
    teaching::LearnerName learner;
};
struct ExploreArguments {
    CommonArguments common;
    std::optional<LessonToTeach> lesson;
    std::optional<std::filesystem::path> world;  // none: the first of the worlds that come with the program
    bool no_window = false;                      // --no-window
    std::optional<std::string> device;           // --device NAME|SERIAL|none
    std::optional<std::string> left_device;      // second --device
    // `handrail calibrate`: only these parts of the set-up, without a world.
    std::optional<std::vector<wizard::WizardPart>> calibrate;
    std::optional<std::filesystem::path> record_in;  // --record, --record-in: folder of the recordings
    std::string learner;                             // --learner: chosen name or id; empty: no named learner
    bool remember = false;                           // the learner has agreed that progress is kept
    std::vector<std::string> lines;                  // run before those from standard input
    std::string program_version;
    // Apply while the person is in the lesson's world.
    std::vector<std::pair<std::string, std::string>> lesson_settings;
    std::vector<std::string> news;              // announced with the welcome
    std::vector<Diagnostic> settings_problems;  // met while reading the settings; announced as well as printed
};
// Defined in lesson_command.cpp.
std::optional<int> run_lesson(const LessonArguments& arguments, ExploreArguments& explore, std::ostream& out,
                              std::ostream& err, const LongWork& progress = {});
// How a session ended: for good, or because another learner takes over.
struct ExploreEnd {
    int status = 0;
    std::optional<std::string> learner;  // id of the next learner; empty: nobody named; none: it ended for good
    core::WorldRequest world;            // the world that the session was in
    std::vector<std::string> lines;      // read but not yet carried out
};
ExploreEnd run_explore(const ExploreArguments& arguments, settings::SettingsStore& settings, std::ostream& err,
                       const LongWork& progress = {});

}  // namespace handrail::program
