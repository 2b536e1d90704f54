#include "worlds/navigation/walk_space.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

#include "worlds/base/language.h"
#include "worlds/geometry/box_index.h"
#include "worlds/geometry/placement.h"

namespace handrail {
namespace {

constexpr double kWalkableNormalZ = 0.7;  // as walking has it: up to about 45 degrees
constexpr double kLeastRoom_m = 1e-3;     // between floor and the highest place of the soles
constexpr double kRounding_m = 1e-6;
constexpr int kTile = 32;  // cells along a side of what is looked at together
constexpr std::size_t kMostSpans = 2'000'000;
constexpr double kMostCells = 40e6;        // of the dense grid
constexpr std::size_t kMostInColumn = 60;  // Recast counts to 62
constexpr double kCoarsest_m = 0.4;
constexpr double kFlatMost_m = 1.5;     // a door no thicker than this may be a bridge
constexpr double kWideThing_m = 5.0;    // a thing as wide is a floor or platform
constexpr double kTallThing_m = 2.3;    // a thing as high as a wall counts as one
constexpr double kWading_m = 0.3;       // deeper counts as being in a liquid
constexpr double kStairWindow_m = 0.6;  // looked at to either side
constexpr double kStairRise_m = 0.35;   // over both of them

struct Bound {
    Plane plane;  // pushed out by the body
};
struct Obstacle {
    std::uint32_t first_plane = 0, plane_count = 0;
    Aabb box_m;  // grown
    FeatureId feature = kNoFeature;
};
// The top of something that comes and goes.
struct PassingFloor {
    Obstacle shape;
    std::uint32_t mover = 0;
};

// Every solid of a scene, grown by the body.
class Obstacles {
public:
    Obstacles(const Scene& scene, const WalkBody& body) : body_(body) {
        std::vector<int> mover_of_feature(scene.features.size(), -1);
        for (std::size_t m = 0; m < scene.movers.size(); ++m)
            if (scene.movers[m].feature.value < mover_of_feature.size() && scene.movers[m].moves())
                mover_of_feature[scene.movers[m].feature.value] = static_cast<int>(m);
        for (const Solid& solid : scene.solids) {
            const int mover = solid.role == SolidRole::Mover && solid.feature.value < mover_of_feature.size() ? mover_of_feature[solid.feature.value] : -1;
            if (body.walls_only && is_furniture(scene.find(solid.feature))) continue;
            if (mover >= 0 && passes(scene, static_cast<std::uint32_t>(mover), solid)) continue;
            add_solid(solid, nullptr, solid.feature, all);
        }
        for (const MeshTriangle& triangle : scene.triangles) add_triangle(triangle, nullptr, triangle.feature);
        for (const PlacedModel& placed : scene.placed) {
            if (body.walls_only && is_furniture(scene.find(placed.feature))) continue;
            const PlacedFrame frame(placed.at);
            for (const Solid& solid : placed.model->solids) add_solid(solid, &frame, placed.feature, all);
            for (const MeshTriangle& triangle : placed.model->triangles) add_triangle(triangle, &frame, placed.feature);
        }
        for (const Solid& solid : scene.solids)
            if (solid.role == SolidRole::Liquid) liquids.push_back(&solid);
    }

    // The heights over one place that an obstacle takes from the soles; false where it takes none. `steep`: its top there cannot be stood on.
    bool column(const Obstacle& o, double x, double y, double& low, double& high, bool& steep) const {
        low = -std::numeric_limits<double>::infinity();
        high = -low;
        double top_normal = 1.0;
        for (std::uint32_t k = o.first_plane; k < o.first_plane + o.plane_count; ++k) {
            const Plane& p = planes[k].plane;
            const double level = p.offset_m - p.normal.x * x - p.normal.y * y;
            if (std::abs(p.normal.z) < 1e-9) {
                if (level <= kRounding_m) return false;
            } else if (p.normal.z > 0.0) {
                if (const double z = level / p.normal.z; z < high) {
                    high = z;
                    top_normal = p.normal.z;
                }
            } else {
                low = std::max(low, level / p.normal.z);
            }
        }
        steep = top_normal < kWalkableNormalZ;
        return low < high;
    }

    std::vector<Obstacle> all;
    std::vector<PassingFloor> passing;
    std::vector<std::pair<Aabb, std::uint32_t>> doors;  // upright leaves and their movers
    std::vector<const Solid*> liquids;
    std::vector<Bound> planes;

private:
    static bool is_furniture(const Feature* feature) {
        if (!feature || feature->kind != FeatureKind::Object || feature->bounds_m.empty()) return false;
        const Vec3 size = feature->bounds_m.size_m();
        return size.z < kTallThing_m && std::max(size.x, size.y) < kWideThing_m;
    }
    double support(const Vec3& n) const { return body_.radius_m * std::sqrt(n.x * n.x + n.y * n.y) + std::max(0.0, -n.z * body_.height_m); }

