#include "worlds/navigation/directions_route.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <unordered_map>

#include "worlds/base/contract.h"

namespace handrail::navigation {
namespace {

constexpr std::uint32_t kPiece = 4;  // side of a piece of floor, in cells
// Number of simulated walkers that try each candidate: one without errors, twelve with errors.
constexpr int kBodies = 13;
constexpr double kFarthestLeg_m = 30.0;
constexpr double kMostApart_m = 1.8;  // a walker farther than this from the walker without errors is lost
// A walker is lost, too, if they are this much farther from the goal than the walker without errors.
constexpr double kMostElsewhere_m = 4.0;
constexpr double kLeg_m = 2.0;         // cost of each leg, in metres of route
constexpr double kStraightOn_m = 0.5;  // cost of a leg that continues in the same direction
// Extra cost of a turn that is not a multiple of a quarter turn. It is the length of two steps.
constexpr double kCrooked_m = 1.4;
constexpr double kBump_m = 0.4;  // cost of a leg that ends at a wall
// Extra cost of each metre walked along a wall, or past furniture nearer than a shoulder.
constexpr double kSlide_per_m = 0.3;
constexpr double kShoulder_m = 0.2;
constexpr double kDoorAskew_m = 3.0;  // cost of going through a doorway at a slant
// About the cosine of half a notch: a walker within this angle goes squarely through a door.
constexpr double kHeadOn = 0.98;
constexpr double kApart_per_m = 0.6;  // cost for each metre that the walkers are spread apart
// Factor of the remaining distance in A*. It is above 1, so that the search expands fewer nodes.
constexpr double kGreed = 1.4;
constexpr double kWider = 1.1;  // the search makes the walkers' errors larger by this factor
constexpr double kSamePlace_m = 0.35;
constexpr int kRefusals = 2;  // after this many refused first legs, one more lost walker is accepted
// A leg that ends at an obstacle must reach it within kStopWithin times the stated distance plus kStopWithin_m.
// Otherwise the walker has missed the obstacle.
constexpr double kStopWithin = 2.0, kStopWithin_m = 4.0;
constexpr double kBehind_m = 0.3;
// The first legs are good enough once this many nodes are beyond a milestone, or this many were expanded since the
// first of them.
constexpr int kToCommit = 3, kLongEnough = 25;
constexpr int kMostAtPlace = 4;  // most nodes kept for one place; more would hardly improve the route
constexpr int kMostExpanded = 1200, kMostTried = 25;
constexpr int kGoodEnough = 98;  // a route is accepted if at least this many of kWordTrials walkers arrive
// Distance added to the spread of the walkers if something stops a counted leg much too early.
constexpr double kShort_m = 0.1;
constexpr double kMostEndShort = 0.5;  // a counted leg may lack this fraction of a step when something stops it
constexpr std::uint64_t kTrialSeed = 20261123;

std::uint64_t mixed(std::uint64_t x) {  // the hash splitmix64 of Steele, Lea, Flood, 2014
    x += 0x9e3779b97f4a7c15ULL;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
    return x ^ (x >> 31);
}
// Returns a random number from -1 to 1.
double drawn(std::uint64_t& state) {
    state = mixed(state);
    return static_cast<double>(state >> 11) * 0x1.0p-52 - 1.0;
}

// One of the simulated walkers who try the directions. `off_rad` is the error of the walker's heading.
struct Sample {
    BlindWalker body;
    double off_rad = 0.0;
};

// The errors of a walker's step length and turns, as fractions of the greatest errors: from -1 to 1. Some walkers
// always have the same errors. The errors of the others change with each leg.
struct Wrong {
    double step = 0.0, turn = 0.0;
};
Wrong wrong_of(int sample, int leg) {
    if (sample == 0) return {};
    if (sample <= 4) return {sample & 1 ? 1.0 : -1.0, sample & 2 ? 1.0 : -1.0};
    const std::uint64_t h = mixed(static_cast<std::uint64_t>(sample) * 977 + static_cast<std::uint64_t>(leg));
    return {h & 1 ? 1.0 : -1.0, h & 2 ? 1.0 : -1.0};
}

int wrapped_notches(int notches) {
    notches = ((notches % kNotches) + kNotches) % kNotches;
    return notches > kNotches / 2 ? notches - kNotches : notches;
}

}  // namespace

int nearest_notch(double heading_rad) {
    const auto notch = static_cast<int>(std::lround(heading_rad / notch_heading_rad(1)));
    return ((notch % kNotches) + kNotches) % kNotches;
}

DirectionsPlanner::DirectionsPlanner(const BlindGround& ground, double step_m) : ground_(ground), step_m_(step_m) {
    contract_pre(step_m > 0.0);
    const WalkSpace& space = ground_.space();
    const auto count = static_cast<std::uint32_t>(space.spans.size());
    piece_of_span_.assign(count, kNothing);
    const auto square = [&](std::uint32_t s) {
        const std::uint32_t cell = space.spans[s].cell;
        return (cell / space.width / kPiece) * (space.width / kPiece + 1) + cell % space.width / kPiece;
    };
    std::vector<Vec3> middles;
    std::vector<std::uint32_t> open;
    for (std::uint32_t s = 0; s < count; ++s) {
        if (piece_of_span_[s] != kNothing) continue;
        const auto piece = static_cast<std::uint32_t>(middles.size());
        open.assign(1, s);
        piece_of_span_[s] = piece;
        Vec3 sum(0.0);
        for (std::size_t i = 0; i < open.size(); ++i) {
            sum += space.place_m(open[i]);
            for (const std::uint32_t n : space.spans[open[i]].next)
                if (n != kNothing && piece_of_span_[n] == kNothing && square(n) == square(s)) {
                    piece_of_span_[n] = piece;
                    open.push_back(n);
                }
        }
        span_of_piece_.push_back(s);
        middles.push_back(sum / static_cast<double>(open.size()));
    }
    std::vector<std::uint64_t> pairs;
    const auto join = [&](std::uint32_t a, std::uint32_t b) {
        if (a != kNothing && b != kNothing && piece_of_span_[a] != piece_of_span_[b])
            pairs.push_back((static_cast<std::uint64_t>(piece_of_span_[a]) << 32) | piece_of_span_[b]);
    };
    for (std::uint32_t s = 0; s < count; ++s)
        for (std::size_t d = 0; d < 4; ++d) {
            const std::uint32_t n = space.spans[s].next[d];
            if (n == kNothing) continue;
            join(s, n);
            join(s, space.spans[n].next[(d + 1) % 4]);
        }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    first_neighbour_.assign(middles.size() + 1, 0);
    for (const std::uint64_t pair : pairs) {
        const auto a = static_cast<std::uint32_t>(pair >> 32), b = static_cast<std::uint32_t>(pair);
        ++first_neighbour_[a + 1];
        neighbours_.push_back(b);
        neighbour_m_.push_back(static_cast<float>(glm::length(middles[a] - middles[b])));
    }
    for (std::size_t i = 1; i < first_neighbour_.size(); ++i) first_neighbour_[i] += first_neighbour_[i - 1];
}

// Returns true if a walker in the direction `notch` goes squarely through the door. A leaf is thinner along the
// direction of walking than across it.
bool DirectionsPlanner::head_on(std::uint32_t door, int notch) const {
    const DirectionsDoor::Leaf& leaf = ground_.doors()[door].leaves.front();
    const Vec3 size = leaf.own_m.size_m();
    const PlacedFrame frame(leaf.shut);
    const Vec3 across = size.x < size.y ? frame.axes[0] : frame.axes[1];
    return std::abs(glm::dot(forward_of_heading(notch_heading_rad(notch)), across)) > kHeadOn;
}

// Returns the walking distance from each piece of floor to the goal. The distance is infinite if no route leads there,
// or if it is much longer than the distance from the piece of `until`.
std::vector<float> DirectionsPlanner::flood(const DirectionsGoal& goal, std::uint32_t until) const {
    constexpr float kFar = std::numeric_limits<float>::infinity(), kBeyond_m = 8.0F;
    std::vector<float> far(first_neighbour_.size() - 1, kFar);
    using Entry = std::pair<float, std::uint32_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    for (std::uint32_t s = 0; s < goal.size(); ++s)
        if (goal[s] && far[piece_of_span_[s]] != 0.0F) {
            far[piece_of_span_[s]] = 0.0F;
            open.emplace(0.0F, piece_of_span_[s]);
        }
    float enough = kFar;
    while (!open.empty()) {
        const auto [so_far, here] = open.top();
        open.pop();
        if (so_far > far[here]) continue;
        if (so_far > enough) break;
        if (here == piece_of_span_[until]) enough = so_far + kBeyond_m;
        for (std::uint32_t k = first_neighbour_[here]; k < first_neighbour_[here + 1]; ++k)
            if (const float there = so_far + neighbour_m_[k]; there < far[neighbours_[k]]) {
                far[neighbours_[k]] = there;
                open.emplace(there, neighbours_[k]);
            }
    }
    return far;
}

struct DirectionsPlanner::Trial {
    Vec3 from_m;
    BlindWalker stands;
    int notch = 0;
    DoorsOpen doors;
    DirectionsErrors errors;
    DoorState opened = DoorState::Open;  // the state of a door after the walker has opened it
};

// Returns the distances to the goal that remain after each door and flight on the shortest route, in walking order.
std::vector<float> DirectionsPlanner::milestones(const std::vector<float>& far_m, std::uint32_t from) const {
    std::vector<float> left_m;
    bool in_narrow = false;
    for (std::uint32_t here = piece_of_span_[from]; far_m[here] > 0.0F;) {
        const std::uint32_t span = span_of_piece_[here];
        const bool narrow = ground_.door_at(span) != kNothing || ground_.space().spans[span].stairs;
        if (in_narrow && !narrow) left_m.push_back(far_m[here]);
        in_narrow = narrow;
        std::uint32_t next = here;
        for (std::uint32_t k = first_neighbour_[here]; k < first_neighbour_[here + 1]; ++k)
            if (far_m[neighbours_[k]] < far_m[next]) next = neighbours_[k];
        if (next == here) break;
        here = next;
    }
    return left_m;
}

struct DirectionsPlanner::Search {
    struct Node {
        std::uint32_t before = kNothing;
        DirectionsLeg leg;
        int notch = 0, legs = 0, behind = 0;  // `behind`: number of milestones that all walkers have passed
        double cost_m = 0.0;
        DoorsOpen open;
        std::uint64_t doors = 0;  // hash of the set of open doors
        std::array<Sample, kBodies> samples;
    };
    struct Candidate {
        double estimate_m = 0.0;
        std::uint32_t node = 0, number = 0;
        std::uint8_t notch = 0;
        PaceEnd end = PaceEnd::Steps;
        std::uint16_t steps = 0;
        float cost_m = 0.0F;
        std::uint64_t place = 0;
        // Orders candidates so that the top of the priority queue is the best one.
        bool operator<(const Candidate& other) const {
            return estimate_m != other.estimate_m ? estimate_m > other.estimate_m : number > other.number;
        }
    };

