// Declares the commands of the command line: one function per subcommand. Each returns the exit status: 0 for success,
// 1 if the request failed, 2 for wrong usage. Errors go to `err` as one sentence that a person can act on. main.cpp
// only parses the command line and calls these functions; tests call them directly. `progress` reports long work,
// except if the output is JSON.
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

// Options that every command accepts.
struct CommonArguments {
    std::optional<double> map_scale_m_per_unit;  // --map-scale, default 1/32 for every .map
    std::optional<double> unit_m;                // --unit in metres, for a file that states no unit
    std::string building;                        // --building, for a file with several buildings
    std::filesystem::path data_in;               // folder of the person's data; empty: user_data_folder()

    // Returns a request for `world` with these options.
    core::WorldRequest request(std::filesystem::path world) const {
        return {std::move(world), map_scale_m_per_unit, unit_m, building};
    }
    std::filesystem::path data_folder() const;
    // Returns how a reader should read `world`. The options include what a person has stated about this world in
    // earlier sessions.
    readers::ReadOptions read_options(const std::filesystem::path& world) const;
};

struct InfoArguments {
    CommonArguments common;
    std::filesystem::path world;
    bool json = false;
    bool lint = false;      // --lint: checks only whether a hand can tell the materials apart
    bool as_words = false;  // --as-words: writes the rooms as a room description, in the format that Handrail can read
    std::string language;   // --language, the language of the room description; empty: the spoken language
    // --scale: also lists what is simplified at this scale. The scale is a name, or a number of world metres per hand
    // metre.
    std::string scale;
};
int run_info(const InfoArguments& arguments, std::ostream& out, std::ostream& err, const LongWork& progress = {});

// `handrail check`: lists what an author or instructor should correct in a world.
struct CheckArguments {
    CommonArguments common;
    std::filesystem::path world;
    bool json = false;
};
// Checks the world. Returns 1 if the world cannot be read, and also if it has a fault that stops or misleads people.
int run_check(const CheckArguments& arguments, std::ostream& out, std::ostream& err, const LongWork& progress = {});

struct TouchArguments {
    CommonArguments common;
    std::filesystem::path world, path_csv, out_csv;
    double radius_m = 0.005;                // --radius of the proxy; 0 stands for 1e-5 m
    double scale_world_m_per_hand_m = 1.0;  // --scale, in world metres per hand metre
    std::optional<double> stiffness_n_per_m, damping_ns_per_m, friction_static, friction_kinetic;
    std::optional<std::string> device;  // --device; the limits of this device apply
};
int run_touch(const TouchArguments& arguments, std::ostream& out, std::ostream& err, const LongWork& progress = {});

struct ScenarioArguments {
    CommonArguments common;
    std::vector<std::filesystem::path> paths;          // scenario files, or folders of *.toml
    std::optional<std::filesystem::path> junit;        // --junit: file for the results
    std::optional<std::filesystem::path> transcripts;  // --transcripts: folder that receives one text for each scenario
};
int run_scenarios(const ScenarioArguments& arguments, std::ostream& out, std::ostream& err,
                  const LongWork& progress = {});

// `handrail export`: writes a storey as a tactile sheet or a printed model, or writes a route card.
struct ExportArguments {
    CommonArguments common;
    std::filesystem::path world;
    // --swell: .svg, with separate files for the key, or .pdf that contains the key.
    std::optional<std::filesystem::path> swell;
    std::optional<std::filesystem::path> stl;         // --stl: file for a printed model
    std::optional<std::filesystem::path> route_card;  // --route-card: .brf or .txt
    std::optional<std::filesystem::path> page;        // --page: the building as a page for browsers, .html
    // --from and --to of the route card; without --from: from the base; without --to: to every room.
    std::optional<std::string> from, to;
    settings::Settings settings;  // the person's settings, for example whether distances are in steps or metres
    std::optional<int> storey;    // --storey, counted from 1; none: the storey with the base
    std::string paper = "a4";     // --paper: "a4" or "a3"
    std::string braille;          // --braille: name of a table; empty: grade 1 of the spoken language
    bool sheets = false;  // --sheets: splits the plan into several sheets if a single sheet cannot keep its promises
    std::optional<std::string> around;  // --around: keeps only the sheets that show this room
    bool coarse = false;                // --coarse: leaves out objects, and the signs of small rooms
    // --strip: also writes a page of samples, from which people choose the signs that they can feel.
    bool strip = false;
    bool force = false;  // --force: replaces existing files
};
int run_export(const ExportArguments& arguments, std::ostream& out, std::ostream& err, const LongWork& progress = {});

