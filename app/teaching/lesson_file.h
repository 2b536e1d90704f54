// Reads and writes lesson files (NAME.lesson.toml). A lesson contains what an instructor wants a learner to learn about
// a world, as sessions made of steps. taught_world.h looks up the lesson's names in the world, and teaching_run.h runs
// the lesson. docs/lessons.md is the reference for the format. Pure functions; any thread.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/core/context/lesson_draft.h"
#include "app/core/scenario/scenario.h"
#include "settings/toml_value.h"
#include "worlds/base/language.h"
#include "worlds/base/result.h"
#include "worlds/base/vec.h"

namespace handrail::teaching {

// A text with its translations, such as say and say_de.
struct LessonText {
    std::string text;
    OtherLanguages others;
    std::string spoken() const { return in_spoken_language(text, others); }
};

// An object or a room by its name in the world, or another place with a name of its own.
struct LessonPlace {
    std::string name;  // the name as announced; for an object or a room, it is the name in the world
    std::string thing, room;
    std::optional<Vec3> place_m;  // position at the height of the soles
    int line = 0;
};

struct LessonRoute {
    std::string name;
    std::vector<LessonPlace> stops;  // places where the route stops, at least one; the route begins at the base
    int line = 0;
};

enum class StepKind : std::uint8_t { Learn, Go, Free, Point, Distance, Order, Question };
inline constexpr std::array<const char*, 7> kStepWords = {"learn", "go", "free", "point", "distance", "order", "ask"};

struct TaughtStep {
    StepKind kind = StepKind::Free;
    LessonText say;    // text that is announced before the step's own text; may be empty
    std::string room;  // for Learn: the room to learn
    // For Learn: the step is complete when the learner knows this share of the walls and this number of exits; 0: when
    // the learner says so.
    int walls_percent = 0, exits = 0;
    std::string route;                 // for Go: name of the route
    std::vector<int> help_percent{0};  // for Go: help in each lap, in percent; the last is 0
    std::vector<std::string> block;    // for Go: names of doors that are shut and cannot be opened
    double off_route_m = 2.0;  // for Go: if the learner is farther than this from the route, it is an error of the lap
    // For Point and Distance: the place at which the learner answers: "base" or the name of a place.
    std::string from;
    std::vector<std::string> to;  // for Point and Distance: the targets; for Order: the items in the right order
    // For Distance: true: the question is about the distance along the route; false: about the straight distance.
    bool along_way = false;
    // For Point: an answer passes if its error is at most this; none: answers cannot fail.
    std::optional<double> pass_deg;
    // For Question: answers are whole numbers in this range; none: answers are words.
    std::optional<std::array<int, 2>> scale;
    int line = 0;
};

struct TaughtSession {
    std::string name;
    int minutes = 0;  // planned duration, which is announced but not enforced; 0: not announced
    bool shuffle = false;
    std::map<std::string, std::string> settings;  // settings that are the conditions of a study
    std::vector<TaughtStep> steps;
    int line = 0;
};

// What a scripted pupil must achieve, in addition to the expectations of scenarios. The expectation is a range for
// either a measure or a strategy's share of the time. A measure belongs to a route or an answer in one step, and has
// the same key as in reports.
struct PupilExpectation {
    std::string measure;   // key of report_measures(), or "reached" or "detour"
    std::string strategy;  // "perimeter", "grid", "object" or "base"
    int step = 0;          // number of the step that has this measure, from 1; 0: the first such step
    double at_least = -1e300, at_most = 1e300;
    int line = 0;
};
struct LessonPupil {
    std::string name, session;
    std::vector<core::ScenarioAction> actions;
    std::vector<core::Expectation> expectations;
    std::vector<PupilExpectation> measured;
    int line = 0;
};

struct LessonFile {
    static constexpr int kForm = 1;
    static constexpr std::size_t kMostSessions = 20, kMostSteps = 100, kMostPlaces = 200;

    std::filesystem::path file;
    LessonText title;
    std::string world_name;           // name of the world as in the lesson file
    std::filesystem::path world;      // path at which the world's file was found
    std::string world_checksum;       // checksum of the world's file when the lesson was written; empty: unknown
    std::optional<Vec3> base_feet_m;  // where the soles are at the lesson's base; none: at the start of the world
    double base_heading_rad = 0.0;
    std::string base_name;
    std::map<std::string, std::string> settings;
    std::vector<LessonPlace> landmarks;  // at least one landmark
    std::vector<LessonRoute> routes;
    std::vector<TaughtSession> sessions;  // at least one session
    std::vector<LessonPupil> pupils;

    const LessonRoute* route(std::string_view name) const;
};

// Reads a lesson. If there are mistakes, fails with a sentence with file and line for each of them. Searches for the
// world in the same way as for scenarios.
Result<LessonFile> read_lesson(const std::filesystem::path& file,
                               const std::vector<std::filesystem::path>& world_folders,
                               const settings::TomlReader& toml = settings::toml_of);
// Reads a lesson from its text; `file` need not exist.
Result<LessonFile> read_lesson_text(const std::string& text, const std::filesystem::path& file,
                                    const std::vector<std::filesystem::path>& world_folders,
                                    const settings::TomlReader& toml = settings::toml_of);

// Returns the text of a lesson file, without pupils. Reading this text gives the same lesson.
std::string lesson_text(const LessonFile& lesson);

// Makes a lesson of three sessions from an instructor's draft. In the first, the learner learns the walls and points to
// places. In the second, the learner learns the route, with less help in each lap. In the third, the learner walks the
// route alone and answers questions.
LessonFile three_sessions(const core::LessonDraft& draft, const std::filesystem::path& world);

// Returns how a lesson in `folder` names a world that is not shipped with the program. The name is the relative path of
// the world, so that lesson and world can be moved together.
std::string named_from(const std::filesystem::path& folder, const std::filesystem::path& world);

// Returns the order of a session's steps for the learner with that number: as written, or shuffled. Equal arguments
// give equal orders.
std::vector<std::size_t> step_order(const TaughtSession& session, std::size_t session_index, std::uint64_t learner);

// Returns the settings, by key, for the session with index `session`. The settings of the session override those of the
// lesson.
std::vector<std::pair<std::string, std::string>> conditions_of(const LessonFile& lesson, std::size_t session);

}  // namespace handrail::teaching