    const DirectionsPlanner& planner;
    const BlindGround& ground;
    const WalkSpace& space;
    const DirectionsGoal& goal;
    const std::vector<float>& far_m;
    const std::vector<float>& milestones_m;
    DirectionsErrors errors;
    DoorState opened;  // the state of a door after the walker has opened it
    std::vector<Node> nodes;
    std::priority_queue<Candidate> open;
    // Nothing iterates over `seen` or `here`, because the order of their elements is arbitrary.
    std::unordered_map<std::uint64_t, double> seen;
    std::unordered_map<std::uint64_t, int> here;  // number of nodes at each place

    double left_m(std::uint32_t span) const { return static_cast<double>(far_m[planner.piece_of_span_[span]]); }

    std::uint64_t place_of(const BlindWalker& body, std::uint64_t doors) const {
        const Vec3 at = ground.feet_m(body);
        std::uint64_t h = mixed(static_cast<std::uint64_t>(std::llround(at.x / kSamePlace_m)));
        h = mixed(h ^ static_cast<std::uint64_t>(std::llround(at.y / kSamePlace_m)));
        h = mixed(h ^ static_cast<std::uint64_t>(std::llround(at.z)));
        return mixed(h ^ doors);
    }
    bool crowded(std::uint64_t place) const {
        const auto found = here.find(place);
        return found != here.end() && found->second >= kMostAtPlace;
    }

