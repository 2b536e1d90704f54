// Lesson files (NAME.lesson.toml). A lesson is what an instructor wants a learner to learn about a world, as sessions
// made of steps. This file only reads and writes them; taught_world.h looks up the names in the world, and
// teaching_run.h runs the lesson. docs/lessons.md is the reference for the format. Pure functions; any thread.
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

enum class StepKind : std::uint8_t { Learn, Go, Free, Point, Distance, Order, Ask };
inline constexpr std::array<const char*, 7> kStepWords = {"learn", "go", "free", "point", "distance", "order", "ask"};

struct TaughtStep {
    StepKind kind = StepKind::Free;
    LessonText say;    // text that is announced before the step's own text; may be empty
    std::string room;  // for Learn: the room to learn
    // For Learn: the step is complete when this much is known; 0: when the learner says so.
    int walls_percent = 0, exits = 0;
    std::string route;                 // for Go: name of the route
    std::vector<int> help_percent{0};  // for Go: help in each lap, in percent; the last is 0
    std::vector<std::string> block;    // for Go: names of doors that are shut and cannot be opened
    double off_route_m = 2.0;  // for Go: a distance from the route that counts as an error of the lap if it is exceeded
    // For Point and Distance: the place from which the learner answers: "base" or the name of a place.
    std::string from;
    std::vector<std::string> to;  // for Point and Distance: the targets; for Order: the items in the right order
    bool along_way = false;  // for Distance: the distance along the route is asked; otherwise the straight distance
    std::optional<double> pass_deg;  // for Point: greatest error with which an answer passes; none: answers cannot fail
    // For Ask: answers are whole numbers in this range; none: answers are words.
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

// What a scripted pupil must achieve, in addition to the expectations of scenarios. It limits either a measure or a
// strategy's share of the time. Measures are those of a route or an answer in one step, named as in reports.
struct PupilExpectation {
    std::string measure;   // key of report_measures(), or "reached" or "detour"
    std::string strategy;  // "perimeter", "grid", "object" or "base"
    int step = 0;          // number of the step, from 1; 0: the first step that has this measure
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
    std::filesystem::path world;      // path of the world's file, as found
    std::string world_checksum;       // checksum of the world's file when the lesson was written; empty: unknown
    std::optional<Vec3> base_feet_m;  // where the soles are at the lesson's base; none: where the world begins
    double base_heading_rad = 0.0;
    std::string base_name;
    std::map<std::string, std::string> settings;
    std::vector<LessonPlace> landmarks;  // at least one landmark
    std::vector<LessonRoute> routes;
    std::vector<TaughtSession> sessions;  // at least one session
    std::vector<LessonPupil> pupils;

    const LessonRoute* route(std::string_view name) const;
};

// Reads a lesson. Each mistake gives a sentence with file and line, and the lesson is then not read at all. Worlds are
// searched for as in scenarios.
Result<LessonFile> read_lesson(const std::filesystem::path& file,
                               const std::vector<std::filesystem::path>& world_folders,
                               const settings::TomlReader& toml = settings::toml_of);
// Reads a lesson from its text; `file` need not exist.
Result<LessonFile> read_lesson_text(const std::string& text, const std::filesystem::path& file,
                                    const std::vector<std::filesystem::path>& world_folders,
                                    const settings::TomlReader& toml = settings::toml_of);

// Returns the text of a lesson file, without pupils. The text reads back as the same lesson.
std::string lesson_text(const LessonFile& lesson);

// Makes a lesson of three sessions from an instructor's draft. The first is for learning the walls and pointing, and
// the second for the route, with less help in each lap. In the third, the learner walks the route alone and answers
// questions.
LessonFile three_sessions(const core::LessonDraft& draft, const std::filesystem::path& world);

// Returns how a lesson in `folder` names a world that is not shipped with the program: by the relative path, so that
// both can be moved together.
std::string named_from(const std::filesystem::path& folder, const std::filesystem::path& world);

// Returns the order of a session's steps for the learner with that number: as written, or shuffled. Equal arguments
// give equal orders.
std::vector<std::size_t> step_order(const TaughtSession& session, std::size_t session_index, std::uint64_t learner);

// Returns the settings for the session with index `session`, by key: those of the lesson, overridden by those of the
// session.
std::vector<std::pair<std::string, std::string>> conditions_of(const LessonFile& lesson, std::size_t session);

}  // namespace handrail::teaching
