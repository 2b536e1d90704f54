#include "app/core/wayfinding/route_plans.h"

#include <algorithm>

#include "app/core/context/context_words.h"
#include "app/core/wayfinding/hand_path.h"
#include "app/core/world/surroundings.h"
#include "worlds/base/contract.h"
#include "worlds/base/language.h"

namespace handrail::core {
namespace {

constexpr double kPassed_m = 0.6;     // a guided hand has passed a stop within this distance
constexpr double kPassedEar_m = 0.3;  // the person has passed a stop this far before the stop, measured along the route
// Limits of the height of a guided hand: above door sills and under lintels.
constexpr double kLowest_m = 0.3, kHighest_m = 1.6;

}  // namespace

void RoutePlans::enter_world() {
    run_.reset();
    last_m_.clear();
}

void RoutePlans::begin(const std::vector<Stop>& stops, bool first_passed, bool by_hand) {
    contract_pre(!stops.empty());
    // The last stop is never skipped, because there would be no goal left. So its arrival is announced, even if it has
    // been passed.
    run_ = RouteRun{stops, first_passed && stops.size() > 1 ? 1U : 0U, by_hand, {}, 0};
}

navigation::Route RoutePlans::on(const Vec3& from_m) {
    run_->planned = run_->next;
    return plan_through(rooms_.navigation(), from_m, run_->places(), &run_->at_m);
}

void RoutePlans::pass(const Vec3& hand_m) {
    RouteRun& run = *run_;
    while (run.next < run.goal() && near_stop(run.stops[run.next], hand_m, kPassed_m)) ++run.next;
}

void RoutePlans::pass(double along_m) {
    RouteRun& run = *run_;
    const auto passed = [&] {
        const std::size_t i = run.next - run.planned;
        return run.next < run.goal() && i < run.at_m.size() && run.at_m[i] < along_m + kPassedEar_m;
    };
    while (passed()) ++run.next;
}

bool RoutePlans::next() {
    if (!run_) return false;
    run_->next = run_->goal() + 1;
    if (run_->next < run_->stops.size()) return true;
    run_.reset();
    return false;
}

HandRoute RoutePlans::for_hand(const Goal& goal, std::size_t most_points) {
    HandRoute way;
    const WalkerWorld& solids = *context_.world.solids;
    const Vec3 from = finding_place_m(context_), on_thing = place_on(goal.box_m, from);
    const std::vector<Vec3> straight{from, nearest_place(goal.box_m, from)};
    // The hand follows the saved route, even if another route is shorter.
    const bool along_kept = runs_to(goal.name) && by_hand();
    const bool stops_first = along_kept && run_->next < run_->goal();
    if (!stops_first && proxy_passes(solids, from, on_thing, goal.feature)) {
        way.points_m = straight;
        return way;
    }
    navigation::Route route;
    if (rooms_.known())
        route = along_kept ? on(from) : walk_to_thing(rooms_.navigation(), solids, from, goal.box_m, goal.feature);
    if (!stops_first && (!route.reaches || !hand_can_follow(route)) &&
        free_line(solids, from, on_thing, goal.feature)) {
        way.points_m = straight;
        return way;
    }
    if (!rooms_.known()) way.problem = why_none();
    else if (route.points_m.empty()) way.problem = phrase("lead.no_start");
    else if (!hand_can_follow(route)) way.problem = phrase("lead.not_for_hands");
    know(route.points_m);
    if (!way.problem.empty()) return way;
    way.reaches = route.reaches;
    way.short_of_m = route.short_of_m;
    for (const navigation::RoutePassage& passage : route.passages)
        if (passage.kind == navigation::PassageKind::Door || passage.kind == navigation::PassageKind::Stairs)
            way.passes.push_back(passage_name(context_, passage.kind, passage.feature, passage.rise_m));
    const double height_m = std::clamp(context_.settings.workspace.hand_height_m, kLowest_m, kHighest_m);
    way.points_m = path_of_hand(route, from, height_m, solids, goal.box_m, goal.feature, most_points);
    return way;
}

std::string RoutePlans::why_none() const {
    return rooms_.awaited() ? phrase("lead.ways_not_yet") : phrase("lead.stands_between");
}

void RoutePlans::know(std::vector<Vec3> soles_m) {
    if (last_m_ != soles_m) ++changes_;
    last_m_ = std::move(soles_m);
}

}  // namespace handrail::core
