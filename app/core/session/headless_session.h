// The whole program on a virtual clock in one thread: servos a thousand times a second, audio two hundred times, the
// app sixty times. Session, SessionDriver, ServoLoop and AudioThread are those of the program. What the program's
// threads do happens here in a fixed order, so the same input gives the same output. For scenarios and tests.
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
    // The sinks receive everything in virtual time and must outlive the session. A hand that is not present gets no
    // servo.
    HeadlessSession(const settings::Settings& settings, const HandFacts& hand, cues::AudioSink& audio,
                    cues::SpeechSink& speech, const SessionOptions& options = {});
    ~HeadlessSession();

    Session& app() { return app_; }
    // Adds a second hand, the left one; the hand of the constructor is then the right one. Facts of an absent hand
    // remove it again.
    void give_left_hand(const HandFacts& facts);
    // Replaces the device of the only or right hand, or removes it, as when a person unplugs it.
    void change_hand(const HandFacts& facts);
    device::SimulatedHand& hand(std::size_t which = 0) { return *hands_[which].simulated; }
    const HandFacts& facts() const { return facts_; }
    const servo::ToolState& tool(std::size_t which = 0) const { return hands_[which].tool; }
    double now_s() const { return clock_.now_s(); }
    void change_settings(const settings::Settings& settings);
    // A key is pressed; the keyboard focus changes. As in a real session, the servo's switches are set at once and the
    // app is informed.
    void press(Command command, int times = 1);
    // Presses and releases a key by name. An open list or question gets it first; otherwise its command is done.
    // Returns false if the key has no meaning here.
    bool tap_key(const std::string& name);
    // Types a line. As in the program, it is carried out when the effect of the previous one is over.
    void type(std::string line) { lines_.add(std::move(line)); }
    const CarriedLines& lines() const { return lines_; }
    void set_focus(bool focused);
    // What the hand does before its first command.
    static device::HandCommand still_hand();
    // From now on the servo runs only every n-th millisecond, as on a slow machine.
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
    servo::ServoSwitches switches_;  // for both hands
    std::array<Hand, 2> hands_;      // the only or right one, the left one
    cues::AudioThread ears_;         // stepped here, not on its own thread
    SessionDriver driver_{app_, ears_};
    CarriedLines lines_{app_};
    long milliseconds_ = 0;
    long frames_ = 0;
    int servo_every_ms_ = 1;
};

}  // namespace handrail::core
