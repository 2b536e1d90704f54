// The meaning of a Quake-family .map: which brushes are solid, move, flow or trigger, what they are made of and what they are called.
#include <map>
#include <set>
#include <tuple>

#include "worlds/base/language.h"
#include "worlds/base/text.h"
#include "worlds/geometry/exposed_surface.h"
#include "worlds/readers/height_picture.h"
#include "worlds/readers/map_effects.h"
#include "worlds/readers/map_keys.h"
#include "worlds/readers/map_movers.h"
#include "worlds/readers/map_soft.h"
#include "worlds/readers/map_syntax.h"
#include "worlds/readers/reader.h"
#include "worlds/readers/spoken_text.h"
#include "worlds/scene/primitive.h"
#include "worlds/scene/surfaces.h"

namespace handrail {
namespace {

constexpr double kFarthestM = 1e6;             // replay and rendering take positions up to here
constexpr double kOriginAboveSolesUnits = 24;  // a player's origin in these maps
constexpr double kMostFriction = 2.0;          // rubber on rubber; more sticks the hand to the wall
constexpr double kMostViscosityNsPerM = 100.0;
constexpr double kMostBuoyancyN = 1.0;
constexpr double kMostFilmN = 0.5;
constexpr double kMostFlowMPerS = 0.5;
constexpr double kMostDampingNsPerM = 10.0;  // more makes a device's own noise heard in the hand
constexpr double kMillimetre = 1e-3;
constexpr double kWaveDepth_mm = 0.4, kPictureDepth_mm = 2.0, kPeriod_mm = 10.0;  // where a map gives none

// What the class of an entity makes of its brushes. The first row that fits counts; a name ending in * fits as a beginning.
struct ClassRow {
    std::string_view class_name;
    SolidRole role;
    FeatureKind kind;
    std::string_view name;  // spoken where the map gives none; empty: by shape
};
constexpr std::array kClasses{
    ClassRow{"func_door*", SolidRole::Mover, FeatureKind::Door, "door"},
    ClassRow{"func_plat*", SolidRole::Mover, FeatureKind::Lift, "lift"},
    ClassRow{"func_button", SolidRole::Mover, FeatureKind::Button, "button"},
    ClassRow{"func_train", SolidRole::Mover, FeatureKind::Mover, "moving platform"},
    ClassRow{"func_rotating", SolidRole::Mover, FeatureKind::Mover, "turning part"},
    ClassRow{"func_illusionary", SolidRole::Illusion, FeatureKind::Object, "illusion"},
    ClassRow{"trigger_teleport", SolidRole::Trigger, FeatureKind::Teleport, "teleporter"},
    ClassRow{"trigger_changelevel", SolidRole::Trigger, FeatureKind::Trigger, "exit"},
    ClassRow{"trigger_hurt", SolidRole::Trigger, FeatureKind::Trigger, "danger"},
    ClassRow{"trigger_secret", SolidRole::Trigger, FeatureKind::Trigger, "secret place"},
    ClassRow{"trigger_*", SolidRole::Trigger, FeatureKind::Trigger, "marked place"},
    ClassRow{"func_episodegate", SolidRole::Solid, FeatureKind::Object, "gate"},
    ClassRow{"func_bossgate", SolidRole::Solid, FeatureKind::Object, "gate"},
};

// One of our own names, where the map gives none.
void give_name(Feature& feature, std::string_view name) {
    feature.name = name;
    feature.made_name = true;
}

bool fits(std::string_view pattern, std::string_view name) {
    return pattern.ends_with('*') ? name.starts_with(pattern.substr(0, pattern.size() - 1)) : name == pattern;
}

const ClassRow* class_row(std::string_view class_name) {
    for (const ClassRow& row : kClasses)
        if (fits(row.class_name, class_name)) return &row;
    return nullptr;
}

// Part of the building itself: its brushes are joined and named by side unless the entity has a name of its own.
bool is_structure(std::string_view class_name) {
    return class_name.empty() || class_name == "worldspawn" || class_name == "func_group" || class_name.starts_with("func_detail");
}

// Fire, fountains and the like: seen in other programs, felt in none, heard here.
bool is_particles(std::string_view class_name) {
    constexpr std::array<std::string_view, 9> kStarts{"particle",  "light_torch", "light_flame", "env_fire",   "env_spark",
                                                      "env_steam", "env_smoke",   "misc_fire",   "misc_sparks"};
    return std::any_of(kStarts.begin(), kStarts.end(), [&](std::string_view start) { return class_name.starts_with(start); });
}

struct SoundRow {
    std::string_view class_name, name;  // a text's key
};
constexpr std::array kSounds{
    SoundRow{"ambient_comp_hum", "map.sound_computer_hum"},
    SoundRow{"ambient_drip", "map.sound_dripping_water"},
    SoundRow{"ambient_drone", "map.sound_machine_drone"},
    SoundRow{"ambient_flouro_buzz", "map.sound_lamp_buzzing"},
    SoundRow{"ambient_light_buzz", "map.sound_lamp_buzzing"},
    SoundRow{"ambient_suck_wind", "map.sound_wind"},
    SoundRow{"ambient_swamp*", "map.sound_swamp"},
    SoundRow{"ambient_thunder", "map.sound_thunder"},
    SoundRow{"light_torch*", "map.sound_torch"},
    SoundRow{"light_flame*", "map.sound_flame"},
    SoundRow{"particle_explo*", "map.sound_explosion"},
    SoundRow{"particle_fire*", "map.sound_fire"},
    SoundRow{"particle_fountain*", "map.sound_fountain"},
    SoundRow{"particle_rain*", "map.sound_rain"},
    SoundRow{"particle_snow*", "map.sound_snow"},
};

// What one texture says about the brush it covers.
enum class TextureSense { Ordinary, Water, Slime, Lava, Teleport, Clip, Trigger, LeftOut };

struct TextureFacts {
    TextureSense sense = TextureSense::Ordinary;
    bool sky = false;
    const MaterialSpec* guess = nullptr;
};

TextureFacts facts_of_texture(std::string_view texture) {
    std::string name = lower_ascii(texture.substr(0, 256));
    if (const std::size_t slash = name.find_last_of("/\\"); slash != std::string::npos) name.erase(0, slash + 1);
    TextureFacts facts;
    if (name.starts_with('*') || name.starts_with('!')) {
        const std::string_view liquid = std::string_view(name).substr(1);
        facts.sense = liquid.starts_with("lava")    ? TextureSense::Lava
                      : liquid.starts_with("slime") ? TextureSense::Slime
                      : liquid.starts_with("tele")  ? TextureSense::Teleport
                                                    : TextureSense::Water;
    } else if (name == "clip") {
        facts.sense = TextureSense::Clip;
    } else if (name == "trigger" || name == "aaatrigger") {
        facts.sense = TextureSense::Trigger;
    } else if (name == "hint" || name == "skip" || name == "hintskip" || name == "origin") {
        facts.sense = TextureSense::LeftOut;
    } else if (name.starts_with("sky")) {
        facts.sky = true;
    } else {
        facts.guess = guess_material(name);
    }
    return facts;
}

// Nothing below a millionth of a millimetre is worth its zeros.
double in_millimetres(double m) { return m < 1e-9 ? 0.0 : 1e3 * m; }

// Equal for surfaces that feel alike, whatever they are made of.
std::string look_of_surface(const Material& m) {
    const auto of = [](const std::optional<double>& value) { return value.value_or(-1.0); };
    std::string look = fmt::format("{} {} {} {}", of(m.stiffness_fraction), of(m.friction_mu), of(m.friction_static), of(m.damping_ns_per_m));
    if (m.wave)
        look += fmt::format(" wave {} {} {} {} {}", static_cast<int>(m.wave->shape), m.wave->depth_hand_m, m.wave->period_hand_m, m.wave->friction_share,
                            m.wave->turn_rad);
    if (m.picture)
        look += fmt::format(" picture {} {} {} {}", static_cast<const void*>(m.picture->heights.get()), m.picture->depth_hand_m, m.picture->size_m,
                            m.picture->turn_rad);
    return look;
}

class MapSceneBuilder {
public:
    MapSceneBuilder(std::string_view bytes, const std::string& file_name, const ReadOptions& options)
        : options_(options), units_(options.map_metres_per_unit), diagnostics_(file_name), keys_(diagnostics_, units_), file_(parse_map(bytes, diagnostics_)) {
        scene_.source_file = file_name;
        scene_.metres_per_unit = units_;
        scene_.materials.emplace_back();
        scene_.report.format = "map";
    }

