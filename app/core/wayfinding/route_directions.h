// Provides a route to a room or a place that the person follows by spoken directions. A background task plans the
// route, the first legs first. The class puts the route into words leg by leg from the person's place. It plans the
// route again if the remaining legs no longer lead to its end. This class makes no announcements. Use it on the app
// thread only. Lengths are in world metres.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/core/context/session_part.h"
#include "app/core/wayfinding/directions_ground.h"
#include "app/core/wayfinding/leg_words.h"

namespace handrail::core {

// The end of a route: a room, or a place.
struct DirectionsEnd {
    std::uint32_t room = navigation::kNothing;  // kNothing: the end is the place
    Vec3 place_m{0.0};                          // the middle of the room, or the place
    bool at_passage = false;  // true: at the place, a passage comes that has no legs, such as a locked door
};

class RouteDirections : SessionPart {
public:
    RouteDirections(const SessionContext& context, Rooms& rooms, DirectionsGround& ground);

    // Begins a route from the walker's place, which replaces the previous route. `goal` is the name of the end of the
    // route.
    void begin(const DirectionsEnd& end, std::string goal);
    void stop();

    // - None: there is no route.
    // - Planned: the route is being planned.
    // - Known: at least its first legs can be announced.
    // - NoRoute: there are no spoken directions for a route.
    enum class State : std::uint8_t { None, Planned, Known, NoRoute };
    State state() const { return state_; }
    bool at_work() const { return state_ == State::Planned || state_ == State::Known; }
    // Returns true while legs that the person requested are being planned. News::planned reports when they are ready.
    bool awaited() const {
        return state_ == State::Planned || (state_ == State::Known && awaited_ != Awaited::Nothing);
    }
    // Returns true if all legs of the route are known, or if there are none.
    bool whole() const { return state_ != State::Planned && (state_ != State::Known || way_.route->whole); }

    struct News {
        bool planned = false;  // true: what the person requested is ready, or does not exist
        bool arrived = false, left = false;
    };
    // Updates the route. If the walker has moved, the call costs one lookup in the grid.
    News tick();

    // These functions return legs as sentences. A result is empty if there is no route. It is also empty while the
    // route is being planned again, and tick() reports when that is done. leg() returns the present leg from the
    // present place, or the next leg if the present one is over.
    std::string leg();
    // Returns the leg after the one announced last.
    std::string next_leg();
    // Returns all remaining legs in order.
    std::vector<std::string> rest();
    // Returns the length of the remaining legs in words, as rest() gives them. Returns no value if not all legs are
    // known.
    std::optional<std::string> total_words() const;
    // How many of the remaining legs begin with a turn, and how many lead through a door.
    struct Counts {
        std::size_t turns = 0, doors = 0;
    };
    // Returns no value if not all legs are known.
    std::optional<Counts> counts() const;
    // Moves on to the end of the present leg, or of the next one if the walker stands at that end already. The caller
    // places the walker there. Returns no value while no leg is known.
    struct LegEnd {
        Vec3 at_m{0.0};
        double heading_rad = 0.0;  // direction of the leg
        bool last = false;         // true: the route ends there
    };
    std::optional<LegEnd> move_on();
    // Plans the route again from the present place. tick() reports when its legs are known.
    void plan_from_here() { plan(); }
    // Call it when the feature `by` has stopped the walker at its present place and heading. If a leg continues in that
    // direction, that leg then begins with the door that stopped the walker. If the cause was not a door, the spoken
    // directions end.
    void note_stop(FeatureId by);
    // Returns the door that the leg announced last tells the person to open or to shut. Returns kNoFeature if the leg
    // names no such door, if the person has operated it since, or if the person does not face in the direction of the
    // leg.
    FeatureId door_to_use() const;
    // Returns the direction of the leg announced last, or no value if none was announced.
    std::optional<double> heading_rad() const;

private:
    struct Planned {
        std::shared_ptr<const DirectionsFloor> floor;
        std::shared_ptr<const navigation::DirectionsGoal> goal;
        std::optional<navigation::DirectionsRoute> route;
        Vec3 from_m{0.0};
        int notch = 0;
        navigation::DoorsOpen open;  // state of the doors when the route was planned
    };
    enum class Awaited : std::uint8_t { Nothing, NextLeg, Rest };
    void plan(bool in_parts = true);
    void plan_rest();
    void take(Planned planned);
    bool take_rest(Planned planned);
    std::string await(Awaited what);
    LegAt leg_at(std::size_t which) const;
    bool stopped_on(const LegAt& leg) const;
    bool begin_with_door(SpokenLeg& leg) const;
    bool in_outline(const Vec3& feet_m) const;
    bool holds() const;
    std::string directions();
    std::vector<SpokenLeg> spoken_rest() const;
    navigation::DoorsOpen open_now() const { return ground_.open_now(*way_.floor); }

    Rooms& rooms_;
    DirectionsGround& ground_;
    State state_ = State::None;
    DirectionsEnd end_;
    std::string goal_;
    bool wanted_ = false;                 // true: a plan begins as soon as the floor is known
    Awaited awaited_ = Awaited::Nothing;  // which unknown legs the person has requested
    Planned way_;
    std::size_t at_ = 0;  // index of the leg that the person is walking
    Vec3 looked_m_{0.0};
    struct Stop {
        Vec3 at_m{0.0};
        double heading_rad = 0.0;
        FeatureId door = kNoFeature;  // kNoFeature: the walker was not stopped by a door
        int times = 1;                // consecutive stops by the same door
    };
    std::optional<Stop> stopped_;
    FeatureId uses_ = kNoFeature;  // the door that the leg announced last tells the person to operate
    bool shuts_ = false;           // true: the person must shut that door; false: open it
    BackgroundTask<Planned> planning_{context_.executor, "word-route", context_.arrivals};
};

}  // namespace handrail::core
