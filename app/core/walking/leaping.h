// Moves the walker in leaps from one nearby thing to the next, and back, and announces each new place. The next thing
// is the nearest one that has not been visited since the last walk or turn. The doors of the room are included. The
// class also undoes every command that moved the walker elsewhere. Use it on the app thread only. Lengths are in world
// metres.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/core/context/session_part.h"

namespace handrail::core {

// A door of the present room, and the walker's place in front of it.
struct LeapDoor {
    FeatureId feature = kNoFeature;
    Vec3 place_m{0.0}, feet_m{0.0};
};

class Leaping : SessionPart {
public:
    // `where_am_i` returns the answer to the question "where am I". `doors` returns the doors of the present room, or
    // none if the rooms are not known. Both functions may be set later, and must outlive this object.
    Leaping(const SessionContext& context, const WalkerState& avatar, const std::function<std::string()>& where_am_i,
            const std::function<std::vector<LeapDoor>()>& doors)
        : SessionPart(context), avatar_(avatar), where_am_i_(where_am_i), doors_(doors) {}

    void enter_world();
    // Begins the series again with the nearest thing. Call it after any other movement.
    void begin_anew() { leapt_.clear(); }
    // Carries out leaps and undoing. Returns false if the command belongs to another feature.
    bool act(Command command, double now_s);
    // Stores the present place for undoing. Call it before leaps, before the command Home, and before any other command
    // that moves the walker elsewhere.
    void keep_place();

private:
    struct Place {
        Vec3 feet_m{0.0};
        double heading_rad = 0.0;
    };
    // A place to which the walker can leap. `number` is the number of its feature. Marks are numbered after all
    // features.
    struct Target {
        std::uint32_t number = 0;
        double bearing_rad = 0.0, distance_m = 0.0;  // from the walker, in the horizontal plane
        bool mark = false;
        std::optional<Place> before;  // where the walker would stand in front of it, if known
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

    const WalkerState& avatar_;
    const std::function<std::string()>& where_am_i_;
    const std::function<std::vector<LeapDoor>()>& doors_;
    std::vector<Place> undo_;   // places to go back to, the newest last
    std::vector<Leapt> leapt_;  // targets visited since the person last walked or turned, the newest last
};

}  // namespace handrail::core
