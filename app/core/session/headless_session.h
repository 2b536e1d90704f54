// Runs the whole program on a virtual clock in one thread. The servos tick a thousand times a second, audio two hundred
// times, and the session sixty times. Session, SessionDriver, ServoLoop and AudioThread are the classes that the
// program uses. What the program does on several threads happens here in a fixed order, so the same input gives the
// same output. Scenarios and tests use it.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <utility>

#include "app/core/session/carried_lines.h"
#include "app/core/session/session.h"
#include "app/core/session/session_driver.h"
#include "audio-cues/plan/audio_thread.h"
#include "audio-cues/plan/sinks.h"
#include "haptic/device/simulated_device.h"
#include "haptic/servo/servo_loop.h"
#include "worlds/base/clock.h"

namespace handrail::core {

class HeadlessSession {
public:
    // The sinks receive all output in virtual time and must outlive the session. A hand that is not present gets no
    // servo.
    HeadlessSession(const settings::Settings& settings, const HandFacts& hand, cues::AudioSink& audio,
                    cues::SpeechSink& speech, const SessionOptions& options = {});
    ~HeadlessSession();

    Session& app() { return app_; }
    // Adds a left hand; the hand of the constructor is then the right one. If `facts` describe an absent hand, removes
    // the left hand.
    void give_left_hand(const HandFacts& facts);
    // Replaces or removes the device of the only or right hand, as if a person had plugged in or removed a device.
    void change_hand(const HandFacts& facts);
    device::SimulatedHand& hand(std::size_t which = 0) { return *hands_[which].simulated; }
    const HandFacts& facts() const { return facts_; }
    const servo::ToolState& tool(std::size_t which = 0) const { return hands_[which].tool; }
    double now_s() const { return clock_.now_s(); }
    void change_settings(const settings::Settings& settings);
    // Inform the session that a key was pressed or that the keyboard focus has changed. As in the program, the switches
    // of the servo are set at once.
    void press(Command command, int times = 1);
    // Presses and releases a key by name. An open list or question gets the key first. Otherwise the session carries
    // out the command of the key. Returns false if the key has no meaning at present.
    bool tap_key(const std::string& name);
    // Adds a line typed in a terminal. As in the program, the line is carried out when the effect of the previous line
    // is over.
    void type(std::string line) { lines_.add(std::move(line)); }
    const CarriedLines& lines() const { return lines_; }
    void set_focus(bool focused);
    // Returns what the hand does before its first command.
    static device::HandCommand still_hand();
    // Makes the servo run only every n-th millisecond from now on, as on a slow machine.
    void slow_servo(int every_ms) { servo_every_ms_ = every_ms; }
    // Advances everything by one millisecond.
    void advance();

private:
    struct Hand {
        std::shared_ptr<device::SimulatedHand> simulated = std::make_shared<device::SimulatedHand>();
        servo::ServoLoop::EventRing contacts;
        std::unique_ptr<servo::ServoLoop> servo;
        servo::ToolState tool;
    };

    void take(std::size_t which, const HandFacts& facts);

    VirtualClock clock_;
    Session app_;
    HandFacts facts_;
    servo::ServoSwitches switches_;  // shared by both hands
    std::array<Hand, 2> hands_;      // the only or right hand, then the left hand
    cues::AudioThread ears_;         // the audio thread; this class steps it, so it has no thread of its own
    SessionDriver driver_{app_, ears_};
    CarriedLines lines_{app_};
    long milliseconds_ = 0;
    long frames_ = 0;
    int servo_every_ms_ = 1;
};

}  // namespace handrail::core
