// A route followed by ear: announced once as a whole, then step by step. Metres, world. App thread only.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "app/core/context/session_part.h"
#include "app/core/context/telling.h"
#include "app/core/wayfinding/route_directions.h"
#include "app/core/wayfinding/route_plans.h"
#include "app/core/wayfinding/route_words.h"

namespace handrail::core {

class SpokenRoute : SessionPart {
public:
    SpokenRoute(const SessionContext& context, Rooms& rooms, RoutePlans& plans, DirectionsGround& ground)
        : SessionPart(context), rooms_(rooms), plans_(plans), word_(context, rooms, ground) {}

    // Announces the route and follows it. If the goal cannot be reached, it leads to the nearest place that can, and
    // returns false. `first` is announced before everything else. Requires that the rooms are found.
    bool follow(navigation::Route route, const std::string& name, const std::string& first, double now_s);
    void follow_to(const Vec3& goal_m, const std::string& name, const std::string& first, double now_s);
    // To a room, in words leg by leg. If lifts, teleporters or edges are on the route, it behaves like follow.
    bool follow_to_room(std::uint32_t room, const std::string& first, double now_s);
    // The route from here; only its length is announced.
    navigation::Route to_room(std::uint32_t room) const { return route_to(room).route; }
    // Plans and announces the route to the present goal again.
    void follow_again(const std::string& first, double now_s);
    void stop();
    bool following() const { return follower_.following(); }
    bool plans_legs() const { return word_.awaited(); }
    bool plans_rest() const { return word_.at_work() && !word_.whole(); }
    // As announced: the goal or the nearest place to it. Kept after the route is over.
    const std::string& name() const { return name_; }
    bool to_nearest() const { return to_nearest_; }  // the goal itself cannot be reached
    const Vec3& goal_m() const { return follower_.goal_m(); }
    double along_m() const { return follower_.along_m(); }
    // Announces how far it goes straight on, in which direction, and to what.
    void tell_on(double now_s);
    // Announces the present leg, the next one, or the rest of the route.
    void tell_leg(double now_s);
    void tell_next_leg(double now_s);
    // Unasked: what comes next, and the same or the way as a whole once more, since the line with it was cut.
    void tell_leg_unasked(std::string words, bool anew, double now_s);
    void tell_anew(cues::SpeechTopic topic, double now_s);
    void tell_rest(double now_s);
    // What tell_rest announces, one text for each leg; empty: it is being planned, or no route is followed.
    std::vector<std::string> rest_of_way();
    // Direction of the announced leg; no value: no route is followed.
    std::optional<double> leg_heading_rad() const;
    // That feature stopped the walker.
    void note_stop(FeatureId by);
    // The stairs that come next on the route and can be climbed in one go, if the person stands before them.
    std::optional<navigation::RoutePassage> climb_here() const;
    // If a door leaf now blocks the rest of the route, a new route leads round it. Only the next directions change;
    // nothing else is announced.
    void renew();
    // Returns what to announce now.
    RouteFollower::Said tick(double now_s);

private:
    struct RoomRoute {
        navigation::Route route;
        bool by_legs = false;  // all of it can be announced leg by leg
    };
    RoomRoute route_to(std::uint32_t room) const;
    navigation::Route planned() const;
    bool stands_in(const navigation::RoutePassage& passage) const;
    bool stands_at(const navigation::RoutePassage& passage) const;
    bool there(bool at_end) const;
    std::string on_words();
    std::optional<Vec3> leg_place_m() const;
    void follow_silently(navigation::Route route, const std::string& goal);
    void tell(const std::string& words, cues::SpeechTopic topic, double now_s);
    std::string leaf_in_way(const Vec3& to_m) const;
    RouteFollower::Said tick_words(double now_s);
    void tell_facing(double now_s);

    Rooms& rooms_;
    RoutePlans& plans_;
    RouteFollower follower_;
    RouteDirections word_;
    std::optional<std::uint32_t> room_;  // the goal room, if the goal is a room and can be reached
    navigation::RouteWish wish_ =
        navigation::RouteWish::Safest;  // OnFoot while legs are announced, so that both plans use the same route
    bool faces_ = false;                // the person faces the announced leg
    bool rest_asked_ = false;           // the rest of the route was requested before it was planned
    std::string name_;
    bool to_nearest_ = false;
    struct Stop {
        FeatureId by = kNoFeature;
        Vec3 at_m{0.0};
        double heading_rad = 0.0;
        int times = 1;  // consecutive stops by the same feature
    };
    std::optional<Stop> stopped_;              // the last stop of the walker
    std::optional<navigation::Route> told_;    // the rest of the route as tell_on last announced it
    std::shared_ptr<const Scene> planned_in_;  // the scene in which the route was planned
};

}  // namespace handrail::core
