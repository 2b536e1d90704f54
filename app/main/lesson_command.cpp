#include <fmt/format.h>
#include <fmt/ostream.h>
#include <unistd.h>

#include "app/core/whereabouts/rooms_kept.h"
#include "app/main/commands.h"
#include "app/main/lesson_here.h"
#include "app/main/world_files.h"
#include "app/teaching/desk.h"
#include "app/teaching/lesson_check.h"
#include "audio-cues/sinks/recording_sinks.h"
#include "worlds/base/language.h"

namespace handrail::program {
namespace {

// Tries the lesson with simulated pupils. Returns 0 if every pupil meets all expectations. Returns 1 if an expectation
// is not met, or if a pupil's script cannot be carried out.
int check_lesson(const std::shared_ptr<teaching::TaughtWorld>& world, core::RoomsKept& rooms_kept,
                 const LongWork& progress, std::ostream& out) {
    bool all_hold = true;
    for (const teaching::LessonPupil& pupil : world->lesson().pupils) {
        sinks::RecordingAudio audio;
        sinks::RecordingSpeech speech;
        progress.at(phrase("progress.scenario", {{"title", pupil.name}}));
        const auto outcome =
            teaching::run_pupil(world, pupil, audio, speech, {imported_scene, toml_next_to_worlds()}, &rooms_kept);
        progress.done();
        std::vector<std::string> failures =
            outcome ? outcome->failures : std::vector<std::string>{outcome.error().sentence()};
        fmt::print(out, "{}\n",
                   phrase(failures.empty() ? "program.scenario_holds" : "program.scenario_fails",
                          {{"title", pupil.name},
                           {"file", world->lesson().file.filename().string()},
                           {"seconds", outcome ? outcome->seconds : 0.0}}));
        for (const std::string& failure : failures) fmt::print(out, "  {}\n", failure);
        all_hold = all_hold && failures.empty();
    }
    if (world->lesson().pupils.empty()) fmt::print(out, "{}\n", phrase("teaching.no_pupils"));
    return all_hold ? 0 : 1;
}

}  // namespace

// Returns 0 on success. Returns 1 if a pupil failed or if there is nothing to watch, and 2 if the lesson has a mistake.
// Returns nothing if the lesson is to be taught; `explore` then contains the arguments of the session.
std::optional<int> run_lesson(const LessonArguments& arguments, ExploreArguments& explore, std::ostream& out,
                              std::ostream& err, const LongWork& progress) {
    std::error_code ec;
    if (arguments.file == "watch" && !std::filesystem::exists(arguments.file, ec))
        return teaching::watch_desk(teaching::desk_folder(), STDIN_FILENO, out, err);
    const teaching::LearnerName learner = teaching::learner_named(arguments.learner);
    const auto refused = [&](const Error& error) {
        fmt::print(err, "{}\n", error.sentence());
        return 2;
    };
    const auto file = lesson_given(arguments.file);
    if (!file) return refused(file.error());
    core::RoomsKept of_all_pupils;
    progress.at(phrase("progress.lesson"));
    auto world = read_taught_world(*file, &of_all_pupils);
    progress.done();
    if (!world) return refused(world.error());
    if (arguments.check) return check_lesson(*world, of_all_pupils, progress, out);
    // The world was read before this, although the protocol does not need it, so that only a lesson that can be taught
    // is printed.
    if (arguments.protocol) {
        out << teaching::protocol_of((*world)->lesson(), learner);
        return 0;
    }
    const teaching::LessonFile& lesson = (*world)->lesson();
    if (arguments.session && (*arguments.session < 1 || *arguments.session > lesson.sessions.size())) {
        fmt::print(err, "{}\n", phrase("teaching.sessions_are", {{"count", lesson.sessions.size()}}));
        return 2;
    }
    std::size_t session = arguments.session.value_or(1) - 1;
    if (!arguments.session && explore.remember) {
        session = next_session(explore, lesson, explore.news);
        explore.news.push_back(
            phrase("teaching.session_is_next", {{"number", session + 1}, {"count", lesson.sessions.size()}}));
    }
    settings::SettingsStore lesson_settings;
    explore.lesson_settings = teaching::conditions_of(lesson, session);
    for (const auto& [key, value] : explore.lesson_settings)
        if (const auto set = lesson_settings.set(key, value, settings::SettingSource::World); !set)
            return refused(set.error());
    explore.world = lesson.world;
    explore.lesson = LessonToTeach{std::move(*world), session, learner};
    return std::nullopt;
}

}  // namespace handrail::program
