// A second force device in the left hand, beside the one the session is about: found, driven and let go here. App
// thread.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/core/session/session.h"
#include "app/main/find_hand.h"
#include "haptic/servo/servo_loop.h"

namespace handrail {

class LeftHand {
public:
    // Both outlive this object.
    LeftHand(Clock& clock, const ServoSwitches& switches, HandRing* recording)
        : clock_(clock), switches_(switches), recording_(recording) {}

    // Begins to look for a device by name or serial number; none: there is no second hand.
    void look_for(const std::string& wanted);
    // Once a frame: tells what is new of it; true on the frame on which the hand came.
    bool take_change(std::vector<std::string>& news);
    bool real() const { return guarded_ != nullptr; }
    const HandFacts& facts() const { return facts_; }
    ServoInbox* servo() { return servo_.get(); }  // null: there is no second hand
    const ToolState& tool();
    // For the ears, from the start.
    ServoLoop::EventRing& contacts() { return contacts_; }
    // Takes the force away and waits for that, at most 76 ms.
    void stop();

private:
    bool use(const HandFacts& facts, std::unique_ptr<GuardedDevice> device, std::vector<std::string>& news);

    Clock& clock_;
    const ServoSwitches& switches_;
    HandRing* recording_;
    ServoLoop::EventRing contacts_;
    std::optional<Hand> simulated_;  // that waits to be used
    std::optional<HandSearch> search_;
    std::unique_ptr<ServoLoop> servo_;
    GuardedDevice* guarded_ = nullptr;  // servo_ owns it
    HandFacts facts_;
    ToolState none_;
};

}  // namespace handrail
