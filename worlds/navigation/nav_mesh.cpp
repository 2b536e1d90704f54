#include "worlds/navigation/nav_mesh.h"

#include <recastnavigation/DetourNavMesh.h>
#include <recastnavigation/DetourNavMeshBuilder.h>
#include <recastnavigation/DetourNavMeshQuery.h>
#include <recastnavigation/Recast.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <map>
#include <unordered_map>

#include "worlds/base/language.h"

namespace handrail::navigation {
namespace {

// In Recast, y points up. Recast's coordinates are our (x, z, y), relative to the origin of the space.
enum Area : unsigned char { kOpen = 1, kNearWall, kNearEdge, kWading, kDropArea, kLiftArea, kTeleportArea };
constexpr double kComfortable_m = 0.2;  // clearance beyond the walker's radius at which floor is comfortable
constexpr double kEdgeComfort_m = 0.5, kWallComfort_m = 0.3;
constexpr double kLeastHeight_m = 0.02;  // Recast's unit of height; the unit is larger in very high worlds
// Largest side of a polygon. It is small, because paths run along polygon edges and should be close to the shortest
// path.
constexpr double kSquare_m = 1.0;
constexpr std::uint32_t kLargestSquare = 8;   // largest side of a polygon in large worlds, as a multiple of kSquare_m
constexpr std::uint32_t kSquaresOfTile = 64;  // number of squares along a side of a tile
// Most regions of a tile and of the whole world, and most vertices of a tile. Recast's indices have 16 bits.
constexpr std::size_t kMostRegions = 30'000, kMostVertices = 60'000;
// Detour identifies a polygon by its tile and its index in that tile. Detour needs 10 bits for other purposes.
constexpr int kMostRefBits = 22;
constexpr int kMostPath = 16'384;
constexpr unsigned short kOnFoot = 1, kOverLink = 2;  // flags of polygons: floor, and links such as lifts

struct Free {
    void operator()(rcContourSet* p) const { rcFreeContourSet(p); }
    void operator()(rcPolyMesh* p) const { rcFreePolyMesh(p); }
    void operator()(dtNavMesh* p) const { dtFreeNavMesh(p); }
    void operator()(dtNavMeshQuery* p) const { dtFreeNavMeshQuery(p); }
};

tl::unexpected<Error> failed() { return fail(phrase("navigation.too_many_floors")); }

unsigned char area_of(const WalkSpan& span) {
    if (span.liquid) return kWading;
    if (span.near_edge && static_cast<double>(span.clearance_m) < kEdgeComfort_m) return kNearEdge;
    return static_cast<double>(span.clearance_m) < kComfortable_m ? kNearWall : kOpen;
}

unsigned char area_of(const WalkLink& link) {
    if (link.kind == PassageKind::Drop) return kDropArea;
    return link.kind == PassageKind::Lift ? kLiftArea : kTeleportArea;
}

float cost_of_area(unsigned char area, RoutePreference preference) {
    if (preference == RoutePreference::Shortest) return 1.0F;
    switch (area) {
        case kNearWall:
            return 1.5F;
        case kNearEdge:
            return 3.0F;
        case kWading:
            return 4.0F;
        case kDropArea:
            return 10.0F;
        default:
            return 1.0F;
    }
}

// Divides the spans into what Recast calls regions. A region is a connected piece of one area within one square, in
// which no span is above another. Returns the number of regions.
std::size_t regions_of(const WalkSpace& space, const std::vector<unsigned char>& areas, std::uint32_t side,
                       std::vector<std::uint32_t>& region) {
    region.assign(space.spans.size(), 0);
    std::size_t made = 0;
    std::vector<std::uint32_t> piece;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> cells;  // cells of the current piece, sorted when needed
    // For each column: the last region that contains one of its spans.
    std::vector<std::size_t> taken_by(space.first.size(), 0);
    for (std::uint32_t s = 0; s < space.spans.size(); ++s) {
        if (region[s] != 0) continue;
        ++made;
        const auto square = [&](std::uint32_t k) {
            const std::uint32_t cell = space.spans[k].cell;
            return std::pair(cell % space.width / side, cell / space.width / side);
        };
        piece.assign(1, s);
        region[s] = static_cast<std::uint32_t>(made);
        taken_by[space.spans[s].cell] = made;
        for (std::size_t i = 0; i < piece.size(); ++i)
            for (const std::uint32_t n : space.spans[piece[i]].next) {
                if (n == kNothing || region[n] != 0 || areas[n] != areas[s] || square(n) != square(s) ||
                    taken_by[space.spans[n].cell] == made)
                    continue;
                region[n] = static_cast<std::uint32_t>(made);
                taken_by[space.spans[n].cell] = made;
                piece.push_back(n);
            }
    }
    return made;
}

struct TileOfMesh;

}  // namespace

double cost_per_m(const WalkSpan& span, RoutePreference preference) {
    if (preference == RoutePreference::Shortest) return 1.0;
    const double clearance_m = static_cast<double>(span.clearance_m);
    const double wall = 2.0 * std::max(0.0, 1.0 - clearance_m / kWallComfort_m),
                 edge = span.near_edge ? 4.0 * std::max(0.0, 1.0 - clearance_m / kEdgeComfort_m) : 0.0;
    return 1.0 + std::max(wall, edge) + (span.liquid ? 3.0 : 0.0);
}

double NavMesh::cost_of(const WalkLink& link, double length_m, RoutePreference preference) {
    return length_m * static_cast<double>(cost_of_area(area_of(link), preference));
}

struct NavMesh::Parts {
    const WalkSpace* space = nullptr;
    std::unique_ptr<dtNavMesh, Free> mesh;
    std::unique_ptr<dtNavMeshQuery, Free> query;
    int polygons = 0;
    std::size_t bytes = 0, far_links = 0;
    std::vector<dtPolyRef> refs = std::vector<dtPolyRef>(kMostPath);
    std::vector<float> straight = std::vector<float>(std::size_t{3} * kMostPath);
    std::vector<unsigned char> flags = std::vector<unsigned char>(kMostPath);

