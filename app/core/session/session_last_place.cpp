// The part of Session that continues where an earlier session crashed. Use it on the app thread only.
#include <algorithm>

#include "app/core/session/session.h"
#include "worlds/base/language.h"

namespace handrail::core {
namespace {

constexpr double kOutside_m = 10.0;  // a stored place that is farther outside the world than this is wrong

}  // namespace

void Session::offer_last_place(double now_s) {
    if (!given_.last_place) {
        play(cues::SoundKind::Denied, now_s);
        return answer(phrase("last_place.none"), now_s);
    }
    state_.requests.last_place = given_.last_place;
}

void Session::go_on_at(const LastPlace& last, double now_s) {
    const Vec3 room(kOutside_m);
    const Aabb& bounds = state_.world.scene->bounds_m;
    if (bounds.empty() || glm::any(glm::lessThan(last.feet_m, bounds.min_m - room)) ||
        glm::any(glm::greaterThan(last.feet_m, bounds.max_m + room)))
        return answer(phrase("last_place.gone"), now_s);
    walk_.by_ear.keep_place();
    place(last.feet_m, last.heading_rad, now_s);
    if (state_.world.solids->blocked(feet_m(), state_.avatar.walker->shape())) {
        const auto free = nearest_free_feet(*state_.world.solids, feet_m(), state_.avatar.walker->shape());
        if (!free) {
            walk_.walking.go_home(now_s);
            return answer(phrase("last_place.gone"), now_s);
        }
        place(*free, last.heading_rad, now_s);
    }
    answer(phrase("last_place.here", {{"where", where_am_i()}}), now_s);
}

}  // namespace handrail::core
