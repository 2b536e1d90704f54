// When somebody who waits is to be told how far it has come: nothing of what is over within two seconds, and then
// something every few. Plain state of whoever does the telling.
#pragma once

namespace handrail {

class Patience {
public:
    static constexpr double kFirst_s = 2.0, kEvery_s = 5.0;

    // Somebody waits from this moment on.
    explicit Patience(double begun_s) : begun_s_(begun_s), next_s_(begun_s + kFirst_s) {}

    // True once for each time that something is to be told.
    bool due(double now_s) {
        if (now_s < next_s_) return false;
        next_s_ = now_s + kEvery_s;
        told_ = true;
        return true;
    }
    bool told() const { return told_; }  // anything yet
    double waited_s(double now_s) const { return now_s - begun_s_; }

private:
    double begun_s_, next_s_;
    bool told_ = false;
};

}  // namespace handrail