// `handrail bench`: measures in one world how steadily the servo runs on this machine, and how long a tick takes.
struct BenchArguments {
    CommonArguments common;
    std::optional<std::filesystem::path> world;  // none: the house that is shipped with the program
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

// `handrail replay`: plays back a recorded session, computes the session again, or converts it to other formats.
struct ReplayArguments {
    std::optional<std::filesystem::path> folder;    // none: the newest recording in the data folder
    double speed = 1.0;                             // --speed, 0.5 to 4
    bool check = false;                             // --check: computes the session again
    std::optional<std::filesystem::path> csv;       // --csv: a folder for tables of the recorded numbers
    std::optional<std::filesystem::path> scenario;  // --scenario: a scenario file to write
};
// Returns the folder in `folder` with the newest name, because names begin with the time; empty if there is none.
std::filesystem::path newest_in(const std::filesystem::path& folder);
int run_replay(const ReplayArguments& arguments, const settings::Settings& settings, std::ostream& out,
               std::ostream& err, const LongWork& progress = {});

// `handrail learner`: manages the learners and what they have agreed to.
struct LearnerArguments {
    std::string action = "list";           // what to do: list, new, show, consent, diary or delete
    std::string name = {};                 // chosen name or id of the learner
    std::string give = {}, withdraw = {};  // purposes of the consent that is given or withdrawn, joined by commas
    std::string by = {}, until = {};       // who gives the consent, and until when
    std::filesystem::path to = {};         // file of an exported diary
    bool yes = false;                      // the command asks no questions
};
// Asks questions on `out` and reads the answers as lines from `in`. Returns 1 if the request failed, if nobody agreed,
// or if some data could not be deleted.
int run_learner(const LearnerArguments& arguments, std::istream& in, std::ostream& out, std::ostream& err,
                const LongWork& progress = {});

// `handrail report`: describes a recorded session, or all sessions of a learner.
struct ReportArguments {
    std::optional<std::filesystem::path> folder;           // none: the newest recording in the data folder
    std::optional<std::filesystem::path> html, csv, json;  // files to write
    std::string learner;  // --learner; without `folder`, the report covers all sessions of that learner
    bool force = false;   // replaces existing files
};
// Returns 0 if the report was written. Returns 1 if the recording or its world cannot be read, or if a file exists
// already. Returns 2 if no output was requested.
int run_report(const ReportArguments& arguments, std::ostream& out, std::ostream& err, const LongWork& progress = {});

// `handrail lesson`: runs a lesson that an instructor has written.
struct LessonArguments {
    std::filesystem::path file;  // the lesson file; "watch" opens the instructor's desk instead
    // --session, counted from 1; none: the next one for the learner, else the first.
    std::optional<std::size_t> session;
    std::string learner;    // --learner
    bool check = false;     // --check: tries the lesson with simulated pupils
    bool protocol = false;  // --protocol: prints the lesson's protocol
};
// A lesson that is to be taught, with its world, its session and its learner.
struct LessonToTeach {
    std::shared_ptr<teaching::TaughtWorld> world;
    std::size_t session = 0;
    teaching::LearnerName learner;
};
struct ExploreArguments {
    CommonArguments common;
    std::optional<LessonToTeach> lesson;
    std::optional<std::filesystem::path> world;  // none: the first of the worlds that are shipped with the program
    std::string at;                              // --at: name of the place to start at; empty: the base
    bool no_window = false;                      // --no-window: opens no window
    std::optional<std::string> device;           // --device NAME|SERIAL|none
    std::optional<std::string> left_device;      // the second --device, for the left hand
    // If set, the program is `handrail calibrate`: the session consists only of these parts of the set-up, without a
    // world.
    std::optional<std::vector<wizard::WizardPart>> calibrate;
    std::optional<std::filesystem::path> record_in;  // --record or --record-in: folder for the recordings
    std::string learner;             // --learner: chosen name or id; empty: the session is for no named learner
    bool remember = false;           // the learner has agreed that the program remembers progress
    std::vector<std::string> lines;  // lines to carry out before those from standard input
    std::string program_version;
    // Settings that apply while the person is in the lesson's world.
    std::vector<std::pair<std::string, std::string>> lesson_settings;
    std::vector<std::string> news;              // sentences that are announced with the welcome
    std::vector<Diagnostic> settings_problems;  // faults of the settings file; announced as well as printed
};
// Runs `handrail lesson`. Returns the exit status. Returns nothing if the lesson is to be taught in a session;
// `explore` then contains the arguments of that session. Defined in lesson_command.cpp.
std::optional<int> run_lesson(const LessonArguments& arguments, ExploreArguments& explore, std::ostream& out,
                              std::ostream& err, const LongWork& progress = {});
// How a session ended, and for whom the next session runs.
struct ExploreEnd {
    int status = 0;
    // Id of the learner for whom the program continues; empty: it continues for nobody named; none: the program ends.
    std::optional<std::string> learner;
    core::WorldRequest world;        // the world that the session was in
    std::vector<std::string> lines;  // lines that were read but not yet carried out
};
ExploreEnd run_explore(const ExploreArguments& arguments, settings::SettingsStore& settings, std::ostream& err,
                       const LongWork& progress = {});

}  // namespace handrail::program
