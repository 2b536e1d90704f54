#include "app/core/whereabouts/over_under.h"

#include <algorithm>
#include <cmath>

#include "app/core/dialogue/words.h"
#include "worlds/base/contract.h"
#include "worlds/base/language.h"

namespace handrail::core {
namespace {

constexpr double kLeastRise_m = 1.8;  // floors nearer than this are not above each other
constexpr double kLeastShare = 0.05;  // a room over a smaller share of the floor is not named
constexpr int kMostSamples = 20;      // samples of a floor in each direction
constexpr double kLeastSample_m = 0.25;
constexpr std::size_t kMostNames = 6;

// Returns the next room straight over the place, or kNothing. The place may be in the room `except`, which is skipped.
std::uint32_t room_over(const Rooms& rooms, const Vec3& at_m, std::uint32_t except, int by) {
    const navigation::RoomGraph& graph = rooms.graph();
    std::uint32_t next = navigation::kNothing;
    double next_m = 0.0;
    for (std::uint32_t r = 0; r < graph.rooms.size(); ++r) {
        const Aabb& box = graph.rooms[r].bounds_m;
        const double rise_m = by * (graph.rooms[r].floor_m - at_m.z);
        if (r == except || rise_m < kLeastRise_m || (next != navigation::kNothing && rise_m >= next_m)) continue;
        if (at_m.x < box.min_m.x || at_m.x > box.max_m.x || at_m.y < box.min_m.y || at_m.y > box.max_m.y) continue;
        if (navigation::room_at(graph, rooms.space(), {at_m.x, at_m.y, graph.rooms[r].floor_m}) != r) continue;
        next = r;
        next_m = rise_m;
    }
    return next;
}

}  // namespace

std::vector<std::uint32_t> rooms_over(const Rooms& rooms, std::uint32_t room, int by) {
    const navigation::RoomGraph& graph = rooms.graph();
    contract_pre(room < graph.rooms.size());
    const Aabb& box = graph.rooms[room].bounds_m;
    const auto samples = [](double size_m) {
        return std::clamp(static_cast<int>(std::ceil(size_m / kLeastSample_m)), 1, kMostSamples);
    };
    const Vec3 size_m = box.size_m();
    const int wide = samples(size_m.x), deep = samples(size_m.y);
    std::vector<int> over(graph.rooms.size(), 0);
    int all = 0;
    for (int y = 0; y < deep; ++y)
        for (int x = 0; x < wide; ++x) {
            const Vec3 at_m(box.min_m.x + (x + 0.5) * size_m.x / wide, box.min_m.y + (y + 0.5) * size_m.y / deep,
                            graph.rooms[room].floor_m);
            if (navigation::room_at(graph, rooms.space(), at_m) != room) continue;
            ++all;
            if (const std::uint32_t next = room_over(rooms, at_m, room, by); next != navigation::kNothing) ++over[next];
        }
    std::vector<std::uint32_t> found;
    for (std::uint32_t r = 0; r < over.size(); ++r)
        if (over[r] > 0 && over[r] >= kLeastShare * all) found.push_back(r);
    std::stable_sort(found.begin(), found.end(), [&](std::uint32_t a, std::uint32_t b) { return over[a] > over[b]; });
    return found;
}

std::string over_person_words(const SessionContext& context, const Rooms& rooms, int by) {
    const std::uint32_t next = room_over(rooms, context.avatar.feet_m(), rooms.here(), by);
    const char* above = by > 0 ? "yes" : "no";
    if (next == navigation::kNothing) return phrase("answer.no_room_over", {{"above", above}});
    return phrase("answer.room_over", {{"above", above}, {"room", rooms.graph().rooms[next].name}});
}

std::string over_room_words(const Rooms& rooms, std::uint32_t room, int by) {
    const navigation::RoomGraph& graph = rooms.graph();
    const std::vector<std::uint32_t> over = rooms_over(rooms, room, by);
    const char* above = by > 0 ? "yes" : "no";
    const std::string& name = graph.rooms[room].name;
    if (over.empty()) return phrase("answer.no_room_over_room", {{"above", above}, {"room", name}});
    std::string names;
    const std::size_t first = std::min(kMostNames, over.size());
    for (std::size_t i = 0; i < first; ++i) names = joined(names, graph.rooms[over[i]].name);
    if (over.size() > first) names = phrase("overview.and_more", {{"names", names}, {"more", over.size() - first}});
    return phrase("answer.room_over_room", {{"above", above}, {"room", name}, {"names", names}});
}

}  // namespace handrail::core
