// An instructor's lesson as the learner meets it: tasks that are announced and repeated, questions answered by typing,
// choosing, facing or with the hand, and requests to the teacher. It knows no lesson file. Whoever listens for Answered
// and LessonWished decides what follows. App thread only.
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
    static constexpr double kPointed_m = 0.01;  // of the hand itself; a shorter movement does not count as pointing

    explicit Exercise(const SessionContext& context) : context_(context) {}
    Exercise(const Exercise&) = delete;  // open lists keep its address
    Exercise& operator=(const Exercise&) = delete;

    void enter_world();
    // Once a tick.
    void tick();
    // Handles every kind of act except Lead, Leave, Block and Open, which belong to other features.
    void take(const TeacherActed& act, double now_s);
    // Handles Task, TaskDone and Learners. Returns false for other commands.
    bool act(Command command, double now_s);
    bool under_way() const { return under_way_; }

    // Set by the session; opens the list that prepares a lesson.
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
    // The question that waits for an answer by typing, choosing or pointing.
    struct Question {
        TeacherActed::Kind kind = TeacherActed::Kind::Ask;
        std::string text;
        std::vector<std::string> items;
        std::vector<std::size_t> chosen;
        // Position of the hand when the question was asked, or when it was first known afterwards. Device frame,
        // because walker and workspace may move meanwhile.
        std::optional<Vec3> hand_m;
    };
    std::optional<Question> question_;
};

}  // namespace handrail::core