    void start(const Vec3& from_m, int notch, const DoorsOpen& doors) {
        Node node;
        node.notch = notch;
        node.open = doors;
        const BlindWalker stands = ground.body_at(from_m);
        for (int i = 0; i < kBodies; ++i) {
            Sample& sample = node.samples[static_cast<std::size_t>(i)];
            sample.body = stands;
            if (i > 0) ground.walk(sample.body, 2.0 * kPi * i / (kBodies - 1), errors.start_m, PaceEnd::Steps, doors);
        }
        nodes.push_back(std::move(node));
    }

    // Adds the possible next legs to the queue, each as the walker without errors would walk it.
    void offer(std::uint32_t number) {
        const Node& node = nodes[number];
        for (int notch = 0; notch < kNotches; ++notch) {
            const int turn = wrapped_notches(notch - node.notch);
            double leg_m = turn == 0 ? kStraightOn_m : kLeg_m + 0.02 * std::abs(turn);
            if (turn % 4 != 0) leg_m += kCrooked_m;
            if (node.leg.door != kNothing && !planner.head_on(node.leg.door, notch)) leg_m += kDoorAskew_m;
            BlindWalker body = node.samples[0].body;
            int steps = 0;
            double near_m = 0.0;
            bool stairs = false;
            const auto put = [&](PaceEnd end, int count, double walked_m, const BlindWalker& to, double more_m) {
                const double left = left_m(to.span);
                if (!std::isfinite(left)) return;
                Candidate c;
                c.place = place_of(to, node.doors);
                if (crowded(c.place)) return;
                c.node = number;
                c.number = static_cast<std::uint32_t>(open.size());
                c.notch = static_cast<std::uint8_t>(notch);
                c.end = end;
                c.steps = static_cast<std::uint16_t>(count);
                c.cost_m = static_cast<float>(leg_m + walked_m + kSlide_per_m * near_m + more_m);
                c.estimate_m = node.cost_m + static_cast<double>(c.cost_m) + kGreed * left;
                open.push(c);
            };
            const Paced paced = ground.walk(
                body, notch_heading_rad(notch), kFarthestLeg_m, PaceEnd::Steps, node.open,
                [&](const BlindWalker& at) {
                    ++steps;
                    const WalkSpan& span = space.spans[at.span];
                    if (static_cast<double>(span.clearance_m) < kShoulder_m) near_m += planner.step_m_;
                    stairs = stairs || span.stairs;
                    put(PaceEnd::Steps, steps, steps * planner.step_m_, at, 0.0);
                    return true;
                },
                planner.step_m_);
            if (paced.at_edge) continue;
            if (paced.stopped && paced.walked_m > 0.15)
                put(PaceEnd::Stopped, std::max(1, static_cast<int>(std::lround(paced.walked_m / planner.step_m_))),
                    paced.walked_m, body, ground.door_at(body.span) == kNothing ? kBump_m : 0.0);
            if (stairs) {
                body = node.samples[0].body;
                const Paced climbed =
                    ground.walk(body, notch_heading_rad(notch), kFarthestLeg_m, PaceEnd::Stairs, node.open);
                if (climbed.climbed)
                    put(PaceEnd::Stairs, std::max(1, static_cast<int>(std::lround(climbed.walked_m / planner.step_m_))),
                        climbed.walked_m, body, 0.0);
            }
        }
    }

