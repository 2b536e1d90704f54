// Plans routes as spoken directions. A route has a few straight legs in directions of the turning notch. If possible, a
// leg ends at something that stops the walker: a wall, a shut door or the end of a flight. Otherwise it ends after
// counted steps. So people still arrive if their steps are a tenth longer or shorter, their turns are a few degrees
// off, and their start is not known exactly.
// Candidates come from a search over straight walks. A handful of walkers with errors try each candidate at once. A leg
// on which one of them gets lost is dropped. Deterministic. Any thread; immutable once made. World metres.
// A plan costs milliseconds in simple cases, a few hundred in a house, and up to some seconds where errors are hard to
// tolerate. So request it on a background thread and be ready to stop it.
// Sources: for the search, A*: Hart, Nilsson, Raphael, A formal basis for the heuristic determination of minimum cost
// paths, 1968. For carrying samples of possible positions: conformant planning, as in Smith, Weld, 1998.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "worlds/navigation/blind_ground.h"
#include "worlds/scene/stated_building.h"

namespace handrail::navigation {

// The turning notch: a sixteenth of a circle.
inline constexpr int kNotches = 16;
constexpr double notch_heading_rad(int notch) { return notch * (2.0 * kPi / kNotches); }
// The nearest notch, 0 to 15, clockwise from north.
int nearest_notch(double heading_rad);

// One instruction: how to turn, then how far to walk, then what ends the leg.
struct DirectionsLeg {
    int turn_notches = 0;  // clockwise, -7 to 8
    int steps = 1;         // counted if `end` is Steps, otherwise approximate
    PaceEnd end = PaceEnd::Steps;
    // Index in BlindGround::doors(): at the end of the leg this door is within reach, shut, and has to be opened.
    std::uint32_t door = kNothing;
    double rise_m = 0.0;  // height of a flight
    Vec3 to_m{0.0};       // where the leg ends if nothing goes wrong
};

struct DirectionsRoute {
    std::vector<DirectionsLeg> legs;
    double length_m = 0.0;
    // How many of kWordTrials walkers with errors arrived when the route was tried.
    int came = 0;
    // False: these are only the first legs, and the rest still has to be planned from their end. `came` is 0 then.
    bool whole = true;
};
inline constexpr int kWordTrials = 100;

// The greatest errors of a person who follows spoken directions.
struct DirectionsErrors {
    double step_part = 0.1;    // as a part of a step's length
    double turn_rad = 0.0873;  // at each turn: 5 degrees
    double start_m = 0.3;
};

// Plans a route in two parts, so that its first legs are known long before the rest.
struct DirectionsParts {
    // The first legs of the route, planned before from the same place. Planning continues from their end.
    std::span<const DirectionsLeg> begun = {};
    // After this many expanded nodes, legs that lead beyond a door or flight are enough. 0: the whole route is planned.
    int places = 0;
};

// Where a route may end: for each span of the space, whether it is part of the goal.
using DirectionsGoal = std::vector<std::uint8_t>;

class DirectionsPlanner {
public:
    // `ground` must outlive this object. Costs a look at each span.
    explicit DirectionsPlanner(const BlindGround& ground, double step_m = 0.7);

    // Plans from a place and a heading, which is rounded to the notch, to the nearest place of the goal. Returns
    // nothing if no way leads there over floor and stairs, if it was stopped, or if no route works even without errors.
    std::optional<DirectionsRoute> plan(const Vec3& from_m, double heading_rad, const DirectionsGoal& goal,
                                        const DoorsOpen& open, const DirectionsErrors& errors = {},
                                        const std::stop_token& stop = {}, const DirectionsParts& parts = {}) const;
    // How many of the given number of walkers, with errors drawn from `seed`, reach the goal by the route.
    int try_out(const DirectionsRoute& route, const Vec3& from_m, double heading_rad, const DirectionsGoal& goal,
                const DoorsOpen& open, const DirectionsErrors& errors, int bodies, std::uint64_t seed) const;

private:
    struct Search;
    struct Trial;
    int try_out(std::span<const DirectionsLeg> legs, const Trial& trial, int bodies, std::uint64_t seed,
                const std::function<bool(const BlindWalker&)>& there) const;
    bool head_on(std::uint32_t door, int notch) const;
    std::vector<float> milestones(const std::vector<float>& far_m, std::uint32_t from) const;
    std::vector<float> flood(const DirectionsGoal& goal, std::uint32_t until) const;

    const BlindGround& ground_;
    double step_m_;
    // Pieces of floor four cells wide, and the distances between their middles. Walking distances are flooded over
    // them.
    std::vector<std::uint32_t> piece_of_span_, span_of_piece_;
    std::vector<std::uint32_t> first_beside_, beside_;
    std::vector<float> beside_m_;
};

// The spans a little inside a room, and within its outline if the file states one. If there are none, all spans of the
// room.
DirectionsGoal goal_in_room(const WalkSpace& space, std::span<const std::uint32_t> room_of_span, std::uint32_t room,
                            const StatedRoom* outline = nullptr);

}  // namespace handrail::navigation
