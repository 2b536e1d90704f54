// Tests the program like a monkey at the keyboard. The class presses random keys, types random characters and lines,
// moves the hands in jumps, and changes settings and worlds. Its devices break, vanish and return. It runs in virtual
// time with the same Session and servo as the program. The same seed gives the same actions.
#pragma once

#include <deque>
#include <filesystem>
#include <map>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "app/core/session/headless_session.h"
#include "audio-cues/sinks/recording_sinks.h"
#include "tests/support/names.h"

namespace handrail::test {

// A sink that counts the sounds and keeps few of them, because a long session would fill the memory.
class CountingAudio final : public AudioSink {
public:
    void play(const SoundCue&) override { ++heard; }
    void set_loop(const SoundCue&) override { ++heard; }
    void set_listener(const Listener&) override {}
    void stop_all() override {}
    void tick(double) override {}
    long heard = 0;
};
class CountingSpeech final : public SpeechSink {
public:
    void say(const Utterance& utterance) override { take(utterance); }
    void write(const Utterance& utterance) override { take(utterance); }
    void stop() override {}
    bool speaking() const override { return false; }
    void tick(double) override {}
    long lines = 0, empty = 0, damaged = 0;  // damaged: lines that are not UTF-8
    std::deque<std::string> last;

private:
    void take(const Utterance& utterance);
};

class Monkey {
public:
    Monkey(std::uint32_t seed, std::vector<std::shared_ptr<const Scene>> worlds);

    // Performs one random action and lets a little time pass. Returns false at the first violation of a rule; fault()
    // then describes the violation.
    bool act();
    const std::string& fault() const { return fault_; }
    // Returns the last actions and the last announcements, for the analysis of a fault.
    std::string story() const;
    const std::map<std::string, long>& done() const { return done_; }  // number of actions by kind
    double seconds() const { return seconds_; }
    long lines() const { return speech_.lines; }

private:
    std::uint32_t below(std::uint32_t n) { return random_() % n; }
    double between(double low, double high) {
        return low + (high - low) * (static_cast<double>(random_()) / 4294967295.0);
    }
    bool chance(double share) { return between(0.0, 1.0) < share; }
    Session& app() { return session_->app(); }

    void begin();
    void note(std::string kind, const std::string& what = {});
    void one_act();
    void press_something();
    void key();
    void text();
    void line();
    void hand();
    void trouble();
    void device();
    void setting();
    void world();
    void owner();  // does what the owner of the app does in the program
    void run(double seconds);
    void check_tick();
    void check_places();
    void expect_an_answer();
    void fail(std::string what);
    std::string word();

    std::mt19937 random_;
    std::vector<std::shared_ptr<const Scene>> worlds_;
    std::vector<SettingRow> settings_;
    CountingAudio audio_;
    CountingSpeech speech_;
    std::unique_ptr<HeadlessSession> session_;
    HandFacts facts_[2];
    std::vector<Command> held_;
    std::deque<std::string> acts_;
    std::map<std::string, long> done_;
    std::string fault_;
    double seconds_ = 0.0;
    // Remembers whether the proxy was outside all solids at the last check, and under which circumstances. While the
    // circumstances stay the same, the proxy must remain outside.
    struct Free {
        bool known = false;
        std::uint32_t generation = 0, jump = 0;
        double gain = 0.0;  // gain of the force at the last tick
    };
    Free proxy_free_[2];
    std::shared_ptr<const Scene> walls_of_;
    std::unique_ptr<WalkerWorld> walls_;
    // Least value that the setting of the walker's radius ever had. A walker copies its radius from the setting when it
    // enters a world.
    double least_radius_m_ = 1.0;
    double body_free_m_ = 0.0;  // radius at which the walker fitted in its place at the last check; 0: it did not fit
};

}  // namespace handrail::test
