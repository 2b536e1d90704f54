// Announces a route that the person follows by ear. The route is announced once as a whole, and then step by step.
// Lengths are in world metres. Use it on the app thread only.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/core/context/context_words.h"
#include "app/core/context/session_part.h"
#include "app/core/wayfinding/far_route.h"
#include "app/core/wayfinding/route_directions.h"
#include "app/core/wayfinding/route_plans.h"
#include "app/core/wayfinding/route_words.h"

namespace handrail::core {

// The form of the announcements of a route: leg by leg if that is possible, or as a whole route.
enum class RouteForm : std::uint8_t { ByLegs, Whole };

class SpokenRoute : SessionPart {
public:
    SpokenRoute(const SessionContext& context, Rooms& rooms, RoutePlans& plans, DirectionsGround& ground)
        : SessionPart(context), rooms_(rooms), plans_(plans), ground_(ground), directions_(context, rooms, ground) {}

    // Announces the route and follows it. If the goal cannot be reached, the route leads to the nearest place that can
    // be reached, and the function returns false. `first` is announced before everything else. Call it only after the
    // rooms have been found.
    bool follow(navigation::Route route, const std::string& name, const std::string& first, double now_s,
                RouteForm form);
    void follow_to(const Vec3& goal_m, const std::string& name, const std::string& first, double now_s);
    // Follows the route to a room. If stairs lead there, too, and are not much farther than a lift, the route is
    // announced leg by leg.
    bool follow_to_room(std::uint32_t room, const std::string& first, double now_s);
    // Returns the route from here to a room, for the announcement of its length. `on_foot` has the distances from here.
    navigation::Route to_room(std::uint32_t room, const navigation::FootDistances& on_foot) const;
    // Plans and announces the route to the present goal again.
    void follow_again(const std::string& first, double now_s);
    void stop();
    bool following() const { return follower_.following(); }
    bool leads_to_room() const { return room_.has_value(); }  // returns true if the goal is a room that can be reached
    bool plans_legs() const { return directions_.awaited(); }
    bool plans_rest() const { return directions_.at_work() && !directions_.whole(); }
    // Returns the name of the goal or of the nearest place to it, as announced. The name is kept after the route has
    // ended.
    const std::string& name() const { return name_; }
    bool to_nearest() const { return to_nearest_; }  // returns true if the goal itself cannot be reached
    const Vec3& goal_m() const { return follower_.goal_m(); }
    double along_m() const { return follower_.along_m(); }
    // Returns the length of the rest of the route in words: the sum of the legs, or the planned length until all legs
    // are known.
    std::string left_words() const;
    // Announces how far the route goes straight on, in which direction, and to what.
    void announce_onward(double now_s);
    // These functions announce the present leg and the next one.
    void announce_leg(double now_s);
    void announce_next_leg(double now_s);
    // announce_leg_unprompted() announces what comes next without a request by the person. announce_anew() announces
    // that or the whole route once more, because the line about the route was cut off.
    void announce_leg_unprompted(std::string words, bool anew, double now_s);
    void announce_anew(cues::SpeechTopic topic, double now_s);
    void announce_rest(double now_s);
    // Places the walker at the end of the present leg, or at the next instruction of a route without legs, and
    // announces that place and the next leg. Returns false if no route is followed, or if its legs are not known yet.
    bool leap_on(double now_s);
    // Places the walker where it was before the last leap along this route. Returns false if there was none.
    bool leap_back(double now_s);
    // Returns what announce_rest() announces, one text for each leg. The result is empty if the legs are being planned
    // or no route is followed.
    std::vector<std::string> rest_of_route();
    // Returns the direction of the announced leg, or no value if no route is followed.
    std::optional<double> leg_heading_rad() const;
    // Returns the door that the announced leg tells the person to open or to shut, or kNoFeature.
    FeatureId door_to_use() const { return directions_.door_to_use(); }
    // Call it when this feature has stopped the walker.
    void note_stop(FeatureId by);
    // Returns the next stairs on the route if the person stands before them and one command climbs all of them.
    std::optional<navigation::RoutePassage> climb_here() const;
    // If a door leaf now blocks the rest of the route, replaces it by a route round the leaf. Only the next directions
    // change; nothing is announced.
    void renew();
    // Follows the walker; returns what to announce now.
    RouteFollower::Said tick(double now_s);

private:
    bool follow_by_legs(const DirectionsEnd& end, FarRoute far, const std::string& name, const std::string& first,
                        double now_s);
    bool begin_legs(const navigation::Route& route, const DirectionsEnd& end, const std::string& name);
    bool goes_by_legs();
    void plan_on();
    navigation::Route planned() const;
    bool stands_in(const navigation::RoutePassage& passage) const;
    bool stands_at(const navigation::RoutePassage& passage) const;
    bool there(bool at_end) const;
    std::string on_words();
    std::vector<std::string> legs_to(const navigation::Route& route, const std::string& goal) const;
    std::string overview(const navigation::Route& route) const;
    std::string length_words(const std::string& through) const;
    RouteCounts counts() const;
    std::optional<Vec3> leg_place_m() const;
    void follow_silently(navigation::Route route, const std::string& goal);
    void announce(const std::string& words, cues::SpeechTopic topic, double now_s);
    bool stopped_towards(const Vec3& to_m) const;
    std::string leaf_on_route(const Vec3& to_m) const;
    bool is_open_leaf(FeatureId by) const;
    // Notes that the walker has left the place of the last stop, if it is so.
    void leave_stop();
    std::optional<Vec3> place_aside(const Vec3& to_m) const;
    RouteFollower::Said tick_words(double now_s);
    void announce_facing(double now_s);

    Rooms& rooms_;
    RoutePlans& plans_;
    DirectionsGround& ground_;
    RouteFollower follower_;
    RouteDirections directions_;
    std::optional<FarRoute> unfinished_;  // the route that is followed, while later ticks plan more of it
    std::optional<std::uint32_t> room_;   // the room that is the goal, if it can be reached
    // OnFoot while directions leg by leg are announced, so that both plans use the same route.
    navigation::RoutePreference preference_ = navigation::RoutePreference::Safest;
    bool faces_ = false;             // true: the person faces in the direction of the announced leg
    bool to_passage_ = false;        // true: the legs end at a passage that has no legs, such as a lift
    bool length_owed_ = false;       // true: the length of the route is announced with its first leg
    bool rest_requested_ = false;    // true: the person requested the rest of the route before it was planned
    std::optional<Vec3> no_legs_m_;  // the last place from which no directions leg by leg were found
    std::string name_;
    bool to_nearest_ = false;
    struct Stop {
        FeatureId by = kNoFeature;
        Vec3 at_m{0.0};
        double heading_rad = 0.0;
        int times = 1;                // consecutive stops by the same feature
        std::vector<Vec3> tried_m;    // places aside that were announced after earlier stops near here
        std::optional<Vec3> aside_m;  // place aside that was announced after this stop
        bool left = false;            // true: the walker has heard directions from elsewhere since
    };
    std::optional<Stop> stopped_;                 // where and by what the walker was last stopped
    std::optional<navigation::Route> announced_;  // the rest of the route, as announce_onward() last announced it
    struct Place {
        Vec3 feet_m{0.0};
        double heading_rad = 0.0;
    };
    std::vector<Place> leapt_from_;            // places before the leaps along this route, the newest last
    std::shared_ptr<const Scene> planned_in_;  // the scene in which the route was planned
};

}  // namespace handrail::core
