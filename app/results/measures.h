// Computes measures of walks, and of answers about places. Pure functions over plain values in metres, seconds and
// radians. The signed and circular pointing errors are those of orientation research (Batschelet's mean direction). We
// chose the thresholds for turns and hesitations.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "worlds/base/vec.h"

namespace handrail::results {

// A position of the walker. `leap`: the walker was moved to this position without walking.
struct WalkedPoint {
    double t_s = 0.0;
    Vec3 place_m{0.0};
    bool leap = false;
};

inline constexpr double kPointSpacing_m = 0.25;
// Returns the walked length. Only uses points that are at least kPointSpacing_m apart, so that swaying on the spot adds
// no length. Leaves out leaps.
double walked_length_m(std::span<const WalkedPoint> walk);
// Returns the horizontal length of a route, computed in the same way as a walked length.
double level_length_m(std::span<const Vec3> route_m);
// Returns the walked length divided by the shortest length. Returns nothing if the shortest length is less than a
// metre, or if the goal was not reached.
std::optional<double> path_ratio(double walked_m, double shortest_m, bool reached);

struct Span {
    double from_s = 0.0, to_s = 0.0;
};
// Returns how many seconds of `span` are outside the `busy` times, which may overlap.
double free_s(const Span& span, std::span<const Span> busy);
// A hesitation is a pause longer than kPause_s, during which the walker stays within kPause_m. Leave `busy` times out
// of pauses: during them, a list was open or the voice was speaking.
inline constexpr double kPause_s = 2.0, kPause_m = 0.15;
struct Hesitations {
    int count = 0;
    double sum_s = 0.0;
};
Hesitations hesitations(std::span<const WalkedPoint> walk, std::span<const Span> busy = {});

// A touch. Touches of one object within two seconds of each other form one contact.
struct Touch {
    double t_s = 0.0;
    std::uint32_t thing = 0;
};
inline constexpr double kSameContact_s = 2.0;
int contact_episodes(std::span<const Touch> touches);

// Returns the pointed direction minus the correct direction, in (-pi, pi].
double pointing_error_rad(double pointed_rad, double right_rad);
struct Pointing {
    double absolute_rad = 0.0;  // mean of the absolute values of the errors
    double signed_rad = 0.0;    // direction of the mean vector of the errors
    double agreement = 0.0;     // length of that mean vector, 0 to 1
    // True if there are at least kLeastAnswers answers, and their errors agree so well that the signed error is
    // meaningful.
    bool biased = false;
};
inline constexpr std::size_t kLeastAnswers = 3;
inline constexpr double kLeastAgreement = 0.5;
std::optional<Pointing> pointing(std::span<const double> errors_rad);

// A judged distance and the true one. distance_ratio returns the geometric mean of judged over true distance. It
// returns nothing if there are no answers, or if one of the distances is not above zero.
struct Judged {
    double judged_m = 0.0, true_m = 0.0;
};
std::optional<double> distance_ratio(std::span<const Judged> answers);

// Returns Kendall's tau of an order: 1 if the order is right, -1 if it is reversed. `order` contains the right position
// of the item put first, of the item put second and so on; each position occurs once. Returns nothing for fewer than
// two items.
std::optional<double> order_tau(std::span<const std::size_t> order);

// Turns of a route by 30 degrees or more, and whether a walk along the route missed them or turned too early.
// - Missed: the walker went 2 m past the turn and at least 1 m off the next leg, or 2 m off both legs, before coming
//   near the next turn.
// - Early: the walker left the route by 1 m to the side of the turn, 1.5 m or more before the turn.
inline constexpr double kTurn_rad = 0.5235987755982988, kPast_m = 2.0, kOff_m = 2.0, kEarly_m = 1.5, kEarlyOff_m = 1.0,
                        kNearTurn_m = 1.0;
struct TurnsMet {
    int turns = 0, missed = 0, early = 0;
    std::vector<Vec3> missed_m, early_m;  // positions of the missed and the early turns, in the order of the route
};
TurnsMet turns_met(std::span<const Vec3> route_m, std::span<const WalkedPoint> walk);

}  // namespace handrail::results