    void finish(std::vector<Plane>& bounds, const Aabb& box, FeatureId feature, std::vector<Obstacle>& into) {
        // The axis planes keep the sum of something sharp and a wide body from sticking out far.
        for (int axis = 0; axis < 3; ++axis)
            for (const double sign : {1.0, -1.0}) {
                Vec3 normal{0.0};
                normal[axis] = sign;
                if (std::none_of(bounds.begin(), bounds.end(), [&](const Plane& b) { return glm::dot(b.normal, normal) > 1.0 - 1e-9; }))
                    bounds.push_back({normal, sign > 0 ? box.max_m[axis] : -box.min_m[axis]});
            }
        Obstacle made{static_cast<std::uint32_t>(planes.size()), static_cast<std::uint32_t>(bounds.size()), box, feature};
        made.box_m.min_m -= Vec3(body_.radius_m, body_.radius_m, body_.height_m);
        made.box_m.max_m += Vec3(body_.radius_m, body_.radius_m, 0.0);
        for (Plane b : bounds) {
            b.offset_m += support(b.normal);
            planes.push_back({b});
        }
        into.push_back(made);
    }

    void add_solid(const Solid& solid, const PlacedFrame* frame, FeatureId feature, std::vector<Obstacle>& into) {
        if (solid.role != SolidRole::Solid && solid.role != SolidRole::Mover && solid.role != SolidRole::BodyClip) return;
        std::vector<Plane> bounds = solid.shape.planes;
        Aabb box = solid.shape.bounds_m;
        if (frame) {
            box = {};
            for (const Polygon& face : solid.shape.faces)
                for (const Vec3& p : face.points_m) box.include(frame->to_world(p));
            for (Plane& plane : bounds) {
                const double own = plane.offset_m;
                plane.normal = frame->turned(plane.normal);
                plane.offset_m = own * frame->scale + glm::dot(plane.normal, frame->position_m);
            }
        }
        if (!box.empty() && is_finite(box.min_m) && is_finite(box.max_m)) finish(bounds, box, feature, into);
    }

    void add_triangle(const MeshTriangle& t, const PlacedFrame* frame, FeatureId feature) {
        const auto at = [frame](const Vec3& p) { return frame ? frame->to_world(p) : p; };
        const Vec3 corners[3] = {at(t.a_m), at(t.b_m), at(t.c_m)};
        const Vec3 area = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
        const double length = glm::length(area);
        if (!(length > 0.0) || !std::isfinite(length)) return;
        const Vec3 n = area / length;
        std::vector<Plane> bounds{{n, glm::dot(n, corners[0])}, {-n, -glm::dot(n, corners[0])}};
        Aabb box;
        for (int e = 0; e < 3; ++e) {
            box.include(corners[e]);
            const Vec3 side = glm::cross(corners[(e + 1) % 3] - corners[e], n);
            if (const double l = glm::length(side); l > 0.0) bounds.push_back({side / l, glm::dot(side / l, corners[e])});
        }
        finish(bounds, box, feature, all);
    }

    // A door counts as open; what it bears at either end of its way counts as there. False: it stands in the way like a wall.
    bool passes(const Scene& scene, std::uint32_t mover, const Solid& solid) {
        const Mover& m = scene.movers[mover];
        const Feature& feature = scene.features[m.feature.value];
        if (feature.kind != FeatureKind::Door && feature.kind != FeatureKind::Lift) return false;
        const Vec3 size = feature.bounds_m.size_m();
        const bool flat = size.z <= kFlatMost_m && size.z < 0.5 * std::min(size.x, size.y);
        if (flat || feature.kind == FeatureKind::Lift || m.slide_m.z != 0.0) {
            for (const double part : {0.0, 1.0}) {
                PassingFloor floor;
                floor.mover = mover;
                const PlacedFrame frame(Placement{m.slide_m * part, {}, 1.0});
                std::vector<Obstacle> made;
                add_solid(solid, &frame, m.feature, made);
                if (made.empty()) continue;
                floor.shape = made.front();
                passing.push_back(floor);
            }
        }
        if (feature.kind == FeatureKind::Door && !flat) doors.emplace_back(solid.shape.bounds_m, mover);
        return true;
    }

    WalkBody body_;
};

struct Interval {
    double low = 0.0, high = 0.0;
    std::uint32_t obstacle = 0;
    bool steep = false;
};
struct Place {  // a WalkSpan in the making
    double floor = 0.0, ceiling = 0.0;
    std::uint32_t ground = kNothing;
    std::uint32_t span = kNothing;  // its number, once the flood has come here
    bool reached = false;
};
struct Tile {
    std::array<std::uint32_t, kTile * kTile + 1> first_interval{}, first_place{};
    std::vector<Interval> intervals;
    std::vector<Place> places;
};

// A column anywhere in the world.
struct Cell {
    std::int64_t x = 0, y = 0;
};
struct Spot {
    std::uint32_t tile = 0, place = 0;
    Cell cell;
};

class Flood {
public:
    Flood(const Scene& scene, const WalkBody& body, const std::function<bool()>& stop)
        : scene_(scene), body_(body), stop_(stop), obstacles_(scene, body), index_(boxes(obstacles_.all)), passing_index_(boxes(obstacles_.passing)) {
        anchor_ = scene.bounds_m.empty() ? Vec3(0.0) : scene.bounds_m.min_m;
        if (!scene.starts.empty()) anchor_ = scene.starts.front().feet_m;
    }

