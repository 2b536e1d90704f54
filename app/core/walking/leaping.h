// Leaps from one nearby thing to the next, and back. The next is the nearest one not visited since the last walk or
// turn; the doors of the room are among them. Announces the new place. Also undoes whatever moved the walker elsewhere.
// App thread only; world metres.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/core/context/session_part.h"

namespace handrail::core {

// A door of the present room, and where the walker stands before it.
struct LeapDoor {
    FeatureId feature = kNoFeature;
    Vec3 place_m{0.0}, feet_m{0.0};
};

class Leaping : SessionPart {
public:
    // where_am_i: the answer to that question. doors: of the present room, none if rooms are not known. Both may be set
    // later, and outlive this object.
    Leaping(const SessionContext& context, const WalkerState& body, const std::function<std::string()>& where_am_i,
            const std::function<std::vector<LeapDoor>()>& doors)
        : SessionPart(context), body_(body), where_am_i_(where_am_i), doors_(doors) {}

    void enter_world();
    // After other movement, the series begins again with what is nearest then.
    void begin_anew() { leapt_.clear(); }
    // Handles leaps and undoing them. Returns false if the command belongs to another feature.
    bool act(Command command, double now_s);
    // Call it before leaps, Home and the like, so that they can be undone.
    void keep_place();

private:
    struct Place {
        Vec3 feet_m{0.0};
        double heading_rad = 0.0;
    };
    // The number of a feature; marks are numbered after all features.
    struct Target {
        std::uint32_t number = 0;
        double bearing_rad = 0.0, distance_m = 0.0;  // from the walker, level
        bool mark = false;
        std::optional<Place> before;  // where the walker would stand, if known
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

    const WalkerState& body_;
    const std::function<std::string()>& where_am_i_;
    const std::function<std::vector<LeapDoor>()>& doors_;
    std::vector<Place> undo_;   // newest last
    std::vector<Leapt> leapt_;  // since the person last walked or turned; newest last
};

}  // namespace handrail::core
