// Decides when to report progress to a waiting person: never in the first two seconds, then every few seconds. Plain
// state, used on the thread that reports.
#pragma once

namespace handrail {

class Patience {
public:
    static constexpr double kFirst_s = 2.0, kEvery_s = 5.0;

    // `begun_s` is the moment at which the person's wait begins.
    explicit Patience(double begun_s) : begun_s_(begun_s), next_s_(begun_s + kFirst_s) {}

    // Returns true whenever a report is due at `now_s`.
    bool due(double now_s) {
        if (now_s < next_s_) return false;
        next_s_ = now_s + kEvery_s;
        announced_ = true;
        return true;
    }
    bool announced() const { return announced_; }  // true after due() has returned true at least once
    double waited_s(double now_s) const { return now_s - begun_s_; }

private:
    double begun_s_, next_s_;
    bool announced_ = false;
};

}  // namespace handrail