    enum class End { Done, TooLarge, Stopped };
    End run() {
        seed();
        std::size_t looked = 0;
        while (!open_.empty()) {
            if ((++looked & 0xffff) == 0 && stop_ && stop_()) return End::Stopped;
            const Spot spot = open_.back();
            open_.pop_back();
            if (++reached_ > kMostSpans) return End::TooLarge;
            const Place here = tiles_[spot.tile].places[spot.place];
            for (int d = 0; d < 4; ++d) {
                const Cell to = neighbour(spot.cell, d);
                const std::uint32_t tile = tile_of(to);
                if (const std::uint32_t k = step(here, tile, to); k != kNothing) visit({tile, k, to});
                else if (const std::uint32_t down = drop(here, tile, to); down != kNothing) visit({tile, down, to});
            }
            // What a lift carries up and down.
            if (here.ground != kNothing && here.ground >= obstacles_.all.size()) {
                const PassingFloor& floor = obstacles_.passing[here.ground - obstacles_.all.size()];
                const Tile& tile = tiles_[spot.tile];
                const std::size_t cell = local(spot.cell);
                if (scene_.features[floor.shape.feature.value].kind == FeatureKind::Lift)
                    for (std::uint32_t k = tile.first_place[cell]; k < tile.first_place[cell + 1]; ++k)
                        if (k != spot.place && passing_mover(tile.places[k].ground) == static_cast<int>(floor.mover)) visit({spot.tile, k, spot.cell});
            }
        }
        return End::Done;
    }

    // After run().
    bool fits_in_grid() const { return reached_ == 0 || static_cast<double>(high_.x - low_.x + 1) * static_cast<double>(high_.y - low_.y + 1) <= kMostCells; }
    std::size_t reached() const { return reached_; }
    void write(WalkSpace& space);

private:
    static std::vector<Aabb> boxes(const std::vector<Obstacle>& all) {
        std::vector<Aabb> found;
        for (const Obstacle& o : all) found.push_back(o.box_m);
        return found;
    }
    static std::vector<Aabb> boxes(const std::vector<PassingFloor>& all) {
        std::vector<Aabb> found;
        for (const PassingFloor& o : all) found.push_back(o.shape.box_m);
        return found;
    }
    static Cell neighbour(Cell c, int d) { return {c.x + (d == 0) - (d == 2), c.y + (d == 1) - (d == 3)}; }
    static std::size_t local(Cell c) {
        const auto m = [](std::int64_t v) { return static_cast<std::size_t>(((v % kTile) + kTile) % kTile); };
        return m(c.y) * kTile + m(c.x);
    }
    static std::int64_t floor_div(std::int64_t v) { return v >= 0 ? v / kTile : -((-v + kTile - 1) / kTile); }
    Vec2 middle(Cell c) const {
        return {anchor_.x + (static_cast<double>(c.x) + 0.5) * body_.cell_m, anchor_.y + (static_cast<double>(c.y) + 0.5) * body_.cell_m};
    }
    Cell cell_at(const Vec3& p) const {
        return {static_cast<std::int64_t>(std::floor((p.x - anchor_.x) / body_.cell_m)),
                static_cast<std::int64_t>(std::floor((p.y - anchor_.y) / body_.cell_m))};
    }
    int passing_mover(std::uint32_t ground) const {
        return ground == kNothing || ground < obstacles_.all.size() ? -1 : static_cast<int>(obstacles_.passing[ground - obstacles_.all.size()].mover);
    }

    std::uint32_t tile_of(Cell c) {
        const std::int64_t tx = floor_div(c.x), ty = floor_div(c.y);
        const std::uint64_t key = (static_cast<std::uint64_t>(tx) << 32) ^ (static_cast<std::uint64_t>(ty) & 0xffffffffU);
        const auto [found, is_new] = tile_number_.try_emplace(key, static_cast<std::uint32_t>(tiles_.size()));
        if (is_new) {
            tiles_.emplace_back();
            fill(tiles_.back(), tx, ty);
        }
        return found->second;
    }

