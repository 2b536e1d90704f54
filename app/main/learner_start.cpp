#include "app/main/learner_start.h"

#include "app/core/kept/side_file.h"
#include "app/learners/learners.h"
#include "app/learners/lesson_progress.h"
#include "worlds/base/language.h"

namespace handrail::program {

namespace fs = std::filesystem;

Result<void> begin_as_learner(ExploreCall& call) {
    ExploreArguments& arguments = call.arguments;
    if (arguments.learner.empty()) return {};
    const learners::Learners learners(core::user_data_folder());
    const auto learner = learners.find(arguments.learner);
    if (!learner) return tl::unexpected(learner.error());
    const bool may_record = learner->allows(learners::Purpose::Record, learners::today());
    if (arguments.record_in && !may_record) return fail(phrase("learner.not_recorded", {{"name", learner->name}}));
    if (may_record) arguments.record_in = learners.recordings_of(learner->id);
    if (!call.settings.file) call.settings.file = learners.settings_of(learner->id);
    arguments.common.data_in = learners.folder_of(learner->id);
    arguments.remember = learner->allows(learners::Purpose::Remember, learners::today());
    if (!arguments.remember)  // deletes progress that was stored before the learner withdrew the consent
        if (auto forgotten = learners::forget_lessons(arguments.common.data_in); !forgotten) return forgotten;
    arguments.learner = learner->name;
    arguments.news.push_back(phrase("learner.welcome", {{"name", learner->name}}));
    return {};
}

Result<void> begin_as_learner(LessonCall& call) {
    std::error_code ec;
    LessonArguments& arguments = call.arguments;
    if (arguments.learner.empty() || arguments.check || (arguments.file == "watch" && !fs::exists(arguments.file, ec)))
        return {};
    if (arguments.protocol) {  // the command can also print a protocol for a learner who does not exist yet
        if (const auto learner = learners::Learners(core::user_data_folder()).find(arguments.learner))
            arguments.learner = learner->name;
        return {};
    }
    call.explore.arguments.learner = arguments.learner;
    if (auto begun = begin_as_learner(call.explore); !begun) return begun;
    arguments.learner = call.explore.arguments.learner;
    return {};
}

ExploreCall as_somebody_else(ExploreCall requested, ExploreEnd end) {
    ExploreArguments& arguments = requested.arguments;
    arguments.learner = end.learner.value_or(std::string());
    // For a named learner, whether the session is recorded depends on what that learner has agreed to.
    if (!arguments.learner.empty()) arguments.record_in.reset();
    arguments.world = std::move(end.world.file);
    arguments.common.building = std::move(end.world.building);
    arguments.at.clear();
    arguments.common.unit_m.reset();  // the next session reads the unit from the file next to the world
    arguments.lesson_settings.clear();
    arguments.lines = std::move(end.lines);
    arguments.lesson.reset();
    arguments.news = {phrase(arguments.learner.empty() ? "learner.nobody_here" : "learner.changes")};
    return requested;
}

}  // namespace handrail::program
