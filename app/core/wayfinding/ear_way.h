// A way that is followed by ear: told once, then step by step. Metres, world. App thread only.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "app/core/context/session_part.h"
#include "app/core/context/telling.h"
#include "app/core/wayfinding/route_words.h"
#include "app/core/wayfinding/way_plans.h"
#include "app/core/wayfinding/word_way.h"

namespace handrail {

class EarWay : SessionPart {
public:
    EarWay(const SessionContext& context, Rooms& rooms, WayPlans& plans, WordGround& ground)
        : SessionPart(context), rooms_(rooms), plans_(plans), word_(context, rooms, ground) {}

    // Tells the way and follows it; where the goal cannot be reached, to the nearest place that can. `first` is said
    // before all else. The rooms are found. False: it ends before the goal.
    bool follow(Route route, const std::string& name, const std::string& first, double now_s);
    void follow_to(const Vec3& goal_m, const std::string& name, const std::string& first, double now_s);
    // To a room by words, leg by leg; as follow where lifts, teleporters or edges lead there.
    bool follow_to_room(std::uint32_t room, const std::string& first, double now_s);
    // How that way goes from here: its length is what is told of it.
    Route to_room(std::uint32_t room) const { return route_to(room).route; }
    // Anew to where one is going.
    void follow_again(const std::string& first, double now_s);
    void stop();
    bool following() const { return follower_.following(); }
    bool plans_legs() const { return word_.awaited(); }
    bool plans_rest() const { return word_.at_work() && !word_.whole(); }
    // As it is told: of the goal or of the nearest place to it. Kept when the way is over.
    const std::string& name() const { return name_; }
    bool to_nearest() const { return to_nearest_; }  // of what cannot be reached
    const Vec3& goal_m() const { return follower_.goal_m(); }
    double along_m() const { return follower_.along_m(); }
    // How far it goes on straight, which way, and to what.
    void tell_on(double now_s);
    // The leg one is on, the next one, or the rest of the way.
    void tell_leg(double now_s);
    void tell_next_leg(double now_s);
    void tell_rest(double now_s);
    // What that tells, a leg each; empty: it is being planned, or no way is followed.
    std::vector<std::string> rest_of_way();
    // Which way the leg that was told leads; none: no way is followed.
    std::optional<double> leg_heading_rad() const;
    // The body was stopped by that part.
    void note_stop(FeatureId by);
    // The stairs to be taken in one go that it leads over next, where one stands at them.
    std::optional<RoutePassage> climb_here() const;
    // A leaf stands across the rest of the way by now: it goes on round it, without a word but what comes.
    void renew();
    // What there is to say now.
    RouteFollower::Said tick(double now_s);

private:
    struct RoomRoute {
        Route route;
        bool by_legs = false;  // nothing of it keeps it from being told leg by leg
    };
    RoomRoute route_to(std::uint32_t room) const;
    Route planned() const;
    bool stands_in(const RoutePassage& passage) const;
    bool stands_at(const RoutePassage& passage) const;
    bool there(bool at_end) const;
    void follow_silently(Route route, const std::string& goal);
    void tell(const std::string& words, double now_s);
    std::string leaf_in_way(const Vec3& to_m) const;
    RouteFollower::Said tick_words(double now_s);
    void tell_facing(double now_s);

    Rooms& rooms_;
    WayPlans& plans_;
    RouteFollower follower_;
    WordWay word_;
    std::optional<std::uint32_t> room_;   // that one goes to, where it is one and can be reached
    RouteWish wish_ = RouteWish::Safest;  // OnFoot where legs are told, so that both tell the same way
    bool faces_ = false;                  // the leg that was told
    bool rest_asked_ = false;             // the rest of the way was asked for before it was planned
    std::string name_;
    bool to_nearest_ = false;
    struct Stop {
        FeatureId by = kNoFeature;
        Vec3 at_m{0.0};
        double heading_rad = 0.0;
        int times = 1;  // by the same part one after the other
    };
    std::optional<Stop> stopped_;              // the body, last
    std::optional<Route> told_;                // how it goes on, as tell_on told it last
    std::shared_ptr<const Scene> planned_in_;  // the world as it was when the way was planned
};

}  // namespace handrail
