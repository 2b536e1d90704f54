// Runs a session of a lesson. It receives what happens, says what the learner does next, and measures how well the
// learner does it. TeachingRun changes nothing directly: its acts become inputs of the session (session_input.h), so a
// recording contains all of them. Plain state; one thread.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/core/context/session_event.h"
#include "app/core/session/lesson_view.h"
#include "app/core/session/session_input.h"
#include "app/results/measures.h"
#include "app/results/strategy.h"
#include "app/teaching/learner_name.h"
#include "app/teaching/taught_world.h"

namespace handrail::teaching {

// The measures of one task, with the keys of reports. "reached" and "detour" are also measures (1: yes).
struct TaskResult {
    StepKind kind = StepKind::Free;
    std::size_t step = 0;  // index of the step in the file, from 0
    int lap = 0;           // index of the lap, from 0
    std::string name;
    std::map<std::string, double> measures;
    double ended_s = 0.0;  // time on the session's clock
};
// Returns the result as an input of the session, which a recording contains.
core::TeacherActed result_act(const TaskResult& result);

class TeachingRun {
public:
    static constexpr double kSummary_s = 10.0;

    struct Start {
        std::size_t session = 0;
        LearnerName learner;
        double step_length_m = 0.7;
        // Names of the keys for answering and for hearing the task again, as they are announced.
        std::string done_key, task_key;
    };
    TeachingRun(std::shared_ptr<TaughtWorld> world, Start start);

    void see(const core::SessionEvent& event);
    // Call after the session's tick; about ten times a second is enough. The lesson begins once the rooms are known.
    // `speaking`: the ears (AudioThread) report that the voice is speaking.
    void tick(double now_s, const core::LessonView& view, bool speaking = false);
    // Returns the inputs to apply to the session now, in their order.
    std::vector<core::SessionInput> take_acts() { return std::exchange(acts_, {}); }
    bool over() const { return over_; }
    // Returns true if all steps of the lesson were done. If the lesson was left early, returns false.
    bool finished() const { return finished_; }

    // The orders of the instructor. Each function returns what happened, or why the order is impossible. If the
    // instructor blocks a door on a route that the learner is learning, the lap is measured against the detour, as if
    // the lesson itself blocked the door.
    std::string next(double now_s);
    std::string repeat();
    std::string change_help(int by);  // `by`: 1 for more help, -1 for less
    // Guides the learner to a place until the learner arrives, the next task begins, or leave_lead() is called. Refused
    // while the learner has to answer a question about places, because guidance would give the answer away.
    std::string lead_to(const std::string& name);
    std::string leave_lead();
    std::string block(const std::string& door, bool blocked);
    void note(const std::string& text);
    std::string end(double now_s);

    // Returns one line about the current state of the learner: place, walls, contacts, help, strategy.
    std::string summary() const;
    const std::vector<TaskResult>& results() const { return results_; }
    // Returns the strategy's share of the session's time until now.
    double share_of(results::Strategy strategy) const;

private:
    const TaughtSession& session() const { return world_->lesson().sessions[start_.session]; }
    const TaughtStep& step() const { return session().steps[order_[at_]]; }
    void begin_step();
    void begin_go();
    void begin_lap();
    void pose_question();
    void answered(const std::string& text);
    bool take_number(const std::string& text, double& number) const;
    void end_task();
    void end_lap(bool reached);
    void end_step();
    void finish(bool all);
    // Ends a time that began at `since_s`, in which the learner was busy. Adds that time to the current task.
    void end_busy(std::optional<double>& since_s);
    void follow_walk();
    void follow_room();
    void lead();
    void end_teachers_lead();
    std::vector<TaughtPlace> led_stops() const;
    void plan_lap();
    double level() const;
    void act(core::TeacherActed::Kind kind, std::string text = {}, double number = 0.0);
    void task(std::string text);
    void place(const TaughtPlace& at, std::optional<double> heading_rad);
    void keep(TaskResult result);
    TaskResult measured(std::string name) const;
    std::vector<results::WalkSample> last_samples() const;

    std::shared_ptr<TaughtWorld> world_;
    Start start_;
    std::vector<std::size_t> order_;
    std::size_t at_ = 0;
    bool begun_ = false, over_ = false, finished_ = false;
    std::vector<FeatureId> shut_;  // doors that the instructor has shut
    std::string led_to_;           // goal to which the instructor has the learner guided; empty: none
    std::vector<core::SessionInput> acts_;
    std::vector<TaskResult> results_;
    core::LessonView view_;
    double now_s_ = 0.0, sampled_s_ = -1e9, summed_s_ = -1e9;
    // Since when the learner has been guided, a list has been open, and the voice has been speaking; nothing: not at
    // the moment.
    std::optional<double> led_since_s_, list_since_s_, speaks_since_s_;

    // The measurements in the current task.
    struct Task {
        double begun_s = 0.0;
        std::vector<results::WalkedPoint> walk;
        std::vector<results::Touch> touches;
        int help = 0;
        double led_s = 0.0;
        std::vector<results::Span> busy;  // times when a list was open, or the voice was speaking
        bool leap = false;
        // How much of the room to learn was known when the learner was last in that room.
        std::optional<double> walls_percent, exits_percent;  // nothing: the room has no walls, or no exits
    } task_;
    struct Question {
        std::string task, text;          // texts of the task and of the question; empty: none
        std::size_t at = 0;              // index of the current question in the step's `to`
        std::vector<double> errors_rad;  // errors of the answers to pointing questions
        std::vector<results::Judged> judged;
        std::vector<std::size_t> shown;  // order in which the items were shown
    } question_;
    // State of a step in which the learner learns a route.
    struct Laps {
        int lap = 0;
        std::size_t level = 0;
        std::optional<int> errors_before;
        std::vector<TaughtPlace> stops;
        std::vector<FeatureId> blocked;
        navigation::Route shortest;
        // `met_s`: when the learner first came to a blocked door in this lap. `left_s`: when the learner was last near
        // that door.
        std::optional<double> met_s, left_s;
    } laps_;
    struct Whole {
        std::vector<results::WalkSample> samples;
        std::vector<results::Touch> touches;
        std::optional<double> helped_s;
        int visited = -1;
        double wall_touched_s = -1e9;
    } whole_;
};

}  // namespace handrail::teaching
