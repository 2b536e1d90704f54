#include "worlds/navigation/nav_mesh.h"

#include <recastnavigation/DetourNavMesh.h>
#include <recastnavigation/DetourNavMeshBuilder.h>
#include <recastnavigation/DetourNavMeshQuery.h>
#include <recastnavigation/Recast.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "worlds/base/language.h"

namespace handrail {
namespace {

// Recast's y is up: (x, z, y) of ours, relative to the space's origin.
enum Area : unsigned char { kOpen = 1, kNearWall, kNearEdge, kWading, kDropArea, kLiftArea, kTeleportArea };
constexpr double kComfortable_m = 0.2;  // of clearance beyond the body
constexpr double kEdgeComfort_m = 0.5, kWallComfort_m = 0.3;
constexpr double kLeastHeight_m = 0.02;  // Recast's unit of height; grows in very high worlds
constexpr double kTile_m = 1.0;          // polygons are no larger, so that ways over their edges come near the shortest
constexpr std::uint32_t kFineTiles = 8;
constexpr std::size_t kMostRegions = 30'000, kMostVertices = 60'000;
constexpr int kMostPath = 16'384;
constexpr unsigned short kOnFoot = 1, kOverLink = 2;  // flags of polygons

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

float cost_of_area(unsigned char area, RouteWish wish) {
    if (wish == RouteWish::Shortest) return 1.0F;
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

// Pieces of one area inside one square, none above itself: what Recast calls regions. Their number.
std::size_t regions_of(const WalkSpace& space, const std::vector<unsigned char>& areas, std::uint32_t tile,
                       std::vector<std::uint32_t>& region) {
    region.assign(space.spans.size(), 0);
    std::size_t made = 0;
    std::vector<std::uint32_t> piece;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> cells;  // of the piece, sorted where it matters
    std::vector<std::size_t> taken_by(space.first.size(), 0);    // column: the last region that took a span of it
    for (std::uint32_t s = 0; s < space.spans.size(); ++s) {
        if (region[s] != 0) continue;
        ++made;
        const auto square = [&](std::uint32_t k) {
            const std::uint32_t cell = space.spans[k].cell;
            return std::pair(cell % space.width / tile, cell / space.width / tile);
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

}  // namespace

double cost_per_m(const WalkSpan& span, RouteWish wish) {
    if (wish == RouteWish::Shortest) return 1.0;
    const double clearance_m = static_cast<double>(span.clearance_m);
    const double wall = 2.0 * std::max(0.0, 1.0 - clearance_m / kWallComfort_m),
                 edge = span.near_edge ? 4.0 * std::max(0.0, 1.0 - clearance_m / kEdgeComfort_m) : 0.0;
    return 1.0 + std::max(wall, edge) + (span.liquid ? 3.0 : 0.0);
}

double NavMesh::cost_of(const WalkLink& link, double length_m, RouteWish wish) {
    return length_m * static_cast<double>(cost_of_area(area_of(link), wish));
}

struct NavMesh::Parts {
    const WalkSpace* space = nullptr;
    std::unique_ptr<dtNavMesh, Free> mesh;
    std::unique_ptr<dtNavMeshQuery, Free> query;
    int polygons = 0;
    std::size_t bytes = 0;
    std::vector<dtPolyRef> refs = std::vector<dtPolyRef>(kMostPath);
    std::vector<float> straight = std::vector<float>(std::size_t{3} * kMostPath);
    std::vector<unsigned char> flags = std::vector<unsigned char>(kMostPath);

    void to_mesh(const Vec3& world_m, float* p) const {
        const Vec3 own = world_m - space->origin_m;
        p[0] = static_cast<float>(own.x);
        p[1] = static_cast<float>(own.z);
        p[2] = static_cast<float>(own.y);
    }
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

Result<NavMesh> NavMesh::make(const WalkSpace& space, const std::stop_token& stop) {
    std::vector<unsigned char> areas(space.spans.size());
    float highest = 0.0F;
    for (std::size_t s = 0; s < areas.size(); ++s) {
        areas[s] = area_of(space.spans[s]);
        highest = std::max(highest, space.spans[s].floor_m);
    }
    auto tile = std::max<std::uint32_t>(2, static_cast<std::uint32_t>(std::lround(kTile_m / space.cell_m)));
    std::vector<std::uint32_t> region;
    rcContext context(false);
    std::unique_ptr<rcPolyMesh, Free> polygons;
    const std::uint32_t finest = tile;
    bool plain = false;
    for (;; tile *= 2) {
        if (stop.stop_requested()) return failed();
        if (!plain && tile > kFineTiles * finest) {
            // So much furniture that what is near to it makes too many pieces: only edges and liquids stay apart. Ways
            // keep off walls all the same, by what the places themselves know.
            plain = true;
            tile = finest;
            std::replace(areas.begin(), areas.end(), static_cast<unsigned char>(kNearWall),
                         static_cast<unsigned char>(kOpen));
        }
        if (tile > 4096) return failed();
        const std::size_t count = regions_of(space, areas, tile, region);
        if (count > kMostRegions) continue;

        rcCompactHeightfield field;
        field.width = static_cast<int>(space.width);
        field.height = static_cast<int>(space.depth);
        field.spanCount = static_cast<int>(space.spans.size());
        field.walkableHeight = 1;
        field.cs = static_cast<float>(space.cell_m);
        field.ch = static_cast<float>(std::max(kLeastHeight_m, static_cast<double>(highest) / 60'000.0));
        field.walkableClimb = static_cast<int>(std::ceil(space.body.step_up_m / static_cast<double>(field.ch)));
        field.maxRegions = static_cast<unsigned short>(count + 1);
        field.bmax[0] = static_cast<float>(space.width * space.cell_m);
        field.bmax[1] = highest + static_cast<float>(space.body.height_m) + 1.0F;
        field.bmax[2] = static_cast<float>(space.depth * space.cell_m);
        // Filled here and lent to Recast: its own way there rasterises triangles, and would know nothing of bodies and
        // slopes as walking has them.
        std::vector<rcCompactCell> cells(static_cast<std::size_t>(space.width) * space.depth);
        std::vector<rcCompactSpan> spans(space.spans.size());
        for (std::size_t c = 0; c < cells.size(); ++c) {
            cells[c].index = space.first[c] & 0xffffffU;
            cells[c].count = (space.first[c + 1] - space.first[c]) & 0xffU;
        }
        for (std::size_t s = 0; s < spans.size(); ++s) {
            const WalkSpan& from = space.spans[s];
            spans[s].y = static_cast<unsigned short>(std::lround(from.floor_m / field.ch));
            spans[s].reg = static_cast<unsigned short>(region[s]);
            spans[s].h = 255;
            spans[s].con = 0;
            // Recast counts its directions from the west, with its z for our north: west, north, east, south.
            constexpr int kDirections[4] = {2, 1, 0, 3};
            for (int d = 0; d < 4; ++d) {
                const std::uint32_t n = from.next[kDirections[d]];
                rcSetCon(spans[s], d,
                         n == kNothing ? RC_NOT_CONNECTED : static_cast<int>(n - space.first[space.spans[n].cell]));
            }
        }
        field.cells = cells.data();
        field.spans = spans.data();
        field.areas = areas.data();
        const auto give_back = [&field] {
            field.cells = nullptr;
            field.spans = nullptr;
            field.areas = nullptr;
        };
        std::unique_ptr<rcContourSet, Free> contours(rcAllocContourSet());
        const bool traced = contours && rcBuildContours(&context, field, 0.7F, 0, *contours, 0);
        give_back();
        if (!traced) return failed();
        std::size_t vertices = 0;
        for (int i = 0; i < contours->nconts; ++i) vertices += static_cast<std::size_t>(contours->conts[i].nverts);
        if (vertices > kMostVertices) continue;
        polygons.reset(rcAllocPolyMesh());
        if (!polygons || !rcBuildPolyMesh(&context, *contours, DT_VERTS_PER_POLYGON, *polygons)) return failed();
        break;
    }
    if (polygons->npolys == 0) return fail(phrase("navigation.little_floor"));
    std::fill(polygons->flags, polygons->flags + polygons->npolys, kOnFoot);

    auto parts = std::make_unique<Parts>();
    parts->space = &space;
    std::vector<float> link_ends, link_radius;
    std::vector<unsigned short> link_flags;
    std::vector<unsigned char> link_areas, link_both;
    std::vector<unsigned int> link_ids;
    for (std::size_t i = 0; i < space.links.size(); ++i) {
        const WalkLink& link = space.links[i];
        float ends[6];
        parts->to_mesh(space.place_m(link.from), ends);
        parts->to_mesh(space.place_m(link.to), ends + 3);
        link_ends.insert(link_ends.end(), ends, ends + 6);
        link_radius.push_back(static_cast<float>(3.0 * space.cell_m));
        link_flags.push_back(kOverLink);
        link_areas.push_back(area_of(link));
        link_both.push_back(link.both_ways ? DT_OFFMESH_CON_BIDIR : 0);
        link_ids.push_back(static_cast<unsigned int>(i));
    }
    dtNavMeshCreateParams params;
    std::memset(&params, 0, sizeof params);
    params.verts = polygons->verts;
    params.vertCount = polygons->nverts;
    params.polys = polygons->polys;
    params.polyAreas = polygons->areas;
    params.polyFlags = polygons->flags;
    params.polyCount = polygons->npolys;
    params.nvp = polygons->nvp;
    params.offMeshConVerts = link_ends.data();
    params.offMeshConRad = link_radius.data();
    params.offMeshConFlags = link_flags.data();
    params.offMeshConAreas = link_areas.data();
    params.offMeshConDir = link_both.data();
    params.offMeshConUserID = link_ids.data();
    params.offMeshConCount = static_cast<int>(link_ids.size());
    params.walkableHeight = static_cast<float>(space.body.height_m);
    params.walkableRadius = 2.0F;  // Detour looks ahead fifty times as far when it straightens a way
    params.walkableClimb = static_cast<float>(space.body.step_up_m);
    std::copy(polygons->bmin, polygons->bmin + 3, params.bmin);
    std::copy(polygons->bmax, polygons->bmax + 3, params.bmax);
    params.cs = polygons->cs;
    params.ch = polygons->ch;
    params.buildBvTree = true;
    unsigned char* data = nullptr;
    int size = 0;
    if (!dtCreateNavMeshData(&params, &data, &size)) return failed();
    parts->mesh.reset(dtAllocNavMesh());
    if (!parts->mesh || dtStatusFailed(parts->mesh->init(data, size, DT_TILE_FREE_DATA))) {
        dtFree(data);
        return failed();
    }
    parts->query.reset(dtAllocNavMeshQuery());
    if (!parts->query || dtStatusFailed(parts->query->init(parts->mesh.get(), 65'535))) return failed();
    parts->polygons = polygons->npolys;
    parts->bytes = static_cast<std::size_t>(size);
    return NavMesh(std::move(parts));
}

std::optional<MeshPath> NavMesh::path(std::uint32_t from, std::uint32_t to, RouteWish wish, bool over_links) {
    Parts& p = *parts_;
    dtQueryFilter filter;
    for (const unsigned char area : {kOpen, kNearWall, kNearEdge, kWading, kDropArea, kLiftArea, kTeleportArea})
        filter.setAreaCost(area, cost_of_area(area, wish));
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

    // Straightened from link to link: on the way as a whole, links above each other look like one place from above, and
    // all but one of them would be lost.
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

}  // namespace handrail
