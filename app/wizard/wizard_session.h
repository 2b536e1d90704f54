// The wizard with its ways in: keys of a window by name, lines of text one after the other, and with them the simulated
// hand where there is no real one. The same for the program and for tests. App thread.
#pragma once

#include <deque>
#include <string>
#include <string_view>

#include "app/wizard/wizard.h"
#include "haptic/device/simulated_device.h"

namespace handrail {

// One line understood. "" is Enter; repeat, back, left, right, up, down, stop, leave; a number is typed and accepted;
// button presses the simulated hand's button; hand-left 6 and so on move it by so many taps; wait 2 waits so many
// seconds.
struct WizardLine {
    std::vector<WizardEvent> events;
    Vec3 hand_by_m{0.0};
    bool button = false;
    bool help = false;
    double wait_s = 0.0;
};
Result<WizardLine> parse_wizard_line(std::string_view line);
// What the keys and lines are, in a sentence or two.
std::string wizard_help();

class WizardSession {
public:
    WizardSession(const Settings& settings, std::span<const WizardPart> parts) : wizard_(settings, parts) {}

    // Carried out when the wizard waits for an answer and what came before has had its time.
    void type(std::string line) { lines_.push_back(std::move(line)); }
    // No more lines will come: leaves once the last one is done.
    void end_of_lines() { lines_end_ = true; }
    // A key went down or repeats, by its name in app/window; names that mean nothing here are ignored.
    void press(std::string_view key_name, double now_s);

    void tick(const WizardSense& sense);
    // All lines so far are done, and an answer is waited for.
    bool wants_line(double now_s) const {
        return lines_.empty() && wizard_.waits_for_person() && now_s >= settle_until_s_;
    }

    Wizard& wizard() { return wizard_; }
    const Wizard& wizard() const { return wizard_; }
    bool finished() const { return wizard_.finished(); }
    // What a simulated hand is to do; a real one takes no notice.
    const HandCommand& simulated_hand() const { return hand_; }
    std::vector<CueRequest> take_cues();

private:
    void take_line(double now_s);
    void move_hand(const Vec3& by_m);

    Wizard wizard_;
    std::deque<std::string> lines_;
    bool lines_end_ = false;
    double settle_until_s_ = 0.0;
    double button_until_s_ = 0.0;
    double reach_m_ = 0.0;
    HandCommand hand_;
    std::vector<CueRequest> told_;  // of lines that were not understood
};

}  // namespace handrail
