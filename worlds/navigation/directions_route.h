// Plans routes that can be spoken as directions. A route has a few straight legs, whose headings are multiples of a
// sixteenth of a circle. If possible, a leg ends at an obstacle that stops the walker, such as a wall or a shut door,
// or at the end of a flight. Otherwise it ends after a counted number of steps. So people still arrive if their steps
// are a tenth longer or shorter, their turns are a few degrees off, and their start is not known exactly. A search over
// straight walks proposes candidates. A handful of simulated walkers with errors try each candidate; the planner drops
// a leg on which one of them gets lost. Deterministic. Immutable once made; any thread may use it. World metres. A plan
// costs milliseconds in simple cases, a few hundred in a house, and up to some seconds if errors are hard to tolerate.
// So request it on a background task that you can stop. Sources: for the search, A*: Hart, Nilsson, Raphael, A formal
// basis for the heuristic determination of minimum cost paths, 1968. For samples of possible positions: conformant
// planning, as in Smith, Weld, 1998.
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

// The number of notches in a circle. Each notch is a direction that can be spoken.
inline constexpr int kNotches = 16;
constexpr double notch_heading_rad(int notch) { return notch * (2.0 * kPi / kNotches); }
// Returns the notch that is nearest to the heading: 0 to 15, clockwise from north.
int nearest_notch(double heading_rad);

// One instruction: a turn, a number of steps, and the event that ends the leg.
struct DirectionsLeg {
    int turn_notches = 0;  // turn before the leg, clockwise, from -7 to 8
    int steps = 1;         // number of steps; exact if `end` is Steps, otherwise approximate
    PaceEnd end = PaceEnd::Steps;
    // Index in BlindGround::doors() of a shut door that the walker can reach at the end of the leg and has to open.
    std::uint32_t door = kNothing;
    double rise_m = 0.0;  // height of the flight that the leg goes up; negative: down
    Vec3 to_m{0.0};       // where a walker without errors ends the leg
};

struct DirectionsRoute {
    std::vector<DirectionsLeg> legs;
    double length_m = 0.0;
    // Number of the kWordTrials simulated walkers with errors that reached the goal.
    int came = 0;
    // False: these are only the first legs, and the rest still has to be planned from their end. In that case `came` is
    // 0.
    bool whole = true;
    // True: on the way, the walker shuts each open door whose leaf blocks a leg.
    bool shuts_leaves = false;
};
// Returns the states of the doors for a walker on the route.
DoorsOpen doors_on(const DirectionsRoute& route, DoorsOpen open);
inline constexpr int kWordTrials = 100;

// The greatest errors that a person makes while following spoken directions.
struct DirectionsErrors {
    double step_part = 0.1;    // error of the step length, as a fraction of a step
    double turn_rad = 0.0873;  // error of each turn: 5 degrees
    double start_m = 0.3;
};

// Options for planning a route in two calls, so that its first legs are known long before the rest.
struct DirectionsParts {
    // The first legs of the route, from an earlier call with the same start. Planning continues from their end.
    std::span<const DirectionsLeg> begun = {};
    // After this many expanded nodes, the planner returns the first legs as soon as they lead beyond a door or flight.
    // 0: it plans the whole route.
    int places = 0;
};

// The set of places where a route may end: for each span of the space, whether it is part of the goal.
using DirectionsGoal = std::vector<std::uint8_t>;

class DirectionsPlanner {
public:
    // `ground` must outlive this object. The constructor visits each span once.
    explicit DirectionsPlanner(const BlindGround& ground, double step_m = 0.7);

    // Plans from a place and a heading, which is rounded to a notch, to the nearest place of the goal. Returns nothing
    // if no route over floor and stairs leads to the goal, if `stop` was requested, or if no route succeeds even
    // without errors. If the leaves of open doors block every route, the walker on the route shuts these doors.
    std::optional<DirectionsRoute> plan(const Vec3& from_m, double heading_rad, const DirectionsGoal& goal,
                                        const DoorsOpen& open, const DirectionsErrors& errors = {},
                                        const std::stop_token& stop = {}, const DirectionsParts& parts = {}) const;
    // Returns how many of `bodies` simulated walkers reach the goal by the route. Their errors are drawn from `seed`.
    int try_out(const DirectionsRoute& route, const Vec3& from_m, double heading_rad, const DirectionsGoal& goal,
                const DoorsOpen& open, const DirectionsErrors& errors, int bodies, std::uint64_t seed) const;

private:
    struct Search;
    struct Trial;
    std::optional<DirectionsRoute> plan_with(const Trial& trial, const DirectionsGoal& goal,
                                             const std::vector<float>& far_m, const std::stop_token& stop,
                                             const DirectionsParts& parts) const;
    int try_out(std::span<const DirectionsLeg> legs, const Trial& trial, int bodies, std::uint64_t seed,
                const std::function<bool(const BlindWalker&)>& there) const;
    bool head_on(std::uint32_t door, int notch) const;
    std::vector<float> milestones(const std::vector<float>& far_m, std::uint32_t from) const;
    std::vector<float> flood(const DirectionsGoal& goal, std::uint32_t until) const;

    const BlindGround& ground_;
    double step_m_;
    // The pieces of floor, four cells wide, over which the planner computes walking distances: the piece of each span,
    // a span of each piece, the neighbours of each piece, and the distances between their middles.
    std::vector<std::uint32_t> piece_of_span_, span_of_piece_;
    std::vector<std::uint32_t> first_neighbour_, neighbours_;
    std::vector<float> neighbour_m_;
};

// Returns the spans that are a little inside a room, and inside its outline if the file states one. If there are no
// such spans, returns all spans of the room.
DirectionsGoal goal_in_room(const WalkSpace& space, std::span<const std::uint32_t> room_of_span, std::uint32_t room,
                            const StatedRoom* outline = nullptr);
// Returns the spans at most `within_m` from a place, measured along the floor, from which a walker can go straight to
// that place. Returns an empty goal if nobody can stand there.
DirectionsGoal goal_at_place(const WalkSpace& space, const Vec3& place_m, double within_m);

}  // namespace handrail::navigation