    void fill(Tile& tile, std::int64_t tx, std::int64_t ty) {
        const Vec2 low = middle({tx * kTile, ty * kTile}), high = middle({tx * kTile + kTile - 1, ty * kTile + kTile - 1});
        const Aabb box{Vec3(low, -1e9), Vec3(high, 1e9)};
        struct Found {
            std::uint32_t cell;
            Interval interval;
        };
        std::vector<Found> found, floors;
        const auto scan = [&](const Obstacle& o, std::uint32_t number, std::vector<Found>& into) {
            const auto clamp = [](double v) { return static_cast<int>(std::clamp(v, 0.0, static_cast<double>(kTile - 1))); };
            const int x0 = clamp(std::ceil((o.box_m.min_m.x - low.x) / body_.cell_m)), x1 = clamp(std::floor((o.box_m.max_m.x - low.x) / body_.cell_m));
            const int y0 = clamp(std::ceil((o.box_m.min_m.y - low.y) / body_.cell_m)), y1 = clamp(std::floor((o.box_m.max_m.y - low.y) / body_.cell_m));
            for (int y = y0; y <= y1; ++y)
                for (int x = x0; x <= x1; ++x) {
                    Interval i;
                    i.obstacle = number;
                    const Vec2 at = low + Vec2(x, y) * body_.cell_m;
                    if (obstacles_.column(o, at.x, at.y, i.low, i.high, i.steep)) into.push_back({static_cast<std::uint32_t>(y * kTile + x), i});
                }
        };
        index_.find(box, near_);
        for (const std::uint32_t k : near_) scan(obstacles_.all[k], k, found);
        passing_index_.find(box, near_);
        for (const std::uint32_t k : near_) scan(obstacles_.passing[k].shape, static_cast<std::uint32_t>(obstacles_.all.size()) + k, floors);
        const auto order = [](const Found& a, const Found& b) { return a.cell != b.cell ? a.cell < b.cell : a.interval.low < b.interval.low; };
        std::stable_sort(found.begin(), found.end(), order);
        std::stable_sort(floors.begin(), floors.end(), order);

        std::size_t at = 0, floor_at = 0;
        for (std::uint32_t cell = 0; cell < kTile * kTile; ++cell) {
            tile.first_interval[cell] = static_cast<std::uint32_t>(tile.intervals.size());
            tile.first_place[cell] = static_cast<std::uint32_t>(tile.places.size());
            const std::size_t first_floor = floor_at;
            while (floor_at < floors.size() && floors[floor_at].cell == cell) ++floor_at;
            const auto covered = [&](double floor_m) {  // by what moves there, a step higher
                for (std::size_t f = first_floor; f < floor_at; ++f)
                    if (!floors[f].interval.steep && floors[f].interval.high > floor_m + kLeastRoom_m && floors[f].interval.high <= floor_m + body_.step_up_m)
                        return true;
                return false;
            };
            const auto bearable = [&](double from, double to) {  // floors of movers in a free stretch
                for (std::size_t f = first_floor; f < floor_at; ++f) {
                    const Interval& i = floors[f].interval;
                    if (!i.steep && i.high > from + kLeastRoom_m && i.high < to - kLeastRoom_m && tile.places.size() - tile.first_place[cell] < kMostInColumn)
                        tile.places.push_back({i.high, to, i.obstacle, kNothing, false});
                }
            };
            double top = -std::numeric_limits<double>::infinity();
            std::uint32_t ground = kNothing;
            bool steep = true;
            while (at < found.size() && found[at].cell == cell) {
                const Interval& i = found[at].interval;
                tile.intervals.push_back(i);
                if (i.low > top + kLeastRoom_m) {
                    if (!steep && !covered(top) && tile.places.size() - tile.first_place[cell] < kMostInColumn)
                        tile.places.push_back({top, i.low, ground, kNothing, false});
                    bearable(top, i.low);
                }
                // Of tops at one height the one that can be stood on counts.
                if (i.high > top + kRounding_m || (i.high > top - kRounding_m && steep && !i.steep)) {
                    top = std::max(top, i.high);
                    ground = i.obstacle;
                    steep = i.steep;
                }
                ++at;
            }
            constexpr double kSky = 1e7;
            if (!steep && !covered(top) && tile.places.size() - tile.first_place[cell] < kMostInColumn)
                tile.places.push_back({top, kSky, ground, kNothing, false});
            bearable(top, kSky);
        }
        tile.first_interval[kTile * kTile] = static_cast<std::uint32_t>(tile.intervals.size());
        tile.first_place[kTile * kTile] = static_cast<std::uint32_t>(tile.places.size());
    }

    // The place in that column one comes to by a step, kNothing for none.
    std::uint32_t step(const Place& here, std::uint32_t tile, Cell to) const {
        const Tile& t = tiles_[tile];
        const std::size_t cell = local(to);
        std::uint32_t best = kNothing;
        double nearest = body_.step_up_m + kRounding_m;
        for (std::uint32_t k = t.first_place[cell]; k < t.first_place[cell + 1]; ++k) {
            const Place& p = t.places[k];
            const double rise = std::abs(p.floor - here.floor);
            if (rise > nearest || std::min(p.ceiling, here.ceiling) - std::max(p.floor, here.floor) < kLeastRoom_m) continue;
            if (best != kNothing && rise == nearest) continue;
            nearest = rise;
            best = k;
        }
        return best;
    }

    // Where one comes to who steps over the edge.
    std::uint32_t drop(const Place& here, std::uint32_t tile, Cell to) const {
        const Tile& t = tiles_[tile];
        const std::size_t cell = local(to);
        std::uint32_t best = kNothing;
        for (std::uint32_t k = t.first_place[cell]; k < t.first_place[cell + 1]; ++k) {
            const Place& p = t.places[k];
            if (p.floor < here.floor - body_.step_up_m && p.floor >= here.floor - body_.most_drop_m && p.ceiling > here.floor + kLeastRoom_m) best = k;
        }
        return best;
    }

    void visit(const Spot& spot) {
        Place& place = tiles_[spot.tile].places[spot.place];
        if (place.reached) return;
        place.reached = true;
        if (reached_ == 0 && open_.empty() && !any_) low_ = high_ = spot.cell;
        any_ = true;
        low_ = {std::min(low_.x, spot.cell.x), std::min(low_.y, spot.cell.y)};
        high_ = {std::max(high_.x, spot.cell.x), std::max(high_.y, spot.cell.y)};
        open_.push_back(spot);
    }

    bool is_building(std::uint32_t ground) const {
        if (ground >= obstacles_.all.size()) return true;
        const Feature* feature = scene_.find(obstacles_.all[ground].feature);
        return !feature || feature->kind != FeatureKind::Object;
    }