    // Lets all simulated walkers walk the leg. Returns nothing if one of them would get lost.
    std::optional<Node> walk(const Candidate& c) const {
        const Node& from = nodes[c.node];
        Node to;
        to.before = c.node;
        to.notch = c.notch;
        to.legs = from.legs + 1;
        to.open = from.open;
        to.doors = from.doors;
        to.leg.turn_notches = wrapped_notches(c.notch - from.notch);
        to.leg.steps = c.steps;
        to.leg.end = c.end;
        const double about_m = c.steps * planner.step_m_;
        double apart_m = 0.0;
        std::uint32_t door = kNothing;
        bool one_door = true;
        for (int i = 0; i < kBodies; ++i) {
            Sample sample = from.samples[static_cast<std::size_t>(i)];
            const Wrong wrong = wrong_of(i, from.legs);
            if (to.leg.turn_notches != 0 || from.legs == 0) sample.off_rad = wrong.turn * errors.turn_rad;
            const double most_m =
                c.end == PaceEnd::Steps ? about_m * (1.0 + wrong.step * errors.step_part) : 1.5 * about_m + 3.0;
            const Paced paced =
                ground.walk(sample.body, notch_heading_rad(c.notch) + sample.off_rad, most_m, c.end, from.open);
            if (paced.at_edge || (c.end == PaceEnd::Stopped && !paced.stopped) ||
                (c.end == PaceEnd::Stairs && !paced.climbed))
                return std::nullopt;
            if (c.end == PaceEnd::Steps && paced.stopped && most_m - paced.walked_m > planner.step_m_ * kMostEndShort)
                apart_m += kShort_m;
            if (i == 0) {
                to.leg.rise_m = c.end == PaceEnd::Stairs ? paced.rise_m : 0.0;
                to.leg.to_m = ground.feet_m(sample.body);
                if (!std::isfinite(left_m(sample.body.span))) return std::nullopt;
            } else {
                const Vec3 off = ground.feet_m(sample.body) - to.leg.to_m;
                const double level_m = std::hypot(off.x, off.y);
                if (level_m > kMostApart_m || std::abs(off.z) > 1.0 ||
                    !(left_m(sample.body.span) < left_m(to.samples[0].body.span) + kMostElsewhere_m))
                    return std::nullopt;
                apart_m = std::max(apart_m, level_m);
            }
            const std::uint32_t near = ground.door_at(sample.body.span);
            if (i == 0) door = near;
            else one_door = one_door && near == door;
            to.samples[static_cast<std::size_t>(i)] = sample;
        }
        if (door != kNothing && one_door && from.open[door] == DoorState::Shut && ground.doors()[door].opens) {
            to.open[door] = opened;
            to.doors = from.doors ^ mixed(door + 1);
            to.leg.door = door;
        }
        to.cost_m = from.cost_m + static_cast<double>(c.cost_m) + kApart_per_m * apart_m;
        double most_left_m = 0.0;
        for (const Sample& sample : to.samples) most_left_m = std::max(most_left_m, left_m(sample.body.span));
        for (const float milestone_m : milestones_m)
            if (most_left_m < static_cast<double>(milestone_m) + kBehind_m) ++to.behind;
        return to;
    }

