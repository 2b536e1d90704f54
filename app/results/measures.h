// What is measured of a walk and of answers about a place. Pure functions over plain values: metres, seconds, radians.
// Signed and circular pointing errors are those of orientation research (Batschelet's mean direction); the thresholds
// of turns and hesitations are our own.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "worlds/base/vec.h"

namespace handrail {

// Where the body was; leap: it was put there, and did not walk.
struct WayPoint {
    double t_s = 0.0;
    Vec3 place_m{0.0};
    bool leap = false;
};

inline constexpr double kWaySpacing_m = 0.25;
// The way walked, over places at least kWaySpacing_m apart, so that swaying on the spot is none. Leaps are left out.
double way_walked_m(std::span<const WayPoint> walk);
// Of a route, measured likewise: on the level, whatever it rises.
double level_way_m(std::span<const Vec3> route_m);
// Over the shortest way; none where that is under a metre or the goal was not reached.
std::optional<double> path_ratio(double walked_m, double shortest_m, bool reached);

struct Span {
    double from_s = 0.0, to_s = 0.0;
};
// How long `span` is without the `busy` times in it, which may overlap.
double free_s(const Span& span, std::span<const Span> busy);
// Pauses within kPause_m of which more than kPause_s are left without the `busy` times: a list is open, somebody
// speaks.
inline constexpr double kPause_s = 2.0, kPause_m = 0.15;
struct Hesitations {
    int count = 0;
    double sum_s = 0.0;
};
Hesitations hesitations(std::span<const WayPoint> walk, std::span<const Span> busy = {});

// Touches of one thing within two seconds of each other are one contact.
struct Touch {
    double t_s = 0.0;
    std::uint32_t thing = 0;
};
inline constexpr double kSameContact_s = 2.0;
int contact_episodes(std::span<const Touch> touches);

// Errors of pointing: pointed less right, each in (-pi, pi].
double pointing_error_rad(double pointed_rad, double right_rad);
struct Pointing {
    double absolute_rad = 0.0;  // mean of the sizes
    double signed_rad = 0.0;    // direction of the mean
    double agreement = 0.0;     // length of the mean, 0 to 1
    bool biased = false;        // kLeastAnswers or more that agree: the signed error says something
};
inline constexpr std::size_t kLeastAnswers = 3;
inline constexpr double kLeastAgreement = 0.5;
std::optional<Pointing> pointing(std::span<const double> errors_rad);

// Geometric mean of judged over true; none where there is no answer or one is not above zero.
struct Judged {
    double judged_m = 0.0, true_m = 0.0;
};
std::optional<double> distance_ratio(std::span<const Judged> answers);

// Kendall's tau of an order: `order` holds the right place of what was put first, second and so on, each once. 1:
// right, -1: back to front. None for less than two.
std::optional<double> order_tau(std::span<const std::size_t> order);

// Turns of a route of 30 degrees or more and how a walk along it met them. Missed: it went 2 m past the turn before it
// came near the next one, or was 2 m off the route by then. Early: it left the route by 1 m to the turn's side, 1.5 m
// or more before the turn.
inline constexpr double kTurn_rad = 0.5235987755982988, kPast_m = 2.0, kOff_m = 2.0, kEarly_m = 1.5, kEarlyOff_m = 1.0,
                        kNearTurn_m = 1.0;
struct TurnsMet {
    int turns = 0, missed = 0, early = 0;
    std::vector<Vec3> missed_m, early_m;  // where those turns are, in the order of the route
};
TurnsMet turns_met(std::span<const Vec3> route_m, std::span<const WayPoint> walk);

}  // namespace handrail
