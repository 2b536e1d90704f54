// A session of a lesson as it goes: sees what happens, says what is to be done next, and measures. Touches nothing
// itself: what it wishes is taken as inputs of the session (session_input.h), so a recording holds all of it. Plain
// state; one thread.
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

namespace handrail {

// What was measured of one task; keys as reports have them, with "reached" and "detour" (1: yes) beside them.
struct TaskResult {
    StepKind kind = StepKind::Free;
    std::size_t step = 0;  // in the file, from 0
    int lap = 0;           // from 0
    std::string name;
    std::map<std::string, double> measures;
    double ended_s = 0.0;  // in the session's clock
};
// As a recording holds it.
TeacherActed result_act(const TaskResult& result);

class TeachingRun {
public:
    static constexpr double kSummary_s = 10.0;

    struct Start {
        std::size_t session = 0;
        LearnerName learner;
        double step_length_m = 0.7;
        std::string done_key, task_key;  // as they are told
    };
    TeachingRun(std::shared_ptr<TaughtWorld> world, Start start);

    void see(const SessionEvent& event);
    // After the session's tick; about ten times a second is enough. It begins once rooms are known. speaking: somebody
    // speaks, which the ears know.
    void tick(double now_s, const LessonView& view, bool speaking = false);
    // What is to reach the session now, in order.
    std::vector<SessionInput> take_acts() { return std::exchange(acts_, {}); }
    bool over() const { return over_; }
    // Over, with all of its steps behind one: nobody left it before.
    bool finished() const { return finished_; }

    // By whoever teaches. Each says what happened, or why it cannot be. On a way that is being learnt, a door that is
    // blocked counts as one that the lesson itself blocks: the way round is what the lap is measured against.
    std::string next(double now_s);
    std::string repeat();
    std::string change_help(int by);  // 1 more, -1 less
    // To a place, until one is there, the next task begins, or leave_lead(). Never while a question about places waits,
    // which it would answer.
    std::string lead_to(const std::string& name);
    std::string leave_lead();
    std::string block(const std::string& door, bool blocked);
    void note(const std::string& text);
    std::string end(double now_s);

    // One line on how it stands: where, walls, contacts, help, strategy.
    std::string summary() const;
    const std::vector<TaskResult>& results() const { return results_; }
    // Of the time of the session so far.
    double share_of(Strategy strategy) const;

private:
    const TaughtSession& session() const { return world_->lesson().sessions[start_.session]; }
    const TaughtStep& step() const { return session().steps[order_[at_]]; }
    void begin_step();
    void begin_go();
    void begin_lap();
    void ask();
    void answered(const std::string& text);
    bool take_number(const std::string& text, double& number) const;
    void end_task();
    void end_lap(bool reached);
    void end_step();
    void finish(bool all);
    // What lasts from one time to another ends, or goes on into the next task.
    void end_busy(std::optional<double>& since_s);
    void follow_walk();
    void follow_room();
    void lead();
    void end_teachers_lead();
    std::vector<TaughtPlace> led_stops() const;
    void plan_lap();
    double level() const;
    void act(TeacherActed::Kind kind, std::string text = {}, double number = 0.0);
    void task(std::string text);
    void place(const TaughtPlace& at, std::optional<double> heading_rad);
    void keep(TaskResult result);
    TaskResult measured(std::string name) const;
    std::vector<WalkSample> last_samples() const;

    std::shared_ptr<TaughtWorld> world_;
    Start start_;
    std::vector<std::size_t> order_;
    std::size_t at_ = 0;
    bool begun_ = false, over_ = false, finished_ = false;
    std::vector<FeatureId> shut_;  // doors, by whoever teaches
    std::string led_to_;           // by whoever teaches; empty: nowhere
    std::vector<SessionInput> acts_;
    std::vector<TaskResult> results_;
    LessonView view_;
    double now_s_ = 0.0, sampled_s_ = -1e9, summed_s_ = -1e9;
    // Since when; none: not now.
    std::optional<double> led_since_s_, list_since_s_, speaks_since_s_;

    // Of the task that goes on.
    struct Task {
        double begun_s = 0.0;
        std::vector<WayPoint> walk;
        std::vector<Touch> touches;
        int help = 0;
        double led_s = 0.0;
        std::vector<Span> busy;  // a list was open, or somebody spoke
        bool leap = false;
        // Of a room to be learnt, while one was in it.
        std::optional<double> walls_percent, exits_percent;  // none: it has no walls, or no exits
    } task_;
    struct Questions {
        std::string told, text;          // of the task, and of what is asked; empty: nothing is
        std::size_t at = 0;              // of the step's `to`
        std::vector<double> errors_rad;  // of pointing
        std::vector<Judged> judged;
        std::vector<std::size_t> shown;  // the order that was shown
    } asked_;
    // Of a way that is learnt.
    struct Laps {
        int lap = 0;
        std::size_t level = 0;
        std::optional<int> errors_before;
        std::vector<TaughtPlace> stops;
        std::vector<FeatureId> blocked;
        Route shortest;
        std::optional<double> met_s, left_s;  // the blocked door: when one came to it, and was last near it
    } laps_;
    struct Whole {
        std::vector<WalkSample> samples;
        std::vector<Touch> touches;
        std::optional<double> helped_s;
        int visited = -1;
        double wall_touched_s = -1e9;
    } whole_;
};

}  // namespace handrail
