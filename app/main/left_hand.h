// A second force device for the left hand, in addition to the one that leads the session. It is found, driven and
// released here. App thread.
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

    // Starts to search for a device by name or serial number; with "none" there is no second hand.
    void look_for(const std::string& wanted);
    // Call once a frame; adds what is new. Returns true on the frame on which the hand was found.
    bool take_change(std::vector<std::string>& news);
    bool real() const { return guarded_ != nullptr; }
    const HandFacts& facts() const { return facts_; }
    ServoInbox* servo() { return servo_.get(); }  // null: there is no second hand
    const ToolState& tool();
    // For the audio thread, which reads it from the start.
    ServoLoop::EventRing& contacts() { return contacts_; }
    // Removes the force and waits for that, at most 76 ms.
    void stop();

private:
    bool use(const HandFacts& facts, std::unique_ptr<GuardedDevice> device, std::vector<std::string>& news);

    Clock& clock_;
    const ServoSwitches& switches_;
    HandRing* recording_;
    ServoLoop::EventRing contacts_;
    std::optional<Hand> simulated_;  // waits to be used
    std::optional<HandSearch> search_;
    std::unique_ptr<ServoLoop> servo_;
    GuardedDevice* guarded_ = nullptr;  // servo_ owns it
    HandFacts facts_;
    ToolState none_;
};

}  // namespace handrail
