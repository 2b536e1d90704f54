// What the command line can do, one function per subcommand. Each returns the exit status: 0 ok, 1 the thing asked for
// failed, 2 wrong usage. Errors go to `err` as one sentence a person can act on. main.cpp only parses and dispatches;
// tests call these directly. `progress` is told what takes long, but not where JSON is asked for.
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

namespace handrail {

class TaughtWorld;

// Options that every command takes.
struct CommonArguments {
    std::optional<double> map_scale_m_per_unit;  // --map-scale, default 1/32 for every .map
    std::optional<double> unit_m;                // --unit: of a file that states none
    std::string building;                        // --building: of a file with several
    std::filesystem::path data_in;               // where what is kept lies; empty: user_data_folder()

    // That world, as these options have it.
    WorldRequest request(std::filesystem::path world) const {
        return {std::move(world), map_scale_m_per_unit, unit_m, building};
    }
    std::filesystem::path data_folder() const;
    // How a reader is asked for that world, with what a person has said of it before.
    ReadOptions read_options(const std::filesystem::path& world) const;
};

struct InfoArguments {
    CommonArguments common;
    std::filesystem::path world;
    bool json = false;
    bool lint = false;      // --lint: only whether the materials can be told apart
    bool as_words = false;  // --as-words: the rooms as a text that is read again
    std::string language;   // --language: of that text; empty: the one spoken
    std::string scale;      // --scale: also what is felt otherwise at it, by its name or world metres per hand metre
};
int run_info(const InfoArguments& arguments, std::ostream& out, std::ostream& err, const LongWork& progress = {});

// What an author or instructor should mend.
struct CheckArguments {
    CommonArguments common;
    std::filesystem::path world;
    bool json = false;
};
// 1 also when a fault stops or misleads people.
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
    std::optional<std::filesystem::path> transcripts;  // --transcripts: a folder; one text a scenario is written there
};
int run_scenarios(const ScenarioArguments& arguments, std::ostream& out, std::ostream& err,
                  const LongWork& progress = {});

// A storey for the fingers.
struct ExportArguments {
    CommonArguments common;
    std::filesystem::path world;
    std::optional<std::filesystem::path> swell;       // --swell: .svg, with the key beside it, or .pdf
    std::optional<std::filesystem::path> stl;         // --stl
    std::optional<std::filesystem::path> route_card;  // --route-card: .brf or .txt
    std::optional<std::string> from, to;              // --from, --to: of the card; none: the base, every room
    Settings settings;                                // the person's: steps or metres, what is told on the way
    std::optional<int> storey;                        // --storey from 1; none: the one with the base
    std::string paper = "a4";                         // --paper
    std::string braille;                              // --braille; empty: grade 1 of the language spoken
    bool sheets = false;                              // --sheets: several, where one does not keep its promises
    std::optional<std::string> around;                // --around: of several only those with this room
    bool coarse = false;                              // --coarse: without things and signs of small rooms
    bool strip = false;                               // --strip: also samples to choose from
    bool force = false;                               // --force: files that are there are replaced
};
int run_export(const ExportArguments& arguments, std::ostream& out, std::ostream& err, const LongWork& progress = {});

// How steadily the servo runs on this machine, and how long a tick takes, in one world.
struct BenchArguments {
    CommonArguments common;
    std::optional<std::filesystem::path> world;  // none: the house that ships with the program
    std::optional<double> seconds;               // --seconds; none: 10
    bool json = false;
};
int run_bench_command(const BenchArguments& arguments, std::ostream& out, std::ostream& err,
                      const LongWork& progress = {});

struct SettingsArguments {
    bool explain = false;
};
int run_settings(const SettingsArguments& arguments, SettingsStore& settings, std::ostream& out, std::ostream& err);

struct DevicesArguments {
    bool json = false;
};
int run_devices(const DevicesArguments& arguments, std::ostream& out, std::ostream& err);

