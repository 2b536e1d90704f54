#include "worlds/ifc/ifc_scene.h"

#include <algorithm>
#include <array>

#include "worlds/base/language.h"
#include "worlds/base/text.h"
#include "worlds/geometry/clip.h"
#include "worlds/scene/surfaces.h"

namespace handrail::ifc {
namespace {

constexpr std::size_t kMostSolids = 150'000, kMostTriangles = 1'500'000;
// The unit for the tolerances of derive_surfaces, the same as for maps.
constexpr double kSurfaceUnit_m = 1.0 / 32.0;

// A spoken name for parts of this role. It is used if a part's own name cannot be spoken or only states its class.
struct Called {
    PartRole role;
    std::string_view kind;
    bool by_own_name = false;
};
constexpr std::array kCalled{
    Called{PartRole::Stairs, "stairs"},
    Called{PartRole::Ramp, "ramp"},
    Called{PartRole::Lift, "lift"},
    Called{PartRole::Escalator, "escalator"},
    Called{PartRole::Walkway, "moving_walkway"},
    Called{PartRole::Railing, "railing"},
    Called{PartRole::Column, "column"},
    Called{PartRole::Beam, "beam"},
    Called{PartRole::Furniture, "furniture", true},
    Called{PartRole::Fixture, "fixture", true},
    Called{PartRole::Other, "object", true},
    Called{PartRole::Window, "window"},
    Called{PartRole::Door, "door"},
};

bool is_structure(PartRole role) {
    return role == PartRole::Wall || role == PartRole::Slab || role == PartRole::Roof || role == PartRole::Cover ||
           role == PartRole::Structure || role == PartRole::Panel;
}

std::shared_ptr<StatedBuilding> stated_part_of(const IfcBuilding& building) {
    auto stated = std::make_shared<StatedBuilding>();
    stated->schema = building.schema;
    stated->storeys = building.storeys;
    stated->rooms = building.rooms;
    stated->missing = building.missing;
    return stated;
}

}  // namespace

IfcScene::IfcScene(IfcBuilding building, const IfcRelations& relations, const IfcModel& model,
                   const IfcOptions& options)
    : building_(std::move(building)),
      relations_(relations),
      model_(model),
      options_(options),
      stated_(stated_part_of(building_)),
      rooms_(stated_->rooms) {}

Result<Scene> IfcScene::build(const std::string& file_name) {
    scene_.source_file = file_name;
    scene_.name = building_.name.empty() ? options_.world_name : building_.name;
    scene_.materials.emplace_back();
    scene_.report.format = "ifc";
    scene_.metres_per_unit = model_.metres_per_unit();
    prove_doors();
    // The borders are found before add_parts(), because that function empties the shapes of the parts.
    std::vector<StatedPortal> borders = open_borders();
    add_parts();
    if (scene_.solids.empty() && scene_.triangles.empty()) return fail(phrase("ifc.nothing_to_touch"), file_name);
    if (scene_.solids.size() > kMostSolids || scene_.triangles.size() > kMostTriangles || building_.too_large)
        return fail(phrase("ifc.too_large", {{"solids", scene_.solids.size()}, {"triangles", scene_.triangles.size()}}),
                    file_name);
    add_ground();
    try_doors();
    if (options_.stop.stop_requested()) return fail(phrase("files.stopped"), file_name);
    derive_surfaces(scene_, looks_, kSurfaceUnit_m, options_.stop);
    if (options_.stop.stop_requested()) return fail(phrase("files.stopped"), file_name);
    join_flights();
    join_open_rooms(std::move(borders));
    add_starts();
    write_report();
    scene_.stated = stated_;
    return std::move(scene_);
}

void IfcScene::prove_doors() {
    for (const auto& [i, gap] : building_.gaps) {
        if (building_.parts[i].role != PartRole::Door) continue;
        if (options_.stop.stop_requested()) return;
        if (const double side = stated_->rooms.empty() ? sky_side(building_, gap) : 0.0; side != 0.0)
            sky_side_.emplace(i, side);
        if (const auto cut = building_.cut_as_leaf.find(i); cut != building_.cut_as_leaf.end()) freed_[i] = cut->second;
        if (!can_pass(building_, gap)) {
            const std::vector<std::string> freed = free_the_way(building_, gap);
            freed_[i].insert(freed_[i].end(), freed.begin(), freed.end());
        }
    }
}

FeatureId IfcScene::add_feature(FeatureKind kind, std::string_view made_name, const std::string& name, int line) {
    Feature feature;
    feature.kind = kind;
    feature.name = name.empty() ? std::string(made_name) : name;
    feature.made_name = name.empty();
    feature.source.line = line;
    scene_.features.push_back(std::move(feature));
    return {static_cast<std::uint32_t>(scene_.features.size() - 1)};
}

FeatureId IfcScene::thing_of(std::size_t part) {
    const std::size_t whole = building_.parts[part].whole;
    if (const auto known = thing_.find(whole); known != thing_.end()) return known->second;
    const IfcPart& of = building_.parts[whole];
    const auto called =
        std::find_if(kCalled.begin(), kCalled.end(), [&](const Called& c) { return c.role == of.role; });
    const bool of_a_kind = of.prefab && of.role != PartRole::Lift;
    const std::string_view kind = of_a_kind ? of.prefab->name : called == kCalled.end() ? "object" : called->kind;
    const FeatureId made = add_feature(
        FeatureKind::Object, kind,
        called != kCalled.end() && called->by_own_name ? spoken_part_name(of.name) : std::string(), of.line);
    return thing_.emplace(whole, made).first->second;
}

MaterialId IfcScene::material(const std::string& name, bool guessed) {
    Material made;
    if (const MaterialSpec* spec = find_material(name)) {
        made.name = name;
        made.sound = spec->sound;
        made.guessed = guessed;
    }
    return material_id(scene_, made);
}

std::string IfcScene::touch_material(const IfcPart& part) {
    const std::string_view found = material_of_words(part.words);
    if (found.empty() || !options_.guess_materials) return {};
    guessed_from_[std::string(found)].insert(part.words.substr(0, part.words.find(';')));
    return std::string(found);
}

void IfcScene::add_solid(ConvexSolid shape, SolidRole role, FeatureId feature, const std::string& of_material,
                         int line) {
    Solid solid;
    solid.role = role;
    solid.feature = feature;
    solid.source = {line, 0};
    const MaterialId id = material(of_material, true);
    solid.face_materials.assign(shape.planes.size(), id);
    looks_.emplace_back(shape.planes.size(), id);
    scene_.bounds_m.include(shape.bounds_m);
    if (feature) scene_.features[feature.value].bounds_m.include(shape.bounds_m);
    ++scene_.report.brushes;
    scene_.report.polygons += static_cast<int>(shape.faces.size());
    solid.shape = std::move(shape);
    scene_.solids.push_back(std::move(solid));
}

void IfcScene::add_part(std::size_t i) {
    IfcPart& part = building_.parts[i];
    if (part.body.empty()) return;
    const std::string of_material = touch_material(part);
    const bool structure = is_structure(part.role) && part.whole == i;
    const FeatureId thing = structure ? kNoFeature : thing_of(i);
    if (part.prefab) ++prefabs_[std::string(part.prefab->name)];
    for (std::size_t k = 0; k < part.body.solids.size(); ++k) {
        const bool usual = part.prefab && of_material.empty() && k < part.prefab->parts.size();
        add_solid(std::move(part.body.solids[k]), SolidRole::Solid, thing,
                  usual ? std::string(part.prefab->parts[k].material) : of_material, part.line);
    }
    if (part.body.sheets.empty()) return;
    FeatureId of_sheets = thing;
    if (!of_sheets) {
        const bool floor = part.role == PartRole::Slab,
                   roof = part.role == PartRole::Roof || part.role == PartRole::Cover;
        of_sheets = add_feature(floor  ? FeatureKind::Floor
                                : roof ? FeatureKind::Ceiling
                                       : FeatureKind::Wall,
                                floor  ? "floor"
                                : roof ? "ceiling"
                                       : "wall",
                                {}, part.line);
    }
    const MaterialId id = material(of_material, true);
    scene_.features[of_sheets.value].material = id;
    for (const Polygon& sheet : part.body.sheets) {
        for (std::size_t k = 1; k + 1 < sheet.points_m.size(); ++k) {
            const Vec3 &a = sheet.points_m[0], &b = sheet.points_m[k], &c = sheet.points_m[k + 1];
            scene_.triangles.push_back({a, b, c, of_sheets, id, TouchSide::Both});
            scene_.features[of_sheets.value].area_m2 += 0.5 * glm::length(glm::cross(b - a, c - a));
        }
        for (const Vec3& p : sheet.points_m) {
            scene_.features[of_sheets.value].bounds_m.include(p);
            scene_.bounds_m.include(p);
        }
    }
}

void IfcScene::add_parts() {
    for (std::size_t i = 0; i < building_.parts.size(); ++i) {
        if (options_.stop.stop_requested() || scene_.solids.size() > kMostSolids ||
            scene_.triangles.size() > kMostTriangles)
            return;
        const IfcPart& part = building_.parts[i];
        if (part.same_as != i) continue;
        const auto gap = building_.gaps.find(i);
        scene_.report.doors += part.role == PartRole::Door ? 1 : 0;
        const bool whole = part.whole == i;
        const bool within_stairs = whole && relations_.whole_of.contains(part.id) &&
                                   role_of(model_.name(relations_.whole_of.at(part.id))) == part.role;
        stated_->stairs += part.role == PartRole::Stairs && whole && !within_stairs ? 1 : 0;
        stated_->ramps += part.role == PartRole::Ramp && whole && !within_stairs ? 1 : 0;
        stated_->lifts += part.role == PartRole::Lift ? 1 : 0;
        stated_->escalators += part.role == PartRole::Escalator ? 1 : 0;
        stated_->walkways += part.role == PartRole::Walkway ? 1 : 0;
        const std::size_t solids = scene_.solids.size(), triangles = scene_.triangles.size();
        if (part.role == PartRole::Door && gap != building_.gaps.end()) add_door(i, gap->second);
        else if (part.role == PartRole::Window && gap != building_.gaps.end()) add_window(i, gap->second);
        else add_part(i);
        if (part.role == PartRole::Door && gap == building_.gaps.end()) add_door_without_place(i);
        if (part.role == PartRole::Window) stated_->windows.push_back(stated_thing(i, solids, triangles));
        if (part.role == PartRole::Furniture) stated_->furnishings.push_back(stated_thing(i, solids, triangles));
    }
}

// Describes a part by the solids and triangles that were added for it. `solids` and `triangles` are the counts before
// they were added.
StatedThing IfcScene::stated_thing(std::size_t part, std::size_t solids, std::size_t triangles) const {
    StatedThing thing;
    if (const auto known = thing_.find(building_.parts[part].whole); known != thing_.end())
        thing.feature = known->second;
    for (std::size_t s = solids; s < scene_.solids.size(); ++s) thing.bounds_m.include(scene_.solids[s].shape.bounds_m);
    for (std::size_t t = triangles; t < scene_.triangles.size(); ++t)
        for (const Vec3& corner : {scene_.triangles[t].a_m, scene_.triangles[t].b_m, scene_.triangles[t].c_m})
            thing.bounds_m.include(corner);
    return thing;
}

void IfcScene::warn(int line, std::string message, std::string action) {
    constexpr std::size_t kMostKept = 20;
    if (++scene_.report.warnings_in_all <= static_cast<int>(kMostKept))
        scene_.report.warnings.push_back(
            {Severity::Warning, scene_.source_file, line, 0, std::move(message), std::move(action)});
}

void IfcScene::write_report() {
    ReadReport& report = scene_.report;
    report.triangles = static_cast<int>(scene_.triangles.size());
    report.polygons_kept = report.polygons - report.polygons_hidden;
    report.movers = static_cast<int>(scene_.movers.size());
    report.starts = static_cast<int>(scene_.starts.size());
    stated_->openings = building_.openings;
    stated_->openings_cut = building_.openings_cut;
    for (const auto& [material, words] : guessed_from_) {
        std::string names;
        int shown = 0;
        for (const std::string& word : words)
            if (shown < 3 && !word.empty()) names += (shown++ > 0 ? ", " : "") + word;
        report.guessed.push_back(
            phrase("ifc.guessed", {{"material", spoken_material(material)},
                                   {"names", names},
                                   {"more", std::max<int>(0, static_cast<int>(words.size()) - 3)}}));
    }
    if (!prefabs_.empty()) {
        int all = 0;
        std::string names;
        for (const auto& [name, count] : prefabs_) {
            all += count;
            names += (names.empty() ? "" : ", ") + spoken_kind(name);
        }
        report.guessed.push_back(phrase("ifc.prefabs", {{"n", all}, {"names", names}}));
    }
    if (!building_.floors_made.empty()) {
        constexpr std::size_t kMostNamed = 4;
        std::string names;
        for (std::size_t i = 0; i < std::min(building_.floors_made.size(), kMostNamed); ++i)
            names += (i > 0 ? ", " : "") + one_line(building_.floors_made[i]);
        report.guessed.push_back(phrase("ifc.floors_made", {{"n", building_.floors_made.size()}, {"names", names}}));
    }
    if (building_.walls_made > 0) report.guessed.push_back(phrase("ifc.walls_made", {{"n", building_.walls_made}}));
    if (plain_ > 0) report.simplified.push_back(phrase("ifc.plain_leaves", {{"n", plain_}}));
    if (building_.approximated > 0)
        report.simplified.push_back(phrase("ifc.approximated", {{"n", building_.approximated}}));
    if (differing_ > 0) report.simplified.push_back(phrase("ifc.differing", {{"n", differing_}}));
    const auto listed = [](const std::map<std::string, int, std::less<>>& counts, int& all) {
        std::string names;
        int shown = 0;
        for (const auto& [name, count] : counts) {
            all += count;
            if (shown++ < 4) names += (shown > 1 ? ", " : "") + one_line(name.substr(0, 60));
        }
        return names;
    };
    int all = 0;
    if (const std::string names = listed(building_.skipped, all); all > 0)
        report.left_out.push_back(phrase("ifc.skipped", {{"n", all}, {"names", names}}));
    stated_->skipped = all;
    all = 0;
    if (const std::string names = listed(building_.not_read, all); all > 0)
        report.left_out.push_back(phrase("ifc.not_read", {{"n", all}, {"names", names}}));
    if (building_.odd_placements > 0)
        report.left_out.push_back(phrase("ifc.odd_placements", {{"n", building_.odd_placements}}));
    if (building_.repeated > 0) report.left_out.push_back(phrase("ifc.repeated", {{"n", building_.repeated}}));
    if (building_.far > 0) report.left_out.push_back(phrase("ifc.far", {{"n", building_.far}}));
    for (const std::size_t line : building_.openings_uncut)
        warn(static_cast<int>(line), phrase("ifc.opening_uncut"), phrase("ifc.then_left_as_is"));
    if (!model_.unit_stated()) warn(0, phrase("ifc.no_unit"), phrase("ifc.then_metres"));
    if (stated_->rooms.empty()) warn(0, phrase("ifc.no_rooms"), phrase("ifc.then_found"));
    for (const StatedRoom& room : stated_->rooms) {
        if (room.rings.empty())
            warn(room.source.line, phrase("ifc.no_outline", {{"room", room.name}}), phrase("ifc.then_found"));
        if (is_oddly_named(room))
            warn(room.source.line, phrase("ifc.odd_name", {{"room", room.name}, {"number", room.number}}),
                 phrase("ifc.then_taken"));
    }
}

Result<Scene> read_ifc_building(std::string_view bytes, const std::string& file_name, const IfcOptions& options) {
    const auto stage = [&](std::string_view key) {
        if (options.stage) options.stage(key);
    };
    stage("import.file");
    const Result<StepFile> file = StepFile::read(bytes, file_name, options.stop);
    if (!file) return tl::unexpected(file.error());
    if (!file->schema().starts_with("IFC2X") && !file->schema().starts_with("IFC4"))
        return fail(phrase("ifc.other_schema",
                           {{"schema", file->schema().empty() ? "?" : one_line(file->schema().substr(0, 60))}}),
                    file_name);
    if (options.progress) options.progress(0.2);
    IfcModel model(*file);
    const IfcRelations relations(model);
    const auto progress = [&](double fraction) {
        if (options.progress) options.progress(0.25 + 0.5 * fraction);
    };
    stage("import.shapes");
    IfcBuilding building = read_building(model, relations, progress, options.stop);
    if (options.stop.stop_requested()) return fail(phrase("files.stopped"), file_name);
    if (building.parts.empty()) return fail(phrase("ifc.no_building"), file_name);
    stage("import.surfaces");
    Result<Scene> scene = IfcScene(std::move(building), relations, model, options).build(file_name);
    if (scene && options.progress) options.progress(1.0);
    return scene;
}

}  // namespace handrail::ifc
