// Lesson files (NAME.lesson.toml): what an instructor wants somebody to learn of a world, as sessions of steps. Reading
// and writing only; lesson_places.h looks up in the world what they name, teaching_run.h teaches. docs/lessons.md is
// the reference of the format. Pure functions, any thread.
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

namespace handrail {

// A text, and the same in other languages: say, say_de.
struct LessonText {
    std::string text;
    OtherLanguages others;
    std::string spoken() const { return in_spoken_language(text, others); }
};

// A thing or a room by its name in the world, or a place of its own under a name.
struct LessonPlace {
    std::string name;  // as it is told; of a thing or a room its name
    std::string thing, room;
    std::optional<Vec3> place_m;  // where soles stand
    int line = 0;
};

struct LessonRoute {
    std::string name;
    std::vector<LessonPlace> stops;  // at least one; from the base on
    int line = 0;
};

enum class StepKind : std::uint8_t { Learn, Go, Free, Point, Distance, Order, Ask };
inline constexpr std::array<const char*, 7> kStepWords = {"learn", "go", "free", "point", "distance", "order", "ask"};

struct TaughtStep {
    StepKind kind = StepKind::Free;
    LessonText say;                           // what is said before what the step says of itself; may be empty
    std::string room;                         // Learn
    int walls_percent = 0, exits = 0;         // Learn: done with so much known; 0: when the learner says so
    std::string route;                        // Go
    std::vector<int> help_percent{0};         // Go: of each lap; the last is 0
    std::vector<std::string> block;           // Go: doors that are shut and stay so
    double off_route_m = 2.0;                 // Go: farther off counts as an error of the lap
    std::string from;                         // Point, Distance: "base" or a place
    std::vector<std::string> to;              // Point, Distance; Order: in what order is right
    bool along_way = false;                   // Distance: along the way, else straight
    std::optional<double> pass_deg;           // Point: an answer passes that is off by no more
    std::optional<std::array<int, 2>> scale;  // Ask: answers are whole numbers; else words
    int line = 0;
};

struct TaughtSession {
    std::string name;
    int minutes = 0;  // told, never enforced; 0: nothing is told
    bool shuffle = false;
    std::map<std::string, std::string> settings;  // conditions of a study
    std::vector<TaughtStep> steps;
    int line = 0;
};

// What must come of a scripted pupil, beside what scenarios expect: of a way or an answer, as reports call it, in the
// step of that number (from 1), or of a strategy's share of the time.
struct PupilExpectation {
    std::string measure;   // key of report_measures(), or "reached", "detour"
    std::string strategy;  // "perimeter", "grid", "object", "base"
    int step = 0;          // 0: the first that has it
    double at_least = -1e300, at_most = 1e300;
    int line = 0;
};
struct LessonPupil {
    std::string name, session;
    std::vector<ScenarioAction> actions;
    std::vector<Expectation> expectations;
    std::vector<PupilExpectation> measured;
    int line = 0;
};

struct LessonFile {
    static constexpr int kForm = 1;
    static constexpr std::size_t kMostSessions = 20, kMostSteps = 100, kMostPlaces = 200;

    std::filesystem::path file;
    LessonText title;
    std::string world_name;           // as written
    std::filesystem::path world;      // as found
    std::string world_checksum;       // empty: unknown
    std::optional<Vec3> base_feet_m;  // else where the world begins
    double base_heading_rad = 0.0;
    std::string base_name;
    std::map<std::string, std::string> settings;
    std::vector<LessonPlace> landmarks;  // at least one
    std::vector<LessonRoute> routes;
    std::vector<TaughtSession> sessions;  // at least one
    std::vector<LessonPupil> pupils;

    const LessonRoute* route(std::string_view name) const;
};

// The sentence of any mistake has file and line; nothing is half read. Worlds are looked for as scenarios look for
// them.
Result<LessonFile> read_lesson(const std::filesystem::path& file,
                               const std::vector<std::filesystem::path>& world_folders,
                               const TomlReader& toml = toml_of);
// From its text; `file` need not be there.
Result<LessonFile> read_lesson_text(const std::string& text, const std::filesystem::path& file,
                                    const std::vector<std::filesystem::path>& world_folders,
                                    const TomlReader& toml = toml_of);

// A lesson without pupils as text that reads back the same.
std::string lesson_text(const LessonFile& lesson);

// A lesson of three sessions, as the program makes it of what an instructor has put together: learning the walls and
// pointing, the way with less help each lap, and the way alone with questions.
LessonFile three_sessions(const LessonDraft& draft, const std::filesystem::path& world);

// How a lesson in that folder names a world that is none of those that come with the program: by the way from the one
// to the other, so that both travel together.
std::string named_from(const std::filesystem::path& folder, const std::filesystem::path& world);

// In which order the steps of a session come for the learner of that number: as they stand, or shuffled, each time
// alike.
std::vector<std::size_t> step_order(const TaughtSession& session, std::size_t session_index, std::uint64_t learner);

// What the lesson sets while that session, from 0, is taught: its own settings, with those of the session on top. By
// key.
std::vector<std::pair<std::string, std::string>> conditions_of(const LessonFile& lesson, std::size_t session);

}  // namespace handrail