    // Lets all simulated walkers walk these legs from the first node. Returns the index of the last node, or nothing if
    // one of the walkers gets lost.
    std::optional<std::uint32_t> begin_with(std::span<const DirectionsLeg> legs) {
        std::uint32_t last = 0;
        for (const DirectionsLeg& leg : legs) {
            Candidate c;
            c.node = last;
            c.notch = static_cast<std::uint8_t>((nodes[last].notch + leg.turn_notches + kNotches) % kNotches);
            c.end = leg.end;
            c.steps = static_cast<std::uint16_t>(leg.steps);
            std::optional<Node> node = walk(c);
            if (!node) return std::nullopt;
            last = static_cast<std::uint32_t>(nodes.size());
            nodes.push_back(std::move(*node));
        }
        return last;
    }

    // Returns the node, from number `first` on, that has passed the most milestones. Of several such nodes, returns the
    // one with the shortest estimated route.
    const Node& farthest(std::uint32_t first) const {
        const auto estimate_m = [&](const Node& node) {
            return node.cost_m + kGreed * left_m(node.samples[0].body.span);
        };
        return *std::max_element(nodes.begin() + first, nodes.end(), [&](const Node& a, const Node& b) {
            return a.behind != b.behind ? a.behind < b.behind : estimate_m(a) > estimate_m(b);
        });
    }

