// Turns the entities of a Quake-family .map into a Scene. map_meaning determines what each entity becomes; the code
// here makes solids, curves, sounds and places from them.
#include <algorithm>
#include <cmath>
#include <utility>

#include "worlds/base/contract.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"
#include "worlds/geometry/exposed_surface.h"
#include "worlds/readers/map_bodies.h"
#include "worlds/readers/map_brushes.h"
#include "worlds/readers/map_curves.h"
#include "worlds/readers/map_effects.h"
#include "worlds/readers/map_groups.h"
#include "worlds/readers/map_keys.h"
#include "worlds/readers/map_labyrinth.h"
#include "worlds/readers/map_looks.h"
#include "worlds/readers/map_meaning.h"
#include "worlds/readers/map_movers.h"
#include "worlds/readers/map_prefab.h"
#include "worlds/readers/map_soft.h"
#include "worlds/readers/map_surfaces.h"
#include "worlds/readers/map_syntax.h"
#include "worlds/readers/map_words.h"
#include "worlds/readers/reader.h"
#include "worlds/readers/spoken_text.h"
#include "worlds/scene/primitive.h"
#include "worlds/scene/surfaces.h"

namespace handrail::readers {
namespace {

constexpr double kOriginAboveSolesUnits = 24;  // height of a player's origin above the soles in these maps
constexpr NumberKey kCurveError{"curve_error", 0.01, 100.0, "map.range_millimetres"};
constexpr NumberKey kVolume{"volume", 0.0, 1.0, "map.range"};

class MapSceneBuilder {
public:
    MapSceneBuilder(std::string_view bytes, const std::string& file_name, const ReadOptions& options)
        : options_(options),
          units_(options.map_metres_per_unit),
          diagnostics_(file_name),
          keys_(diagnostics_, units_),
          file_(parse_map(bytes, diagnostics_, options.stop)) {
        scene_.source_file = file_name;
        scene_.metres_per_unit = units_;
        scene_.materials.emplace_back();
        scene_.report.format = "map";
    }

    Result<Scene> build() {
        progress(0.3);
        groups_ = MapGroups(file_);
        scene_.groups = groups_.groups();
        for (std::size_t i = 0; i < file_.entities.size() && !stopped(); ++i)
            read_entity(file_.entities[i], static_cast<int>(i));
        progress(0.5);
        curves_.bend(scene_, curve_error_m_, options_.stop);
        if (stopped()) return fail(phrase("files.stopped"), scene_.source_file);
        if (scene_.solids.empty() && scene_.triangles.empty())
            return nothing_to_touch(diagnostics_, scene_.source_file, "map");
        join_volumes();
        derive_surfaces(scene_, looks_, units_, options_.stop);
        if (stopped()) return fail(phrase("files.stopped"), scene_.source_file);
        progress(0.9);
        choose_base();
        attach_effects(effects_, scene_, diagnostics_);
        name_world();
        attach_movers(movers_, scene_, diagnostics_);
        bodies_.finish(scene_, diagnostics_);
        labyrinth_.attach(scene_, diagnostics_);
        write_report();
        progress(1.0);
        return std::move(scene_);
    }

private:
    // A brush of the building that is a liquid, a teleporter face or a trigger. Touching volumes of the same kind are
    // joined.
    struct Volume {
        std::size_t solid = 0;
        FeatureKind kind = FeatureKind::Liquid;
        std::string_view name;
    };

    bool stopped() const { return options_.stop.stop_requested(); }
    void progress(double fraction) const {
        if (options_.progress) options_.progress(fraction);
    }

    // ---- entities ----

