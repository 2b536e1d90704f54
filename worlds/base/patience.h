// Decides when to report progress to a waiting person: never if the wait ends within two seconds, then every few
// seconds. Plain state; used on the thread that reports.
#pragma once

namespace handrail {

class Patience {
public:
    static constexpr double kFirst_s = 2.0, kEvery_s = 5.0;

    // The wait begins at this moment.
    explicit Patience(double begun_s) : begun_s_(begun_s), next_s_(begun_s + kFirst_s) {}

    // Returns true each time that a report is due.
    bool due(double now_s) {
        if (now_s < next_s_) return false;
        next_s_ = now_s + kEvery_s;
        told_ = true;
        return true;
    }
    bool told() const { return told_; }  // true once a report was due
    double waited_s(double now_s) const { return now_s - begun_s_; }

private:
    double begun_s_, next_s_;
    bool told_ = false;
};

}  // namespace handrail
