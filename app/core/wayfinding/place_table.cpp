#include "app/core/wayfinding/place_table.h"

#include <algorithm>
#include <array>
#include <memory>
#include <tuple>

#include "app/core/context/context_words.h"
#include "app/core/wayfinding/find_list.h"
#include "app/core/whereabouts/room_things.h"
#include "app/core/world/body_heights.h"
#include "app/core/world/surroundings.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"
#include "worlds/navigation/foot_distances.h"

namespace handrail::core {
namespace {

constexpr std::size_t kMostLines = 300;  // lines of a table that is announced as a whole
constexpr std::array<const char*, kPlaceOrders> kOrders{"places.by_distance", "places.by_name", "places.by_room",
                                                        "places.by_kind"};
constexpr std::array kKindWords{"places.room", "places.door",  "places.landmark",
                                "places.clue", "places.thing", "places.mark"};

PlaceKind kind_of(const SessionContext& context, const Goal& goal) {
    const Feature* feature = context.world.scene->find(goal.feature);
    if (!feature) return PlaceKind::Mark;
    if (feature->landmark) return PlaceKind::Landmark;
    if (feature->clue) return PlaceKind::Clue;
    return feature->kind == FeatureKind::Door ? PlaceKind::Door : PlaceKind::Thing;
}

std::string words_of(const SessionContext& context, const PlaceRow& row) {
    const std::string kind = phrase(kKindWords[static_cast<std::size_t>(row.kind)]);
    return joined(joined(kind, row.room), distance_words(row.far_m, distances(context)));
}

void announce_table(const SessionContext& context, const Rooms& rooms, PlaceOrder order) {
    const std::vector<PlaceRow> rows = place_table(context, rooms, order);
    const std::size_t lines = std::min(rows.size(), kMostLines);
    for (std::size_t i = 0; i < lines; ++i)
        context.say(place_line(context, rows[i]), cues::SpeechClass::Answer, context.tick_s);
    if (rows.size() > lines)
        context.say(phrase("places.more", {{"more", rows.size() - lines}}), cues::SpeechClass::Answer, context.tick_s);
}

}  // namespace

std::vector<PlaceRow> place_table(const SessionContext& context, const Rooms& rooms, PlaceOrder order) {
    const navigation::RoomGraph& graph = rooms.graph();
    const Vec3& feet_m = context.avatar.feet_m();
    const Vec3 waist_m = feet_m + Vec3(0.0, 0.0, kWaist_m);
    std::vector<PlaceRow> rows;
    const navigation::FootDistances on_foot(graph, rooms.here(), feet_m);
    for (std::uint32_t r = 0; r < graph.rooms.size(); ++r) {
        const navigation::Room& room = graph.rooms[r];
        if (room.kind == navigation::RoomKind::Niche) continue;
        const double straight_m = r == rooms.here() ? 0.0 : glm::length(room.middle_m - feet_m);
        const double far_m = r == rooms.here() ? 0.0 : on_foot.to(r, room.middle_m).value_or(straight_m);
        const std::string name = sentence_case(room.name);
        rows.push_back({name, PlaceKind::Room, {}, far_m, {name, point_box(room.middle_m), kNoFeature}, r});
    }
    for (const FindGroup& group : find_groups(context, rooms, FindKind::Everything))
        for (const Found& found : group.found) {
            const double straight_m = glm::length(nearest_place(found.goal.box_m, waist_m) - waist_m);
            const std::uint32_t in = found.room != navigation::kNothing ? found.room : room_of(rooms, found.goal.box_m);
            const std::string room = in == navigation::kNothing ? std::string() : sentence_case(graph.rooms[in].name);
            rows.push_back({found.goal.name, kind_of(context, found.goal), room, found.on_foot_m.value_or(straight_m),
                            found.goal, navigation::kNothing});
        }
    const auto before = [order](const PlaceRow& a, const PlaceRow& b) {
        const auto key = [order](const PlaceRow& row) {
            return std::tuple(order == PlaceOrder::Kind ? static_cast<int>(row.kind) : 0,
                              order == PlaceOrder::Name   ? lower_ascii(row.name)
                              : order == PlaceOrder::Room ? lower_ascii(row.room)
                                                          : std::string(),
                              row.far_m);
        };
        return key(a) < key(b);
    };
    std::stable_sort(rows.begin(), rows.end(), before);
    return rows;
}

std::string place_line(const SessionContext& context, const PlaceRow& row) {
    return phrase("places.line", {{"name", row.name}, {"what", words_of(context, row)}});
}

void open_places(const SessionContext& context, const Rooms& rooms,
                 std::function<void(const PlaceRow& row, double now_s)> chosen, double now_s) {
    const auto rows = std::make_shared<const std::vector<PlaceRow>>(place_table(context, rooms, PlaceOrder::Distance));
    ListSpec list;
    list.title = phrase("places.title");
    for (const PlaceRow& row : *rows) list.items.push_back({row.name, words_of(context, row), false});
    for (const char* order : kOrders) list.hidden.push_back({phrase(order), {}, false});
    list.chosen = [&context, &rooms, rows, chosen = std::move(chosen)](std::size_t i) {
        if (i < rows->size()) return chosen((*rows)[i], context.tick_s);
        if (rooms.found()) announce_table(context, rooms, static_cast<PlaceOrder>(i - rows->size()));
    };
    context.open_list(std::move(list), now_s);
}

}  // namespace handrail::core