    std::uint64_t key(const Node& node) const {
        double apart_m = 0.0;
        const Vec3 at = ground.feet_m(node.samples[0].body);
        for (const Sample& sample : node.samples)
            apart_m = std::max(apart_m, glm::length(ground.feet_m(sample.body) - at));
        return mixed(place_of(node.samples[0].body, node.doors) ^
                     static_cast<std::uint64_t>(std::llround(apart_m / kSamePlace_m)));
    }

    bool all_there(const Node& node) const {
        return std::all_of(node.samples.begin(), node.samples.end(),
                           [&](const Sample& sample) { return goal[sample.body.span] != 0; });
    }

    DirectionsRoute route_to(const Node& last) const {
        DirectionsRoute route;
        for (const Node* node = &last; node->before != kNothing; node = &nodes[node->before])
            route.legs.push_back(node->leg);
        std::reverse(route.legs.begin(), route.legs.end());
        return route;
    }
};

DoorsOpen doors_on(const DirectionsRoute& route, DoorsOpen open) {
    if (route.shuts_leaves)
        for (DoorState& door : open)
            if (door == DoorState::Open) door = DoorState::Cleared;
    return open;
}

std::optional<DirectionsRoute> DirectionsPlanner::plan(const Vec3& from_m, double heading_rad,
                                                       const DirectionsGoal& goal, const DoorsOpen& doors,
                                                       const DirectionsErrors& errors, const std::stop_token& stop,
                                                       const DirectionsParts& parts) const {
    contract_pre(goal.size() == ground_.space().spans.size() && doors.size() == ground_.doors().size());
    const BlindWalker stands = ground_.body_at(from_m);
    if (stands.span == kNothing) return std::nullopt;
    const std::vector<float> far = flood(goal, stands.span);
    if (!std::isfinite(far[piece_of_span_[stands.span]])) return std::nullopt;
    DirectionsRoute route;
    for (const bool shuts_leaves : {false, true}) {
        route.shuts_leaves = shuts_leaves;
        const Trial trial{from_m,
                          stands,
                          nearest_notch(heading_rad),
                          doors_on(route, doors),
                          errors,
                          shuts_leaves ? DoorState::Cleared : DoorState::Open};
        if (auto found = plan_with(trial, goal, far, stop, parts)) {
            found->shuts_leaves = shuts_leaves;
            return found;
        }
        if (doors.empty() || stop.stop_requested()) break;
    }
    return std::nullopt;
}

std::optional<DirectionsRoute> DirectionsPlanner::plan_with(const Trial& trial, const DirectionsGoal& goal,
                                                            const std::vector<float>& far, const std::stop_token& stop,
                                                            const DirectionsParts& parts) const {
    const std::vector<float> milestones_m = milestones(far, trial.stands.span);
    const DirectionsErrors& errors = trial.errors;
    std::optional<DirectionsRoute> best;
    // If no route succeeds with the full errors, tries smaller errors, and finally none.
    for (const double part : {1.0, 0.7, 0.4, 0.0}) {
        Search search{
            *this,
            ground_,
            ground_.space(),
            goal,
            far,
            milestones_m,
            {errors.step_part * part * kWider, errors.turn_rad * part * kWider, errors.start_m * part * kWider},
            trial.opened,
            {},
            {},
            {},
            {}};
        search.start(trial.from_m, trial.notch, trial.doors);
        const std::optional<std::uint32_t> first = search.begin_with(parts.begun);
        if (!first) continue;
        search.offer(*first);
        int expanded = 0, tried = 0;
        const int behind_first = search.nodes[*first].behind;
        int behind = behind_first, farther = 0, since = 0, refused = 0;
        while (!search.open.empty() && expanded < kMostExpanded && tried < kMostTried && !stop.stop_requested()) {
            const Search::Candidate candidate = search.open.top();
            search.open.pop();
            if (search.crowded(candidate.place)) continue;
            if (search.nodes[candidate.node].behind < behind) continue;
            std::optional<Search::Node> node = search.walk(candidate);
            if (!node) continue;
            const auto [known, fresh] = search.seen.try_emplace(search.key(*node), node->cost_m);
            if (!fresh) {
                if (known->second <= node->cost_m) continue;
                known->second = node->cost_m;
            }
            if (search.all_there(*node)) {
                ++tried;
                DirectionsRoute route = search.route_to(*node);
                for (const DirectionsLeg& leg : route.legs) route.length_m += leg.steps * step_m_;
                route.came = try_out(route.legs, trial, kWordTrials, kTrialSeed,
                                     [&](const BlindWalker& body) { return goal[body.span] != 0; });
                if (!best || route.came > best->came) best = std::move(route);
                if (best->came >= kGoodEnough) return best;
                continue;
            }
            ++expanded;
            if (node->behind > behind) {
                // Later legs cannot bring back a walker who is lost at this stage, so such a node is refused.
                const double left_m = static_cast<double>(milestones_m[static_cast<std::size_t>(node->behind - 1)]) +
                                      kSamePlace_m + kBehind_m;
                const int passed = try_out(search.route_to(*node).legs, trial, kWordTrials, kTrialSeed,
                                           [&](const BlindWalker& body) { return search.left_m(body.span) < left_m; });
                if (part > 0.0 && passed < kWordTrials - refused / kRefusals) {
                    ++refused;
                    continue;
                }
                ++farther;
                if (farther >= kToCommit || since > kLongEnough) {
                    behind = node->behind;
                    farther = since = 0;
                }
            }
            if (farther > 0) ++since;
            ++search.here[candidate.place];
            search.nodes.push_back(std::move(*node));
            search.offer(static_cast<std::uint32_t>(search.nodes.size() - 1));
            if (parts.places > 0 && expanded >= parts.places && !best)
                if (const Search::Node& farthest = search.farthest(*first); farthest.behind > behind_first) {
                    DirectionsRoute begin = search.route_to(farthest);
                    begin.whole = false;
                    for (const DirectionsLeg& leg : begin.legs) begin.length_m += leg.steps * step_m_;
                    return begin;
                }
        }
        if (stop.stop_requested()) return best;
        if (best && best->came >= kWordTrials * 9 / 10) break;
    }
    return best;
}

int DirectionsPlanner::try_out(const DirectionsRoute& route, const Vec3& from_m, double heading_rad,
                               const DirectionsGoal& goal, const DoorsOpen& doors, const DirectionsErrors& errors,
                               int bodies, std::uint64_t seed) const {
    const BlindWalker stands = ground_.body_at(from_m);
    if (stands.span == kNothing) return 0;
    const Trial trial{from_m,
                      stands,
                      nearest_notch(heading_rad),
                      doors_on(route, doors),
                      errors,
                      route.shuts_leaves ? DoorState::Cleared : DoorState::Open};
    return try_out(route.legs, trial, bodies, seed, [&](const BlindWalker& body) { return goal[body.span] != 0; });
}

int DirectionsPlanner::try_out(std::span<const DirectionsLeg> legs, const Trial& trial, int bodies, std::uint64_t seed,
                               const std::function<bool(const BlindWalker&)>& there) const {
    int came = 0;
    for (int i = 0; i < bodies; ++i) {
        std::uint64_t state = mixed(seed + static_cast<std::uint64_t>(i));
        BlindWalker body = trial.stands;
        const double way_rad = drawn(state) * kPi;
        const double off_m = trial.errors.start_m * std::sqrt(std::abs(drawn(state)));
        ground_.walk(body, way_rad, off_m, PaceEnd::Steps, trial.doors);
        DoorsOpen open = trial.doors;
        int notch = trial.notch;
        double off_rad = trial.errors.turn_rad * drawn(state);
        bool lost = false;
        for (const DirectionsLeg& leg : legs) {
            notch += leg.turn_notches;
            if (leg.turn_notches != 0) off_rad = trial.errors.turn_rad * drawn(state);
            const double about_m = leg.steps * step_m_;
            const double most_m = leg.end == PaceEnd::Steps ? about_m * (1.0 + trial.errors.step_part * drawn(state))
                                                            : kStopWithin * about_m + kStopWithin_m;
            const Paced paced = ground_.walk(body, notch_heading_rad(notch) + off_rad, most_m, leg.end, open);
            lost = paced.at_edge;
            if (lost) break;
            if (leg.door != kNothing && ground_.door_at(body.span) == leg.door && open[leg.door] == DoorState::Shut)
                open[leg.door] = trial.opened;
        }
        came += !lost && there(body) ? 1 : 0;
    }
    return came;
}

DirectionsGoal goal_in_room(const WalkSpace& space, std::span<const std::uint32_t> room_of_span, std::uint32_t room,
                            const StatedRoom* outline) {
    DirectionsGoal all(space.spans.size(), 0);
    for (std::uint32_t s = 0; s < all.size(); ++s) all[s] = room_of_span[s] == room ? 1 : 0;
    if (outline) {
        DirectionsGoal within = all;
        for (std::uint32_t s = 0; s < all.size(); ++s)
            if (all[s] && !holds(*outline, space.place_m(s))) within[s] = 0;
        if (std::any_of(within.begin(), within.end(), [](std::uint8_t in) { return in != 0; })) all = std::move(within);
    }
    // The goal begins a hand's breadth inside the room. On the border it would be unclear which room the program
    // announces.
    const int rings = std::max(1, static_cast<int>(std::lround(0.15 / space.cell_m)));
    DirectionsGoal inside = all;
    for (int ring = 0; ring < rings; ++ring) {
        DirectionsGoal less = inside;
        for (std::uint32_t s = 0; s < all.size(); ++s)
            if (inside[s])
                for (const std::uint32_t n : space.spans[s].next)
                    if (n != kNothing && !inside[n]) less[s] = 0;
        inside = std::move(less);
    }
    return std::any_of(inside.begin(), inside.end(), [](std::uint8_t in) { return in != 0; }) ? inside : all;
}

DirectionsGoal goal_at_place(const WalkSpace& space, const Vec3& place_m, double within_m) {
    DirectionsGoal goal(space.spans.size(), 0);
    const std::uint32_t at = space.at(place_m);
    if (at == kNothing) return goal;
    // The spans that a walk of few cells reaches from the place. So floors above and below, and places behind a wall,
    // are not examined.
    std::vector<std::uint32_t> reached{at};
    goal[at] = 1;
    for (std::size_t i = 0; i < reached.size(); ++i)
        for (const std::uint32_t n : space.spans[reached[i]].next) {
            if (n == kNothing || goal[n]) continue;
            const Vec3 to_m = space.place_m(n), off_m = to_m - place_m;
            if (std::hypot(off_m.x, off_m.y) > within_m || !space.straight(to_m, place_m)) continue;
            goal[n] = 1;
            reached.push_back(n);
        }
    return goal;
}

}  // namespace handrail::navigation