    Result<Scene> build() {
        progress(0.3);
        for (std::size_t i = 0; i < file_.entities.size(); ++i) read_entity(file_.entities[i], static_cast<int>(i));
        progress(0.5);
        bend_patches();
        if (scene_.solids.empty() && scene_.triangles.empty()) return nothing_to_touch(diagnostics_, scene_.source_file, "map");
        join_volumes();
        derive_surfaces(scene_, looks_, units_);
        progress(0.9);
        choose_base();
        attach_effects(effects_, scene_, diagnostics_);
        name_world();
        attach_movers(movers_, scene_, diagnostics_);
        write_report();
        progress(1.0);
        return std::move(scene_);
    }

private:
    // What an entity makes of its brushes.
    struct Meaning {
        SolidRole role = SolidRole::Solid;
        std::optional<PrimitiveKind> exact;  // one exact shape in the box around its brushes
        bool structure = false;              // not one thing: walls are named by side
        bool liquid = false;                 // cs_name liquid
        Feature feature;                     // used unless `structure`
        std::optional<double> viscosity_ns_per_m;
        double buoyancy_n = 0.0, film_n = 0.0;
        Vec3 flow_hand_m_per_s{0.0};
        std::optional<SoftWish> soft;
        Material surface;  // what the keys say; its name one of the library, or empty
        std::string look;  // the same for surfaces with the same keys
        SourcePlace source;
    };
    // A liquid, teleporter face or trigger brush of the building: touching ones of a kind become one.
    struct Volume {
        std::size_t solid = 0;
        FeatureKind kind = FeatureKind::Liquid;
        std::string_view name;
    };

    // A curved patch in world metres, before it is cut into triangles.
    struct Bent {
        PatchGrid grid;
        FeatureId feature;
        MaterialId material = kDefaultMaterial;
        TouchSide side = TouchSide::Both;
    };

    void progress(double fraction) const {
        if (options_.progress) options_.progress(fraction);
    }

    // ---- keys ----

    static std::string words_of_value(std::string_view value) { return spoken_text(unquoted(value.substr(0, 4096))); }
    static std::string text_of(const MapEntity& entity, std::string_view key) { return words_of_value(entity.value(key)); }
    // The key's texts in other languages: `name_de` and so on for `name`.
    static OtherLanguages texts_in(const MapEntity& entity, std::string_view key) {
        OtherLanguages texts;
        for (const MapKey& other : entity.keys) {
            const std::string_view all = other.key;
            if (all.size() <= key.size() + 1 || !all.starts_with(key) || all[key.size()] != '_') continue;
            const std::string_view code = all.substr(key.size() + 1);
            if (std::string text = words_of_value(other.value); !text.empty()) texts.push_back({std::string(code), std::move(text)});
        }
        return texts;
    }

    std::optional<double> number_of(const MapEntity& entity, std::string_view key, double least, double most, std::string_view range) {
        return keys_.number_of(entity, key, least, most, range);
    }

    bool yes_no_of(const MapEntity& entity, std::string_view key) {
        const MapKey* found = entity.find(key);
        if (!found) return false;
        const std::string value = lower_ascii(trimmed(found->value).substr(0, 16));
        if (value == "1" || value == "yes" || value == "true") return true;
        if (value == "0" || value == "no" || value == "false") return false;
        double number = 1.0;
        const bool yes = !parse_finite(value, number) || number > 0.5;
        diagnostics_.warn(found->place, "map.then_number", "map.no_switch", {{"value", excerpt(found->value)}, {"key", key}, {"taken", yes ? 1 : 0}});
        return yes;
    }

    std::string side_of_key(const MapEntity& entity, std::string_view key) {
        static const std::vector<std::string> kSides{"north", "north-east", "east", "south-east", "south", "south-west",
                                                     "west",  "north-west", "left", "right",      "top",   "bottom"};
        const MapKey* found = entity.find(key);
        if (!found) return {};
        const std::string value = lower_ascii(trimmed(found->value).substr(0, 32));
        if (std::find(kSides.begin(), kSides.end(), value) != kSides.end()) return value;
        const std::string nearest = nearest_name(value, kSides);
        diagnostics_.warn(found->place, "map.then_word", "map.no_side", {{"value", excerpt(found->value)}, {"key", key}, {"taken", nearest}});
        return nearest;
    }

