// Where a walker of a certain size can stand and walk in a Scene. Vertical columns are cut through its solids, each
// grown by the walker's body. So a place is free exactly if a walker there overlaps nothing. Growth and slopes are the
// same as in walking itself. The space is built by flooding from the places where a designer put something, so its size
// depends on what can be reached, not on the world. Immutable afterwards. Deterministic. Any thread.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "worlds/base/result.h"
#include "worlds/navigation/route.h"
#include "worlds/scene/scene.h"

namespace handrail::navigation {

struct WalkerMeasures {
    double radius_m = 0.25;
    double height_m = 1.8;
    double step_up_m = 0.25;
    double most_drop_m = 1.0;  // nobody is led farther down
    double cell_m = 0.05;      // width of the columns; larger if there is too much floor
    bool operator==(const WalkerMeasures&) const = default;
};

// The index that means no span, no obstacle or no room.
inline constexpr std::uint32_t kNothing = 0xffffffffU;

// A place to stand in a column.
struct WalkSpan {
    float floor_m = 0.0F;    // above WalkSpace::origin_m.z
    float ceiling_m = 0.0F;  // the greatest height at which the soles could be
    std::uint32_t cell = 0;
    std::uint32_t next[4] = {kNothing, kNothing, kNothing,
                             kNothing};  // the span to which a step leads: east, north, west, south
    std::uint32_t ground = kNothing;     // the obstacle underfoot
    std::uint32_t door = kNothing;       // index in Scene::movers of the door that hangs here
    float clearance_m = 0.0F;            // from here to where the walker would touch something or step off an edge
    std::uint32_t beside = kNothing;     // the nearest obstacle; kNothing: an edge
    bool near_edge = false;              // the nearest border is an edge to fall from
    bool liquid = false;
    bool stairs = false;
};

// The same without furniture, that is without objects lower than a wall. Only the search for rooms uses it.
struct WallSpan {
    float floor_m = 0.0F;
    std::uint32_t next[4] = {kNothing, kNothing, kNothing, kNothing};
    float clearance_m = 0.0F;
    std::uint32_t cell : 29 = 0;  // far fewer cells fit into a grid
    std::uint32_t door : 1 = 0, liquid : 1 = 0, stairs : 1 = 0;
};
static_assert(sizeof(WallSpan) == 28);  // small, because there are millions

// A connection that cannot be walked.
struct WalkLink {
    PassageKind kind = PassageKind::Drop;
    std::uint32_t from = 0, to = 0;  // indices of spans
    bool both_ways = false;
    FeatureId feature = kNoFeature;
};

// Columns side by side, each with its spans from below.
template <class Span>
struct SpanGrid {
    Vec3 origin_m{0.0};  // corner of cell 0
    double cell_m = 0.05;
    std::uint32_t width = 0, depth = 0;  // cells to the east and to the north
    std::vector<std::uint32_t> first;    // for each cell the first span; the size is width x depth + 1
    std::vector<Span> spans;

    Vec3 place_m(std::uint32_t span) const {
        const std::uint32_t x = spans[span].cell % width, y = spans[span].cell / width;
        return origin_m + Vec3((x + 0.5) * cell_m, (y + 0.5) * cell_m, static_cast<double>(spans[span].floor_m));
    }
    // The span whose middle is nearest, at most this far away horizontally, up and down; kNothing if there is none.
    // Costs a search of the cells that are nearer than the result.
    std::uint32_t nearest(const Vec3& feet_m, double level_m, double up_m, double down_m) const;
};
extern template struct SpanGrid<WalkSpan>;
extern template struct SpanGrid<WallSpan>;

struct WalkSpace : SpanGrid<WalkSpan> {
    WalkerMeasures body;
    std::vector<WalkLink> links;
    std::vector<FeatureId> obstacle_features;  // for each obstacle its feature; kNoFeature: the building itself
    std::vector<std::string> said;             // sentences about what was simplified or left out
    // How far from the building the ground outside is included, if some of it is left out; else 0.
    double outdoors_m = 0.0;
    bool part = false;  // there was too much floor, so this is the part nearest to the start
    std::shared_ptr<const SpanGrid<WallSpan>> walls;  // without furniture, for make_rooms; may be freed afterwards

    // The span of the column at that place whose floor is nearest in height; kNothing if there is none within one and a
    // half steps.
    std::uint32_t at(const Vec3& feet_m) const;
    // Returns whether a walker can go straight from one place to the other without leaving the spans. Calls `touched`
    // for every span on the way, in order.
    bool straight(const Vec3& from_m, const Vec3& to_m, const std::function<void(std::uint32_t)>& touched = {}) const;
    double cell_area_m2() const { return cell_m * cell_m; }
};

// What to announce about a space that was requested with this body: that its columns are coarser, and what was left
// out.
std::vector<std::string> said_of(const WalkSpace& space, const WalkerMeasures& asked);

// What to make of a space for a body that is only tried: what it can reach, its drops and lifts, and stairs taken in
// one go. The space has no floor without furniture, no closed rooms, no marks of stairs, and nothing about what is
// nearest.
struct WalkTrial {
    bool clearance = false;  // also measures WalkSpan::clearance_m
    // If set, the body starts at `from_m` and stays in the box. Only what touches the box is considered, and lifts,
    // teleporters and stairs in one go are left out.
    struct Stretch {
        Vec3 from_m{0.0};
        Aabb box_m;
    };
    std::optional<Stretch> within;
};
// Fails as make_walk_space does. Costs about a third of it; a stretch costs a small part.
Result<WalkSpace> make_trial_space(const Scene& scene, const WalkerMeasures& body, const WalkTrial& trial,
                                   const std::stop_token& stop = {});

// Fails with a sentence if there is nothing to walk on, or if `stop` ends it, which is queried every few milliseconds.
// If there is much floor, the columns are coarser and ground far from everything else is left out. If there is still
// too much, the space ends with what is nearest to the start. One flood gives both the space and its walls. Needs at
// most 150 bytes for each span during the work.
Result<WalkSpace> make_walk_space(const Scene& scene, const WalkerMeasures& body, const std::stop_token& stop = {});

}  // namespace handrail::navigation
