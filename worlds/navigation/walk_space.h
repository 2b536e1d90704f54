// Describes where a walker of a certain size can stand and walk in a Scene. Solids are grown by the walker's size and
// cut into vertical columns. So a place is free exactly if a walker there overlaps nothing. The growth and the slopes
// are the same as in walking itself. A flood fill from the places where a designer put something finds the space, so
// its size depends on what walkers can reach, not on the size of the world. Deterministic. Immutable afterwards; any
// thread may use it.
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
    double most_drop_m = 1.0;  // height of the deepest edge down which routes lead
    double cell_m = 0.05;      // width of the columns; it becomes larger if there is too much floor
    bool operator==(const WalkerMeasures&) const = default;
};

// The index that means that there is no span, obstacle, room or other item.
inline constexpr std::uint32_t kNothing = 0xffffffffU;

// A place to stand in a column.
struct WalkSpan {
    float floor_m = 0.0F;    // height of the floor above WalkSpace::origin_m.z
    float ceiling_m = 0.0F;  // the greatest height above the origin at which the soles could be
    std::uint32_t cell = 0;
    std::uint32_t next[4] = {kNothing, kNothing, kNothing,
                             kNothing};  // the spans to which a step leads: to the east, north, west and south
    std::uint32_t ground = kNothing;     // index of the obstacle underfoot
    std::uint32_t door = kNothing;       // index in Scene::movers of the door in whose doorway the span is
    float clearance_m = 0.0F;            // distance to where the walker would touch something or step off an edge
    std::uint32_t beside = kNothing;     // the nearest obstacle; kNothing: an edge
    bool near_edge = false;              // the nearest border is an edge to fall from
    bool liquid = false;
    bool stairs = false;
};

// A place to stand if there were no furniture. Furniture means objects lower than a wall. Only the search for rooms
// uses these spans.
struct WallSpan {
    float floor_m = 0.0F;
    std::uint32_t next[4] = {kNothing, kNothing, kNothing, kNothing};
    float clearance_m = 0.0F;
    std::uint32_t cell : 29 = 0;  // 29 bits suffice: a grid has far fewer cells
    std::uint32_t door : 1 = 0, liquid : 1 = 0, stairs : 1 = 0;
};
static_assert(sizeof(WallSpan) == 28);  // kept small, because there are millions of these spans

// A connection between two spans that cannot be walked, such as a lift or a drop.
struct WalkLink {
    PassageKind kind = PassageKind::Drop;
    std::uint32_t from = 0, to = 0;  // indices of spans
    bool both_ways = false;
    FeatureId feature = kNoFeature;
};

// A grid of columns. Each column contains its spans from the lowest to the highest.
template <class Span>
struct SpanGrid {
    Vec3 origin_m{0.0};  // lower south-west corner of cell 0
    double cell_m = 0.05;
    std::uint32_t width = 0, depth = 0;  // cells to the east and to the north
    std::vector<std::uint32_t> first;    // index of the first span of each cell; the size is width x depth + 1
    std::vector<Span> spans;

    Vec3 place_m(std::uint32_t span) const {
        const std::uint32_t x = spans[span].cell % width, y = spans[span].cell / width;
        return origin_m + Vec3((x + 0.5) * cell_m, (y + 0.5) * cell_m, static_cast<double>(spans[span].floor_m));
    }
    // Returns the span whose middle is nearest to `feet_m`. It is at most `level_m` away horizontally, `up_m` higher
    // and `down_m` lower; kNothing if there is none. The cost is a search of the cells that are nearer than the result.
    std::uint32_t nearest(const Vec3& feet_m, double level_m, double up_m, double down_m) const;
};
extern template struct SpanGrid<WalkSpan>;
extern template struct SpanGrid<WallSpan>;

struct WalkSpace : SpanGrid<WalkSpan> {
    WalkerMeasures body;
    std::vector<WalkLink> links;
    std::vector<FeatureId> obstacle_features;  // feature of each obstacle; kNoFeature: the building itself
    std::vector<std::string> said;             // sentences about what was simplified or left out
    // Range around the building within which the ground outside is included. 0: no ground is left out.
    double outdoors_m = 0.0;
    bool part = false;  // there was too much floor, so the space contains only the part nearest to the start
    // The floor without furniture, for make_rooms; null once it is freed.
    std::shared_ptr<const SpanGrid<WallSpan>> walls;

    // Returns the span in the column at that place whose floor is nearest in height. Returns kNothing if no floor is
    // within one and a half steps.
    std::uint32_t at(const Vec3& feet_m) const;
    // Returns whether a walker can go straight from one place to the other without leaving the spans. Calls `touched`
    // for every span on the line, in order.
    bool straight(const Vec3& from_m, const Vec3& to_m, const std::function<void(std::uint32_t)>& touched = {}) const;
    double cell_area_m2() const { return cell_m * cell_m; }
};

// Returns sentences about the space, which the program announces: that its columns are coarser than requested in
// `requested`, and what was left out.
std::vector<std::string> said_of(const WalkSpace& space, const WalkerMeasures& requested);

// Options of a space that is made only to try a walker of another size. Such a space contains the places that the
// walker can reach, drops, lifts, and links over stairs that nobody can walk on. It contains no floor without
// furniture, no closed rooms, no marks of stairs and no nearest obstacles.
struct WalkTrial {
    bool clearance = false;  // true: WalkSpan::clearance_m is measured, too
    // If set, the walker starts at `from_m` and stays in the box. Only solids that touch the box are included. Lifts,
    // teleporters and links over stairs are left out.
    struct Stretch {
        Vec3 from_m{0.0};
        Aabb box_m;
    };
    std::optional<Stretch> within;
};
// Fails as make_walk_space does. It takes about a third of the time of make_walk_space; with a stretch, only a small
// part.
Result<WalkSpace> make_trial_space(const Scene& scene, const WalkerMeasures& body, const WalkTrial& trial,
                                   const std::stop_token& stop = {});

// Fails with a sentence if there is nothing to walk on, or if `stop` was requested, which the function checks every few
// milliseconds. If there is much floor, the columns become coarser, and ground far from everything else is left out. If
// there is still too much floor, the space contains only the part nearest to the start. One flood gives both the space
// and its floor without furniture. Needs at most 150 bytes for each span during the work.
Result<WalkSpace> make_walk_space(const Scene& scene, const WalkerMeasures& body, const std::stop_token& stop = {});

}  // namespace handrail::navigation