    // "x y z" in units.
    std::optional<Vec3> vector_of(const MapEntity& entity, std::string_view key) { return keys_.vector_of(entity, key); }

    // ---- entities ----

    void read_entity(const MapEntity& entity, int index) {
        const std::string class_name = lower_ascii(entity.value("classname").substr(0, 64));
        const bool world = class_name == "worldspawn";
        if (world) {
            saw_worldspawn_ = true;
            if (const auto error = number_of(entity, "curve_error", 0.01, 100.0, "map.range_millimetres")) curve_error_m_ = *error * 1e-3;
        }
        note_kind_of_map(entity, class_name);
        if (class_name.empty() && !entity.keys.empty())
            diagnostics_.warn(entity.place, entity.brushes.empty() ? "map.then_left_out" : "map.then_part_of_building", "map.no_classname");
        if (class_name == "misc_external_map" || class_name == "func_instance" || class_name == "misc_prefab" || entity.find("_external_map"))
            diagnostics_.warn(entity.place, "map.then_missing", "map.other_file");
        if (class_name.starts_with("info_player_")) read_start(entity, class_name, index);
        if (class_name.starts_with("func_door")) ++scene_.report.doors;
        note_name(movers_, entity);
        if (class_name == "info_teleport_destination") read_destination(entity);
        if (class_name == "info_room") {
            read_room_name(entity);
            return;
        }
        if (entity.value("cs_name") == "PHANTOM" || entity.value("name") == "PHANTOM") {
            left_out_cursor_ = true;
            for (const MapBrush& brush : entity.brushes) counted_solid_of(brush);
            return;
        }
        if (class_name == "haptic_effect") {
            add_effects(entity, index);
            return;
        }
        read_sound(entity, class_name);
        if (world) {
            for (const std::string_view key : {"name", "message"})
                if (world_name_.empty()) {
                    world_name_ = text_of(entity, key);
                    scene_.name_in = texts_in(entity, key);
                }
        }
        if (!entity.brushes.empty() || !entity.patches.empty()) read_brushes(entity, class_name, index);
        else if (!world && !class_name.empty() && !class_name.starts_with("info_player_") && class_name.find("light") != 0 &&
                 !class_name.starts_with("ambient_") && !is_particles(class_name) && class_name != "target_speaker")
            ++shapeless_things_;
    }

    // A place for a force, without a shape of its own: its brushes are counted and neither touched nor seen.
    void add_effects(const MapEntity& entity, int index) {
        const auto built = [this](const MapBrush& brush) {
            BuiltSolid solid = solid_of(brush, false);
            count_brush(solid);
            return solid;
        };
        for (ReadEffect& effect : read_effects(entity, index, text_of(entity, "name"), units_, built, diagnostics_)) effects_.push_back(std::move(effect));
    }

    void note_kind_of_map(const MapEntity& entity, const std::string& class_name) {
        for (const std::string_view start :
             {"info_player_deathmatch", "info_player_coop", "info_intermission", "monster_", "item_", "weapon_", "light", "ambient_", "trigger_changelevel"})
            if (class_name.starts_with(start)) game_things_ = true;
        if (class_name == "thing" || entity.find("cs_name")) building_things_ = true;
        if (class_name != "worldspawn") return;
        if (entity.find("wad") || entity.find("worldtype")) game_things_ = true;
        if (entity.find("building")) stated_building_ = yes_no_of(entity, "building");
    }

    // Clockwise from north, 0 to 2 pi.
    double heading_of(const MapEntity& entity) {
        double angle_deg = 0.0;
        if (entity.find("angle")) angle_deg = number_of(entity, "angle", -1e6, 1e6, "map.range_angle").value_or(0.0);
        else if (const std::optional<Vec3> angles = vector_of(entity, entity.find("angles") ? "angles" : "mangle")) angle_deg = angles->y;
        if (angle_deg == -1.0 || angle_deg == -2.0) angle_deg = 0.0;  // these two mean up and down
        const double heading = std::remainder(radians_from_degrees(90.0 - angle_deg), 2.0 * kPi);
        return heading < 0.0 ? heading + 2.0 * kPi : heading;
    }

    void read_start(const MapEntity& entity, const std::string& class_name, int index) {
        ++scene_.report.starts;
        const std::optional<Vec3> origin = vector_of(entity, "origin");
        if (!origin) {
            if (!entity.find("origin")) diagnostics_.warn(entity.place, "map.then_left_out", "map.start_nowhere");
            return;
        }
        Start start;
        start.feet_m = (*origin - Vec3{0.0, 0.0, kOriginAboveSolesUnits}) * units_;
        start.heading_rad = heading_of(entity);
        start.name = text_of(entity, "name");
        start.base = class_name == "info_player_start";
        start.source = {entity.place.line, index};
        scene_.starts.push_back(std::move(start));
    }

    // Where teleporters lead: like a start, but nobody starts there.
    void read_destination(const MapEntity& entity) {
        if (const std::optional<Vec3> origin = vector_of(entity, "origin"))
            note_destination(movers_, entity, (*origin - Vec3{0.0, 0.0, kOriginAboveSolesUnits}) * units_, heading_of(entity));
    }

    // A place in a room, and the room's name.
    void read_room_name(const MapEntity& entity) {
        const std::optional<Vec3> origin = vector_of(entity, "origin");
        std::string name = text_of(entity, "name");
        if (origin && !name.empty()) scene_.room_names.push_back({*origin * units_, std::move(name), texts_in(entity, "name")});
        else diagnostics_.warn(entity.place, "map.then_left_out", "map.room_nowhere");
    }

    void choose_base() {
        if (scene_.starts.empty()) return;
        const auto first = std::find_if(scene_.starts.begin(), scene_.starts.end(), [](const Start& start) { return start.base; });
        const auto chosen = first == scene_.starts.end() ? scene_.starts.begin() : first;
        for (auto start = scene_.starts.begin(); start != scene_.starts.end(); ++start) {
            start->base = start == chosen;
            if (start->name.empty()) start->name = phrase(start->base ? "map.base" : "map.other_start");
        }
    }