    // The nearest place to stand around there is reached.
    void seed_at(const Vec3& at, double level_m, double up_m, double down_m, bool on_building) {
        if (!is_finite(at)) return;
        const Cell middle_cell = cell_at(at);
        const auto rings = static_cast<std::int64_t>(std::min(level_m / body_.cell_m, 100.0));
        double best = std::numeric_limits<double>::infinity();
        Spot found;
        for (std::int64_t ring = 0; ring <= rings && static_cast<double>(ring) * body_.cell_m < best; ++ring)
            for (std::int64_t dy = -ring; dy <= ring; ++dy)
                for (std::int64_t dx = -ring; dx <= ring; dx += std::abs(dy) == ring ? 1 : 2 * std::max<std::int64_t>(ring, 1)) {
                    const Cell c{middle_cell.x + dx, middle_cell.y + dy};
                    const std::uint32_t tile = tile_of(c);
                    const std::size_t cell = local(c);
                    for (std::uint32_t k = tiles_[tile].first_place[cell]; k < tiles_[tile].first_place[cell + 1]; ++k) {
                        const Place& p = tiles_[tile].places[k];
                        const double rise = p.floor - at.z;
                        if (rise > up_m || rise < -down_m || (on_building && !is_building(p.ground))) continue;
                        const Vec2 m = middle(c);
                        const double far = std::hypot(m.x - at.x, m.y - at.y) + std::abs(rise);
                        if (far < best) {
                            best = far;
                            found = {tile, k, c};
                        }
                    }
                }
        if (std::isfinite(best)) visit(found);
    }

    void seed() {
        for (const Start& start : scene_.starts) seed_at(start.feet_m, 1.0, 0.6, 3.0, false);
        for (const Switch& s : scene_.switches)
            if (s.leads_elsewhere) seed_at(s.feet_m, 1.0, 0.6, 3.0, false);
        for (const SoundSource& sound : scene_.sounds) seed_at(sound.position_m, 1.5, 0.3, 3.0, true);
        for (const Feature& feature : scene_.features) {
            if (feature.bounds_m.empty()) continue;
            const bool thing = feature.kind == FeatureKind::Object || feature.kind == FeatureKind::Button || feature.kind == FeatureKind::Trigger ||
                               feature.kind == FeatureKind::Teleport;
            const Vec3 centre = feature.bounds_m.centre_m(), size = feature.bounds_m.size_m();
            // Of what is as large as a room or a hall's ceiling the middle says nothing.
            if (!thing || std::max(size.x, size.y) > 6.0) continue;
            seed_at({centre.x, centre.y, feature.bounds_m.min_m.z}, 0.5 * std::max(size.x, size.y) + body_.radius_m + 0.3, 0.3, 2.0, true);
        }
        // Nothing that a designer has put: the middle of the world, from above.
        if (!any_ && scene_.starts.empty() && !scene_.bounds_m.empty()) {
            const Vec3 c = scene_.bounds_m.centre_m();
            seed_at({c.x, c.y, scene_.bounds_m.min_m.z}, 5.0, scene_.bounds_m.size_m().z + 0.1, 0.1, false);
        }
    }