    void read_entity(const MapEntity& entity, int index) {
        const std::string class_name = lower_ascii(entity.value("classname").substr(0, 64));
        const bool world = class_name == "worldspawn";
        if (world) {
            saw_worldspawn_ = true;
            if (const auto error = keys_.number_of(entity, kCurveError)) curve_error_m_ = *error * 1e-3;
            labyrinth_.note_world(entity, keys_);
        }
        note_kind_of_map(entity, class_name);
        if (class_name.empty() && !entity.keys.empty())
            diagnostics_.warn(entity.place, entity.brushes.empty() ? "map.then_left_out" : "map.then_part_of_building",
                              "map.no_classname");
        if (class_name == "misc_external_map" || class_name == "func_instance" || class_name == "misc_prefab" ||
            entity.find("_external_map"))
            diagnostics_.warn(entity.place, "map.then_missing", "map.other_file");
        if (class_name.starts_with("info_player_")) read_start(entity, class_name, index);
        if (class_name.starts_with("func_door")) ++scene_.report.doors;
        note_name(movers_, entity);
        // A rubber string can be tied to a named entity with an origin, so its place is stored.
        if (const MapKey* name = entity.find("targetname"); name && entity.find("origin"))
            if (const std::optional<Vec3> origin = keys_.vector_of(entity, "origin"))
                bodies_.note_point(std::string(trimmed(name->value)), *origin * units_);
        if (class_name == "info_teleport_destination") read_destination(entity);
        if (class_name == "path_corner") {
            note_corner(movers_, entity, keys_);
            return;
        }
        if (class_name == "info_room") {
            read_room_name(entity);
            return;
        }
        if (entity.value("cs_name") == "PHANTOM" || entity.value("name") == "PHANTOM") {
            left_out_cursor_ = true;
            for (const MapBrush& brush : entity.brushes)
                if (!stopped()) brushes_.counted_solid_of(brush);
            return;
        }
        if (class_name == "haptic_effect") {
            add_effects(entity, index);
            return;
        }
        if (labyrinth_.take_place(entity, class_name, index, [this](const MapBrush& brush) { return unseen(brush); }))
            return;
        read_sound(entity, class_name);
        if (world) {
            for (const std::string_view key : {"name", "message"})
                if (world_name_.empty()) {
                    world_name_ = text_of(entity, key);
                    scene_.name_in = texts_in(entity, key);
                }
        }
        if (entity.find("prefab")) read_prefab(entity, class_name, index);
        else if (!entity.brushes.empty() || !entity.patches.empty()) read_brushes(entity, class_name, index);
        else if (!world && !class_name.empty() && !class_name.starts_with("info_player_") &&
                 class_name.find("light") != 0 && !class_name.starts_with("ambient_") && !is_particles(class_name) &&
                 class_name != "target_speaker" && class_name != "info_notnull")  // info_notnull is only a position
            ++shapeless_things_;
    }

    // Reads a piece of furniture. If the map gives it no name, it is named after its kind.
    void read_prefab(const MapEntity& entity, const std::string& class_name, int index) {
        const Prefab* prefab = prefab_of(entity, diagnostics_);
        const std::optional<Vec3> origin = prefab ? keys_.vector_of(entity, "origin") : std::nullopt;
        if (origin)
            read_brushes(with_prefab(entity, *prefab, *origin, heading_of(entity), units_), class_name, index,
                         prefab->name);
        else if (!entity.brushes.empty() || !entity.patches.empty()) read_brushes(entity, class_name, index);
    }

    // Returns the brush's solid for entities that are only places. The brush is counted, but can be neither touched nor
    // seen.
    BuiltSolid unseen(const MapBrush& brush) {
        BuiltSolid solid = brushes_.solid_of(brush, false);
        brushes_.count(solid);
        return solid;
    }

    void add_effects(const MapEntity& entity, int index) {
        const auto built = [this](const MapBrush& brush) { return unseen(brush); };
        for (ReadEffect& effect : read_effects(entity, index, text_of(entity, "name"), units_, built, diagnostics_))
            effects_.push_back(std::move(effect));
    }