    void read_sound(const MapEntity& entity, const std::string& class_name) {
        const bool ambient = class_name.starts_with("ambient_");
        std::string sound = text_of(entity, "sound");
        // Other games' editors write the file to play under these keys.
        if (sound.empty() && class_name == "ambient_generic") sound = text_of(entity, "message");
        if (sound.empty() && class_name == "target_speaker") sound = text_of(entity, "noise");
        if (!ambient && sound.empty() && !is_particles(class_name)) return;
        SoundSource source;
        source.sound = sound.empty() ? class_name : sound;
        source.name = text_of(entity, "name");
        source.name_in = texts_in(entity, "name");
        for (const SoundRow& row : kSounds)
            if (source.name.empty() && sound.empty() && fits(row.class_name, class_name)) {
                source.name = row.name;
                source.made_name = true;
            }
        if (source.name.empty())
            source.name = words_of_name(ambient && sound.empty() ? std::string_view(class_name).substr(8) : std::string_view(source.sound));
        source.loudness = number_of(entity, "volume", 0.0, 1.0, "map.range").value_or(1.0);
        if (const std::optional<Vec3> origin = vector_of(entity, "origin")) {
            source.position_m = *origin * units_;
        } else {
            Aabb box;
            for (const MapBrush& brush : entity.brushes)
                if (const BuiltSolid built = solid_of(brush, false); built.fault == SolidFault::None) box.include(built.solid.bounds_m);
            if (box.empty()) return;
            source.position_m = box.centre_m();
        }
        scene_.sounds.push_back(std::move(source));
    }

    Meaning meaning_of(const MapEntity& entity, const std::string& class_name, int index) {
        Meaning meaning;
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
            feature.landmark = yes_no_of(entity, "landmark");
            feature.clue = yes_no_of(entity, "clue");
            feature.hinge = side_of_key(entity, "hinge");
            feature.handle = side_of_key(entity, "handle");
        }
        if (class_name == "trigger_changelevel") {  // where the map ends: one may look for it, and is told
            feature.landmark = true;
            if (feature.message.empty()) {
                feature.message = "exit.reached";
                feature.made_message = true;
            }
        }
        meaning.structure = world || (is_structure(class_name) && feature.name.empty() && !feature.landmark && !feature.clue);
        if (const ClassRow* row = class_row(class_name)) {
            meaning.role = row->role;
            feature.kind = row->kind;
            if (feature.name.empty()) give_name(feature, row->name);
        }
        const std::string cs_name = world ? std::string{} : lower_ascii(entity.value("cs_name").substr(0, 256));
        if (cs_name == "liquid") {
            meaning.structure = false;
            meaning.liquid = true;
            meaning.role = SolidRole::Liquid;
            feature.kind = FeatureKind::Liquid;
            if (feature.name.empty()) give_name(feature, "liquid");
        } else if (cs_name == "dynamic_box" || cs_name == "dynamic_sphere" || cs_name == "dynamic_cylinder") {
            meaning.structure = false;
            meaning.role = SolidRole::Mover;
            meaning.exact = cs_name == "dynamic_box" ? PrimitiveKind::Box : cs_name == "dynamic_sphere" ? PrimitiveKind::Sphere : PrimitiveKind::Cylinder;
            if (feature.name.empty()) give_name(feature, cs_name == "dynamic_box" ? "box" : cs_name == "dynamic_sphere" ? "ball" : "cylinder");
        } else if (feature.name.empty() && !cs_name.empty()) {
            feature.name = words_of_name(entity.value("cs_name"));
        }
        if (const std::optional<PrimitiveKind> exact = shape_of(entity, world, meaning)) {
            meaning.structure = false;
            meaning.exact = exact;
            if (feature.name.empty()) give_name(feature, *exact == PrimitiveKind::Sphere ? "ball" : kPrimitiveNames[static_cast<std::size_t>(*exact)]);
        }
        meaning.viscosity_ns_per_m = number_of(entity, "viscosity", 0.0, kMostViscosityNsPerM, "map.range_viscosity");
        meaning.soft = soft_wish_of(entity, units_, diagnostics_);
        meaning.buoyancy_n = number_of(entity, "buoyancy", 0.0, kMostBuoyancyN, "map.range_newtons").value_or(0.0);
        meaning.film_n = number_of(entity, "film", 0.0, kMostFilmN, "map.range_newtons").value_or(0.0);
        if (const std::optional<Vec3> flow = keys_.vector_of(entity, "flow", "map.then_still")) {
            meaning.flow_hand_m_per_s = *flow;
            if (const double speed = glm::length(*flow); speed > kMostFlowMPerS) {
                meaning.flow_hand_m_per_s *= kMostFlowMPerS / speed;
                diagnostics_.warn(entity.find("flow")->place, "map.then_slower", "map.fast_flow", {{"speed", speed}, {"most", kMostFlowMPerS}});
            }
            if (meaning.viscosity_ns_per_m.value_or(0.0) <= 0.0) diagnostics_.warn(entity.find("flow")->place, "map.then_unfelt", "map.thin_flow");
        }
        read_surface(entity, meaning.surface);
        meaning.look = look_of_surface(meaning.surface);
        if (const MapKey* key = entity.find("material")) {
            if (const MaterialSpec* spec = find_material(trimmed(key->value).substr(0, 64))) {
                meaning.surface.name = spec->name;
            } else {
                std::vector<std::string> names;
                for (const MaterialSpec& row : material_library()) names.emplace_back(row.name);
                diagnostics_.warn(key->place, "map.then_default", "map.no_material",
                                  {{"value", excerpt(key->value)}, {"nearest", nearest_name(key->value.substr(0, 64), names)}});
            }
        }
        return meaning;
    }

    // ---- surfaces ----

    void read_surface(const MapEntity& entity, Material& surface) {
        surface.stiffness_fraction = number_of(entity, "stiffness", 0.0, 1.0, "map.range");
        surface.friction_mu = number_of(entity, "friction", 0.0, kMostFriction, "map.range");
        surface.friction_static = number_of(entity, "friction_static", 0.0, kMostFriction, "map.range");
        surface.damping_ns_per_m = number_of(entity, "damping", 0.0, kMostDampingNsPerM, "map.range_viscosity");
        if (surface.friction_static && surface.friction_mu) {
            const TextPlace place = entity.find("friction_static")->place;
            if (*surface.friction_static < *surface.friction_mu) {
                diagnostics_.warn(place, "map.then_number", "map.low_static", {{"taken", *surface.friction_mu}});
                surface.friction_static = surface.friction_mu;
            } else if (*surface.friction_static > kMostStaticOverKinetic * *surface.friction_mu) {
                diagnostics_.warn(place, "map.then_taken", "map.high_static", {{"times", kMostStaticOverKinetic}});
            }
        }
        const std::optional<double> depth_mm = number_of(entity, "texture_depth", 0.0, 5.0, "map.range_millimetres");
        const double turn_rad = radians_from_degrees(number_of(entity, "texture_angle", -360.0, 360.0, "map.range_degrees").value_or(0.0));
        read_wave(entity, depth_mm, turn_rad, surface);
        read_picture(entity, depth_mm, turn_rad, surface);
    }

