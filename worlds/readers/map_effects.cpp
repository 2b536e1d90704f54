#include "worlds/readers/map_effects.h"

#include <algorithm>
#include <array>

#include "worlds/base/text.h"
#include "worlds/scene/scene.h"

namespace handrail::readers {
namespace {

constexpr std::array<std::string_view, 4> kPulls{"point", "line", "surface", "object"};

// Reads one entity. If the entity is refused, the reader reports the reason and stops.
class EffectReader {
public:
    EffectReader(const MapEntity& entity, std::string name, double units, Diagnostics& diagnostics)
        : entity_(entity),
          name_(std::move(name)),
          units_(units),
          diagnostics_(diagnostics),
          keys_(diagnostics, units) {}

    bool read(Effect& effect) {
        const MapKey* kind = entity_.find("effect");
        if (!kind) return refuse(entity_.place, "map.effect_which");
        const std::string word = lower_ascii(trimmed(kind->value).substr(0, 64));
        const EffectSpec* spec = find_effect(word == "flypaper" ? "fly-paper" : word);
        if (!spec) {
            std::vector<std::string> names;
            for (const EffectSpec& row : effect_table()) names.emplace_back(row.name);
            diagnostics_.warn(kind->place, "map.then_left_out", "map.no_effect",
                              {{"value", excerpt(kind->value)}, {"nearest", nearest_name(word, names)}});
            return false;
        }
        effect.kind = spec->kind;
        effect.name = name_.empty() ? phrase("effect_name." + std::string(spec->name)) : name_;
        name_ = effect.name;
        effect.strength_n = spec->strength_n;
        effect.width_hand_m = spec->width_hand_m;
        effect.edge_hand_m = spec->edge_hand_m;
        if (spec->most_n > 0.0)
            effect.strength_n = keys_.number_of(entity_, "strength", spec->least_n, spec->most_n, "map.range_newtons")
                                    .value_or(effect.strength_n);
        if (spec->most_hand_m > 0.0) {
            if (!has_size("width", "map.effect_no_width")) return false;
            effect.width_hand_m =
                keys_.number_of(entity_, "width", spec->least_hand_m, spec->most_hand_m, "map.range_hand_metres")
                    .value_or(effect.width_hand_m);
        }
        effect.edge_hand_m =
            keys_.number_of(entity_, "edge", kLeastEdge_hand_m, kMostEdge_hand_m, "map.range_hand_metres")
                .value_or(effect.edge_hand_m);
        effect.frequency_hz =
            keys_.number_of(entity_, "frequency", kLeastVibration_hz, kMostVibration_hz, "map.range_hertz")
                .value_or(effect.frequency_hz);
        effect.mass_kg = keys_.number_of(entity_, "mass", kLeastMass_kg, kMostMass_kg, "map.range_kilograms")
                             .value_or(effect.mass_kg);
        if (const std::optional<Vec3> direction = keys_.vector_of(entity_, "direction", "map.then_up")) {
            const double length = glm::length(*direction);
            if (length > 0.0) effect.direction = *direction / length;
            else
                diagnostics_.warn(entity_.find("direction")->place, "map.then_up", "map.effect_direction",
                                  {{"name", name_}});
        }
        if (const MapKey* pull = entity_.find("pull")) {
            const std::string value = lower_ascii(trimmed(pull->value).substr(0, 32));
            const auto found = std::find(kPulls.begin(), kPulls.end(), value);
            if (found != kPulls.end()) {
                effect.pull = static_cast<MagnetPull>(found - kPulls.begin());
            } else {
                diagnostics_.warn(pull->place, "map.then_point", "map.effect_pull", {{"value", excerpt(pull->value)}});
            }
        }
        return true;
    }

