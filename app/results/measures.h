// Measures of walks and of answers about places. Pure functions over plain values: metres, seconds, radians. Signed and
// circular pointing errors are those of orientation research (Batschelet's mean direction); the thresholds for turns
// and hesitations are our own.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "worlds/base/vec.h"

namespace handrail::results {

// A position of the walker. `leap`: the walker was put there and did not walk.
struct WayPoint {
    double t_s = 0.0;
    Vec3 place_m{0.0};
    bool leap = false;
};

inline constexpr double kWaySpacing_m = 0.25;
// The length walked, over points at least kWaySpacing_m apart, so that swaying on the spot does not count. Leaps are
// left out.
double way_walked_m(std::span<const WayPoint> walk);
// The length of a route measured the same way, horizontally, whatever its rise.
double level_way_m(std::span<const Vec3> route_m);
// The length walked, divided by the shortest. Nothing if the shortest is under a metre or the goal was not reached.
std::optional<double> path_ratio(double walked_m, double shortest_m, bool reached);

struct Span {
    double from_s = 0.0, to_s = 0.0;
};
// How much of `span` is outside the `busy` times, which may overlap.
double free_s(const Span& span, std::span<const Span> busy);
// Finds pauses within kPause_m that are longer than kPause_s after the `busy` times are subtracted. Busy means that a
// list is open or the voice is speaking.
inline constexpr double kPause_s = 2.0, kPause_m = 0.15;
struct Hesitations {
    int count = 0;
    double sum_s = 0.0;
};
Hesitations hesitations(std::span<const WayPoint> walk, std::span<const Span> busy = {});

// Touches of one thing within two seconds of each other count as one contact.
struct Touch {
    double t_s = 0.0;
    std::uint32_t thing = 0;
};
inline constexpr double kSameContact_s = 2.0;
int contact_episodes(std::span<const Touch> touches);

// The pointing error: pointed direction minus right direction, in (-pi, pi].
double pointing_error_rad(double pointed_rad, double right_rad);
struct Pointing {
    double absolute_rad = 0.0;  // mean of the absolute errors
    double signed_rad = 0.0;    // direction of the mean vector
    double agreement = 0.0;     // length of the mean vector, 0 to 1
    // At least kLeastAnswers that agree, so the signed error is meaningful.
    bool biased = false;
};
inline constexpr std::size_t kLeastAnswers = 3;
inline constexpr double kLeastAgreement = 0.5;
std::optional<Pointing> pointing(std::span<const double> errors_rad);

// The geometric mean of judged over true distance. Nothing if there are no answers or one of them is not above zero.
struct Judged {
    double judged_m = 0.0, true_m = 0.0;
};
std::optional<double> distance_ratio(std::span<const Judged> answers);

// Kendall's tau of an order. `order` contains the right position of the item put first, second and so on, each once. 1:
// right; -1: reversed. Nothing for fewer than two items.
std::optional<double> order_tau(std::span<const std::size_t> order);

// The turns of a route of 30 degrees or more, and how a walk along it met them.
// - Missed: the walk went 2 m past the turn before it came near the next one, or was 2 m off the route by then.
// - Early: it left the route by 1 m to the turn's side, 1.5 m or more before the turn.
inline constexpr double kTurn_rad = 0.5235987755982988, kPast_m = 2.0, kOff_m = 2.0, kEarly_m = 1.5, kEarlyOff_m = 1.0,
                        kNearTurn_m = 1.0;
struct TurnsMet {
    int turns = 0, missed = 0, early = 0;
    std::vector<Vec3> missed_m, early_m;  // positions of those turns, in the order of the route
};
TurnsMet turns_met(std::span<const Vec3> route_m, std::span<const WayPoint> walk);

}  // namespace handrail::results