    void read_wave(const MapEntity& entity, std::optional<double> depth_mm, double turn_rad, Material& surface) {
        const std::optional<double> share = number_of(entity, "friction_wave", 0.0, 0.3, "map.range");
        const std::optional<double> period_mm = number_of(entity, "texture_period", 1.0, 100.0, "map.range_millimetres");
        std::optional<WaveShape> shape;
        if (const MapKey* key = entity.find("texture_wave")) {
            const std::string word = lower_ascii(trimmed(key->value).substr(0, 16));
            if (word == "sine") shape = WaveShape::Sine;
            else if (word == "square") shape = WaveShape::Square;
            else if (word == "none") shape = WaveShape::Level;
            else diagnostics_.warn(key->place, "map.then_plain", "map.no_wave", {{"value", excerpt(key->value)}});
        }
        if (!share && !shape) return;
        TextureWave wave;
        wave.shape = shape.value_or(WaveShape::Level);
        wave.period_hand_m = period_mm.value_or(kPeriod_mm) * kMillimetre;
        wave.depth_hand_m = wave.shape == WaveShape::Level ? 0.0 : depth_mm.value_or(kWaveDepth_mm) * kMillimetre;
        wave.friction_share = share.value_or(0.0);
        wave.turn_rad = turn_rad;
        surface.wave = wave;
    }

    void read_picture(const MapEntity& entity, std::optional<double> depth_mm, double turn_rad, Material& surface) {
        const std::optional<double> size_units = number_of(entity, "texture_size", 1.0, 1e5, "map.range_in_units");
        const MapKey* key = entity.find("texture_picture");
        if (!key) return;
        const std::string name = unquoted(trimmed(key->value).substr(0, 256));
        const auto [found, is_new] = pictures_.try_emplace(name);
        if (is_new) {
            const Result<std::string> bytes = options_.read_beside ? options_.read_beside(name) : fail(phrase("map.no_folder"), name);
            Result<HeightPicture> picture = bytes ? read_height_picture(*bytes, name) : tl::unexpected(bytes.error());
            if (picture) found->second = std::make_shared<const HeightPicture>(std::move(*picture));
            else diagnostics_.warn(key->place, "map.then_plain", "map.bad_picture", {{"picture", excerpt(name, 60)}, {"why", picture.error().message}});
        }
        if (!found->second) return;
        TexturePicture picture;
        picture.heights = found->second;
        picture.depth_hand_m = depth_mm.value_or(kPictureDepth_mm) * kMillimetre;
        picture.turn_rad = turn_rad;
        for (const MapBrush& brush : entity.brushes)
            if (const BuiltSolid built = solid_of(brush, false); built.fault == SolidFault::None) picture.box_m.include(built.solid.bounds_m);
        if (picture.box_m.empty()) return;
        const Vec3 size = picture.box_m.size_m();
        picture.size_m = size_units ? *size_units * units_ : std::max(size.x, size.y);
        surface.picture = picture;
    }

    // The key `shape`.
    std::optional<PrimitiveKind> shape_of(const MapEntity& entity, bool world, const Meaning& meaning) {
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
        diagnostics_.warn(key->place, "map.then_brushes", "map.no_shape", {{"value", excerpt(key->value)}, {"nearest", nearest_name(value, names)}});
        return std::nullopt;
    }

    // The key `axis`: x, y or z, or the other way with a minus sign. The turn that brings z there.
    struct AxisTurn {
        int axis = 2;
        Rotation turn;
    };
    AxisTurn axis_of(const MapEntity& entity) {
        const MapKey* key = entity.find("axis");
        if (!key) return {};
        const std::string value = lower_ascii(trimmed(key->value).substr(0, 8));
        const bool back = value.starts_with('-');
        const std::string name = back ? value.substr(1) : value;
        if (name == "x") return {0, rotation_about({0, 1, 0}, back ? -0.5 * kPi : 0.5 * kPi)};
        if (name == "y") return {1, rotation_about({1, 0, 0}, back ? 0.5 * kPi : -0.5 * kPi)};
        if (name != "z") diagnostics_.warn(key->place, "map.then_word", "map.no_axis", {{"value", excerpt(key->value)}, {"taken", "z"}});
        return {2, name == "z" && back ? rotation_about({1, 0, 0}, kPi) : Rotation{}};
    }

    // ---- brushes ----