    void to_mesh(const Vec3& world_m, float* p) const {
        const Vec3 own = world_m - space->origin_m;
        p[0] = static_cast<float>(own.x);
        p[1] = static_cast<float>(own.z);
        p[2] = static_cast<float>(own.y);
    }
    bool add(const TileOfMesh& tile);
    Vec3 to_world(const float* p) const {
        return space->origin_m + Vec3(static_cast<double>(p[0]), static_cast<double>(p[2]), static_cast<double>(p[1]));
    }
};

NavMesh::NavMesh(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
NavMesh::~NavMesh() = default;
NavMesh::NavMesh(NavMesh&&) noexcept = default;
NavMesh& NavMesh::operator=(NavMesh&&) noexcept = default;
int NavMesh::polygons() const { return parts_->polygons; }
std::size_t NavMesh::bytes() const { return parts_->bytes; }
std::size_t NavMesh::far_links() const { return parts_->far_links; }

namespace {

// Makes the polygons of one square tile at a time. Tiles are needed because Recast and Detour use 16-bit indices, and
// because joining the outlines of holes takes time that grows with the square of their number.
class TileMaker {
public:
    // `side`: side of a tile in cells. It is a multiple of the side of the squares with which `region` was computed.
    TileMaker(const WalkSpace& space, const std::vector<unsigned char>& areas, const std::vector<std::uint32_t>& region,
              std::uint32_t side)
        : space_(space), areas_(areas), region_(region), side_(side) {
        for (const WalkSpan& span : space.spans) highest_ = std::max(highest_, span.floor_m);
        unit_m_ = static_cast<float>(std::max(kLeastHeight_m, static_cast<double>(highest_) / 60'000.0));
    }

    // `polygons` is null if the tile is too large. It may be empty.
    struct Made {
        std::unique_ptr<rcPolyMesh, Free> polygons;
        bool failed = false;
    };
    Made make(std::uint32_t tile_x, std::uint32_t tile_y) {
        x0_ = tile_x * side_;
        y0_ = tile_y * side_;
        const int wide = static_cast<int>(std::min(side_, space_.width - x0_)),
                  deep = static_cast<int>(std::min(side_, space_.depth - y0_));
        if (!fill(wide, deep)) return {};
        rcCompactHeightfield field;
        field.width = wide + 2 * kBorder;
        field.height = deep + 2 * kBorder;
        field.borderSize = kBorder;
        field.spanCount = static_cast<int>(spans_.size());
        field.walkableHeight = 1;
        field.cs = static_cast<float>(space_.cell_m);
        field.ch = unit_m_;
        field.walkableClimb = static_cast<int>(std::ceil(space_.body.step_up_m / static_cast<double>(unit_m_)));
        field.maxRegions = static_cast<unsigned short>(local_.size() + 1);
        field.bmin[0] = (static_cast<float>(x0_) - kBorder) * field.cs;
        field.bmin[2] = (static_cast<float>(y0_) - kBorder) * field.cs;
        field.bmax[0] = field.bmin[0] + static_cast<float>(field.width) * field.cs;
        field.bmax[1] = highest_ + static_cast<float>(space_.body.height_m) + 1.0F;
        field.bmax[2] = field.bmin[2] + static_cast<float>(field.height) * field.cs;
        // Recast uses the arrays that this function fills; they must outlive `field`. Recast's own rasteriser is not
        // used, because it knows only triangles, not the walker's body and the slopes on which the walker can stand.
        field.cells = cells_.data();
        field.spans = spans_.data();
        field.areas = span_areas_.data();
        std::unique_ptr<rcContourSet, Free> contours(rcAllocContourSet());
        rcContext context(false);
        const bool traced = contours && rcBuildContours(&context, field, 0.7F, 0, *contours, 0);
        field.cells = nullptr;
        field.spans = nullptr;
        field.areas = nullptr;
        if (!traced) return {nullptr, true};
        std::size_t vertices = 0;
        for (int i = 0; i < contours->nconts; ++i) vertices += static_cast<std::size_t>(contours->conts[i].nverts);
        if (vertices > kMostVertices) return {};
        Made made{std::unique_ptr<rcPolyMesh, Free>(rcAllocPolyMesh()), false};
        if (!made.polygons || !rcBuildPolyMesh(&context, *contours, DT_VERTS_PER_POLYGON, *made.polygons))
            return {nullptr, true};
        std::fill(made.polygons->flags, made.polygons->flags + made.polygons->npolys, kOnFoot);
        return made;
    }

private:
    // Each tile also reads one row of cells beyond each side, so that its outline has corners in the same places as the
    // outlines of neighbouring tiles.
    static constexpr int kBorder = 1;

    // Fills in the columns of the tile. Returns false if there are too many regions.
    bool fill(int wide, int deep) {
        cells_.assign(static_cast<std::size_t>(wide + 2 * kBorder) * static_cast<std::size_t>(deep + 2 * kBorder), {});
        spans_.clear();
        span_areas_.clear();
        local_.clear();
        std::size_t cell = 0;
        for (int y = -kBorder; y < deep + kBorder; ++y)
            for (int x = -kBorder; x < wide + kBorder; ++x, ++cell) {
                const std::int64_t cx = std::int64_t{x0_} + x, cy = std::int64_t{y0_} + y;
                if (cx < 0 || cy < 0 || cx >= space_.width || cy >= space_.depth) continue;
                const bool border = x < 0 || y < 0 || x >= wide || y >= deep;
                const auto column = static_cast<std::size_t>(cy) * space_.width + static_cast<std::size_t>(cx);
                cells_[cell].index = static_cast<unsigned int>(spans_.size()) & 0xffffffU;
                cells_[cell].count = (space_.first[column + 1] - space_.first[column]) & 0xffU;
                for (std::uint32_t s = space_.first[column]; s < space_.first[column + 1]; ++s)
                    if (!add_span(s, x, y, wide, deep, border)) return false;
            }
        return true;
    }

    bool add_span(std::uint32_t s, int x, int y, int wide, int deep, bool border) {
        const WalkSpan& from = space_.spans[s];
        const std::uint32_t region =
            local_.try_emplace(region_[s], static_cast<std::uint32_t>(local_.size() + 1)).first->second;
        if (region > kMostRegions) return false;
        rcCompactSpan span{};
        span.y = static_cast<unsigned short>(std::lround(from.floor_m / unit_m_));
        span.reg = static_cast<unsigned short>(region | (border ? RC_BORDER_REG : 0U));
        span.h = 255;
        span.con = 0;
        // Recast orders its directions west, north, east, south; its z axis is our north.
        constexpr int kDirections[4] = {2, 1, 0, 3};
        constexpr int kEast[4] = {-1, 0, 1, 0}, kNorth[4] = {0, 1, 0, -1};
        for (int d = 0; d < 4; ++d) {
            const std::uint32_t n = from.next[kDirections[d]];
            const int to_x = x + kEast[d], to_y = y + kNorth[d];
            const bool there =
                n != kNothing && to_x >= -kBorder && to_y >= -kBorder && to_x < wide + kBorder && to_y < deep + kBorder;
            rcSetCon(span, d, there ? static_cast<int>(n - space_.first[space_.spans[n].cell]) : int{RC_NOT_CONNECTED});
        }
        spans_.push_back(span);
        span_areas_.push_back(areas_[s]);
        return true;
    }

    const WalkSpace& space_;
    const std::vector<unsigned char>& areas_;
    const std::vector<std::uint32_t>& region_;
    std::uint32_t side_, x0_ = 0, y0_ = 0;
    float highest_ = 0.0F, unit_m_ = 0.0F;
    std::vector<rcCompactCell> cells_;
    std::vector<rcCompactSpan> spans_;
    std::vector<unsigned char> span_areas_;
    std::unordered_map<std::uint32_t, std::uint32_t> local_;  // number in this tile of each region; never iterated
};

struct TileOfMesh {
    std::uint32_t x = 0, y = 0;
    std::unique_ptr<rcPolyMesh, Free> polygons;
    std::vector<std::uint32_t> links;  // links that begin on this tile
};

int bits_for(std::size_t count) { return static_cast<int>(std::bit_width(std::bit_ceil(count)) - 1); }

}  // namespace

Result<NavMesh> NavMesh::make(const WalkSpace& space, const std::stop_token& stop) {
    std::vector<unsigned char> areas(space.spans.size());
    for (std::size_t s = 0; s < areas.size(); ++s) areas[s] = area_of(space.spans[s]);
    const auto finest = std::max<std::uint32_t>(2, static_cast<std::uint32_t>(std::lround(kSquare_m / space.cell_m)));
    std::vector<std::uint32_t> region;
    std::uint32_t square = finest;
    bool plain = false;
    while (regions_of(space, areas, square, region) > kMostRegions) {
        if (stop.stop_requested()) return failed();
        if (square < kLargestSquare * finest) {
            square *= 2;
            continue;
        }
        if (plain) break;
        // If furniture divides the floor into too many regions, only edges and liquids stay separate areas. Routes
        // still keep away from walls, because each span knows its distance from them.
        plain = true;
        square = finest;
        std::replace(areas.begin(), areas.end(), static_cast<unsigned char>(kNearWall),
                     static_cast<unsigned char>(kOpen));
    }

    auto parts = std::make_unique<Parts>();
    parts->space = &space;
    std::vector<TileOfMesh> tiles;
    const auto tile_of = [&](std::uint32_t span, std::uint32_t side) {
        const std::uint32_t cell = space.spans[span].cell;
        return std::pair(cell % space.width / side, cell / space.width / side);
    };
    std::uint32_t side = square * std::max<std::uint32_t>(1, kSquaresOfTile * finest / square);
    for (;; side = side / square / 2 * square) {
        if (stop.stop_requested() || side == 0) return failed();
        TileMaker maker(space, areas, region, side);
        tiles.clear();
        bool too_large = false;
        for (std::uint32_t y = 0; y * side < space.depth && !too_large; ++y)
            for (std::uint32_t x = 0; x * side < space.width && !too_large; ++x) {
                if (stop.stop_requested()) return failed();
                TileMaker::Made made = maker.make(x, y);
                if (made.failed) return failed();
                too_large = !made.polygons;
                if (too_large || made.polygons->npolys == 0) continue;
                tiles.push_back({x, y, std::move(made.polygons), {}});
            }
        if (!too_large) break;
    }
    if (tiles.empty()) return fail(phrase("navigation.little_floor"));

    std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> tile_at;
    for (std::size_t t = 0; t < tiles.size(); ++t) tile_at[{tiles[t].y, tiles[t].x}] = t;
    for (std::uint32_t i = 0; i < space.links.size(); ++i) {
        const auto [x, y] = tile_of(space.links[i].from, side);
        const auto [to_x, to_y] = tile_of(space.links[i].to, side);
        const bool next = x <= to_x + 1 && to_x <= x + 1 && y <= to_y + 1 && to_y <= y + 1;
        if (const auto found = tile_at.find({y, x}); found != tile_at.end() && next)
            tiles[found->second].links.push_back(i);
        if (!next) ++parts->far_links;
    }
    std::size_t most_polygons = 1;
    for (const TileOfMesh& tile : tiles)
        most_polygons = std::max(most_polygons, static_cast<std::size_t>(tile.polygons->npolys) + tile.links.size());

    dtNavMeshParams shape;
    std::memset(&shape, 0, sizeof shape);
    shape.tileWidth = shape.tileHeight = static_cast<float>(side * space.cell_m);
    shape.maxTiles = static_cast<int>(std::bit_ceil(tiles.size()));
    shape.maxPolys = static_cast<int>(std::bit_ceil(most_polygons));
    if (bits_for(tiles.size()) + bits_for(most_polygons) > kMostRefBits) return failed();
    parts->mesh.reset(dtAllocNavMesh());
    if (!parts->mesh || dtStatusFailed(parts->mesh->init(&shape))) return failed();
    for (const TileOfMesh& tile : tiles) {
        if (stop.stop_requested()) return failed();
        if (!parts->add(tile)) return failed();
    }
    parts->query.reset(dtAllocNavMeshQuery());
    if (!parts->query || dtStatusFailed(parts->query->init(parts->mesh.get(), 65'535))) return failed();
    return NavMesh(std::move(parts));
}

// Adds the polygons of one tile, and the links that begin on it, to Detour's mesh.
bool NavMesh::Parts::add(const TileOfMesh& tile) {
    std::vector<float> link_ends, link_radius;
    std::vector<unsigned short> link_flags;
    std::vector<unsigned char> link_areas, link_both;
    std::vector<unsigned int> link_ids;
    for (const std::uint32_t i : tile.links) {
        const WalkLink& link = space->links[i];
        float ends[6];
        to_mesh(space->place_m(link.from), ends);
        to_mesh(space->place_m(link.to), ends + 3);
        link_ends.insert(link_ends.end(), ends, ends + 6);
        link_radius.push_back(static_cast<float>(3.0 * space->cell_m));
        link_flags.push_back(kOverLink);
        link_areas.push_back(area_of(link));
        link_both.push_back(link.both_ways ? DT_OFFMESH_CON_BIDIR : 0);
        link_ids.push_back(i);
    }
    const rcPolyMesh& made = *tile.polygons;
    dtNavMeshCreateParams params;
    std::memset(&params, 0, sizeof params);
    params.tileX = static_cast<int>(tile.x);
    params.tileY = static_cast<int>(tile.y);
    params.verts = made.verts;
    params.vertCount = made.nverts;
    params.polys = made.polys;
    params.polyAreas = made.areas;
    params.polyFlags = made.flags;
    params.polyCount = made.npolys;
    params.nvp = made.nvp;
    params.offMeshConVerts = link_ends.data();
    params.offMeshConRad = link_radius.data();
    params.offMeshConFlags = link_flags.data();
    params.offMeshConAreas = link_areas.data();
    params.offMeshConDir = link_both.data();
    params.offMeshConUserID = link_ids.data();
    params.offMeshConCount = static_cast<int>(link_ids.size());
    params.walkableHeight = static_cast<float>(space->body.height_m);
    params.walkableRadius = 2.0F;  // when Detour straightens a path, it looks ahead fifty times this distance
    params.walkableClimb = static_cast<float>(space->body.step_up_m);
    std::copy(made.bmin, made.bmin + 3, params.bmin);
    std::copy(made.bmax, made.bmax + 3, params.bmax);
    params.cs = made.cs;
    params.ch = made.ch;
    params.buildBvTree = true;
    unsigned char* data = nullptr;
    int size = 0;
    if (!dtCreateNavMeshData(&params, &data, &size)) return false;
    if (dtStatusFailed(mesh->addTile(data, size, DT_TILE_FREE_DATA, 0, nullptr))) {
        dtFree(data);
        return false;
    }
    polygons += made.npolys;
    bytes += static_cast<std::size_t>(size);
    return true;
}

std::optional<MeshPath> NavMesh::path(std::uint32_t from, std::uint32_t to, RoutePreference preference,
                                      bool over_links) {
    Parts& p = *parts_;
    dtQueryFilter filter;
    for (const unsigned char area : {kOpen, kNearWall, kNearEdge, kWading, kDropArea, kLiftArea, kTeleportArea})
        filter.setAreaCost(area, cost_of_area(area, preference));
    if (!over_links) filter.setExcludeFlags(kOverLink);

    const auto locate = [&](std::uint32_t span, float* at, dtPolyRef& ref, float* on) {
        p.to_mesh(p.space->place_m(span), at);
        const auto level = static_cast<float>(4.0 * p.space->cell_m);
        const float reach[3] = {level, static_cast<float>(p.space->body.step_up_m + 0.1), level};
        ref = 0;
        return dtStatusSucceed(p.query->findNearestPoly(at, reach, &filter, &ref, on)) && ref != 0;
    };
    float a[3], b[3], on_a[3], on_b[3];
    dtPolyRef first = 0, last = 0;
    if (!locate(from, a, first, on_a) || !locate(to, b, last, on_b)) return std::nullopt;

    int count = 0;
    dtStatus status = p.query->initSlicedFindPath(first, last, on_a, on_b, &filter,
                                                  over_links ? 0U : static_cast<unsigned int>(DT_FINDPATH_ANY_ANGLE));
    while (dtStatusInProgress(status)) status = p.query->updateSlicedFindPath(1 << 20, nullptr);
    if (dtStatusFailed(status)) return std::nullopt;
    status = p.query->finalizeSlicedFindPath(p.refs.data(), &count, kMostPath);
    if (dtStatusFailed(status) || count == 0) return std::nullopt;
    MeshPath found;
    found.complete = p.refs[static_cast<std::size_t>(count - 1)] == last &&
                     !dtStatusDetail(status, DT_PARTIAL_RESULT) && !dtStatusDetail(status, DT_BUFFER_TOO_SMALL);
    if (!found.complete) p.query->closestPointOnPoly(p.refs[static_cast<std::size_t>(count - 1)], on_b, on_b, nullptr);

    // Straightens the path between links separately. Detour ignores heights, so it would treat links that are above
    // each other as one place and lose all but one.
    const auto straighten = [&](const float* begin, const float* end, int first_ref, int refs) {
        int corners = 0;
        if (refs > 0 &&
            dtStatusFailed(p.query->findStraightPath(begin, end, p.refs.data() + first_ref, refs, p.straight.data(),
                                                     p.flags.data(), nullptr, &corners, kMostPath)))
            return false;
        for (int i = 0; i < corners; ++i)
            found.corners.push_back({p.to_world(&p.straight[3 * static_cast<std::size_t>(i)]), kNothing});
        if (corners == 0) found.corners.push_back({p.to_world(begin), kNothing});
        return true;
    };
    float begin[3] = {on_a[0], on_a[1], on_a[2]};
    int first_ref = 0;
    for (int i = 1; i < count; ++i) {
        const dtPolyRef ref = p.refs[static_cast<std::size_t>(i)];
        const dtOffMeshConnection* link = p.mesh->getOffMeshConnectionByRef(ref);
        float foot[3], head[3];
        if (!link || dtStatusFailed(p.mesh->getOffMeshConnectionPolyEndPoints(p.refs[static_cast<std::size_t>(i - 1)],
                                                                              ref, foot, head)))
            continue;
        if (!straighten(begin, foot, first_ref, i - first_ref)) return std::nullopt;
        found.corners.back().link = link->userId;
        std::copy(head, head + 3, begin);
        first_ref = i + 1;
    }
    if (!straighten(begin, on_b, first_ref, count - first_ref)) return std::nullopt;
    return found;
}

}  // namespace handrail::navigation