    // Reads an effect without brushes: a sphere around its origin, or a capsule from its origin to its `end`.
    bool read_round(Effect& effect) {
        const std::optional<Vec3> origin = keys_.vector_of(entity_, "origin");
        if (!origin) {
            if (!entity_.find("origin")) refuse(entity_.place, "map.effect_nowhere");
            return false;
        }
        if (!entity_.find("radius")) return refuse(entity_.place, "map.effect_point");
        if (!has_size("radius", "map.effect_no_radius")) return false;
        const std::optional<double> radius =
            keys_.number_of(entity_, "radius", 0.0, kFarthestM / units_, "map.range_length");
        if (!radius) return false;
        const std::optional<Vec3> end = keys_.vector_of(entity_, "end", "map.then_ball");
        if (end && *end != *origin) effect.where = EffectCapsule{*origin * units_, *end * units_, *radius * units_};
        else effect.where = EffectBall{*origin * units_, *radius * units_};
        return true;
    }

    // Reports why the effect is left out. `why` is the key of a sentence about the effect {name}; {named} is "yes" if
    // the effect has a name, else "no". Always returns false.
    bool refuse(TextPlace place, std::string_view why) {
        diagnostics_.warn(place, "map.then_left_out", why, {{"name", name_}, {"named", name_.empty() ? "no" : "yes"}});
        return false;
    }

private:
    // Returns false, with a warning, if the value of `key` is a number that is zero or less.
    bool has_size(std::string_view key, std::string_view lack) {
        double value = 1.0;
        const MapKey* found = entity_.find(key);
        if (!found || !parse_finite(trimmed(found->value), value) || value > 0.0) return true;
        return refuse(found->place, lack);
    }

    const MapEntity& entity_;
    std::string name_;
    double units_;
    Diagnostics& diagnostics_;
    MapKeys keys_;
};

}  // namespace

std::vector<ReadEffect> read_effects(const MapEntity& entity, int index, const std::string& name,
                                     double metres_per_unit, const std::function<BuiltSolid(const MapBrush&)>& built,
                                     Diagnostics& diagnostics) {
    std::vector<ReadEffect> effects;
    EffectReader reader(entity, name, metres_per_unit, diagnostics);
    ReadEffect one;
    if (!reader.read(one.effect)) return effects;
    one.effect.source = {entity.place.line, index};
    if (const MapKey* target = entity.find("target")) {
        one.target = lower_ascii(trimmed(target->value).substr(0, 256));
        one.target_place = target->place;
    }
    if (entity.brushes.empty()) {
        if (reader.read_round(one.effect)) effects.push_back(std::move(one));
        return effects;
    }
    for (const MapBrush& brush : entity.brushes) {
        BuiltSolid solid = built(brush);
        if (solid.fault != SolidFault::None) {
            if (solid.fault == SolidFault::Open) reader.refuse(brush.place, "map.effect_open");
            else reader.refuse(brush.place, "map.effect_no_volume");
            continue;
        }
        one.effect.where = std::move(solid.solid);
        effects.push_back(one);
    }
    return effects;
}

void attach_effects(std::vector<ReadEffect>& effects, Scene& scene, Diagnostics& diagnostics) {
    for (ReadEffect& read : effects) {
        Effect& effect = read.effect;
        if (!read.target.empty()) {
            std::vector<std::string> names;
            for (std::uint32_t i = 0; i < scene.features.size() && !effect.belongs_to; ++i) {
                const Feature& feature = scene.features[i];
                if (lower_ascii(feature.name) == read.target) effect.belongs_to = {i};
                else if (names.size() < 1000) names.push_back(feature.name);
            }
            if (!effect.belongs_to)
                diagnostics.warn(read.target_place, "map.then_stays", "map.effect_target",
                                 {{"name", effect.name},
                                  {"target", excerpt(read.target)},
                                  {"nearest", nearest_name(read.target, names)}});
        }
        if (effect.pull == MagnetPull::Object && !effect.belongs_to) {
            if (read.target.empty())
                diagnostics.warn({effect.source.line, 0}, "map.then_point", "map.effect_no_target",
                                 {{"name", effect.name}});
            effect.pull = MagnetPull::Point;
        }
        scene.effects.push_back(std::move(effect));
    }
}

}  // namespace handrail::readers