    const Scene& scene_;
    WalkBody body_;
    const std::function<bool()>& stop_;
    Obstacles obstacles_;
    BoxIndex index_, passing_index_;
    Vec3 anchor_{0.0};
    std::unordered_map<std::uint64_t, std::uint32_t> tile_number_;  // looked up, never walked through: no order of its own
    std::vector<Tile> tiles_;
    std::vector<Spot> open_;
    std::vector<std::uint32_t> near_;
    std::size_t reached_ = 0;
    bool any_ = false;
    Cell low_, high_;
};

bool wades(const std::vector<const Solid*>& liquids, const Vec3& feet) {
    return std::any_of(liquids.begin(), liquids.end(), [&](const Solid* s) { return contains(s->shape, feet + Vec3(0.0, 0.0, kWading_m)); });
}

void Flood::write(WalkSpace& space) {
    space.cell_m = body_.cell_m;
    space.width = static_cast<std::uint32_t>(high_.x - low_.x + 1);
    space.depth = static_cast<std::uint32_t>(high_.y - low_.y + 1);
    space.first.assign(static_cast<std::size_t>(space.width) * space.depth + 1, 0);
    double lowest = std::numeric_limits<double>::infinity();
    for (const Tile& tile : tiles_)
        for (const Place& p : tile.places)
            if (p.reached) lowest = std::min(lowest, p.floor);
    const Vec2 corner = middle(low_) - Vec2(0.5 * body_.cell_m);
    space.origin_m = Vec3(corner, lowest);
    for (const Obstacle& o : obstacles_.all) space.obstacle_features.push_back(o.feature);
    for (const PassingFloor& o : obstacles_.passing) space.obstacle_features.push_back(o.shape.feature);

    std::vector<Aabb> door_boxes, liquid_boxes;
    for (const auto& [box, mover] : obstacles_.doors) door_boxes.push_back(box);
    for (const Solid* s : obstacles_.liquids) liquid_boxes.push_back(s->shape.bounds_m);
    const BoxIndex doors(door_boxes), liquids(liquid_boxes);

    // Numbers for all that was reached, cell by cell.
    std::vector<Spot> spots;
    spots.reserve(reached_);
    for (std::int64_t y = low_.y; y <= high_.y; ++y)
        for (std::int64_t x = low_.x; x <= high_.x; ++x) {
            const Cell c{x, y};
            const auto number = static_cast<std::uint32_t>((y - low_.y) * space.width + (x - low_.x));
            space.first[number] = static_cast<std::uint32_t>(space.spans.size());
            const std::uint64_t key = (static_cast<std::uint64_t>(floor_div(x)) << 32) ^ (static_cast<std::uint64_t>(floor_div(y)) & 0xffffffffU);
            const auto known = tile_number_.find(key);
            if (known == tile_number_.end()) continue;
            Tile& tile = tiles_[known->second];
            const std::size_t cell = local(c);
            for (std::uint32_t k = tile.first_place[cell]; k < tile.first_place[cell + 1]; ++k) {
                Place& p = tile.places[k];
                if (!p.reached) continue;
                p.span = static_cast<std::uint32_t>(space.spans.size());
                WalkSpan span;
                span.floor_m = static_cast<float>(p.floor - lowest);
                span.ceiling_m = static_cast<float>(std::min(p.ceiling - lowest, 1e6));
                span.cell = number;
                span.ground = p.ground;
                const Vec2 m = middle(c);
                const Vec3 feet(m, p.floor);
                Aabb here{feet - Vec3(0.5 * body_.cell_m, 0.5 * body_.cell_m, 0.1), feet + Vec3(0.5 * body_.cell_m, 0.5 * body_.cell_m, body_.height_m)};
                doors.find(here, near_);
                if (!near_.empty()) span.door = obstacles_.doors[near_.front()].second;
                liquids.find({feet, feet + Vec3(0.0, 0.0, kWading_m)}, near_);
                span.liquid = !near_.empty() && wades(obstacles_.liquids, feet);
                space.spans.push_back(span);
                spots.push_back({known->second, k, c});
            }
        }
    space.first.back() = static_cast<std::uint32_t>(space.spans.size());

    for (std::uint32_t s = 0; s < spots.size(); ++s) {
        const Place& here = tiles_[spots[s].tile].places[spots[s].place];
        for (int d = 0; d < 4; ++d) {
            const Cell to = neighbour(spots[s].cell, d);
            const std::uint32_t tile = tile_of(to);
            const std::uint32_t k = step(here, tile, to);
            // Only where it is the nearest step from both sides.
            if (k != kNothing && step(tiles_[tile].places[k], spots[s].tile, spots[s].cell) == spots[s].place) {
                space.spans[s].next[d] = tiles_[tile].places[k].span;
                continue;
            }
            if (const std::uint32_t down = drop(here, tile, to); down != kNothing && k == kNothing)
                space.links.push_back({PassageKind::Drop, s, tiles_[tile].places[down].span, false, kNoFeature});
            // What stands in the way there, the building itself before what stands in it.
            const Tile& t = tiles_[tile];
            const std::size_t cell = local(to);
            std::uint32_t blocker = kNothing;
            for (std::uint32_t i = t.first_interval[cell]; i < t.first_interval[cell + 1]; ++i) {
                const Interval& interval = t.intervals[i];
                if (interval.low >= here.floor + 0.01 || interval.high <= here.floor + kRounding_m) continue;
                if (blocker == kNothing || (!is_building(blocker) && is_building(interval.obstacle))) blocker = interval.obstacle;
            }
            if (space.spans[s].beside == kNothing || !is_building(space.spans[s].beside)) space.spans[s].beside = blocker;
            if (blocker == kNothing) space.spans[s].near_edge = true;
        }
    }
}

// How far each span is from the nearest of those that count as borders, and which one that is: every border spreads over the spans nearer to it than to others.
std::vector<float> distance_from(const WalkSpace& space, const std::function<bool(std::uint32_t span)>& counts, std::vector<std::uint32_t>& source) {
    struct Wave {
        std::uint32_t span, source;
    };
    const auto count = static_cast<std::uint32_t>(space.spans.size());
    std::vector<float> found(count, 1e6F);
    source.assign(count, kNothing);
    std::vector<std::vector<Wave>> buckets(1);
    const auto distance = [&](std::uint32_t a, std::uint32_t b) {
        const double dx = static_cast<double>(space.spans[a].cell % space.width) - static_cast<double>(space.spans[b].cell % space.width);
        const double dy = static_cast<double>(space.spans[a].cell / space.width) - static_cast<double>(space.spans[b].cell / space.width);
        return std::sqrt(dx * dx + dy * dy);  // cells
    };
    for (std::uint32_t s = 0; s < count; ++s)
        if (counts(s)) buckets[0].push_back({s, s});
    for (std::size_t b = 0; b < buckets.size(); ++b)
        for (std::size_t i = 0; i < buckets[b].size(); ++i) {
            const Wave wave = buckets[b][i];
            const auto far = static_cast<float>((distance(wave.span, wave.source) + 0.5) * space.cell_m);
            if (!(far < found[wave.span])) continue;
            found[wave.span] = far;
            source[wave.span] = wave.source;
            for (const std::uint32_t n : space.spans[wave.span].next) {
                if (n == kNothing) continue;
                const double next_far = distance(n, wave.source);
                if (!((next_far + 0.5) * space.cell_m < static_cast<double>(found[n]))) continue;
                const auto bucket = std::max(static_cast<std::size_t>(next_far * 2.0), b);
                if (bucket >= buckets.size()) buckets.resize(bucket + 1);
                buckets[bucket].push_back({n, wave.source});
            }
        }
    return found;
}

// How far each span is from the nearest border, and what stands there.
void measure_clearance(WalkSpace& space) {
    std::vector<std::uint32_t> source;
    const auto is_border = [&](std::uint32_t s) {
        const auto& next = space.spans[s].next;
        return std::any_of(std::begin(next), std::end(next), [](std::uint32_t n) { return n == kNothing; });
    };
    const std::vector<float> clearance = distance_from(space, is_border, source);
    for (std::uint32_t s = 0; s < space.spans.size(); ++s) {
        space.spans[s].clearance_m = clearance[s];
        if (source[s] == kNothing || source[s] == s) continue;
        space.spans[s].beside = space.spans[source[s]].beside;
        space.spans[s].near_edge = space.spans[source[s]].near_edge;
    }
}

// Where the floor rises step by step.
void find_stairs(WalkSpace& space) {
    const int reach = std::max(2, static_cast<int>(std::lround(kStairWindow_m / space.cell_m)));
    const double least_range_m = std::max(0.6, 2.0 * space.body.step_up_m);
    const auto count = static_cast<std::uint32_t>(space.spans.size());
    const auto walk = [&](std::uint32_t s, int d) {
        for (int i = 0; i < reach && space.spans[s].next[d] != kNothing; ++i) s = space.spans[s].next[d];
        return static_cast<double>(space.spans[s].floor_m);
    };
    for (std::uint32_t s = 0; s < count; ++s)
        space.spans[s].stairs = std::abs(walk(s, 0) - walk(s, 2)) >= kStairRise_m || std::abs(walk(s, 1) - walk(s, 3)) >= kStairRise_m;
    std::vector<bool> seen(count, false);
    std::vector<std::uint32_t> piece;
    for (std::uint32_t s = 0; s < count; ++s) {
        if (seen[s] || !space.spans[s].stairs) continue;
        piece.assign(1, s);
        seen[s] = true;
        float low = space.spans[s].floor_m, high = low;
        for (std::size_t i = 0; i < piece.size(); ++i) {
            low = std::min(low, space.spans[piece[i]].floor_m);
            high = std::max(high, space.spans[piece[i]].floor_m);
            for (const std::uint32_t n : space.spans[piece[i]].next)
                if (n != kNothing && space.spans[n].stairs && !seen[n]) {
                    seen[n] = true;
                    piece.push_back(n);
                }
        }
        if (static_cast<double>(high - low) < least_range_m)
            for (const std::uint32_t p : piece) space.spans[p].stairs = false;
    }
}

// Of the many places along an edge where one could step off, one for each stretch of about a metre.
void thin_drops(WalkSpace& space) {
    std::unordered_map<std::uint64_t, std::size_t> kept;
    std::vector<WalkLink> thin;
    const auto tile = std::max<std::uint32_t>(1, static_cast<std::uint32_t>(std::lround(1.0 / space.cell_m)));
    for (const WalkLink& link : space.links) {
        const WalkSpan &from = space.spans[link.from], &to = space.spans[link.to];
        const std::uint64_t x = from.cell % space.width / tile, y = from.cell / space.width / tile;
        const auto level = static_cast<std::uint64_t>(std::lround(static_cast<double>(from.floor_m) * 2.0)) & 0xfff;
        const auto below = static_cast<std::uint64_t>(std::lround(static_cast<double>(to.floor_m) * 2.0)) & 0xfff;
        const std::uint64_t key = (x << 44) ^ (y << 24) ^ (level << 12) ^ below;
        const auto [found, is_new] = kept.try_emplace(key, thin.size());
        if (is_new) thin.push_back(link);
        else if (from.clearance_m > space.spans[thin[found->second].from].clearance_m) thin[found->second] = link;
    }
    space.links = std::move(thin);
}

void link_lifts_and_teleporters(const Scene& scene, WalkSpace& space) {
    const auto lift_of = [&](std::uint32_t span) -> FeatureId {
        const std::uint32_t ground = space.spans[span].ground;
        if (ground == kNothing || ground >= space.obstacle_features.size()) return kNoFeature;
        const FeatureId feature = space.obstacle_features[ground];
        const Feature* found = scene.find(feature);
        return found && found->kind == FeatureKind::Lift ? feature : kNoFeature;
    };
    std::vector<std::pair<FeatureId, std::pair<double, WalkLink>>> lifts;  // the column nearest to the middle
    for (std::uint32_t cell = 0; cell + 1 < space.first.size(); ++cell)
        for (std::uint32_t low = space.first[cell]; low < space.first[cell + 1]; ++low) {
            const FeatureId feature = lift_of(low);
            if (!feature) continue;
            for (std::uint32_t high = low + 1; high < space.first[cell + 1]; ++high) {
                if (lift_of(high) != feature) continue;
                const Vec3 off = space.place_m(low) - scene.features[feature.value].bounds_m.centre_m();
                const double far = std::hypot(off.x, off.y);
                auto known = std::find_if(lifts.begin(), lifts.end(), [&](const auto& l) { return l.first == feature; });
                const WalkLink link{PassageKind::Lift, low, high, true, feature};
                if (known == lifts.end()) lifts.push_back({feature, {far, link}});
                else if (far < known->second.first) known->second = {far, link};
            }
        }
    for (const auto& lift : lifts) space.links.push_back(lift.second.second);
    for (const Switch& s : scene.switches) {
        const Feature* volume = scene.find(s.volume);
        if (!s.leads_elsewhere || !volume || volume->bounds_m.empty()) continue;
        const Vec3 c = volume->bounds_m.centre_m(), size = volume->bounds_m.size_m();
        const std::uint32_t from = space.nearest({c.x, c.y, volume->bounds_m.min_m.z}, 0.5 * std::max(size.x, size.y) + 0.3, size.z, 1.0);
        const std::uint32_t to = space.nearest(s.feet_m, 1.0, 0.6, 3.0);
        if (from != kNothing && to != kNothing && from != to) space.links.push_back({PassageKind::Teleporter, from, to, false, s.volume});
    }
}

}  // namespace

std::uint32_t WalkSpace::nearest(const Vec3& feet_m, double level_m, double up_m, double down_m) const {
    if (!is_finite(feet_m) || width == 0) return kNothing;
    const double fx = (feet_m.x - origin_m.x) / cell_m, fy = (feet_m.y - origin_m.y) / cell_m;
    if (std::abs(fx) > 1e8 || std::abs(fy) > 1e8) return kNothing;
    const auto cx = static_cast<std::int64_t>(std::floor(fx)), cy = static_cast<std::int64_t>(std::floor(fy));
    const auto rings = static_cast<std::int64_t>(level_m / cell_m);
    double best = std::numeric_limits<double>::infinity();
    std::uint32_t found = kNothing;
    for (std::int64_t ring = 0; ring <= rings && (static_cast<double>(ring) - 1.0) * cell_m < best; ++ring)
        for (std::int64_t dy = -ring; dy <= ring; ++dy)
            for (std::int64_t dx = -ring; dx <= ring; dx += std::abs(dy) == ring ? 1 : 2 * std::max<std::int64_t>(ring, 1)) {
                const std::int64_t x = cx + dx, y = cy + dy;
                if (x < 0 || y < 0 || x >= width || y >= depth) continue;
                const auto cell = static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x);
                for (std::uint32_t s = first[cell]; s < first[cell + 1]; ++s) {
                    const Vec3 off = place_m(s) - feet_m;
                    if (off.z > up_m || off.z < -down_m) continue;
                    const double far = std::hypot(off.x, off.y) + std::abs(off.z);
                    if (far < best) {
                        best = far;
                        found = s;
                    }
                }
            }
    return found;
}

