// The lesson of an instructor as the one who learns meets it: the task told and told again, questions answered by
// typing, by choosing, by facing or with the hand, and what can be asked of whoever teaches. Knows no lesson file; what
// follows is another's, who listens for Answered and LessonWished. App thread only.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/core/context/session_context.h"
#include "app/core/context/teacher_act.h"

namespace handrail {

class Exercise {
public:
    static constexpr double kPointed_m = 0.01;  // of the hand itself: a shorter movement is no pointing

    explicit Exercise(const SessionContext& context) : context_(context) {}
    Exercise(const Exercise&) = delete;  // open lists know it by its place
    Exercise& operator=(const Exercise&) = delete;

    void enter_world();
    // Once a tick.
    void tick();
    // All but Lead, Leave, Block and Open, which concern others.
    void take(const TeacherActed& act, double now_s);
    // Task, TaskDone and Learners. False: it is another's.
    bool act(Command command, double now_s);
    bool under_way() const { return under_way_; }

    // Set by the session: the list that prepares a lesson.
    std::function<void(double now_s)> on_prepare;

private:
    void ask_again(double now_s);
    void open_order(double now_s);
    void point(double now_s);
    void open_list(double now_s);
    void open_offers(double now_s);
    void open_learners(const TeacherActed& act, double now_s);
    void wish(LessonWish wish, double now_s) const;

    const SessionContext& context_;
    bool under_way_ = false;
    std::string title_, task_;
    std::vector<std::string> offers_;
    // The question that waits for its answer: by typing, by choosing or by pointing.
    struct Question {
        TeacherActed::Kind kind = TeacherActed::Kind::Ask;
        std::string text;
        std::vector<std::string> items;
        std::vector<std::size_t> chosen;
        // Where the hand was when it was asked to point, or was first known after that. Device frame, because the body
        // and the workspace may be moved meanwhile.
        std::optional<Vec3> hand_m;
    };
    std::optional<Question> question_;
};

}  // namespace handrail
