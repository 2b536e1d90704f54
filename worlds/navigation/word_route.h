// Routes planned for words: a few straight legs in directions of the turning notch, ended where possible by what stops
// a body (a wall, a shut door, the end of a flight) and else by counted steps, so that somebody who follows them with
// steps a tenth longer or shorter, turns a few degrees off and a start that is not quite known still gets there.
// Candidates come from a search over straight walks; each is walked by a handful of bodies with errors at once, and
// what one of them would not survive is no route. Deterministic. Any thread; immutable after it is made. World metres.
// A plan costs milliseconds where the way is plain, a few hundred in a house, and up to some seconds where errors are
// hard to bear: to be asked for beside everything else, and stopped. Source of the search: A*, Hart, Nilsson, Raphael,
// A formal basis for the heuristic determination of minimum cost paths, 1968; of carrying samples of where one may be:
// conformant planning, as in Smith, Weld, 1998.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "worlds/navigation/blind_ground.h"
#include "worlds/scene/stated_building.h"

namespace handrail {

// The turning notch: a sixteenth of a circle.
inline constexpr int kNotches = 16;
constexpr double notch_heading_rad(int notch) { return notch * (2.0 * kPi / kNotches); }
// The nearest one, 0 to 15, clockwise from north.
int nearest_notch(double heading_rad);

// One instruction: what to do first, then how far, then to what.
struct WordLeg {
    int turn_notches = 0;  // clockwise, -7 to 8
    int steps = 1;         // counted where `end` is Steps, else about how many
    PaceEnd end = PaceEnd::Steps;
    std::uint32_t door = kNothing;  // of BlindGround::doors(): at its end this door is in reach, shut, and is opened
    double rise_m = 0.0;            // of a flight
    Vec3 to_m{0.0};                 // where it ends when all goes as told
};

struct WordRoute {
    std::vector<WordLeg> legs;
    double length_m = 0.0;
    // Of kWordTrials bodies with errors, how many came there when it was tried.
    int came = 0;
    // False: these are its first legs only, and where they end the rest is still to be planned. `came` is 0 then.
    bool whole = true;
};
inline constexpr int kWordTrials = 100;

// How wrong somebody may be who follows words.
struct WordErrors {
    double step_part = 0.1;    // of a step's length
    double turn_rad = 0.0873;  // at each turn: 5 degrees
    double start_m = 0.3;
};

// A route in two parts, so that its first legs are known long before the rest.
struct WordParts {
    // The first legs of the route, which were planned before from the same place. Planning goes on from their end.
    std::span<const WordLeg> begun = {};
    // Once this many places were looked at, the legs to beyond a door or flight are enough. 0: the whole route is
    // planned.
    int places = 0;
};

// Where a route may end: of each span of the space whether it is there.
using WordGoal = std::vector<std::uint8_t>;

class WordPlanner {
public:
    // `ground` outlives it. A look at each span.
    explicit WordPlanner(const BlindGround& ground, double step_m = 0.7);

    // From a place and a heading, rounded to the notch, to the nearest place of the goal. None: there is no way on foot
    // over floor and stairs, it was stopped, or no route was found on which a body comes there even without errors.
    std::optional<WordRoute> plan(const Vec3& from_m, double heading_rad, const WordGoal& goal, const DoorsOpen& open,
                                  const WordErrors& errors = {}, const std::stop_token& stop = {},
                                  const WordParts& parts = {}) const;
    // How many of so many bodies with errors, drawn from `seed`, come to the goal by the route.
    int try_out(const WordRoute& route, const Vec3& from_m, double heading_rad, const WordGoal& goal,
                const DoorsOpen& open, const WordErrors& errors, int bodies, std::uint64_t seed) const;

private:
    struct Search;
    struct Trial;
    int try_out(std::span<const WordLeg> legs, const Trial& trial, int bodies, std::uint64_t seed,
                const std::function<bool(const BlindBody&)>& there) const;
    bool head_on(std::uint32_t door, int notch) const;
    std::vector<float> milestones(const std::vector<float>& far_m, std::uint32_t from) const;
    std::vector<float> flood(const WordGoal& goal, std::uint32_t until) const;

    const BlindGround& ground_;
    double step_m_;
    // Pieces of floor four cells wide, and how far their middles are apart: what distances are flooded over.
    std::vector<std::uint32_t> piece_of_span_, span_of_piece_;
    std::vector<std::uint32_t> first_beside_, beside_;
    std::vector<float> beside_m_;
};

// The spans of a room that lie a little inside it, and within its outline where the file states one; or all of a room
// that has no such.
WordGoal goal_in_room(const WalkSpace& space, std::span<const std::uint32_t> room_of_span, std::uint32_t room,
                      const StatedRoom* outline = nullptr);
// The spans within so far of a place, on its floor.
WordGoal goal_round(const WalkSpace& space, const Vec3& place_m, double within_m);

}  // namespace handrail
