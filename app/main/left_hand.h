// Finds, drives and releases a second force device for the left hand, in addition to the hand that leads the session.
// App thread.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/core/session/session.h"
#include "app/main/find_hand.h"
#include "haptic/servo/servo_loop.h"

namespace handrail::program {

class LeftHand {
public:
    // Clock and switches must outlive this object. `recording` is null if nothing is recorded.
    LeftHand(Clock& clock, const servo::ServoSwitches& switches, servo::HandRing* recording)
        : clock_(clock), switches_(switches), recording_(recording) {}

    // Starts to search for a device by name or serial number. With "none", there is no second hand and no search.
    void look_for(const std::string& wanted);
    // Call once a frame. Adds new sentences to `news`. Returns true on the frame on which the hand was found.
    bool take_change(std::vector<std::string>& news);
    bool real() const { return guarded_ != nullptr; }
    const core::HandFacts& facts() const { return facts_; }
    servo::ServoInbox* servo() { return servo_.get(); }  // null if there is no second hand
    const servo::ToolState& tool();
    // Contacts of this hand. The audio thread reads them from its start, before a hand is found.
    servo::ServoLoop::EventRing& contacts() { return contacts_; }
    // Removes the force and waits until it has faded, at most 76 ms.
    void stop();

private:
    bool use(const core::HandFacts& facts, std::unique_ptr<drivers::GuardedDevice> device,
             std::vector<std::string>& news);

    Clock& clock_;
    const servo::ServoSwitches& switches_;
    servo::HandRing* recording_;
    servo::ServoLoop::EventRing contacts_;
    std::optional<Hand> simulated_;  // a simulated hand, which the next take_change puts into use
    std::optional<HandSearch> search_;
    std::unique_ptr<servo::ServoLoop> servo_;
    drivers::GuardedDevice* guarded_ = nullptr;  // servo_ owns it
    core::HandFacts facts_;
    servo::ToolState none_;
};

}  // namespace handrail::program
