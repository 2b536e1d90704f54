#include "app/main/route_cards.h"

#include <algorithm>
#include <cmath>

#include "app/core/context/context_words.h"
#include "app/core/session/session.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail::program {
namespace {

struct CardPlace {
    std::string name;
    Vec3 at_m{0.0};
    std::optional<double> heading_rad;  // the direction in which a person at this place faces, if it is known
    bool room = false;
};

// Returns everything with a name that can be a destination. Rooms come first, because an object may have the same name
// as its room.
std::vector<CardPlace> places_of(const Scene& scene, const navigation::RoomGraph& graph) {
    std::vector<CardPlace> places;
    for (const navigation::Room& room : graph.rooms) places.push_back({room.name, room.middle_m, std::nullopt, true});
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

// A session with a simulated person, who stands at the start of a route and requests directions.
class AtStart {
public:
    AtStart(const std::shared_ptr<const Scene>& scene, const settings::Settings& settings)
        : session_(settings, core::HandFacts{}) {
        session_.apply(core::WorldEntered{core::make_ready(scene)}, now_s_);
    }

    std::vector<std::string> legs(const Vec3& from_m, double heading_rad, const CardPlace& to) {
        session_.apply(core::Placed{from_m, heading_rad}, now_s_);
        // Tick the session until the walker stands on the floor.
        for (int i = 0; i < 30 && (i < 2 || !session_.avatar().walker->state().on_ground); ++i)
            session_.tick(now_s_ += core::kFrame_s, servo::ToolState{});
        const bool leads = session_.guide().follow_to(to.at_m, to.name, to.room, now_s_);
        for (int i = 0; i < 10 && leads && session_.guide().plans_rest(); ++i)
            session_.tick(now_s_ += core::kFrame_s, servo::ToolState{});
        std::vector<std::string> legs = session_.guide().take_legs();
        if (!leads) legs.clear();
        session_.take_cues();
        session_.take_events();
        return legs;
    }

private:
    core::Session session_;
    double now_s_ = 0.0;
};

std::optional<exports::CardRoute> route_between(AtStart& at_start, navigation::Navigation& navigation,
                                                const CardPlace& from, const CardPlace& to) {
    const Vec3 start_m = navigation.nearest_place(from.at_m).value_or(from.at_m);
    double heading_rad = from.heading_rad.value_or(0.0);
    if (!from.heading_rad) {
        const navigation::Route route = navigation.plan(start_m, to.at_m);
        if (route.points_m.size() >= 2) {
            const Vec3 first = route.points_m[1] - route.points_m[0];
            heading_rad = std::atan2(first.x, first.y);
        }
    }
    heading_rad = navigation::notch_heading_rad(
        navigation::nearest_notch(heading_rad));  // Round to a direction that the card has a word for.
    const std::vector<std::string> legs = at_start.legs(start_m, heading_rad, to);
    if (legs.empty()) return std::nullopt;
    exports::CardRoute way{phrase("export.card_title", {{"from", from.name}, {"to", to.name}}),
                           phrase("export.card_face", {{"direction", core::fine_compass_word(heading_rad)}})};
    way.insert(way.end(), legs.begin(), legs.end());
    return way;
}

}  // namespace

Result<CardRoutes> card_routes(const std::shared_ptr<const Scene>& scene, const navigation::RoomGraph& graph,
                               navigation::Navigation& navigation, const plan::Storey& storey,
                               const CardOptions& options) {
    const std::vector<CardPlace> places = places_of(*scene, graph);
    const Result<CardPlace> from = options.from ? place_named(places, *options.from) : base_of(*scene);
    if (!from) return tl::unexpected(from.error());
    const std::uint32_t begins_in =
        navigation::room_at(graph, navigation.space(), navigation.nearest_place(from->at_m).value_or(from->at_m));
    std::vector<CardPlace> goals;
    if (options.to) {
        const Result<CardPlace> to = place_named(places, *options.to);
        if (!to) return tl::unexpected(to.error());
        if (to->room && begins_in != navigation::kNothing &&
            navigation::room_at(graph, navigation.space(), to->at_m) == begins_in)
            return fail(phrase("export.begins_there", {{"room", to->name}}));
        goals.push_back(*to);
    } else {
        for (const plan::StoreyRoom& room : storey.rooms)
            if (room.room != begins_in)
                goals.push_back({room.name, graph.rooms[room.room].middle_m, std::nullopt, true});
        std::sort(goals.begin(), goals.end(), [](const CardPlace& a, const CardPlace& b) { return a.name < b.name; });
    }
    AtStart at_start(scene, options.settings);
    CardRoutes made;
    for (const CardPlace& to : goals) {
        if (auto way = route_between(at_start, navigation, *from, to)) made.ways.push_back(std::move(*way));
        else made.unreached.push_back(to.name);
    }
    if (made.ways.empty())
        return fail(phrase("export.no_way", {{"from", from->name}, {"to", options.to ? goals[0].name : storey.world}}));
    return made;
}

}  // namespace handrail::program
