#include "worlds/readers/map_meaning.h"

#include "worlds/base/text.h"
#include "worlds/readers/map_words.h"
#include "worlds/readers/spoken_text.h"

namespace handrail::readers {
namespace {

constexpr double kMostFlowMPerS = 0.5;
constexpr NumberKey kViscosity{"viscosity", 0.0, 100.0, "map.range_viscosity"};
constexpr NumberKey kBuoyancy{"buoyancy", 0.0, 1.0, "map.range_newtons"};
constexpr NumberKey kEdgeRounding{"edge_rounding", 0.0, 5.0, "map.range_millimetres"};
constexpr NumberKey kFilm{"film", 0.0, 0.5, "map.range_newtons"};

}  // namespace

MapMeaning MapMeanings::read(const MapEntity& entity, const std::string& class_name, int index) {
    MapMeaning meaning;
    meaning.source = {entity.place.line, index};
    Feature& feature = meaning.feature;
    feature.kind = FeatureKind::Object;
    feature.source = meaning.source;
    const bool world = class_name == "worldspawn";
    if (!world) {
        feature.name = text_of(entity, "name");
        feature.name_in = texts_in(entity, "name");
        feature.message = text_of(entity, "message");
        feature.message_in = texts_in(entity, "message");
        feature.landmark = keys_.yes_no_of(entity, "landmark");
        feature.clue = keys_.yes_no_of(entity, "clue");
        feature.hinge = keys_.side_of(entity, "hinge");
        feature.handle = keys_.side_of(entity, "handle");
    }
    // The entity is the end of the map: the person may look for it, and its message is announced there.
    if (class_name == "trigger_changelevel") {
        feature.landmark = true;
        if (feature.message.empty()) {
            feature.message = "exit.reached";
            feature.made_message = true;
        }
    }
    meaning.structure =
        world || (is_structure(class_name) && feature.name.empty() && !feature.landmark && !feature.clue);
    if (const ClassRow* row = class_row(class_name)) {
        meaning.role = row->role;
        feature.kind = row->kind;
        if (feature.name.empty()) give_name(feature, row->name);
    }
    const std::string cs_name = world ? std::string{} : lower_ascii(entity.value("cs_name").substr(0, 256));
    const bool dynamic = cs_name == "dynamic_box" || cs_name == "dynamic_sphere" || cs_name == "dynamic_cylinder";
    const bool still = meaning.role == SolidRole::Solid && !world;
    if (cs_name == "liquid") {
        meaning.structure = false;
        meaning.liquid = true;
        meaning.role = SolidRole::Liquid;
        feature.kind = FeatureKind::Liquid;
        if (feature.name.empty()) give_name(feature, "liquid");
    } else if (dynamic) {
        meaning.structure = false;
        meaning.role = SolidRole::Mover;
        meaning.exact = cs_name == "dynamic_box"      ? PrimitiveKind::Box
                        : cs_name == "dynamic_sphere" ? PrimitiveKind::Sphere
                                                      : PrimitiveKind::Cylinder;
        if (feature.name.empty())
            give_name(feature, cs_name == "dynamic_box" ? "box" : cs_name == "dynamic_sphere" ? "ball" : "cylinder");
    } else if (feature.name.empty() && !cs_name.empty()) {
        feature.name = words_of_name(entity.value("cs_name"));
    }
    if (const std::optional<PrimitiveKind> exact = shape_of(entity, world, meaning)) {
        meaning.structure = false;
        meaning.exact = exact;
        if (feature.name.empty())
            give_name(feature,
                      *exact == PrimitiveKind::Sphere ? "ball" : kPrimitiveNames[static_cast<std::size_t>(*exact)]);
    }
    meaning.viscosity_ns_per_m = keys_.number_of(entity, kViscosity);
    meaning.soft = soft_options_of(entity, units_, diagnostics_);
    if (const auto rounding_mm = keys_.number_of(entity, kEdgeRounding))
        meaning.edge_rounding_hand_m = *rounding_mm * 1e-3;
    meaning.buoyancy_n = keys_.number_of(entity, kBuoyancy).value_or(0.0);
    meaning.film_n = keys_.number_of(entity, kFilm).value_or(0.0);
    if (const std::optional<Vec3> flow = keys_.vector_of(entity, "flow", "map.then_still")) {
        meaning.flow_hand_m_per_s = *flow;
        if (const double speed = glm::length(*flow); speed > kMostFlowMPerS) {
            meaning.flow_hand_m_per_s *= kMostFlowMPerS / speed;
            diagnostics_.warn(entity.find("flow")->place, "map.then_slower", "map.fast_flow",
                              {{"speed", speed}, {"most", kMostFlowMPerS}});
        }
        if (meaning.viscosity_ns_per_m.value_or(0.0) <= 0.0)
            diagnostics_.warn(entity.find("flow")->place, "map.then_unfelt", "map.thin_flow");
    }
    meaning.surface = surfaces_.read(entity);
    meaning.look = look_of_surface(meaning.surface);
    meaning.body =
        body_options_of(entity, dynamic, (dynamic || still) && !meaning.liquid, meaning.surface, keys_, diagnostics_);
    if (meaning.body) {
        meaning.structure = false;
        meaning.role = SolidRole::Mover;
        if (feature.name.empty()) give_name(feature, "box");
    }
    if (const MapKey* key = entity.find("material")) {
        if (const MaterialSpec* spec = find_material(trimmed(key->value).substr(0, 64))) {
            meaning.surface.name = spec->name;
        } else {
            std::vector<std::string> names;
            for (const MaterialSpec& row : material_library()) names.emplace_back(row.name);
            diagnostics_.warn(
                key->place, "map.then_default", "map.no_material",
                {{"value", excerpt(key->value)}, {"nearest", nearest_name(key->value.substr(0, 64), names)}});
        }
    }
    return meaning;
}

// Returns the exact shape that the key `shape` requests. Empty if it requests none.
std::optional<PrimitiveKind> MapMeanings::shape_of(const MapEntity& entity, bool world, const MapMeaning& meaning) {
    const MapKey* key = entity.find("shape");
    if (!key) return std::nullopt;
    const std::string value = lower_ascii(trimmed(key->value).substr(0, 32));
    if (world) {
        diagnostics_.warn(key->place, "map.then_left_out", "map.shape_on_building");
        return std::nullopt;
    }
    if (meaning.role != SolidRole::Solid && meaning.role != SolidRole::Mover) {
        diagnostics_.warn(key->place, "map.then_left_out", "map.shape_untouchable");
        return std::nullopt;
    }
    for (std::size_t kind = 0; kind < kPrimitiveNames.size(); ++kind)
        if (value == kPrimitiveNames[kind]) return static_cast<PrimitiveKind>(kind);
    const std::vector<std::string> names(kPrimitiveNames.begin(), kPrimitiveNames.end());
    diagnostics_.warn(key->place, "map.then_brushes", "map.no_shape",
                      {{"value", excerpt(key->value)}, {"nearest", nearest_name(value, names)}});
    return std::nullopt;
}

}  // namespace handrail::readers