    // An exact shape in the box around all brushes of the entity. Where sides that should be equal differ the smallest counts, so that the shape stays in its
    // box.
    FeatureId read_exact(const MapEntity& entity, const Meaning& meaning, int index) {
        Aabb box;
        const MapBrush* first = nullptr;
        for (const MapBrush& brush : entity.brushes) {
            const BuiltSolid built = counted_solid_of(brush);
            if (built.fault != SolidFault::None) continue;
            if (sense_of(brush) == TextureSense::LeftOut) {
                ++helper_brushes_;
                continue;
            }
            if (!first) first = &brush;
            box.include(built.solid.bounds_m);
        }
        if (!first) return kNoFeature;
        constexpr double kAgree = 1.05;
        const AxisTurn axis = *meaning.exact == PrimitiveKind::Box || *meaning.exact == PrimitiveKind::Sphere ? AxisTurn{} : axis_of(entity);
        Primitive primitive{*meaning.exact, box.size_m(), Vec3(1.0), {box.centre_m(), axis.turn}};
        Vec3& size = primitive.size_m;
        if (primitive.kind != PrimitiveKind::Box) {
            const double length = size[axis.axis], across = size[(axis.axis + 1) % 3], deep = size[(axis.axis + 2) % 3];
            const bool sphere = primitive.kind == PrimitiveKind::Sphere;
            const double least = std::min(std::min(across, deep), sphere ? length : across), most = std::max(std::max(across, deep), sphere ? length : across);
            if (most > kAgree * least)
                diagnostics_.warn(entity.place, "map.then_number", "map.uneven_shape",
                                  {{"shape", kPrimitiveNames[static_cast<std::size_t>(primitive.kind)]},
                                   {"x", box.size_m().x / units_},
                                   {"y", box.size_m().y / units_},
                                   {"z", box.size_m().z / units_},
                                   {"taken", least / units_}});
            size = {least, least, sphere ? least : length};
            if (primitive.kind == PrimitiveKind::Capsule && length < least) {
                diagnostics_.warn(entity.place, "map.then_thinner", "map.wide_capsule");
                size = Vec3(length);
            }
        }
        const TextureFacts& facts = facts_of(first->faces.front().texture);
        const Result<Solid> made = make_solid(primitive, material_of(meaning, facts, first->faces.front().texture));
        if (!made) {
            diagnostics_.pass_on(entity.place, "map.then_left_out", made.error().message);
            ++brushes_left_out_;
            return kNoFeature;
        }
        Solid solid = *made;
        solid.role = meaning.role;
        solid.source = {first->place.line, index};
        solid.feature = add_feature(meaning.feature);
        scene_.features[solid.feature.value].bounds_m = solid.shape.bounds_m;
        scene_.bounds_m.include(box);
        if (solid.role == SolidRole::Mover) ++scene_.report.movers;
        looks_.emplace_back(solid.shape.planes.size(), look_of(meaning, facts));
        const FeatureId thing = solid.feature;
        scene_.solids.push_back(std::move(solid));
        return thing;
    }

    BuiltSolid solid_of(const MapBrush& brush, bool report) {
        std::vector<Plane>& planes = planes_;
        planes.clear();
        face_of_plane_.clear();
        Vec3 middle{0.0};
        double farthest_m = 0.0;
        int degenerate = 0;
        for (std::uint32_t i = 0; i < brush.faces.size(); ++i) {
            const MapFace& face = brush.faces[i];
            std::array<Vec3, 3> p;
            for (std::size_t k = 0; k < 3; ++k) {
                p[k] = face.points_units[k] * units_;
                farthest_m = std::max({farthest_m, std::abs(p[k].x), std::abs(p[k].y), std::abs(p[k].z)});
            }
            Plane plane;
            if (!plane_from_clockwise(p[0], p[1], p[2], plane)) {
                if (report && degenerate == 0) diagnostics_.warn(face.place, "map.then_without_face", "map.flat_face");
                ++degenerate;
                continue;
            }
            planes.push_back(plane);
            face_of_plane_.push_back(i);
            middle += p[0];
        }
        if (farthest_m > kFarthestM) {
            if (report) diagnostics_.warn(brush.place, "map.then_left_out", "map.far_brush");
            BuiltSolid nothing;
            nothing.fault = SolidFault::Open;
            return nothing;
        }
        if (!planes.empty()) middle /= static_cast<double>(planes.size());
        BuiltSolid built = solid_from_planes(planes, middle, 4.0 * farthest_m + 4096.0, {1e-6 * units_, 1e-4 * units_});
        if (!report) return built;
        if (built.fault == SolidFault::Empty) diagnostics_.warn(brush.place, "map.then_left_out", "map.flat_brush");
        if (built.fault == SolidFault::Open) diagnostics_.warn(brush.place, "map.then_left_out", "map.leaky_brush");
        if (built.was_inside_out) diagnostics_.warn(brush.place, "map.then_turned", "map.inside_out");
        if (built.fault == SolidFault::None) dropped_faces_ += built.planes_without_face;
        return built;
    }

    BuiltSolid counted_solid_of(const MapBrush& brush) {
        BuiltSolid built = solid_of(brush, true);
        count_brush(built);
        return built;
    }

    void count_brush(const BuiltSolid& built) {
        ++scene_.report.brushes;
        if (built.fault != SolidFault::None) {
            ++brushes_left_out_;
            return;
        }
        for (const Polygon& face : built.solid.faces) {
            ++scene_.report.polygons;
            scene_.report.triangles += static_cast<int>(face.points_m.size()) - 2;
        }
    }

    const TextureFacts& facts_of(std::string_view texture) {
        const auto [found, is_new] = textures_.try_emplace(texture);
        if (is_new) found->second = facts_of_texture(texture);
        return found->second;
    }

    // Special only when every face is: the first face then names the kind.
    TextureSense sense_of(const MapBrush& brush) {
        for (const MapFace& face : brush.faces)
            if (facts_of(face.texture).sense == TextureSense::Ordinary) return TextureSense::Ordinary;
        return facts_of(brush.faces.front().texture).sense;
    }