// A recorded session: heard again, or computed again, or written otherwise.
struct ReplayArguments {
    std::optional<std::filesystem::path> folder;    // none: the newest of the data folder
    double speed = 1.0;                             // --speed, 0.5 to 4
    bool check = false;                             // --check
    std::optional<std::filesystem::path> csv;       // --csv: a folder of tables with the numbers themselves
    std::optional<std::filesystem::path> scenario;  // --scenario: a scenario file
};
// The newest folder in there, by its name; empty: there is none.
std::filesystem::path newest_in(const std::filesystem::path& folder);
int run_replay(const ReplayArguments& arguments, const Settings& settings, std::ostream& out, std::ostream& err,
               const LongWork& progress = {});

// `handrail learner`: who learns, and what they have agreed to.
struct LearnerArguments {
    std::string action = "list";           // list, new, show, consent, delete
    std::string name = {};                 // chosen name or id
    std::string give = {}, withdraw = {};  // purposes joined by commas
    std::string by = {}, until = {};       // of what is given
    bool yes = false;                      // nothing is asked
};
// Asks and is answered in lines of `in`. 1: what was asked for failed, nothing was agreed to, or something is left.
int run_learner(const LearnerArguments& arguments, std::istream& in, std::ostream& out, std::ostream& err,
                const LongWork& progress = {});

// `handrail report`: what a recorded session was like.
struct ReportArguments {
    std::optional<std::filesystem::path> folder;           // none: the newest of the data folder
    std::optional<std::filesystem::path> html, csv, json;  // files to be written
    std::string learner;                                   // whose; without a folder: of all sessions of that learner
    bool force = false;                                    // files that are there are replaced
};
// 0: written. 1: the recording or its world cannot be read, or a file is there already. 2: nothing was asked for.
int run_report(const ReportArguments& arguments, std::ostream& out, std::ostream& err, const LongWork& progress = {});

// `handrail lesson`: a lesson of an instructor.
struct LessonArguments {
    std::filesystem::path file;          // "watch": the desk
    std::optional<std::size_t> session;  // --session, from 1; none: what comes next for the learner, else the first
    std::string learner;                 // --learner
    bool check = false;                  // --check
    bool protocol = false;               // --protocol
};
// In its world, for who learns.
struct LessonToTeach {
    std::shared_ptr<TaughtWorld> world;
    std::size_t session = 0;
    LearnerName learner;
};
struct ExploreArguments {
    CommonArguments common;
    std::optional<LessonToTeach> lesson;
    std::optional<std::filesystem::path> world;        // none: the bundled first world
    bool no_window = false;                            // --no-window
    std::optional<std::string> device;                 // --device NAME|SERIAL|none
    std::optional<std::string> left_device;            // --device once more
    std::optional<std::vector<WizardPart>> calibrate;  // `handrail calibrate`: these parts of the set-up and no world
    std::optional<std::filesystem::path> record_in;    // --record, --record-in: where recordings lie
    std::string learner;                               // --learner: chosen name or id; empty: nobody by name
    bool remember = false;                             // the learner wants what was learnt to be kept
    std::vector<std::string> lines;                    // to be done before those of standard input
    std::string program_version;
    std::vector<std::pair<std::string, std::string>> lesson_settings;  // while one is in the lesson's world
    std::vector<std::string> news;                                     // to be said with the welcome
    std::vector<Diagnostic> settings_problems;  // met while reading the settings; to be spoken, not only printed
};
// See lesson_command.cpp.
std::optional<int> run_lesson(const LessonArguments& arguments, ExploreArguments& explore, std::ostream& out,
                              std::ostream& err, const LongWork& progress = {});
// How it ended: for good, or because somebody else is to be here.
struct ExploreEnd {
    int status = 0;
    std::optional<std::string> learner;  // who, by id; empty: nobody by name. None: it ended for good
    WorldRequest world;                  // that one was in
    std::vector<std::string> lines;      // that were read and not done yet
};
ExploreEnd run_explore(const ExploreArguments& arguments, SettingsStore& settings, std::ostream& err,
                       const LongWork& progress = {});

}  // namespace handrail
