#include "worlds/stored/stored_scene.h"

#include "worlds/cache/sha256.h"
#include "worlds/scene/stated_building.h"
#include "worlds/stored/archive.h"
#include "worlds/stored/stored_basics.h"

namespace handrail::stored {

// Each fields() names all members, so the code does not compile if a new member is missing here.

template <>
inline constexpr int kLastOf<FeatureKind> = static_cast<int>(FeatureKind::Teleport);
template <>
inline constexpr int kLastOf<SolidRole> = static_cast<int>(SolidRole::Illusion);
template <>
inline constexpr int kLastOf<TouchSide> = static_cast<int>(TouchSide::Back);
template <>
inline constexpr int kLastOf<SoundClass> = static_cast<int>(SoundClass::Generic);
template <>
inline constexpr int kLastOf<WaveShape> = static_cast<int>(WaveShape::Square);
template <>
inline constexpr int kLastOf<EffectKind> = static_cast<int>(EffectKind::Vibration);
template <>
inline constexpr int kLastOf<MagnetPull> = static_cast<int>(MagnetPull::Object);
template <>
inline constexpr int kLastOf<StatedPortalKind> = static_cast<int>(StatedPortalKind::Lift);
template <>
inline constexpr int kLastOf<Severity> = static_cast<int>(Severity::Error);

template <class A, Is<SourcePlace> T>
void fields(A& a, T& v) {
    auto& [line, entity] = v;
    a(line, entity);
}
template <class A, Is<Diagnostic> T>
void fields(A& a, T& v) {
    auto& [severity, file, line, column, message, action] = v;
    a(severity, file, line, column, message, action);
}
template <class A, Is<Plane> T>
void fields(A& a, T& v) {
    auto& [normal, offset] = v;
    a(normal, offset);
}
template <class A, Is<Polygon> T>
void fields(A& a, T& v) {
    auto& [points] = v;
    a(points);
}
template <class A, Is<ConvexSolid> T>
void fields(A& a, T& v) {
    auto& [planes, faces, bounds] = v;
    a(planes, faces, bounds);
}
template <class A, Is<SphereShape> T>
void fields(A& a, T& v) {
    auto& [centre, radius] = v;
    a(centre, radius);
}
template <class A, Is<CapsuleShape> T>
void fields(A& a, T& v) {
    auto& [start, axis, length, radius] = v;
    a(start, axis, length, radius);
}
template <class A, Is<CylinderShape> T>
void fields(A& a, T& v) {
    auto& [bottom, axis, height, radius] = v;
    a(bottom, axis, height, radius);
}
template <class A, Is<ConeShape> T>
void fields(A& a, T& v) {
    auto& [base, axis, height, radius, slant_out, slant_up] = v;
    a(base, axis, height, radius, slant_out, slant_up);
}
template <class A, Is<Rotation> T>
void fields(A& a, T& v) {
    auto& [w, x, y, z] = v;
    a(w, x, y, z);
}
template <class A, Is<Placement> T>
void fields(A& a, T& v) {
    auto& [position, rotation, scale] = v;
    a(position, rotation, scale);
}
template <class A, Is<TextureWave> T>
void fields(A& a, T& v) {
    auto& [shape, depth, period, share, turn] = v;
    a(shape, depth, period, share, turn);
}
template <class A, Is<HeightPicture> T>
void fields(A& a, T& v) {
    auto& [width, height, depths] = v;
    a(width, height, depths);
}
template <class A, Is<TexturePicture> T>
void fields(A& a, T& v) {
    auto& [heights, depth, size, turn, box] = v;
    a(heights, depth, size, turn, box);
}
template <class A, Is<Material> T>
void fields(A& a, T& v) {
    auto& [name, sound, guessed, stiffness, friction, friction_static, damping, wave, picture] = v;
    a(name, sound, guessed, stiffness, friction, friction_static, damping, wave, picture);
}
template <class A, Is<Feature> T>
void fields(A& a, T& v) {
    auto& [kind, name, name_in, made_name, material, normal, bounds, area, landmark, clue, base, message, message_in,
           made_message, hinge, handle, source] = v;
    a(kind, name, name_in, made_name, material, normal, bounds, area, landmark, clue, base, message, message_in,
      made_message, hinge, handle, source);
}
template <class A, Is<SoftFace> T>
void fields(A& a, T& v) {
    auto& [face, plastic, depth, stiffness, recovery, yields] = v;
    auto packed_face = static_cast<std::uint32_t>(face);
    a(packed_face);
    if constexpr (A::kReads) face = packed_face;
    a(plastic, depth, stiffness, recovery, yields);
}
template <class A, Is<Solid> T>
void fields(A& a, T& v) {
    auto& [shape, role, round, feature, face_features, face_materials, face_hidden, viscosity, buoyancy, film, flow,
           soft, rounding, group, source] = v;
    a(shape, role, round, feature, face_features, face_materials, face_hidden, viscosity, buoyancy, film, flow, soft,
      rounding, group, source);
}
template <class A, Is<Group> T>
void fields(A& a, T& v) {
    auto& [name, inside, hidden] = v;
    a(name, inside, hidden);
}
template <class A, Is<MeshTriangle> T>
void fields(A& a, T& v) {
    auto& [p, q, r, feature, material, side] = v;
    a(p, q, r, feature, material, side);
}
template <class A, Is<SurfacePolygon> T>
void fields(A& a, T& v) {
    auto& [polygon, normal, feature, material, role] = v;
    a(polygon, normal, feature, material, role);
}
template <class A, Is<Start> T>
void fields(A& a, T& v) {
    auto& [feet, heading, base, name, source] = v;
    a(feet, heading, base, name, source);
}
template <class A, Is<SoundSource> T>
void fields(A& a, T& v) {
    auto& [position, name, sound, loudness, name_in, made_name] = v;
    a(position, name, sound, loudness, name_in, made_name);
}
template <class A, Is<RoomName> T>
void fields(A& a, T& v) {
    auto& [at, name, name_in] = v;
    a(at, name, name_in);
}
template <class A, Is<PlacedModel> T>
void fields(A& a, T& v) {
    auto& [feature, model, material, at] = v;
    a(feature, model, material, at);
}
template <class A, Is<EffectBall> T>
void fields(A& a, T& v) {
    auto& [centre, radius] = v;
    a(centre, radius);
}
template <class A, Is<EffectCapsule> T>
void fields(A& a, T& v) {
    auto& [from, to, radius] = v;
    a(from, to, radius);
}
template <class A, Is<Effect> T>
void fields(A& a, T& v) {
    auto& [kind, where, name, strength, width, edge, direction, frequency, mass, pull, belongs_to, source] = v;
    a(kind, where, name, strength, width, edge, direction, frequency, mass, pull, belongs_to, source);
}
template <class A, Is<TrainStop> T>
void fields(A& a, T& v) {
    auto& [at, wait] = v;
    a(at, wait);
}
template <class A, Is<Mover> T>
void fields(A& a, T& v) {
    auto& [feature, slide, swing, pivot, travel, wait, rests_far, by_hand, approach, group, sets_going, passes, halts,
           lift, lift_part, sends_to, stops, after_last, speed, turn, turn_axis, starts_going] = v;
    a(feature, slide, swing, pivot, travel, wait, rests_far, by_hand, approach, group, sets_going, passes, halts, lift,
      lift_part, sends_to, stops, after_last, speed, turn, turn_axis, starts_going);
}
template <class A, Is<Switch> T>
void fields(A& a, T& v) {
    auto& [volume, sets_going, once, leads_elsewhere, feet, heading] = v;
    a(volume, sets_going, once, leads_elsewhere, feet, heading);
}
template <class A, Is<LabyrinthPlan::Place> T>
void fields(A& a, T& v) {
    auto& [box, source] = v;
    a(box, source);
}
template <class A, Is<LabyrinthPlan> T>
void fields(A& a, T& v) {
    auto& [level, ball, holes, goals, planks, blocks, borders] = v;
    a(level, ball, holes, goals, planks, blocks, borders);
}
template <class A, Is<FreeBody> T>
void fields(A& a, T& v) {
    auto& [feature, mass, friction, friction_static, elasticity, rolling, string_at, string, by_density, source] = v;
    a(feature, mass, friction, friction_static, elasticity, rolling, string_at, string, by_density, source);
}
template <class A, Is<StatedStorey> T>
void fields(A& a, T& v) {
    auto& [name, floor, rooms] = v;
    a(name, floor, rooms);
}
template <class A, Is<StatedRoom> T>
void fields(A& a, T& v) {
    auto& [name, number, guid, part, storey, rings, floor, height, at, area, holds_stairs, is_way, source] = v;
    a(name, number, guid, part, storey, rings, floor, height, at, area, holds_stairs, is_way, source);
}
template <class A, Is<StatedPortal> T>
void fields(A& a, T& v) {
    auto& [kind, name, guid, feature, rooms, place, width, height, by_boundaries, outside, opened_by_box, passable, why,
           in_the_way, step, source] = v;
    a(kind, name, guid, feature, rooms, place, width, height, by_boundaries, outside, opened_by_box, passable, why,
      in_the_way, step, source);
}
template <class A, Is<MissingPart> T>
void fields(A& a, T& v) {
    auto& [name, guid, storey, reason, detail, share, at, source] = v;
    a(name, guid, storey, reason, detail, share, at, source);
}
template <class A, Is<StatedThing> T>
void fields(A& a, T& v) {
    auto& [feature, bounds] = v;
    a(feature, bounds);
}
template <class A, Is<StatedBuilding> T>
void fields(A& a, T& v) {
    auto& [schema, storeys, rooms, portals, missing, wall, windows, furnishings, openings, openings_cut, stairs, ramps,
           lifts, escalators, walkways, skipped] = v;
    a(schema, storeys, rooms, portals, missing, wall, windows, furnishings, openings, openings_cut, stairs, ramps,
      lifts, escalators, walkways, skipped);
}
template <class A, Is<ReadReport> T>
void fields(A& a, T& v) {
    auto& [format, brushes, polygons, polygons_kept, polygons_hidden, triangles, liquids, movers, doors, starts,
           patches, guessed, simplified, left_out, warnings, warnings_in_all] = v;
    a(format, brushes, polygons, polygons_kept, polygons_hidden, triangles, liquids, movers, doors, starts, patches,
      guessed, simplified, left_out, warnings, warnings_in_all);
}
// Packs the whole scene except the report about reading it.
template <class A, Is<Scene> T>
void all_but_report(A& a, T& v) {
    auto& [name, name_in, source_file, game_map, metres_per_unit, bounds, materials, features, solids, triangles,
           placed, surfaces, starts, sounds, room_names, effects, movers, labyrinth, bodies, switches, groups, stated,
           report] = v;
    a(name, name_in, source_file, game_map, metres_per_unit, bounds, materials, features, solids, triangles, placed,
      surfaces, starts, sounds, room_names, effects, movers, labyrinth, bodies, switches, groups, stated);
}
template <class A, Is<Scene> T>
void fields(A& a, T& v) {
    all_but_report(a, v);
    a(v.report);
}

namespace {

bool is_known(const Scene& scene, FeatureId id) { return !id || id.value < scene.features.size(); }

bool are_movers(const Scene& scene, const std::vector<std::uint32_t>& places) {
    return std::all_of(places.begin(), places.end(), [&](std::uint32_t p) { return p < scene.movers.size(); });
}

bool is_whole(const Scene& scene, const Mover& mover) {
    return is_known(scene, mover.feature) && are_movers(scene, mover.sets_going) &&
           (mover.lift == kNoMover || mover.lift < scene.movers.size());
}

bool is_whole(const HeightPicture* heights) {
    return heights && heights->width >= 1 && heights->height >= 1 &&
           heights->depths.size() ==
               static_cast<std::size_t>(heights->width) * static_cast<std::size_t>(heights->height);
}

bool is_whole(const Scene& scene, const LabyrinthPlan& game) {
    const auto all_known = [&](const std::vector<FeatureId>& ids) {
        return std::all_of(ids.begin(), ids.end(), [&](FeatureId id) { return is_known(scene, id); });
    };
    return is_known(scene, game.ball) && all_known(game.planks) && all_known(game.blocks) && all_known(game.borders);
}

bool is_whole(const Scene& scene, const StatedBuilding& stated) {
    for (const StatedRoom& room : stated.rooms)
        if (room.storey != kNotStated && room.storey >= stated.storeys.size()) return false;
    for (const std::vector<StatedThing>* things : {&stated.windows, &stated.furnishings})
        for (const StatedThing& thing : *things)
            if (!is_known(scene, thing.feature)) return false;
    for (const StatedPortal& portal : stated.portals) {
        if (!is_known(scene, portal.feature)) return false;
        for (const std::uint32_t room : portal.rooms)
            if (room >= stated.rooms.size()) return false;
    }
    return true;
}

// Returns true if the scene passes the checks that validate() leaves out because readers cannot violate them.
bool holds_together(const Scene& scene) {
    for (const Solid& solid : scene.solids)
        if (solid.soft && solid.soft->face >= solid.shape.planes.size()) return false;
    for (const Solid& solid : scene.solids)
        if (solid.group != kNoGroup && solid.group >= scene.groups.size()) return false;
    for (std::size_t i = 0; i < scene.groups.size(); ++i)
        if (scene.groups[i].inside != kNoGroup && scene.groups[i].inside >= i) return false;
    for (const Mover& mover : scene.movers)
        if (!is_whole(scene, mover)) return false;
    for (const Switch& one : scene.switches)
        if (!is_known(scene, one.volume) || !are_movers(scene, one.sets_going)) return false;
    for (const Effect& effect : scene.effects)
        if (!is_known(scene, effect.belongs_to)) return false;
    for (const Material& material : scene.materials)
        if (material.picture && !is_whole(material.picture->heights.get())) return false;
    if (!is_whole(scene, scene.labyrinth) || scene.bodies.size() > FreeBody::kMost) return false;
    for (const PlacedModel& placed : scene.placed)
        if (!placed.model || !validate(*placed.model) || !holds_together(*placed.model)) return false;
    return !scene.stated || is_whole(scene, *scene.stated);
}

}  // namespace

std::string stored(const Scene& scene) {
    Packer pack;
    pack(scene);
    return pack.take();
}

Result<Scene> scene_from(std::string_view bytes) {
    Unpacker unpack(bytes);
    Scene scene;
    unpack(scene);
    if (!unpack.good() || !unpack.rest().empty()) return fail(phrase("import.damaged"));
    if (const Result<void> valid = validate(scene); !valid) return tl::unexpected(valid.error());
    if (!holds_together(scene)) return fail(phrase("import.damaged"));
    return scene;
}

std::string sum_of(const Scene& scene) {
    cache::Sha256 sum;
    Packer pack([&](std::string_view bytes) { sum.add(bytes); });
    all_but_report(pack, scene);
    sum.add(pack.take());
    return sum.hex();
}

}  // namespace handrail::stored