    void note_kind_of_map(const MapEntity& entity, const std::string& class_name) {
        for (const std::string_view start :
             {"info_player_deathmatch", "info_player_coop", "info_intermission", "monster_", "item_", "weapon_",
              "light", "ambient_", "trigger_changelevel"})
            if (class_name.starts_with(start)) game_things_ = true;
        if (class_name == "thing" || entity.find("cs_name")) building_things_ = true;
        if (class_name != "worldspawn") return;
        if (entity.find("wad") || entity.find("worldtype")) game_things_ = true;
        if (entity.find("building")) stated_building_ = keys_.yes_no_of(entity, "building");
    }

    // Returns the heading in radians clockwise from north, from 0 to 2 pi.
    double heading_of(const MapEntity& entity) {
        double angle_deg = 0.0;
        if (entity.find("angle"))
            angle_deg = keys_.number_of(entity, "angle", -1e6, 1e6, "map.range_angle").value_or(0.0);
        else if (const std::optional<Vec3> angles =
                     keys_.vector_of(entity, entity.find("angles") ? "angles" : "mangle"))
            angle_deg = angles->y;
        // The values -1 and -2 mean up and down, so they give no heading.
        if (angle_deg == -1.0 || angle_deg == -2.0) angle_deg = 0.0;
        const double heading = std::remainder(radians_from_degrees(90.0 - angle_deg), 2.0 * kPi);
        return heading < 0.0 ? heading + 2.0 * kPi : heading;
    }

