// The whole program on a virtual clock in one thread: servos a thousand times a second, ears two hundred times, the app
// sixty times. Session, SessionDriver, ServoLoop and AudioThread are those of the program; what its threads do happens
// here in a fixed order, so the same input gives the same output. For scenarios and tests.
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

namespace handrail {

class HeadlessSession {
public:
    // The sinks are told everything in virtual time and must outlive the session. A hand that is not present gets no
    // servo.
    HeadlessSession(const Settings& settings, const HandFacts& hand, AudioSink& audio, SpeechSink& speech,
                    const SessionOptions& options = {});
    ~HeadlessSession();

    Session& app() { return app_; }
    // A second hand, the left one; from then on the one of the constructor is the right one. Facts of none take it away
    // again.
    void give_left_hand(const HandFacts& facts);
    // Another device, or none, for the only or right hand from now on, as when one is unplugged and another taken.
    void change_hand(const HandFacts& facts);
    SimulatedHand& hand(std::size_t which = 0) { return *hands_[which].simulated; }
    const HandFacts& facts() const { return facts_; }
    const ToolState& tool(std::size_t which = 0) const { return hands_[which].tool; }
    double now_s() const { return clock_.now_s(); }
    void change_settings(const Settings& settings);
    // A key goes down, and the keyboard comes and goes: as in a real session the servo's switches are set at once, and
    // the app is told.
    void press(Command command, int times = 1);
    // A key by name goes down and up: to an open list or question, else the command it stands for. False: it means
    // nothing here.
    bool tap_key(const std::string& name);
    // Types a line. It is carried out as by the program: when what the line before began is over.
    void type(std::string line) { lines_.add(std::move(line)); }
    const CarriedLines& lines() const { return lines_; }
    void set_focus(bool focused);
    // What the hand does before it is told anything.
    static HandCommand still_hand();
    // The servo runs only every n-th millisecond from now on, as on a machine that is too slow.
    void slow_servo(int every_ms) { servo_every_ms_ = every_ms; }
    // One millisecond of everything.
    void advance();

private:
    struct Hand {
        std::shared_ptr<SimulatedHand> simulated = std::make_shared<SimulatedHand>();
        ServoLoop::EventRing contacts;
        std::unique_ptr<ServoLoop> servo;
        ToolState tool;
    };

    void take(std::size_t which, const HandFacts& facts);

    VirtualClock clock_;
    Session app_;
    HandFacts facts_;
    ServoSwitches switches_;     // of both hands
    std::array<Hand, 2> hands_;  // the only or right one, the left one
    AudioThread ears_;           // stepped, without its thread
    SessionDriver driver_{app_, ears_};
    CarriedLines lines_{app_};
    long milliseconds_ = 0;
    long frames_ = 0;
    int servo_every_ms_ = 1;
};

}  // namespace handrail
