// Lesson files (NAME.lesson.toml): what an instructor wants someone to learn about a world, as sessions made of steps.
// This file only reads and writes them; taught_world.h looks up the names in the world, and teaching_run.h teaches.
// docs/lessons.md is the reference for the format. Pure functions; any thread.
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

// A text and its translations: say, say_de.
struct LessonText {
    std::string text;
    OtherLanguages others;
    std::string spoken() const { return in_spoken_language(text, others); }
};

// An object or a room, by its name in the world, or another place with a name.
struct LessonPlace {
    std::string name;  // as announced; for an object or a room, its name
    std::string thing, room;
    std::optional<Vec3> place_m;  // where the soles are
    int line = 0;
};

struct LessonRoute {
    std::string name;
    std::vector<LessonPlace> stops;  // at least one; the route begins at the base
    int line = 0;
};

enum class StepKind : std::uint8_t { Learn, Go, Free, Point, Distance, Order, Ask };
inline constexpr std::array<const char*, 7> kStepWords = {"learn", "go", "free", "point", "distance", "order", "ask"};

struct TaughtStep {
    StepKind kind = StepKind::Free;
    LessonText say;                    // said before the step's own text; may be empty
    std::string room;                  // for Learn
    int walls_percent = 0, exits = 0;  // for Learn: complete when this much is known; 0: when the learner says so
    std::string route;                 // for Go
    std::vector<int> help_percent{0};  // for Go: help in each lap; the last is 0
    std::vector<std::string> block;    // for Go: doors that are shut and stay shut
    double off_route_m = 2.0;          // for Go: a greater distance counts as an error of the lap
    std::string from;                  // for Point and Distance: "base" or a place
    std::vector<std::string> to;       // for Point, Distance, and Order, which lists them in the right order
    bool along_way = false;            // for Distance: along the route; otherwise straight
    std::optional<double> pass_deg;    // for Point: greatest error with which an answer passes
    std::optional<std::array<int, 2>> scale;  // for Ask: answers are whole numbers in this range; otherwise words
    int line = 0;
};

struct TaughtSession {
    std::string name;
    int minutes = 0;  // announced, never enforced; 0: not announced
    bool shuffle = false;
    std::map<std::string, std::string> settings;  // conditions of a study
    std::vector<TaughtStep> steps;
    int line = 0;
};

// What a scripted pupil must achieve, in addition to the expectations of scenarios. It limits a measure of a route or
// an answer, named as in reports, in the step with that number (from 1), or a strategy's share of the time.
struct PupilExpectation {
    std::string measure;   // key of report_measures(), or "reached" or "detour"
    std::string strategy;  // "perimeter", "grid", "object", "base"
    int step = 0;          // 0: the first step that has it
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
    std::string world_name;           // as written in the file
    std::filesystem::path world;      // path, as found
    std::string world_checksum;       // empty: unknown
    std::optional<Vec3> base_feet_m;  // otherwise where the world begins
    double base_heading_rad = 0.0;
    std::string base_name;
    std::map<std::string, std::string> settings;
    std::vector<LessonPlace> landmarks;  // at least one
    std::vector<LessonRoute> routes;
    std::vector<TaughtSession> sessions;  // at least one
    std::vector<LessonPupil> pupils;

    const LessonRoute* route(std::string_view name) const;
};

// Every mistake has a sentence with file and line, and nothing is read in part. Worlds are searched for as in
// scenarios.
Result<LessonFile> read_lesson(const std::filesystem::path& file,
                               const std::vector<std::filesystem::path>& world_folders,
                               const settings::TomlReader& toml = settings::toml_of);
// Reads a lesson from its text; `file` need not exist.
Result<LessonFile> read_lesson_text(const std::string& text, const std::filesystem::path& file,
                                    const std::vector<std::filesystem::path>& world_folders,
                                    const settings::TomlReader& toml = settings::toml_of);

// A lesson without pupils, as text that reads back unchanged.
std::string lesson_text(const LessonFile& lesson);

// Makes a lesson of three sessions from an instructor's draft: learning the walls and pointing, the route with less
// help in each lap, and the route alone with questions.
LessonFile three_sessions(const core::LessonDraft& draft, const std::filesystem::path& world);

// How a lesson in `folder` names a world that does not come with the program: by the relative path, so that both can be
// moved together.
std::string named_from(const std::filesystem::path& folder, const std::filesystem::path& world);

// The order of a session's steps for the learner with that number: as written or shuffled, but always the same.
std::vector<std::size_t> step_order(const TaughtSession& session, std::size_t session_index, std::uint64_t learner);

// The settings during that session (counted from 0), by key: those of the lesson, overridden by those of the session.
std::vector<std::pair<std::string, std::string>> conditions_of(const LessonFile& lesson, std::size_t session);

}  // namespace handrail::teaching
