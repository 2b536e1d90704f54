// Builds stairs that are in the floor of a room and are not a space themselves. They have one straight flight, or two
// with a landing.
#include <algorithm>
#include <cmath>

#include "worlds/floorplan/plan_builder.h"
#include "worlds/floorplan/upright.h"

namespace handrail::floorplan {
namespace {

constexpr double kEasyRise_m = 0.185, kSteepestRise_m = 0.22, kShortestGoing_m = 0.19, kUsualGoing_m = 0.28;
constexpr double kShortestLanding_m = 0.7, kLongestLanding_m = 1.1;
constexpr double kTreadThick_m = 0.3, kFence_m = 1.0, kFenceThick_m = 0.08, kSlabThick_m = 0.2;
// kStepOff_m: length of a strip in front of the foot and behind the top of the stairs. Walls are opened and floors are
// laid in this strip, so that rooms whose outlines end at the stairs can be reached.
constexpr double kStepOff_m = 0.35, kKeptSide_m = 0.02;

StairWell well_of(const PlanFlight& flight) {
    const Vec2 middle = 0.5 * (flight.least + flight.most), size = flight.most - flight.least;
    const bool level = std::abs(flight.up.x) > 0.5;
    StairWell well;
    well.along = flight.up;
    well.length_m = level ? size.x : size.y;
    well.width_m = level ? size.y : size.x;
    well.from = middle - flight.up * (0.5 * well.length_m);
    return well;
}

struct Steps {
    int count = 1;         // number of steps in the flight, or in each of two flights
    double landing_m = 0;  // length of the landing at the end of the first of two flights
    bool climbable = false;
};

Steps steps_of(const StairWell& well, bool back, double rise_m) {
    Steps steps;
    for (const double rise : {kEasyRise_m, kSteepestRise_m}) {
        steps.count =
            back ? steps_of_half(rise_m, rise) : std::max(1, static_cast<int>(std::ceil(rise_m / rise - 1e-9)));
        steps.landing_m = back ? std::clamp(well.length_m - steps.count * kUsualGoing_m,
                                            std::min(kShortestLanding_m, 0.5 * well.length_m), kLongestLanding_m)
                               : 0.0;
        steps.climbable = (well.length_m - steps.landing_m) / steps.count >= kShortestGoing_m;
        if (steps.climbable) break;
    }
    return steps;
}

}  // namespace

void PlanBuilder::add_flights() {
    for (const PlanFlight& flight : plan_.flights) {
        if (stopped()) return;
        add_flight(flight);
    }
}

void PlanBuilder::add_flight(const PlanFlight& flight) {
    const double low_m = floor_of(flight.from, flight.low), top_m = floor_of(flight.to, flight.high);
    const StairWell well = well_of(flight);
    const Steps steps = steps_of(well, flight.back, top_m - low_m);
    const FeatureId feature = add_feature(FeatureKind::Object, "stairs", flight.name);
    const double half = 0.5 * well.width_m, going = (well.length_m - steps.landing_m) / steps.count,
                 rise = (top_m - low_m) / (flight.back ? 2 * steps.count : steps.count);
    const auto step = [&](double from, double to, double right, double left, double at_m) {
        add_solid(upright(well.box(from, to, right, left), std::max(at_m - kTreadThick_m, low_m), at_m),
                  SolidRole::Solid, feature);
    };
    for (int k = 0; k < steps.count; ++k) {
        step(k * going, (k + 1) * going, -half, flight.back ? 0.0 : half, low_m + (k + 1) * rise);
        if (flight.back)
            step((steps.count - 1 - k) * going, (steps.count - k) * going, 0.0, half,
                 low_m + (steps.count + k + 1) * rise);
    }
    if (flight.back) step(steps.count * going, well.length_m, -half, half, low_m + steps.count * rise);
    // Lays floors in front of the foot and behind the top of the stairs.
    const double top_from = flight.back ? -kStepOff_m : well.length_m;
    for (const auto& [from, at_m] : {std::pair(-kStepOff_m, low_m), std::pair(top_from, top_m)})
        add_solid(upright(well.box(from, from + kStepOff_m, -half, half), at_m - kSlabThick_m, at_m), SolidRole::Solid,
                  kNoFeature);
    fence_flight(flight, well, top_m);
    StatedPortal portal = portal_between(StatedPortalKind::Stairs, flight.name, flight.line,
                                         room_at(flight.from, flight.low), room_at(flight.to, flight.high));
    portal.passable = steps.climbable;
    portal.feature = feature;
    portal.place_m = Vec3(well.at(0.0, flight.back ? -0.5 * half : 0.0), low_m);
    portal.width_m = flight.back ? half : well.width_m;
    portal.height_m = top_m - low_m;
    no_stairs_ += steps.climbable ? 0 : 1;
    ++stated_->stairs;
    stated_->portals.push_back(std::move(portal));
}

// Adds low walls around the hole in the upper floor, and between two flights, so that nobody falls.
void PlanBuilder::fence_flight(const PlanFlight& flight, const StairWell& well, double top_m) {
    const double half = 0.5 * well.width_m, length = well.length_m, thick = kFenceThick_m;
    const auto fence = [&](double from, double to, double right, double left, double from_m) {
        add_solid(upright(well.box(from, to, right, left), from_m, top_m + kFence_m), SolidRole::Solid, kNoFeature);
    };
    fence(0.0, length, -half - thick, -half, top_m);
    fence(0.0, length, half, half + thick, top_m);
    if (!flight.back) {
        fence(-thick, 0.0, -half - thick, half + thick, top_m);
        return;
    }
    const Steps steps = steps_of(well, true, top_m - floor_of(flight.from, flight.low));
    fence(length, length + thick, -half - thick, half + thick, top_m);
    fence(-thick, 0.0, -half - thick, 0.0, top_m);
    fence(0.0, length - steps.landing_m, -0.5 * thick, 0.5 * thick, floor_of(flight.from, flight.low));
}

// Returns the parts of floors or ceilings that remain after holes for stairs are cut into them.
std::vector<Ring> PlanBuilder::without_flights(std::vector<Ring> parts, std::size_t level, bool ceiling) const {
    for (const PlanFlight& flight : plan_.flights) {
        if (ceiling ? level < flight.low || level >= flight.high : level <= flight.low || level > flight.high) continue;
        const Ring hole{flight.least, {flight.most.x, flight.least.y}, flight.most, {flight.least.x, flight.most.y}};
        std::vector<Ring> kept;
        for (const Ring& part : parts)
            for (Ring& left : without(part, hole)) kept.push_back(std::move(left));
        parts = std::move(kept);
    }
    return parts;
}

// Opens a wall where people step onto the stairs and off them, and returns the rest of the wall. Walls along the sides
// of the stairs stay.
std::vector<Ring> PlanBuilder::without_flight_gaps(const Ring& wall, std::size_t level) const {
    std::vector<Ring> parts{wall};
    const double kept = 0.5 * plan_.wall_m + kKeptSide_m;
    for (const PlanFlight& flight : plan_.flights) {
        if (level < flight.low || level > flight.high) continue;
        const StairWell well = well_of(flight);
        const bool off_at_foot = level == flight.low || (level == flight.high && flight.back),
                   off_at_top = level == flight.high && !flight.back;
        const double from = off_at_foot ? -kStepOff_m : kept,
                     to = off_at_top ? well.length_m + kStepOff_m : well.length_m - kept,
                     half = 0.5 * well.width_m - kept;
        if (to <= from || half <= 0.0) continue;
        const Ring gap = well.box(from, to, -half, half);
        std::vector<Ring> left;
        for (const Ring& part : parts)
            for (Ring& piece : without(part, gap)) left.push_back(std::move(piece));
        parts = std::move(left);
    }
    return parts;
}

}  // namespace handrail::floorplan
