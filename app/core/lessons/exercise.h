// Runs an instructor's lesson on the side of the learner. It announces and repeats tasks, and passes on requests to the
// teacher. It asks questions, which the learner answers by typing, choosing, facing or pointing. It does not know
// lesson files. The listener for Answered and LessonRequested decides what follows. Use it on the app thread only.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/core/context/session_context.h"
#include "app/core/context/teacher_act.h"

namespace handrail::core {

class Exercise {
public:
    static constexpr double kPointed_m = 0.01;  // least movement of the hand on the device that is taken as pointing

    explicit Exercise(const SessionContext& context) : context_(context) {}
    Exercise(const Exercise&) = delete;  // not copyable, because open lists keep the address of this object
    Exercise& operator=(const Exercise&) = delete;

    void enter_world();
    // Notes the position of the hand for the open question. Call it once a tick.
    void tick();
    // Carries out all kinds of acts except Lead, Leave, Block and Open, which belong to other features.
    void take(const TeacherActed& act, double now_s);
    // Carries out the commands Task, TaskDone and Learners. Returns false for other commands.
    bool act(Command command, double now_s);
    bool under_way() const { return under_way_; }
    const std::string& title() const { return title_; }  // returns the title of the lesson
    // Returns the present task of the lesson that is under way; empty: none.
    std::string task() const { return under_way_ ? task_ : std::string{}; }

    // The session sets this function. It opens the list in which an instructor prepares a lesson.
    std::function<void(double now_s)> on_prepare;

private:
    void repeat_question(double now_s);
    void open_order(double now_s);
    void point(double now_s);
    void open_list(double now_s);
    void open_offers(double now_s);
    void open_learners(const TeacherActed& act, double now_s);
    void request(LessonRequest request, double now_s) const;

    const SessionContext& context_;
    bool under_way_ = false;
    std::string title_, task_;
    std::vector<std::string> offers_;
    // The question that waits for an answer.
    struct Question {
        TeacherActed::Kind kind = TeacherActed::Kind::Question;
        std::string text;
        std::vector<std::string> items;
        std::vector<std::size_t> chosen;
        // Position of the hand when the question was asked, or when the hand first became known after that. It is in
        // the device frame, because walker and workspace may move meanwhile.
        std::optional<Vec3> hand_m;
    };
    std::optional<Question> question_;
};

}  // namespace handrail::core
