// A way that is followed by ear: told once, then step by step. Metres, world. App thread only.
#pragma once

#include <memory>
#include <string>

#include "app/core/context/telling.h"
#include "app/core/wayfinding/route_words.h"
#include "app/core/wayfinding/way_plans.h"

namespace handrail {

class EarWay {
public:
    EarWay(const SessionContext& context, Rooms& rooms, WayPlans& plans)
        : context_(context), rooms_(rooms), plans_(plans) {}

    // Tells the way and follows it; where the goal cannot be reached, to the nearest place that can. `first` is said
    // before all else. The rooms are found.
    void follow(Route route, const std::string& name, const std::string& first, double now_s);
    void follow_to(const Vec3& goal_m, const std::string& name, const std::string& first, double now_s);
    void stop() { follower_.stop(); }
    bool following() const { return follower_.following(); }
    // As it is told: of the goal or of the nearest place to it. Kept when the way is over.
    const std::string& name() const { return name_; }
    bool to_nearest() const { return to_nearest_; }  // of what cannot be reached
    const Vec3& goal_m() const { return follower_.goal_m(); }
    double along_m() const { return follower_.along_m(); }
    // How far it goes on straight, which way, and to what.
    void tell_on(double now_s) const;
    // A leaf stands across the rest of the way by now: it goes on round it, without a word but what comes.
    void renew();
    // What there is to say now.
    RouteFollower::Said tick() { return follower_.tick(context_.body.feet_m(), distances(context_)); }

private:
    const SessionContext& context_;
    Rooms& rooms_;
    WayPlans& plans_;
    RouteFollower follower_;
    std::string name_;
    bool to_nearest_ = false;
    std::shared_ptr<const Scene> planned_in_;  // the world as it was when the way was planned
};

}  // namespace handrail