    void read_start(const MapEntity& entity, const std::string& class_name, int index) {
        ++scene_.report.starts;
        const std::optional<Vec3> origin = keys_.vector_of(entity, "origin");
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

    // Reads a place that teleporters lead to. It is like a start, but no walk starts there.
    void read_destination(const MapEntity& entity) {
        if (const std::optional<Vec3> origin = keys_.vector_of(entity, "origin"))
            note_destination(movers_, entity, (*origin - Vec3{0.0, 0.0, kOriginAboveSolesUnits}) * units_,
                             heading_of(entity));
    }

    // Reads a place in a room and the name of that room.
    void read_room_name(const MapEntity& entity) {
        const std::optional<Vec3> origin = keys_.vector_of(entity, "origin");
        std::string name = text_of(entity, "name");
        if (origin && !name.empty())
            scene_.room_names.push_back({*origin * units_, std::move(name), texts_in(entity, "name")});
        else diagnostics_.warn(entity.place, "map.then_left_out", "map.room_nowhere");
    }

    void choose_base() {
        if (scene_.starts.empty()) return;
        const auto first =
            std::find_if(scene_.starts.begin(), scene_.starts.end(), [](const Start& start) { return start.base; });
        const auto chosen = first == scene_.starts.end() ? scene_.starts.begin() : first;
        for (auto start = scene_.starts.begin(); start != scene_.starts.end(); ++start) {
            start->base = start == chosen;
            if (start->name.empty()) start->name = phrase(start->base ? "map.base" : "map.other_start");
        }
    }

    void read_sound(const MapEntity& entity, const std::string& class_name) {
        const bool ambient = class_name.starts_with("ambient_");
        std::string sound = text_of(entity, "sound");
        // The editors of other games write the name of the sound file under these keys.
        if (sound.empty() && class_name == "ambient_generic") sound = text_of(entity, "message");
        if (sound.empty() && class_name == "target_speaker") sound = text_of(entity, "noise");
        if (!ambient && sound.empty() && !is_particles(class_name)) return;
        SoundSource source;
        source.sound = sound.empty() ? class_name : sound;
        source.name = text_of(entity, "name");
        source.name_in = texts_in(entity, "name");
        if (source.name.empty() && sound.empty()) {
            source.name = sound_of_class(class_name);
            source.made_name = !source.name.empty();
        }
        if (source.name.empty())
            source.name = words_of_name(ambient && sound.empty() ? std::string_view(class_name).substr(8)
                                                                 : std::string_view(source.sound));
        source.loudness = keys_.number_of(entity, kVolume).value_or(1.0);
        if (const std::optional<Vec3> origin = keys_.vector_of(entity, "origin")) {
            source.position_m = *origin * units_;
        } else {
            Aabb box;
            for (const MapBrush& brush : entity.brushes)
                if (const BuiltSolid built = brushes_.solid_of(brush, false); built.fault == SolidFault::None)
                    box.include(built.solid.bounds_m);
            if (box.empty()) return;
            source.position_m = box.centre_m();
        }
        scene_.sounds.push_back(std::move(source));
    }

    // ---- brushes ----

    // Reads an exact shape in the box around all brushes of the entity. If sizes that should be equal differ, the
    // smallest is used, so that the shape stays within the box.
    FeatureId read_exact(const MapEntity& entity, const MapMeaning& meaning, int index) {
        Aabb box;
        const MapBrush* first = nullptr;
        for (const MapBrush& brush : entity.brushes) {
            if (stopped()) break;
            const BuiltSolid built = brushes_.counted_solid_of(brush);
            if (built.fault != SolidFault::None) continue;
            if (brushes_.sense_of(brush) == TextureSense::LeftOut) {
                ++helper_brushes_;
                continue;
            }
            if (!first) first = &brush;
            box.include(built.solid.bounds_m);
        }
        if (!first) return kNoFeature;
        constexpr double kAgree = 1.05;
        const MapKeys::AxisTurn axis = *meaning.exact == PrimitiveKind::Box || *meaning.exact == PrimitiveKind::Sphere
                                           ? MapKeys::AxisTurn{}
                                           : keys_.axis_of(entity);
        Primitive primitive{*meaning.exact, box.size_m(), Vec3(1.0), {box.centre_m(), axis.turn}};
        Vec3& size = primitive.size_m;
        if (primitive.kind != PrimitiveKind::Box) {
            const double length = size[axis.axis], across = size[(axis.axis + 1) % 3], deep = size[(axis.axis + 2) % 3];
            const bool sphere = primitive.kind == PrimitiveKind::Sphere;
            const double least = std::min(std::min(across, deep), sphere ? length : across),
                         most = std::max(std::max(across, deep), sphere ? length : across);
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
        const TextureFacts& facts = brushes_.facts_of(first->faces.front().texture);
        const Result<Solid> made =
            make_solid(primitive, looks_of_.material_of(scene_, meaning, facts, first->faces.front().texture));
        if (!made) {
            diagnostics_.pass_on(entity.place, "map.then_left_out", made.error().message);
            brushes_.leave_out();
            return kNoFeature;
        }
        Solid solid = *made;
        solid.role = meaning.role;
        solid.group = groups_.group_of(entity);
        solid.source = {first->place.line, index};
        solid.feature = add_feature(meaning.feature);
        scene_.features[solid.feature.value].bounds_m = solid.shape.bounds_m;
        scene_.bounds_m.include(box);
        if (solid.role == SolidRole::Mover) ++scene_.report.movers;
        looks_.emplace_back(solid.shape.planes.size(), looks_of_.look_of(meaning, facts));
        const FeatureId thing = solid.feature;
        scene_.solids.push_back(std::move(solid));
        return thing;
    }

    // The role and volume that a brush has because of its texture, in addition to the meaning of its entity.
    struct BrushSense {
        SolidRole role = SolidRole::Solid;
        FeatureKind kind = FeatureKind::Liquid;  // kind of the volume
        std::string_view volume;                 // name of the volume; empty: no volume
    };
    // Returns the role and volume of the brush. Empty for brushes that only editors need and nobody can touch.
    std::optional<BrushSense> sense_of(const MapBrush& brush, const MapMeaning& meaning) {
        if (meaning.role == SolidRole::Trigger || meaning.role == SolidRole::Illusion || meaning.liquid)
            return BrushSense{meaning.role, FeatureKind::Liquid, {}};
        switch (brushes_.sense_of(brush)) {
            case TextureSense::Water:
                return BrushSense{SolidRole::Liquid, FeatureKind::Liquid, "water"};
            case TextureSense::Slime:
                return BrushSense{SolidRole::Liquid, FeatureKind::Liquid, "slime"};
            case TextureSense::Lava:
                return BrushSense{SolidRole::Liquid, FeatureKind::Liquid, "lava"};
            case TextureSense::Teleport:
                return BrushSense{SolidRole::Teleport, FeatureKind::Teleport, "teleporter"};
            case TextureSense::Trigger:
                return BrushSense{SolidRole::Trigger, FeatureKind::Trigger, "marked place"};
            case TextureSense::Clip:
                return BrushSense{SolidRole::BodyClip, FeatureKind::Liquid, {}};
            case TextureSense::LeftOut:
                return std::nullopt;
            case TextureSense::Ordinary:
                break;
        }
        return BrushSense{meaning.role, FeatureKind::Liquid, {}};
    }

    // The features that have been made from an entity's brushes up to now.
    struct Made {
        FeatureId whole = kNoFeature;
        bool moves = false;
        std::uint32_t group = kNoGroup;
        std::optional<Vec3> origin_units;  // the point about which the entity turns
    };

    // Reads the brushes of an entity. `called` is the name of the entity's kind, used if the map gives no name.
    void read_brushes(const MapEntity& entity, const std::string& class_name, int index, std::string_view called = {}) {
        MapMeaning meaning = meanings_.read(entity, class_name, index);
        if (!called.empty() && entity.value("name").empty()) give_name(meaning.feature, called);
        if (!called.empty()) meaning.structure = false;
        const TouchSide side = touch_side_of(entity);
        // A single brush is kept if a box was requested, because it may be a rotated box.
        if (meaning.exact && !entity.brushes.empty() &&
            (*meaning.exact != PrimitiveKind::Box || entity.brushes.size() > 1)) {
            FeatureId thing = read_exact(entity, meaning, index);
            for (const MapPatch& patch : entity.patches) read_patch(patch, meaning, index, thing, side);
            if (thing && meaning.body) bodies_.add(scene_, *meaning.body, thing, entity.place, diagnostics_);
            note_role(entity, thing);
            return;
        }
        Made made;
        made.group = groups_.group_of(entity);
        for (const MapBrush& brush : entity.brushes) {
            if (stopped()) return;
            read_brush(brush, meaning, index, made);
        }
        for (const MapPatch& patch : entity.patches) read_patch(patch, meaning, index, made.whole, side);
        if (made.moves) ++scene_.report.movers;
        if (made.whole && meaning.body) bodies_.add(scene_, *meaning.body, made.whole, entity.place, diagnostics_);
        else if (made.moves) note_mover(movers_, entity, class_name, made.whole, keys_, made.origin_units);
        note_role(entity, made.whole);
        if (!made.whole) return;
        if (meaning.role == SolidRole::Trigger) note_switch(movers_, entity, class_name, made.whole);
        Feature& feature = scene_.features[made.whole.value];
        const Vec3 size = feature.bounds_m.size_m();
        if (feature.kind == FeatureKind::Door && feature.name == "door" && size.z < 0.5 * std::min(size.x, size.y))
            feature.name = "sliding floor";  // the mover is lower than it is wide, so it is a bridge or trapdoor
    }

    void read_brush(const MapBrush& brush, const MapMeaning& meaning, int index, Made& made) {
        BuiltSolid built = brushes_.counted_solid_of(brush);
        if (built.fault != SolidFault::None) return;
        const std::optional<BrushSense> sense = sense_of(brush, meaning);
        if (!sense) {
            ++helper_brushes_;
            if (lower_ascii(brush.faces.front().texture) == "origin")
                made.origin_units = built.solid.bounds_m.centre_m() / units_;
            return;
        }
        if (repeats(brush, built, *sense, meaning, index)) return;
        Solid solid;
        solid.role = sense->role;
        solid.group = made.group;
        solid.edge_rounding_hand_m = meaning.edge_rounding_hand_m;
        solid.source = {brush.place.line, index};
        const bool touchable = solid.role == SolidRole::Solid || solid.role == SolidRole::Mover;
        if (solid.role == SolidRole::Liquid) {
            ++scene_.report.liquids;
            solid.viscosity_ns_per_m = meaning.viscosity_ns_per_m;
            solid.buoyancy_n = meaning.buoyancy_n;
            solid.film_n = meaning.film_n;
            solid.flow_hand_m_per_s = meaning.flow_hand_m_per_s;
        }
        made.moves = made.moves || solid.role == SolidRole::Mover;
        if (touchable) scene_.bounds_m.include(built.solid.bounds_m);
        if (!meaning.structure) solid.feature = part_of_whole(made, meaning, built.solid.bounds_m, *sense);
        else if (!sense->volume.empty()) volumes_.push_back({scene_.solids.size(), sense->kind, sense->volume});
        std::vector<FaceLook>& looks = looks_.emplace_back();
        for (const std::uint32_t plane : built.plane_index) {
            const std::string_view texture = brush.faces[brushes_.face_of_plane(plane)].texture;
            const TextureFacts& facts = brushes_.facts_of(texture);
            solid.face_materials.push_back(touchable ? looks_of_.material_of(scene_, meaning, facts, texture)
                                                     : kDefaultMaterial);
            looks.push_back(facts.sky ? kSkyLook : looks_of_.look_of(meaning, facts));
        }
        solid.shape = std::move(built.solid);
        if (meaning.soft && touchable)
            solid.soft = soft_face_of(*meaning.soft, solid.shape, spoken_name(meaning.feature), diagnostics_);
        scene_.solids.push_back(std::move(solid));
    }

    // True if the brush repeats an earlier one and is therefore left out. If an author copied a brush twice by mistake,
    // a hand feels only one anyway, and thousands at one place would cost time.
    bool repeats(const MapBrush& brush, const BuiltSolid& built, const BrushSense& sense, const MapMeaning& meaning,
                 int index) {
        if (sense.role != SolidRole::Solid || meaning.soft) return false;
        const int line =
            brushes_.repeats(built, meaning.structure ? 0U : 1U + static_cast<std::uint32_t>(index), brush.place.line);
        if (line <= 0) return false;
        ++repeated_brushes_;
        diagnostics_.warn(brush.place, "map.then_left_out", "map.repeated_brush", {{"line", line}});
        return true;
    }

    // Returns the feature for all brushes of an entity. Without a name in the map, it is named after the volume.
    FeatureId part_of_whole(Made& made, const MapMeaning& meaning, const Aabb& bounds_m, const BrushSense& sense) {
        if (!made.whole) made.whole = add_feature(meaning.feature);
        Feature& feature = scene_.features[made.whole.value];
        feature.bounds_m.include(bounds_m);
        if (feature.name.empty() && !sense.volume.empty()) {
            give_name(feature, sense.volume);
            feature.kind = sense.kind;
        }
        return made.whole;
    }

    void note_role(const MapEntity& entity, FeatureId feature) {
        const bool free = std::any_of(scene_.bodies.begin(), scene_.bodies.end(),
                                      [&](const FreeBody& body) { return body.feature == feature; });
        labyrinth_.note_role(entity, feature, free, diagnostics_);
    }

    FeatureId add_feature(Feature feature) {
        scene_.features.push_back(std::move(feature));
        return {static_cast<std::uint32_t>(scene_.features.size() - 1)};
    }

    // ---- curved patches ----

    // Returns the side from which an entity's patches can be touched. The key does not apply to brushes, because they
    // have an inside.
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

    // Reads a patch of an entity for MapCurves. `whole` is the entity's feature; if the entity has only patches, the
    // feature is made here.
    void read_patch(const MapPatch& patch, const MapMeaning& meaning, int index, FeatureId& whole, TouchSide side) {
        const TextureFacts& facts = brushes_.facts_of(patch.texture);
        if ((meaning.role != SolidRole::Solid && meaning.role != SolidRole::Mover) ||
            facts.sense != TextureSense::Ordinary) {
            curves_.leave_out();
            return;
        }
        MapCurve bent{patch.grid_units, kNoFeature, looks_of_.material_of(scene_, meaning, facts, patch.texture), side};
        Aabb box;
        for (Vec3& p : bent.grid.points_m) {
            p *= units_;
            box.include(p);
        }
        if (std::max({-box.min_m.x, -box.min_m.y, -box.min_m.z, box.max_m.x, box.max_m.y, box.max_m.z}) > kFarthestM) {
            diagnostics_.warn(patch.place, "map.then_left_out", "map.far_patch");
            curves_.leave_out();
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
        curves_.add(std::move(bent));
    }

    // ---- whole scene ----

    // Joins touching volume brushes of the same kind into one volume, for example one pool.
    void join_volumes() {
        std::vector<Aabb> boxes;
        for (const Volume& volume : volumes_)
            boxes.push_back(grown(scene_.solids[volume.solid].shape.bounds_m, 1e-3 * units_));
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
        looks_of_.report_guesses(report);
        if (brushes_.dropped_faces() > 0)
            report.simplified.push_back(phrase("map.faces_dropped", {{"n", brushes_.dropped_faces()}}));
        const auto left_out = [&](int count, std::string_view says) {
            if (count > 0) report.left_out.push_back(phrase(says, {{"n", count}}));
        };
        left_out(brushes_.left_out() + file_.brushes_damaged, "map.brushes_left_out");
        left_out(file_.curves_damaged + curves_.left_out(), "map.curves_left_out");
        left_out(file_.primitives, "map.forms_left_out");
        left_out(helper_brushes_, "map.helpers_left_out");
        left_out(repeated_brushes_, "map.repeated_left_out");
        left_out(shapeless_things_, "map.things_left_out");
        if (left_out_cursor_) report.left_out.push_back(phrase("map.cursor_left_out"));
        diagnostics_.move_into(report);
    }

    const ReadOptions& options_;
    double units_ = 1.0;  // metres per map unit
    Diagnostics diagnostics_;
    MapKeys keys_;
    MapFile file_;
    Scene scene_;
    MapBrushes brushes_{units_, diagnostics_, scene_.report};
    MapSurfaces surfaces_{options_, units_, diagnostics_, keys_,
                          [this](const MapBrush& brush) { return brushes_.solid_of(brush, false); }};
    MapMeanings meanings_{units_, diagnostics_, keys_, surfaces_};
    MapCurves curves_;
    MapLooks looks_of_{options_.guess_materials};
    std::vector<std::vector<FaceLook>> looks_;  // looks of the faces, for each solid
    std::vector<Volume> volumes_;
    std::vector<ReadEffect> effects_;
    ReadMovers movers_;
    MapBodies bodies_;
    MapLabyrinth labyrinth_;
    MapGroups groups_;
    double curve_error_m_ = 1e-3;
    std::string world_name_;
    std::optional<bool> stated_building_;
    bool saw_worldspawn_ = false, game_things_ = false, building_things_ = false, left_out_cursor_ = false;
    int helper_brushes_ = 0, shapeless_things_ = 0, repeated_brushes_ = 0;
};

}  // namespace

Result<Scene> read_quake_map(std::string_view bytes, const std::string& file_name, const ReadOptions& options) {
    contract_pre(options.map_metres_per_unit > 0.0 && std::isfinite(options.map_metres_per_unit));
    if (!std::isfinite(options.map_metres_per_unit) || options.map_metres_per_unit <= 0.0)
        return fail(phrase("map.unit_size"), file_name);
    return MapSceneBuilder(bytes, file_name, options).build();
}

}  // namespace handrail::readers