std::uint32_t WalkSpace::at(const Vec3& feet_m) const {
    const double reach = 1.5 * body.step_up_m;
    return nearest(feet_m, 0.0, reach, reach);
}

bool WalkSpace::straight(const Vec3& from_m, const Vec3& to_m, const std::function<void(std::uint32_t)>& touched) const {
    std::uint32_t here = nearest(from_m, 1.5 * cell_m, 1.5 * body.step_up_m + 0.1, 1.5 * body.step_up_m + 0.1);
    if (here == kNothing) return false;
    if (touched) touched(here);
    // From cell to cell along the line, each over its side.
    const Vec3 start = place_m(here);
    const double dx = to_m.x - start.x, dy = to_m.y - start.y;
    auto x = static_cast<std::int64_t>(spans[here].cell % width), y = static_cast<std::int64_t>(spans[here].cell / width);
    const auto to_x = static_cast<std::int64_t>(std::floor((to_m.x - origin_m.x) / cell_m)),
               to_y = static_cast<std::int64_t>(std::floor((to_m.y - origin_m.y) / cell_m));
    const double inf = std::numeric_limits<double>::infinity();
    const double step_x = dx != 0.0 ? cell_m / std::abs(dx) : inf, step_y = dy != 0.0 ? cell_m / std::abs(dy) : inf;
    double next_x = 0.5 * step_x, next_y = 0.5 * step_y;
    while (x != to_x || y != to_y) {
        const bool along_x = next_x < next_y;
        if (std::min(next_x, next_y) > 1.0 + std::max(step_x == inf ? 0.0 : step_x, step_y == inf ? 0.0 : step_y)) break;
        const int d = along_x ? (dx > 0.0 ? 0 : 2) : (dy > 0.0 ? 1 : 3);
        const std::uint32_t n = spans[here].next[d];
        if (n == kNothing) return false;
        here = n;
        if (touched) touched(here);
        (along_x ? x : y) += along_x ? (dx > 0.0 ? 1 : -1) : (dy > 0.0 ? 1 : -1);
        (along_x ? next_x : next_y) += along_x ? step_x : step_y;
    }
    return std::abs(place_m(here).z - to_m.z) <= 1.5 * body.step_up_m + 0.1;
}

Result<WalkSpace> make_walk_space(const Scene& scene, const WalkBody& body, const std::function<bool()>& stop) {
    WalkSpace space;
    space.body = body;
    WalkBody tried = body;
    for (;; tried.cell_m *= 2.0) {
        if (tried.cell_m > kCoarsest_m) return fail(phrase("navigation.too_large"), scene.source_file);
        Flood flood(scene, tried, stop);
        const Flood::End end = flood.run();
        if (end == Flood::End::Stopped) return fail(phrase("navigation.given_up"), scene.source_file);
        if (end == Flood::End::TooLarge || !flood.fits_in_grid()) continue;
        if (flood.reached() == 0) return fail(phrase("navigation.no_floor"), scene.source_file);
        flood.write(space);
        break;
    }
    space.body.cell_m = tried.cell_m;
    if (tried.cell_m > body.cell_m) space.said.push_back(phrase("navigation.coarse", {{"centimetres", std::lround(tried.cell_m * 100.0)}}));
    measure_clearance(space);
    find_stairs(space);
    thin_drops(space);
    link_lifts_and_teleporters(scene, space);
    return space;
}

}  // namespace handrail
