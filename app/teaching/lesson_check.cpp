#include "app/teaching/lesson_check.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "app/core/session/headless_session.h"
#include "worlds/base/language.h"

namespace handrail::teaching {
namespace {

constexpr int kTurn_ms = 100;

results::Strategy strategy_named(const std::string& word) {
    if (word == "perimeter") return results::Strategy::Perimeter;
    if (word == "grid") return results::Strategy::Grid;
    if (word == "object") return results::Strategy::ObjectToObject;
    return results::Strategy::BackToBase;
}

std::string measured_failure(const PupilExpectation& expected, const TeachingRun& run, const std::string& file) {
    const auto at = [&](const std::string& message) { return fail(message, file, expected.line).value().sentence(); };
    if (!expected.strategy.empty()) {
        const double share = run.share_of(strategy_named(expected.strategy));
        if (share >= expected.at_least && share <= expected.at_most) return {};
        return at(
            phrase("teaching.share_was", {{"strategy", expected.strategy}, {"percent", std::lround(100.0 * share)}}));
    }
    for (const TaskResult& result : run.results()) {
        if (expected.step != 0 && static_cast<int>(result.step) + 1 != expected.step) continue;
        const auto found = result.measures.find(expected.measure);
        if (found == result.measures.end()) continue;
        if (found->second >= expected.at_least && found->second <= expected.at_most) return {};
        return at(phrase("teaching.measure_was", {{"measure", expected.measure}, {"value", found->second}}));
    }
    return at(phrase("teaching.not_measured", {{"measure", expected.measure}}));
}

}  // namespace

void teach_on(TeachingRun& run, core::Session& app, std::span<const core::SessionEvent> events, double now_s,
              bool speaking) {
    for (const core::SessionEvent& event : events) run.see(event);
    run.tick(now_s, app.lesson_view(), speaking);
    for (core::SessionInput& input : run.take_acts()) app.apply(std::move(input), now_s);
}

TeachingRun begin_lesson(const std::shared_ptr<TaughtWorld>& world, std::size_t session, const LearnerName& learner,
                         const core::Session& app) {
    return TeachingRun(world, {.session = session,
                               .learner = learner,
                               .step_length_m = app.settings().walk.step_length_m,
                               .done_key = app.keys().keys_of(core::Command::TaskDone),
                               .task_key = app.keys().keys_of(core::Command::Task)});
}

Result<PupilOutcome> run_pupil(const std::shared_ptr<TaughtWorld>& world, const LessonPupil& pupil,
                               cues::AudioSink& audio, cues::SpeechSink& speech, const core::WorldReader& read,
                               core::RoomsKept* rooms_kept) {
    const LessonFile& lesson = world->lesson();
    const auto found = std::find_if(lesson.sessions.begin(), lesson.sessions.end(),
                                    [&](const TaughtSession& one) { return one.name == pupil.session; });
    const auto session = static_cast<std::size_t>(found - lesson.sessions.begin());
    core::Scenario scenario;
    scenario.title = pupil.name;
    scenario.file = lesson.file;
    scenario.world.file = lesson.world;
    scenario.has_start = true;
    scenario.start_feet_m = world->base().stand_m;
    scenario.start_heading_rad = world->base_heading_rad();
    for (const auto& [key, value] : conditions_of(lesson, session)) scenario.settings[key] = value;
    scenario.actions = pupil.actions;
    scenario.expectations = pupil.expectations;
    std::optional<TeachingRun> run;
    int ms = 0;
    const auto teach = [&](core::HeadlessSession& headless) {
        if (ms++ % kTurn_ms != 0) return;
        if (!run) run.emplace(begin_lesson(world, session, {}, headless.app()));
        teach_on(*run, headless.app(), headless.app().take_events(), headless.now_s());
    };
    auto log = core::run_scenario(scenario, world->scene(), audio, speech, read, teach, nullptr, rooms_kept);
    if (!log) return tl::unexpected(log.error());
    PupilOutcome outcome{pupil.name, {}, run ? run->results() : std::vector<TaskResult>{}, {}, log->end_s};
    for (const PupilExpectation& expected : pupil.measured)
        if (std::string failure = run ? measured_failure(expected, *run, lesson.file.filename().string())
                                      : phrase("teaching.not_measured", {{"measure", expected.measure}});
            !failure.empty())
            outcome.failures.push_back(std::move(failure));
    outcome.lines = log->lines;
    return outcome;
}

std::string protocol_of(const LessonFile& lesson, const LearnerName& learner) {
    std::string text = lesson.title.spoken() + "\n";
    for (std::size_t s = 0; s < lesson.sessions.size(); ++s) {
        const TaughtSession& session = lesson.sessions[s];
        text += fmt::format("\n{}. {}\n", s + 1, session.name);
        if (session.minutes > 0) text += "  " + phrase("teaching.minutes", {{"count", session.minutes}}) + "\n";
        for (const auto& [key, value] : session.settings) text += fmt::format("  {} = {}\n", key, value);
        for (const std::size_t i : step_order(session, s, learner.number)) {
            const TaughtStep& step = session.steps[i];
            text += fmt::format("  {}.{} {}", s + 1, i + 1, kStepWords.at(static_cast<std::size_t>(step.kind)));
            for (const std::string* part : {&step.room, &step.route, &step.from})
                if (!part->empty()) text += " " + *part;
            if (!step.to.empty()) text += fmt::format(": {}", fmt::join(step.to, ", "));
            if (step.kind == StepKind::Go) text += fmt::format(" [{}]", fmt::join(step.help_percent, ", "));
            if (!step.block.empty()) text += fmt::format(" - {}", fmt::join(step.block, ", "));
            if (step.scale) text += fmt::format(" [{}, {}]", (*step.scale)[0], (*step.scale)[1]);
            if (!step.say.text.empty()) text += " | " + step.say.spoken();
            text += "\n";
        }
    }
    return text;
}

}  // namespace handrail::teaching
