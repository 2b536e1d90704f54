// Connects the wizard with its inputs: window keys by name, lines of text in their order, and a simulated hand if there
// is no real one. The program and the tests use this class. App thread.
#pragma once

#include <deque>
#include <string>
#include <string_view>

#include "app/wizard/wizard.h"
#include "haptic/device/simulated_device.h"

namespace handrail::wizard {

// What a typed line means:
// - "" is Enter; repeat, back, left, right, up, down, stop and leave are keys;
// - a number is typed and accepted;
// - button presses the simulated hand's button;
// - hand-left 6 and the like move the simulated hand by this many taps;
// - wait 2 waits for this many seconds.
struct WizardLine {
    std::vector<WizardEvent> events;
    Vec3 hand_by_m{0.0};
    bool button = false;
    bool help = false;
    double wait_s = 0.0;
};
Result<WizardLine> parse_wizard_line(std::string_view line);
// Returns one or two sentences that explain the keys and lines.
std::string wizard_help();

class WizardSession {
public:
    WizardSession(const settings::Settings& settings, std::span<const WizardPart> parts) : wizard_(settings, parts) {}

    // Queues a line. The wizard carries the line out when it waits for an answer and all earlier lines have been
    // carried out.
    void type(std::string line) { lines_.push_back(std::move(line)); }
    // Call this function if no more lines will come. The wizard then leaves the set-up after the last line.
    void end_of_lines() { lines_end_ = true; }
    // Call this function when a key goes down or repeats. `key_name` is as in app/window. Ignores keys that have no
    // meaning in the set-up.
    void press(std::string_view key_name, double now_s);

    void tick(const WizardSense& sense);
    // Returns true if all lines have been carried out and the wizard is waiting for an answer.
    bool wants_line(double now_s) const {
        return lines_.empty() && wizard_.waits_for_person() && now_s >= settle_until_s_;
    }

    Wizard& wizard() { return wizard_; }
    const Wizard& wizard() const { return wizard_; }
    bool finished() const { return wizard_.finished(); }
    // Returns the commands for a simulated hand. A real hand ignores them.
    const device::HandCommand& simulated_hand() const { return hand_; }
    std::vector<cues::CueRequest> take_cues();

private:
    void take_line(double now_s);
    void move_hand(const Vec3& by_m);

    Wizard wizard_;
    std::deque<std::string> lines_;
    bool lines_end_ = false;
    double settle_until_s_ = 0.0;
    double button_until_s_ = 0.0;
    double reach_m_ = 0.0;
    device::HandCommand hand_;
    std::vector<cues::CueRequest> announced_;  // announcements about lines that were not understood
};

}  // namespace handrail::wizard