    void read_brushes(const MapEntity& entity, const std::string& class_name, int index) {
        const Meaning meaning = meaning_of(entity, class_name, index);
        const TouchSide side = touch_side_of(entity);
        // One brush stays as it is where a box was asked for: it may be a turned one.
        if (meaning.exact && !entity.brushes.empty() && (*meaning.exact != PrimitiveKind::Box || entity.brushes.size() > 1)) {
            FeatureId thing = read_exact(entity, meaning, index);
            for (const MapPatch& patch : entity.patches) read_patch(patch, meaning, index, thing, side);
            return;
        }
        FeatureId whole = kNoFeature;
        bool moves = false;
        for (const MapBrush& brush : entity.brushes) {
            BuiltSolid built = counted_solid_of(brush);
            if (built.fault != SolidFault::None) continue;
            Solid solid;
            solid.role = meaning.role;
            solid.source = {brush.place.line, index};
            FeatureKind volume_kind = FeatureKind::Liquid;
            std::string_view volume_name;
            const bool fixed_role = meaning.role == SolidRole::Trigger || meaning.role == SolidRole::Illusion || meaning.liquid;
            switch (fixed_role ? TextureSense::Ordinary : sense_of(brush)) {
                case TextureSense::Ordinary:
                    break;
                case TextureSense::Water:
                    volume_name = "water";
                    break;
                case TextureSense::Slime:
                    volume_name = "slime";
                    break;
                case TextureSense::Lava:
                    volume_name = "lava";
                    break;
                case TextureSense::Teleport:
                    volume_kind = FeatureKind::Teleport;
                    volume_name = "teleporter";
                    break;
                case TextureSense::Trigger:
                    volume_kind = FeatureKind::Trigger;
                    volume_name = "marked place";
                    break;
                case TextureSense::Clip:
                    solid.role = SolidRole::BodyClip;
                    break;
                case TextureSense::LeftOut:
                    ++helper_brushes_;
                    continue;
            }
            if (!volume_name.empty())
                solid.role = volume_kind == FeatureKind::Liquid     ? SolidRole::Liquid
                             : volume_kind == FeatureKind::Teleport ? SolidRole::Teleport
                                                                    : SolidRole::Trigger;
            if (solid.role == SolidRole::Liquid) {
                ++scene_.report.liquids;
                solid.viscosity_ns_per_m = meaning.viscosity_ns_per_m;
                solid.buoyancy_n = meaning.buoyancy_n;
                solid.film_n = meaning.film_n;
                solid.flow_hand_m_per_s = meaning.flow_hand_m_per_s;
            }
            moves = moves || solid.role == SolidRole::Mover;
            if (solid.role == SolidRole::Solid || solid.role == SolidRole::Mover) scene_.bounds_m.include(built.solid.bounds_m);
            if (meaning.structure) {
                if (!volume_name.empty()) volumes_.push_back({scene_.solids.size(), volume_kind, volume_name});
            } else {
                if (!whole) whole = add_feature(meaning.feature);
                Feature& feature = scene_.features[whole.value];
                feature.bounds_m.include(built.solid.bounds_m);
                if (feature.name.empty() && !volume_name.empty()) {
                    give_name(feature, volume_name);
                    feature.kind = volume_kind;
                }
                solid.feature = whole;
            }
            std::vector<FaceLook>& looks = looks_.emplace_back();
            for (const std::uint32_t plane : built.plane_index) {
                const TextureFacts& facts = facts_of(brush.faces[face_of_plane_[plane]].texture);
                const bool touchable = solid.role == SolidRole::Solid || solid.role == SolidRole::Mover;
                solid.face_materials.push_back(touchable ? material_of(meaning, facts, brush.faces[face_of_plane_[plane]].texture) : kDefaultMaterial);
                looks.push_back(facts.sky ? kSkyLook : look_of(meaning, facts));
            }
            solid.shape = std::move(built.solid);
            if (meaning.soft && (solid.role == SolidRole::Solid || solid.role == SolidRole::Mover))
                solid.soft = soft_face_of(*meaning.soft, solid.shape, spoken_name(meaning.feature), diagnostics_);
            scene_.solids.push_back(std::move(solid));
        }
        for (const MapPatch& patch : entity.patches) read_patch(patch, meaning, index, whole, side);
        if (moves) ++scene_.report.movers;
        if (moves) note_mover(movers_, entity, class_name, whole, keys_);
        if (whole && meaning.role == SolidRole::Trigger) note_switch(movers_, entity, class_name, whole);
        if (whole && scene_.features[whole.value].kind == FeatureKind::Door) {
            Feature& door = scene_.features[whole.value];
            const Vec3 size = door.bounds_m.size_m();
            if (door.name == "door" && size.z < 0.5 * std::min(size.x, size.y)) door.name = "sliding floor";  // lies flat: a bridge or trapdoor
        }
    }

    FeatureId add_feature(Feature feature) {
        scene_.features.push_back(std::move(feature));
        return {static_cast<std::uint32_t>(scene_.features.size() - 1)};
    }

    // ---- curved patches ----

    // From where an entity's patches are touched. Brushes have an inside and no sides.
    TouchSide touch_side_of(const MapEntity& entity) {
        const MapKey* key = entity.find("touch_side");
        if (!key) return TouchSide::Both;
        if (entity.patches.empty()) {
            diagnostics_.warn(key->place, "map.then_left_out", "map.side_of_brush");
            return TouchSide::Both;
        }
        if (const std::optional<TouchSide> side = touch_side_named(key->value)) return *side;
        diagnostics_.warn(key->place, "map.then_both", "map.no_touch_side", {{"value", excerpt(key->value)}});
        return TouchSide::Both;
    }

    // Notes a patch of an entity; `whole` is the entity's thing, made here where it has only patches.
    void read_patch(const MapPatch& patch, const Meaning& meaning, int index, FeatureId& whole, TouchSide side) {
        const TextureFacts& facts = facts_of(patch.texture);
        if ((meaning.role != SolidRole::Solid && meaning.role != SolidRole::Mover) || facts.sense != TextureSense::Ordinary) {
            ++patches_left_out_;
            return;
        }
        Bent bent{patch.grid_units, kNoFeature, material_of(meaning, facts, patch.texture), side};
        Aabb box;
        for (Vec3& p : bent.grid.points_m) {
            p *= units_;
            box.include(p);
        }
        if (std::max({-box.min_m.x, -box.min_m.y, -box.min_m.z, box.max_m.x, box.max_m.y, box.max_m.z}) > kFarthestM) {
            diagnostics_.warn(patch.place, "map.then_left_out", "map.far_patch");
            ++patches_left_out_;
            return;
        }
        if (meaning.structure) {
            Feature curve;
            curve.kind = FeatureKind::Object;
            give_name(curve, "curved surface");
            curve.material = bent.material;
            curve.source = {patch.place.line, index};
            bent.feature = add_feature(curve);
        } else {
            if (!whole) {
                whole = add_feature(meaning.feature);
                scene_.features[whole.value].material = bent.material;
            }
            bent.feature = whole;
        }
        bent_.push_back(std::move(bent));
    }

    // All patches become triangles, coarser ones where they would be too many.
    void bend_patches() {
        if (bent_.empty()) return;
        constexpr std::size_t kMostTriangles = 400'000;
        double chord_m = curve_error_m_;
        for (int round = 0; round < 40; ++round, chord_m *= 2.0) {
            std::size_t all = 0;
            for (const Bent& bent : bent_) all += triangles_of_patch(bent.grid, chord_m);
            if (all <= kMostTriangles) break;
        }
        double error_m = 0.0;
        for (const Bent& bent : bent_) {
            const PatchMesh made = tessellate(bent.grid, chord_m);
            error_m = std::max(error_m, made.error_m);
            Feature& feature = scene_.features[bent.feature.value];
            for (const Corners& t : made.mesh.triangles) {
                const Vec3 &a = made.mesh.points_m[t[0]], &b = made.mesh.points_m[t[1]], &c = made.mesh.points_m[t[2]];
                scene_.triangles.push_back({a, b, c, bent.feature, bent.material, bent.side});
                feature.area_m2 += 0.5 * glm::length(glm::cross(b - a, c - a));
                for (const Vec3& p : {a, b, c}) {
                    feature.bounds_m.include(p);
                    scene_.bounds_m.include(p);
                }
            }
        }
        scene_.report.patches = static_cast<int>(bent_.size());
        scene_.report.simplified.push_back(
            phrase("map.curves_cut",
                   {{"n", bent_.size()}, {"triangles", scene_.triangles.size()}, {"error", in_millimetres(error_m)}, {"bound", in_millimetres(chord_m)}}));
    }

