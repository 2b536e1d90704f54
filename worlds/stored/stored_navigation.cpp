#include "worlds/stored/stored_navigation.h"

#include <zlib.h>

#include <algorithm>
#include <array>

#include "worlds/cache/sha256.h"
#include "worlds/navigation/validate_ways.h"
#include "worlds/stored/stored_basics.h"

namespace handrail::stored {

template <>
inline constexpr int kLastOf<navigation::PassageKind> = static_cast<int>(navigation::PassageKind::Climb);
template <>
inline constexpr int kLastOf<navigation::RoomKind> = static_cast<int>(navigation::RoomKind::Niche);
template <>
inline constexpr int kLastOf<navigation::RoomLook> = static_cast<int>(navigation::RoomLook::Hall);

template <class A, Is<navigation::WalkerMeasures> T>
void fields(A& a, T& v) {
    auto& [radius, height, step_up, most_drop, cell] = v;
    a(radius, height, step_up, most_drop, cell);
}
template <class A, Is<navigation::WalkLink> T>
void fields(A& a, T& v) {
    auto& [kind, from, to, both_ways, feature] = v;
    a(kind, from, to, both_ways, feature);
}
template <class A, Is<navigation::MadeRoomName> T>
void fields(A& a, T& v) {
    auto& [thing, thing_made, thing_in, with_thing, look, wide, deep, side, level, levels, storey] = v;
    a(thing, thing_made, thing_in, with_thing, look, wide, deep, side, level, levels, storey);
}
template <class A, Is<navigation::Room> T>
void fields(A& a, T& v) {
    auto& [kind, name, given, map_name, map_name_in, is_way, made, same_name, level, area, floor, bounds, middle] = v;
    a(kind, name, given, map_name, map_name_in, is_way, made, same_name, level, area, floor, bounds, middle);
}
template <class A, Is<navigation::Portal> T>
void fields(A& a, T& v) {
    auto& [kind, rooms, place, width, feature, one_way] = v;
    a(kind, rooms[0], rooms[1], place, width, feature, one_way);
}
template <class A, Is<navigation::RoomGraph> T>
void fields(A& a, T& v) {
    auto& [rooms, portals, room_of_span, language] = v;
    a(rooms, portals, room_of_span, language);
}

namespace {

// Greatest size of the bytes before compression; two million spans need 90 MB.
constexpr std::size_t kMostKept_bytes = std::size_t{512} << 20;
constexpr std::size_t kPacked_bytes = 1 << 18;  // the bytes are compressed in pieces of this size
constexpr std::uint8_t kEdge = 1, kLiquid = 2, kStairs = 4;

// The spans, stored as one column for each kind of value, because this compresses well. A neighbour is stored as its
// position in its column of the walkable space, counted from 1; 0 means that there is no neighbour.
struct SpanColumns {
    std::vector<std::uint8_t> counts;  // number of spans in each cell
    std::vector<float> floors, ceilings, clearances;
    std::vector<std::uint32_t> ground, doors, beside;
    std::array<std::vector<std::uint8_t>, 4> next;
    std::vector<std::uint8_t> flags;
};
template <class A, Is<SpanColumns> T>
void fields(A& a, T& v) {
    auto& [counts, floors, ceilings, clearances, ground, doors, beside, next, flags] = v;
    a(counts, floors, ceilings, clearances, ground, doors, beside, next[0], next[1], next[2], next[3], flags);
}

// Returns the neighbour of a cell to the east (0), north (1), west (2) or south (3); kNothing if it is outside.
std::uint32_t cell_beside(const navigation::WalkSpace& space, std::uint32_t cell, std::size_t way) {
    const std::uint32_t x = cell % space.width, y = cell / space.width;
    if (way == 0) return x + 1 < space.width ? cell + 1 : navigation::kNothing;
    if (way == 1) return y + 1 < space.depth ? cell + space.width : navigation::kNothing;
    if (way == 2) return x > 0 ? cell - 1 : navigation::kNothing;
    return y > 0 ? cell - space.width : navigation::kNothing;
}

std::optional<SpanColumns> columns_of(const navigation::WalkSpace& space) {
    SpanColumns columns;
    const std::size_t cells = static_cast<std::size_t>(space.width) * space.depth, count = space.spans.size();
    columns.counts.reserve(cells);
    for (std::size_t cell = 0; cell < cells; ++cell) {
        const std::uint32_t here = space.first[cell + 1] - space.first[cell];
        if (here > 254) return std::nullopt;
        columns.counts.push_back(static_cast<std::uint8_t>(here));
    }
    for (auto* each : {&columns.floors, &columns.ceilings, &columns.clearances}) each->reserve(count);
    for (auto* each : {&columns.ground, &columns.doors, &columns.beside}) each->reserve(count);
    for (auto& each : columns.next) each.reserve(count);
    columns.flags.reserve(count);
    for (const navigation::WalkSpan& span : space.spans) {
        const auto& [floor, ceiling, cell, next, ground, door, clearance, beside, near_edge, liquid, stairs] = span;
        columns.floors.push_back(floor);
        columns.ceilings.push_back(ceiling);
        columns.clearances.push_back(clearance);
        columns.ground.push_back(ground);
        columns.doors.push_back(door);
        columns.beside.push_back(beside);
        columns.flags.push_back(
            static_cast<std::uint8_t>((near_edge ? kEdge : 0) | (liquid ? kLiquid : 0) | (stairs ? kStairs : 0)));
        for (std::size_t way = 0; way < 4; ++way) {
            if (next[way] == navigation::kNothing) {
                columns.next[way].push_back(0);
                continue;
            }
            const std::uint32_t there = cell_beside(space, cell, way);
            if (there == navigation::kNothing || next[way] < space.first[there] || next[way] >= space.first[there + 1])
                return std::nullopt;
            columns.next[way].push_back(static_cast<std::uint8_t>(next[way] - space.first[there] + 1));
        }
    }
    return columns;
}

// Copies the columns into `space`. Returns false if they do not match its width and depth.
bool put(const SpanColumns& columns, navigation::WalkSpace& space) {
    const std::size_t cells = static_cast<std::size_t>(space.width) * space.depth, count = columns.floors.size();
    if (columns.counts.size() != cells) return false;
    for (const auto* each : {&columns.ceilings, &columns.clearances})
        if (each->size() != count) return false;
    for (const auto* each : {&columns.ground, &columns.doors, &columns.beside})
        if (each->size() != count) return false;
    for (const auto* each : {&columns.next[0], &columns.next[1], &columns.next[2], &columns.next[3], &columns.flags})
        if (each->size() != count) return false;
    space.first.resize(cells + 1);
    std::uint32_t sum = 0;
    for (std::size_t cell = 0; cell < cells; ++cell) {
        space.first[cell] = sum;
        sum += columns.counts[cell];
    }
    space.first[cells] = sum;
    if (sum != count) return false;
    space.spans.resize(count);
    for (std::uint32_t cell = 0; cell < cells; ++cell)
        for (std::uint32_t s = space.first[cell]; s < space.first[cell + 1]; ++s) {
            navigation::WalkSpan& span = space.spans[s];
            span.floor_m = columns.floors[s];
            span.ceiling_m = columns.ceilings[s];
            span.cell = cell;
            span.ground = columns.ground[s];
            span.door = columns.doors[s];
            span.clearance_m = columns.clearances[s];
            span.beside = columns.beside[s];
            span.near_edge = (columns.flags[s] & kEdge) != 0;
            span.liquid = (columns.flags[s] & kLiquid) != 0;
            span.stairs = (columns.flags[s] & kStairs) != 0;
            for (std::size_t way = 0; way < 4; ++way) {
                const std::uint8_t place = columns.next[way][s];
                if (place == 0) continue;
                const std::uint32_t there = cell_beside(space, cell, way);
                if (there == navigation::kNothing || place > columns.counts[there]) return false;
                span.next[way] = space.first[there] + place - 1;
            }
        }
    return true;
}

// Compresses the bytes. Empty after a stop request.
std::string deflated(std::string_view bytes, const std::stop_token& stop) {
    z_stream stream{};
    if (::deflateInit(&stream, 1) != Z_OK) return {};
    std::string packed;
    std::vector<Bytef> piece(kPacked_bytes);
    int end = Z_OK;
    while (end == Z_OK && !stop.stop_requested()) {
        if (stream.avail_in == 0) {
            const std::size_t size = std::min(bytes.size(), kPacked_bytes);
            stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
            stream.avail_in = static_cast<uInt>(size);
            bytes.remove_prefix(size);
        }
        stream.next_out = piece.data();
        stream.avail_out = static_cast<uInt>(piece.size());
        end = ::deflate(&stream, bytes.empty() ? Z_FINISH : Z_NO_FLUSH);
        packed.append(reinterpret_cast<const char*>(piece.data()), piece.size() - stream.avail_out);
    }
    ::deflateEnd(&stream);
    return end == Z_STREAM_END ? packed : std::string();
}

bool inflate_into(std::string& bytes, std::string_view packed) {
    auto size = static_cast<uLongf>(bytes.size());
    return ::uncompress(reinterpret_cast<Bytef*>(bytes.data()), &size, reinterpret_cast<const Bytef*>(packed.data()),
                        static_cast<uLong>(packed.size())) == Z_OK &&
           size == bytes.size();
}

template <class A, Is<navigation::WalkSpace> T>
void all_but_spans(A& a, T& space) {
    a(space.origin_m, space.cell_m, space.width, space.depth, space.body, space.links, space.obstacle_features,
      space.outdoors_m, space.part);
}

// Packs the space and the graph without compression. Empty if the space must not be kept.
std::string plain_navigation(const navigation::WalkSpace& space, const navigation::RoomGraph& graph) {
    const std::optional<SpanColumns> columns = columns_of(space);
    if (!columns || graph.room_of_span.size() != space.spans.size()) return {};
    Packer all;
    all_but_spans(all, space);
    all(*columns, graph);
    return all.take();
}

// Reads the space and the graph, and makes all checks that do not need the scene.
std::optional<FoundNavigation> whole_navigation(std::string_view plain) {
    Unpacker all(plain);
    FoundNavigation found;
    SpanColumns columns;
    all_but_spans(all, found.space);
    all(columns, found.graph);
    if (!all.good() || !all.rest().empty() || !put(columns, found.space)) return std::nullopt;
    if (!navigation::validate(found.space) || !navigation::validate(found.graph, found.space)) return std::nullopt;
    return found;
}

// Makes the checks that need the scene, and checks that the space can belong to a walker of this size.
bool belong_to(const Scene& scene, const navigation::WalkerMeasures& requested, const navigation::WalkSpace& space,
               const navigation::RoomGraph& graph) {
    const auto known = [&](FeatureId id) { return !id || id.value < scene.features.size(); };
    navigation::WalkerMeasures body = space.body;
    if (space.cell_m != body.cell_m || !(body.cell_m >= requested.cell_m) || !(body.cell_m <= 1.0)) return false;
    body.cell_m = requested.cell_m;
    return body == requested && std::all_of(space.obstacle_features.begin(), space.obstacle_features.end(), known) &&
           std::all_of(space.links.begin(), space.links.end(),
                       [&](const navigation::WalkLink& link) { return known(link.feature); }) &&
           std::all_of(space.spans.begin(), space.spans.end(),
                       [&](const navigation::WalkSpan& span) {
                           return span.door == navigation::kNothing || span.door < scene.movers.size();
                       }) &&
           std::all_of(graph.portals.begin(), graph.portals.end(),
                       [&](const navigation::Portal& portal) { return known(portal.feature); }) &&
           std::none_of(graph.rooms.begin(), graph.rooms.end(),
                        [](const navigation::Room& room) { return room.given; });
}

}  // namespace

std::string navigation_key(const Scene& scene, const navigation::WalkerMeasures& body) {
    Packer pack;
    archive::count(pack, kWorldsVersion);
    pack(body);
    cache::Sha256 sum;
    sum.add_counted(pack.take());
    sum.add_counted(sum_of(scene));
    return sum.hex();
}

std::string stored_navigation(const navigation::WalkSpace& space, const navigation::RoomGraph& graph,
                              const std::stop_token& stop) {
    const std::string plain = plain_navigation(space, graph);
    if (plain.empty() || plain.size() > kMostKept_bytes) return {};
    const std::string packed = deflated(plain, stop);
    if (packed.empty()) return {};
    Packer head;
    archive::count(head, plain.size());
    return head.take() + packed;
}

std::string unpacked_navigation(std::string_view packed) {
    Unpacker head(packed);
    const std::uint64_t size = archive::count(head, 0);
    if (!head.good() || size > kMostKept_bytes) return {};
    std::string plain(size, '\0');
    if (!inflate_into(plain, head.rest())) return {};
    const std::optional<FoundNavigation> found = whole_navigation(plain);
    return found ? plain_navigation(found->space, found->graph) : std::string();
}

std::optional<FoundNavigation> navigation_from(std::string_view plain, const navigation::WalkerMeasures& body,
                                               const Scene& scene) {
    std::optional<FoundNavigation> found = whole_navigation(plain);
    if (!found || !belong_to(scene, body, found->space, found->graph)) return std::nullopt;
    found->space.said = navigation::said_of(found->space, body);
    // Makes the names in the language that is spoken now, in which the person may have texts of their own.
    navigation::number_room_names(found->graph);
    return found;
}

bool worth_keeping(const navigation::WalkSpace& space, const Scene& scene) {
    return space.spans.size() >= kLeastKeptSpans || scene.solids.size() + scene.triangles.size() >= kLeastKeptShapes;
}

}  // namespace handrail::stored
