#include "app/main/learners_here.h"

#include "app/core/kept/side_file.h"
#include "app/learners/forget.h"
#include "app/learners/lesson_progress.h"
#include "app/main/world_files.h"
#include "app/teaching/lesson_file.h"
#include "worlds/base/language.h"

namespace handrail::program {

LearnersHere::LearnersHere(const ExploreArguments& arguments, core::Session& app, SessionRecording& recording,
                           const SessionVoice& say)
    : arguments_(arguments), app_(app), recording_(recording), say_(say), learners_(core::user_data_folder()) {}

void LearnersHere::turn(double now_s) {
    if (app_.requests().take_learners()) show(now_s);
    if (const auto chosen = app_.requests().take_learner()) choose(*chosen, now_s);
}

void LearnersHere::show(double now_s) {
    learners::Learners::Found found = learners_.all();
    for (const Error& fault : found.faults) say_(fault.sentence());
    if (found.learners.empty()) return say_(phrase("learner.none"));
    if (recording_.leave_off()) say_(phrase("learner.recording_ends"));
    shown_ = std::move(found.learners);
    const std::string& here = arguments_.learner;
    core::TeacherActed act{core::TeacherActed::Kind::Learners, {}, {}, {}, 0.0};
    act.text = here.empty() ? phrase("learner.nobody_here") : phrase("learner.here", {{"name", here}});
    act.items = {phrase("learner.nobody_by_name"), {}};
    for (const learners::Learner& one : shown_) {
        if (one.name == here) act.number = static_cast<double>(act.items.size() / 2);
        act.items.push_back(one.name);
        act.items.push_back(learners::agreed_words(one, learners::today()));
    }
    app_.apply(std::move(act), now_s);
}

// Returns sentences about the current learner: which data about the person are stored, and where the lessons continue.
std::string LearnersHere::facts_of(const learners::Learner& learner) const {
    const std::filesystem::path folder = learners_.folder_of(learner.id);
    const learners::Holdings holdings = learners::holdings_of(folder);
    std::string words = phrase("learner.here", {{"name", learner.name}}) + " " +
                        phrase("learner.listed", {{"name", learner.name},
                                                  {"purposes", learners::agreed_words(learner, learners::today())},
                                                  {"recordings", holdings.recordings}});
    if (holdings.worlds > 0) words += " " + phrase("learner.knows_worlds", {{"worlds", holdings.worlds}});
    const auto lessons = learners::lessons_begun(folder);
    if (!lessons) return words + " " + lessons.error().sentence();
    for (const learners::LessonProgress& one : *lessons)
        if (const auto lesson = teaching::read_lesson(one.file, {world_folder()}, toml_next_to_worlds()))
            words += " " + phrase("learner.lesson_goes_on",
                                  {{"title", lesson->title.spoken()},
                                   {"number", learners::session_behind(one.taught, lesson->sessions.size()) + 1},
                                   {"count", lesson->sessions.size()}});
    return words;
}

void LearnersHere::choose(std::size_t at, double now_s) {
    const std::string& here = arguments_.learner;
    if (at == 0) {
        if (here.empty()) return say_(phrase("learner.nobody_here"), now_s);
        next_ = "";
        return;
    }
    if (at > shown_.size()) return;
    // Read the learner again, because another process may have deleted or damaged the learner since the list was made.
    const auto learner = learners_.find(shown_[at - 1].id);
    if (!learner) return say_(learner.error().sentence(), now_s);
    if (learner->name == here) return say_(facts_of(*learner), now_s);
    next_ = learner->id;
}

}  // namespace handrail::program
