// Leaping from one thing that is near to the next, and back: the nearest first that one has not leapt to since one last
// walked or turned, the doors of the room among them. Says where one is then. Also takes back what put the body
// elsewhere. App thread only; world metres.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/core/context/session_part.h"

namespace handrail {

// A door of the room one is in, and where one stands before it.
struct LeapDoor {
    FeatureId feature = kNoFeature;
    Vec3 place_m{0.0}, feet_m{0.0};
};

class Leaping : SessionPart {
public:
    // where_am_i: the answer to that question; doors: of the room one is in, none where rooms are not known. Both may
    // be set later, and outlive this object.
    Leaping(const SessionContext& context, const BodyState& body, const std::function<std::string()>& where_am_i,
            const std::function<std::vector<LeapDoor>()>& doors)
        : SessionPart(context), body_(body), where_am_i_(where_am_i), doors_(doors) {}

    void enter_world();
    // Whoever goes or turns by other means begins anew with what is nearest then.
    void begin_anew() { leapt_.clear(); }
    // Leaps and taking them back. False: it is another's.
    bool act(Command command, double now_s);
    // Leaps, Home and the like can be taken back: called before them.
    void keep_place();

private:
    struct Place {
        Vec3 feet_m{0.0};
        double heading_rad = 0.0;
    };
    // Features by their number, and marks, counted on from them.
    struct Target {
        std::uint32_t number = 0;
        double bearing_rad = 0.0, distance_m = 0.0;  // from the body, level
        bool mark = false;
        std::optional<Place> before;  // where one stands, where that is known
    };
    struct Leapt {
        std::uint32_t number = 0;
        std::string name;
        Place place;
    };
    std::vector<Target> targets() const;
    std::optional<Place> place_at(const Target& target) const;
    std::string name_of_target(const Target& target) const;
    void leap_on(double now_s);
    void leap_back(double now_s);
    void leap_to(const Leapt& to, double now_s);
    void undo(double now_s);

    const BodyState& body_;
    const std::function<std::string()>& where_am_i_;
    const std::function<std::vector<LeapDoor>()>& doors_;
    std::vector<Place> undo_;   // the newest last
    std::vector<Leapt> leapt_;  // since the person last went or turned otherwise, the newest last
};

}  // namespace handrail
