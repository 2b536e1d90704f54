// Announces that the person has arrived at a goal, and does so again if the announcement was cut off and the person is
// still there. Guide owns it. Use it on the app thread only.
#pragma once

#include <optional>
#include <string>

#include "app/core/context/session_part.h"
#include "worlds/base/vec.h"

namespace handrail::core {

class Arrival : SessionPart {
public:
    explicit Arrival(const SessionContext& context) : SessionPart(context) {}

    // How an arrival is announced.
    struct How {
        bool room = false;     // true: the text names the room, so it replaces the announcement of the room
        bool answers = false;  // as in Cues::Telling
        bool led = false;      // true: the person still follows another route
    };
    void tell(std::string text, const How& how, double now_s);
    // Announces the arrival again. Returns false if there is nothing to announce: the person has gone away, follows a
    // new route, or the last arrival has another topic. `led` is the present value of How::led.
    bool announce_anew(cues::SpeechTopic topic, bool led, double now_s);
    void forget() { last_.reset(); }

private:
    struct Last {
        std::string text;
        How how;
        Vec3 feet_m{0.0};  // position of the walker on arrival
    };
    std::optional<Last> last_;
};

}  // namespace handrail::core