    // ---- materials ----

    static std::string_view guessed_name(const Meaning& meaning, const TextureFacts& facts) {
        return meaning.surface.name.empty() && facts.guess ? facts.guess->name : std::string_view{};
    }

    // Alike or not must not depend on whether guessing is on, or the same map would have other walls when replayed.
    FaceLook look_of(const Meaning& meaning, const TextureFacts& facts) {
        const std::string_view guess = guessed_name(meaning, facts);
        const LookKey key{guess.empty() ? meaning.surface.name : std::string(guess), meaning.look};
        return known_looks_.try_emplace(key, static_cast<FaceLook>(known_looks_.size())).first->second;
    }

    MaterialId material_of(const Meaning& meaning, const TextureFacts& facts, std::string_view texture) {
        Material material = meaning.surface;
        if (const std::string_view guess = guessed_name(meaning, facts); options_.guess_materials && !guess.empty()) {
            material.name = guess;
            material.guessed = true;
            guessed_from_[material.name].insert(lower_ascii(texture.substr(0, 64)));
        }
        if (const MaterialSpec* spec = find_material(material.name)) material.sound = spec->sound;
        return material_id(scene_, material);
    }

    // ---- the whole ----

    // Touching brushes of one kind are one pool.
    void join_volumes() {
        std::vector<Aabb> boxes;
        for (const Volume& volume : volumes_) boxes.push_back(grown(scene_.solids[volume.solid].shape.bounds_m, 1e-3 * units_));
        const BoxIndex index(boxes);
        DisjointSets pools(volumes_.size());
        std::vector<std::uint32_t> near;
        for (std::uint32_t i = 0; i < volumes_.size(); ++i) {
            index.find(boxes[i], near);
            for (const std::uint32_t j : near)
                if (volumes_[i].name == volumes_[j].name) pools.join(i, j);
        }
        for (std::uint32_t i = 0; i < volumes_.size(); ++i) {
            Solid& solid = scene_.solids[volumes_[i].solid];
            if (const std::uint32_t root = pools.find(i); root != i) {
                solid.feature = scene_.solids[volumes_[root].solid].feature;
                continue;
            }
            Feature feature;
            feature.kind = volumes_[i].kind;
            give_name(feature, volumes_[i].name);
            feature.source = solid.source;
            solid.feature = add_feature(feature);
        }
    }

    void name_world() {
        scene_.name = world_name_.empty() ? words_of_name(scene_.source_file) : world_name_;
        scene_.game_map = stated_building_ ? !*stated_building_ : game_things_ && !building_things_;
        if (!saw_worldspawn_) diagnostics_.warn({}, "map.then_what_is_there", "map.no_worldspawn");
    }

    void write_report() {
        ReadReport& report = scene_.report;
        report.brushes += file_.brushes_damaged + file_.primitives;
        for (const auto& [material, textures] : guessed_from_) {
            std::string names;
            int shown = 0;
            for (const std::string& texture : textures)
                if (shown++ < 3) names += (shown > 1 ? ", " : "") + excerpt(texture);
            report.guessed.push_back(phrase("map.guessed", {{"material", spoken_material(material)}, {"n", shown}, {"names", names}, {"more", std::max(0, shown - 3)}}));
        }
        if (dropped_faces_ > 0) report.simplified.push_back(phrase("map.faces_dropped", {{"n", dropped_faces_}}));
        const auto left_out = [&](int count, std::string_view says) {
            if (count > 0) report.left_out.push_back(phrase(says, {{"n", count}}));
        };
        left_out(brushes_left_out_ + file_.brushes_damaged, "map.brushes_left_out");
        left_out(file_.curves_damaged + patches_left_out_, "map.curves_left_out");
        left_out(file_.primitives, "map.forms_left_out");
        left_out(helper_brushes_, "map.helpers_left_out");
        left_out(shapeless_things_, "map.things_left_out");
        if (left_out_cursor_) report.left_out.push_back(phrase("map.cursor_left_out"));
        diagnostics_.move_into(report);
    }

    using LookKey = std::pair<std::string, std::string>;  // material and keys

    const ReadOptions& options_;
    double units_ = 1.0;  // metres per map unit
    Diagnostics diagnostics_;
    MapKeys keys_;
    MapFile file_;
    Scene scene_;
    std::vector<std::vector<FaceLook>> looks_;  // one per solid
    std::vector<Volume> volumes_;
    std::vector<ReadEffect> effects_;
    ReadMovers movers_;
    std::vector<Bent> bent_;
    double curve_error_m_ = 1e-3;
    int patches_left_out_ = 0;
    std::map<std::string_view, TextureFacts> textures_;
    std::map<LookKey, FaceLook> known_looks_;
    std::map<std::string, std::shared_ptr<const HeightPicture>> pictures_;  // null: told already that it cannot be used
    std::map<std::string, std::set<std::string>> guessed_from_;
    std::vector<Plane> planes_;                 // of the brush being built
    std::vector<std::uint32_t> face_of_plane_;  // likewise
    std::string world_name_;
    std::optional<bool> stated_building_;
    bool saw_worldspawn_ = false, game_things_ = false, building_things_ = false, left_out_cursor_ = false;
    int dropped_faces_ = 0, brushes_left_out_ = 0, helper_brushes_ = 0, shapeless_things_ = 0;
};

}  // namespace

Result<Scene> read_quake_map(std::string_view bytes, const std::string& file_name, const ReadOptions& options) {
    if (!std::isfinite(options.map_metres_per_unit) || options.map_metres_per_unit <= 0.0) return fail(phrase("map.unit_size"), file_name);
    return MapSceneBuilder(bytes, file_name, options).build();
}

}  // namespace handrail
