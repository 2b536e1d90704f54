#include "app/main/route_cards.h"

#include <algorithm>
#include <cmath>

#include "app/core/context/telling.h"
#include "app/core/wayfinding/route_words.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail {
namespace {

struct CardPlace {
    std::string name;
    Vec3 at_m{0.0};
    std::optional<double> heading_rad;  // of who stands there, where that is known
};

// Everything with a name that one can go to: rooms first, since a thing may be called as its room is.
std::vector<CardPlace> places_of(const Scene& scene, const RoomGraph& graph) {
    std::vector<CardPlace> places;
    for (const Room& room : graph.rooms) places.push_back({room.name, room.middle_m, std::nullopt});
    for (const Start& start : scene.starts)
        if (!start.name.empty()) places.push_back({start.name, start.feet_m, start.heading_rad});
    for (const Feature& feature : scene.features)
        if ((feature.kind == FeatureKind::Object || feature.kind == FeatureKind::Door) && !feature.bounds_m.empty())
            places.push_back({spoken_name(feature), feature.bounds_m.centre_m(), std::nullopt});
    return places;
}

Result<CardPlace> place_named(const std::vector<CardPlace>& places, const std::string& name) {
    std::vector<std::string> names;
    for (const CardPlace& place : places) {
        if (lower_ascii(place.name) == lower_ascii(name)) return place;
        names.push_back(place.name);
    }
    return fail(phrase("export.no_place", {{"name", name}, {"nearest", nearest_name(name, names)}}));
}

Result<CardPlace> base_of(const Scene& scene) {
    const Start* base = nullptr;
    for (const Start& start : scene.starts)
        if (!base || (start.base && !base->base)) base = &start;
    if (!base) return fail(phrase("export.no_base"));
    return CardPlace{phrase("export.the_base"), base->feet_m, base->heading_rad};
}

std::optional<CardWay> way_between(const Scene& scene, Navigation& navigation, const CardPlace& from,
                                   const CardPlace& to, const DistanceWords& how) {
    const Vec3 start_m = navigation.nearest_place(from.at_m).value_or(from.at_m);
    const Route route = navigation.plan(start_m, to.at_m);
    if (!route.reaches) return std::nullopt;
    const Vec3 first = route.points_m.size() < 2 ? Vec3(0.0, 1.0, 0.0) : route.points_m[1] - route.points_m[0];
    const double heading_rad = from.heading_rad.value_or(std::atan2(first.x, first.y));
    CardWay way{phrase("export.card_title", {{"from", from.name}, {"to", to.name}})};
    way.push_back(phrase("export.card_face", {{"direction", fine_compass_word(heading_rad)}}));
    const auto name_of_passage = [&](const RoutePassage& passage) {
        return passage_name(scene, passage.kind, passage.feature, passage.rise_m);
    };
    way.push_back(route_words(route, nodes_of(route, to.name, name_of_passage), heading_rad, how));
    return way;
}

}  // namespace

Result<CardWays> card_ways(const Scene& scene, const RoomGraph& graph, Navigation& navigation, const Storey& storey,
                           const CardWish& wish) {
    const std::vector<CardPlace> places = places_of(scene, graph);
    const Result<CardPlace> from = wish.from ? place_named(places, *wish.from) : base_of(scene);
    if (!from) return tl::unexpected(from.error());
    std::vector<CardPlace> goals;
    if (wish.to) {
        const Result<CardPlace> to = place_named(places, *wish.to);
        if (!to) return tl::unexpected(to.error());
        goals.push_back(*to);
    } else {
        for (const StoreyRoom& room : storey.rooms)
            goals.push_back({room.name, graph.rooms[room.room].middle_m, std::nullopt});
        std::sort(goals.begin(), goals.end(), [](const CardPlace& a, const CardPlace& b) { return a.name < b.name; });
    }
    CardWays made;
    for (const CardPlace& to : goals) {
        if (auto way = way_between(scene, navigation, *from, to, wish.how)) made.ways.push_back(std::move(*way));
        else made.unreached.push_back(to.name);
    }
    if (made.ways.empty())
        return fail(phrase("export.no_way", {{"from", from->name}, {"to", wish.to ? goals[0].name : storey.world}}));
    return made;
}

}  // namespace handrail
