#include <fmt/ranges.h>
#include <sys/resource.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/core/context/workspace_scale.h"
#include "app/core/dialogue/words.h"
#include "app/core/hand/felt_world.h"
#include "app/core/hand/simplified_words.h"
#include "app/core/whereabouts/rooms_of_world.h"
#include "app/core/world/entering.h"
#include "app/core/world/walker.h"
#include "app/main/commands.h"
#include "app/main/confinement_facts.h"
#include "app/main/world_files.h"
#include "haptic/compile/compile_haptic.h"
#include "haptic/compile/touch_model.h"
#include "settings/settings.h"
#include "worlds/base/clock.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"
#include "worlds/exports/as_words.h"
#include "worlds/navigation/navigation.h"
#include "worlds/navigation/reach.h"
#include "worlds/navigation/rooms.h"
#include "worlds/scene/building_bounds.h"
#include "worlds/scene/honest_report.h"
#include "worlds/scene/lint.h"
#include "worlds/scene/stated_building.h"

namespace handrail::program {
namespace {

using Json = nlohmann::ordered_json;

struct Cost {
    double load_s = 0.0;                 // time to read the file
    double all_s = 0.0;                  // time to read the file and make everything that a session needs
    std::int64_t peak_memory_bytes = 0;  // peak memory of the whole process, measured at its end
    bool kept = false;                   // the world came from the cache, so the file was not read again
};

std::int64_t peak_memory_bytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return std::int64_t{usage.ru_maxrss} * 1024;
}

Json vector_of(const Vec3& v) { return Json::array({v.x, v.y, v.z}); }

std::vector<std::string> material_names(const Scene& scene) {
    std::vector<std::string> names;
    for (const Material& material : scene.materials)
        if (!material.name.empty() && std::find(names.begin(), names.end(), material.name) == names.end())
            names.push_back(material.name);
    return names;
}

// Returns the number of movers that can move. A door of a map that cannot open is not counted, because it is a wall.
std::ptrdiff_t moving_parts(const Scene& scene) {
    return std::count_if(scene.movers.begin(), scene.movers.end(), [](const Mover& mover) { return mover.moves(); });
}

// Returns a list of the freely movable objects, the heaviest last: "Ball 0.5 kg, Safe 400 kg".
std::string bodies_words(const Scene& scene) {
    constexpr std::size_t kMostPrinted = 20;
    std::vector<FreeBody> bodies = scene.bodies;
    std::stable_sort(bodies.begin(), bodies.end(),
                     [](const FreeBody& a, const FreeBody& b) { return a.mass_kg < b.mass_kg; });
    std::vector<std::string> words;
    for (const FreeBody& body : bodies)
        if (words.size() < kMostPrinted)
            words.push_back(phrase(
                "info.body", {{"name", spoken_name(scene.features[body.feature.value])}, {"mass", body.mass_kg}}));
    return phrase("info.bodies", {{"count", bodies.size()},
                                  {"names", fmt::format("{}", fmt::join(words, ", "))},
                                  {"more", bodies.size() - words.size()}});
}

// Returns as JSON what Handrail understood of a building; null if the file states no rooms.
Json honesty_json(const Scene& scene) {
    if (!scene.stated) return nullptr;
    const HonestReport report = honest_report(scene);
    Json storeys = Json::array(), check = Json::array();
    for (const StatedStorey& storey : scene.stated->storeys)
        storeys.push_back({{"name", storey.name}, {"floor_m", storey.floor_m}, {"rooms", storey.rooms}});
    for (const CheckPoint& point : report.check)
        check.push_back({{"kind", word_of(point.what)},
                         {"what", check_words(scene, point)},
                         {"file", scene.source_file},
                         {"line", point.source.line},
                         {"at_m", vector_of(point.at_m)}});
    return {{"sentence", honest_sentence(scene, report)},
            {"schema", scene.stated->schema},
            {"understood",
             {{"storeys", report.storeys},
              {"storeys_with_rooms", report.storeys_with_rooms},
              {"rooms", report.rooms},
              {"doors", report.doors},
              {"windows", report.windows},
              {"openings", report.openings},
              {"stairs", report.stairs},
              {"ramps", report.ramps},
              {"lifts", report.lifts},
              {"escalators", report.escalators},
              {"moving_walkways", report.walkways},
              {"furnishings", report.furnishings},
              {"landmarks", report.landmarks}}},
            {"guessed", report.guessed},
            {"missing", report.left_out},
            {"parts_missing", report.parts_missing},
            {"openings_uncut", report.openings_uncut},
            {"simplified_for_touch", report.simplified},
            {"problems", report.problems},
            {"rooms_by_storey", std::move(storeys)},
            {"doors_joining_two_rooms", report.doors_of_two_rooms},
            {"doors_of_one_room", report.doors_of_one_room},
            {"doors_of_no_room", report.doors_of_no_room},
            {"doors_cut_free", report.doors_cut_free},
            {"doors_impassable", report.doors_impassable},
            {"largest_connected", report.largest_connected},
            {"check", std::move(check)}};
}

Json json_of(const Scene& scene, const compile::TouchModel& touch, const Cost& cost) {
    const ReadReport& report = scene.report;
    const StatedBuilding stated = scene.stated ? *scene.stated : StatedBuilding{};
    const Aabb bounds = scene.bounds_m.empty() ? Aabb{Vec3{0.0}, Vec3{0.0}} : scene.bounds_m;
    Json warnings = Json::array();
    for (const Diagnostic& warning : report.warnings)
        warnings.push_back(
            {{"file", warning.file},
             {"line", warning.line},
             {"column", warning.column},
             {"message", warning.action.empty() ? warning.message : warning.message + " " + warning.action}});
    Json bodies = Json::array();
    for (const FreeBody& body : scene.bodies)
        bodies.push_back({{"name", scene.features[body.feature.value].name}, {"mass_kg", body.mass_kg}});
    Json modelled = Json::object();
    for (const compile::TouchModel::Part& part : touch.parts) modelled[std::string(part.key)] = part.count;
    return {{"name", scene.name},
            {"format", report.format},
            {"brushes", report.brushes},
            {"polygons", report.polygons},
            {"polygons_hidden", report.polygons_hidden},
            {"polygons_kept", report.polygons_kept},
            {"triangles", report.triangles},
            {"liquids", report.liquids},
            {"effects", scene.effects.size()},
            {"movers", moving_parts(scene)},
            {"bodies", std::move(bodies)},
            {"labyrinth",
             {{"level", scene.labyrinth.level},
              {"goals", scene.labyrinth.goals.size()},
              {"holes", scene.labyrinth.holes.size()},
              {"planks", scene.labyrinth.planks.size()},
              {"blocks", scene.labyrinth.blocks.size()}}},
            {"patches", report.patches},
            {"starts", report.starts},
            {"spaces", stated.rooms.size()},
            {"doors", report.doors},
            {"windows", stated.windows.size()},
            {"stairs", stated.stairs},
            {"storeys", stated.storeys.size()},
            {"furnishings", stated.furnishings.size()},
            {"portals", stated.portals.size()},
            {"largest_connected_spaces", largest_connected(stated)},
            {"features", scene.features.size()},
            {"materials", material_names(scene)},
            {"openings", stated.openings},
            {"openings_cut", stated.openings_cut},
            {"honesty", honesty_json(scene)},
            {"guessed", report.guessed},
            {"simplified", report.simplified},
            {"left_out", report.left_out},
            {"warnings", std::move(warnings)},
            {"warnings_in_all", report.warnings_in_all},
            {"bounds_min_m", vector_of(bounds.min_m)},
            {"bounds_max_m", vector_of(bounds.max_m)},
            {"scale_m_per_unit", scene.metres_per_unit},
            {"game_map", scene.game_map},
            {"touch_model", std::move(modelled)},
            {"touch_stages_on", touch.stages_on},
            {"touch_stages_off", touch.stages_off},
            {"load_s", cost.load_s},
            {"kept", cost.kept},
            {"all_s", cost.all_s},
            {"peak_memory_bytes", cost.peak_memory_bytes},
            {"confinement", program::json_of(confine::confinement_offered())}};
}

std::string spoken_stages(const std::vector<std::string_view>& stages) {
    std::string text;
    for (const std::string_view stage : stages) text += (text.empty() ? "" : ", ") + compile::spoken_stage(stage);
    return text;
}

// For a file that states rooms, prints sentences: what Handrail understood, and what the author should check.
void print_check(const Scene& scene, std::ostream& out) {
    constexpr std::size_t kMostPrinted = 20;
    const HonestReport report = honest_report(scene);
    out << honest_sentence(scene, report) << '\n';
    for (const std::string& sentence : honest_details(scene, report)) out << "  " << sentence << '\n';
    if (report.check.empty()) return;
    out << phrase("honest.to_check") << '\n';
    for (std::size_t i = 0; i < std::min(kMostPrinted, report.check.size()); ++i)
        out << "  "
            << phrase("honest.check_item", {{"what", core::sentence_case(check_words(scene, report.check[i]))},
                                            {"line", report.check[i].source.line}})
            << '\n';
    if (report.check.size() > kMostPrinted)
        out << "  " << phrase("info.more", {{"count", report.check.size() - kMostPrinted}}) << '\n';
}

// Prints sentences for people who listen to them in order, so the important sentences come first.
void print_facts(const Scene& scene, const compile::TouchModel& touch, const Cost& cost, std::ostream& out) {
    const ReadReport& report = scene.report;
    const Aabb building = building_bounds_m(scene);
    const Vec3 size = building.empty() ? Vec3{0.0} : building.size_m();
    const auto line = [&out](const std::string& sentence) { out << one_line(sentence) << '\n'; };
    line(phrase("info.world", {{"world", spoken_name(scene)}, {"file", scene.source_file}}));
    line(phrase("info.size",
                {{"x", size.x}, {"y", size.y}, {"z", size.z}, {"unit", fmt::format("{}", scene.metres_per_unit)}}));
    line(phrase("info.holds", {{"things", scene.features.size()},
                               {"doors", report.doors},
                               {"movers", moving_parts(scene)},
                               {"liquids", report.liquids},
                               {"starts", report.starts}}));
    line(phrase("info.file_holds", {{"brushes", report.brushes},
                                    {"faces", report.polygons},
                                    {"triangles", report.triangles},
                                    {"hidden", report.polygons_hidden},
                                    {"kept", report.polygons_kept}}));
    if (!scene.bodies.empty()) line(bodies_words(scene));
    if (const LabyrinthPlan& game = scene.labyrinth; game.there())
        line(phrase("info.labyrinth", {{"level", game.level},
                                       {"ball", spoken_name(scene.features[game.ball.value])},
                                       {"goals", game.goals.size()},
                                       {"holes", game.holes.size()},
                                       {"planks", game.planks.size()},
                                       {"blocks", game.blocks.size()}}));
    if (scene.stated) print_check(scene, out);
    if (!scene.effects.empty()) {
        std::vector<std::string> kinds;
        for (const EffectSpec& row : effect_table()) {
            const auto many = std::count_if(scene.effects.begin(), scene.effects.end(),
                                            [&](const Effect& effect) { return effect.kind == row.kind; });
            if (many > 0) kinds.push_back(fmt::format("{} {}", phrase("effect_name." + std::string(row.name)), many));
        }
        line(phrase("info.forces", {{"kinds", fmt::format("{}", fmt::join(kinds, ", "))}}));
    }
    const std::vector<std::string> materials = material_names(scene);
    line(materials.empty() ? phrase("info.no_materials")
                           : phrase("info.materials", {{"names", fmt::format("{}", fmt::join(materials, ", "))}}));
    std::vector<std::string> parts;
    for (const compile::TouchModel::Part& part : touch.parts)
        if (part.count > 0) parts.push_back(compile::spoken_part(part));
    line(parts.empty() ? phrase("info.meets_nothing")
                       : phrase("info.meets", {{"parts", fmt::format("{}", fmt::join(parts, ", "))}}));
    if (!touch.stages_on.empty()) line(phrase("info.stages", {{"stages", spoken_stages(touch.stages_on)}}));
    if (!touch.stages_off.empty()) line(phrase("info.not_modelled", {{"stages", spoken_stages(touch.stages_off)}}));
    const auto list = [&](const std::string& title, const std::vector<std::string>& sentences) {
        if (sentences.empty()) return;
        line(title);
        for (const std::string& sentence : sentences) out << "  " << one_line(sentence) << '\n';
    };
    list(phrase("info.guessed"), report.guessed);
    list(phrase("info.simplified"), report.simplified);
    list(phrase("info.left_out"), report.left_out);
    if (report.warnings_in_all == 0) {
        line(phrase("info.no_problems"));
    } else {
        line(phrase("info.problems", {{"count", report.warnings_in_all}}));
        for (const Diagnostic& warning : report.warnings) out << "  " << warning.sentence() << '\n';
        if (const auto more = report.warnings_in_all - static_cast<int>(report.warnings.size()); more > 0)
            line("  " + phrase("info.more", {{"count", more}}));
    }
    line(phrase("info.loaded", {{"seconds", cost.all_s},
                                {"reading", cost.load_s},
                                {"megabytes", (cost.peak_memory_bytes + (1 << 19)) >> 20}}));
    if (cost.kept) line(phrase("info.kept"));
}

// Finds the rooms of a world whose file states none, in the same way as a session. `left_out` receives sentences: why
// there are no rooms, or what was left out of the search. `unreachable` receives a sentence about the rooms that cannot
// be reached on foot, or stays empty.
navigation::RoomGraph rooms_of(const std::shared_ptr<const Scene>& scene, std::string& unreachable,
                               std::vector<std::string>& left_out) {
    const core::WalkerSize size = core::walker_size(*scene, settings::Settings{}.walk.body_radius_m);
    core::RoomsOfWorld rooms(scene, navigation::walker_measures(*scene, size.radius_m, size.height_m, size.step_up_m),
                             at_once(), navigation_in_cache());
    if (!rooms.ready() || !rooms.found()) {
        if (!rooms.problem().empty()) left_out.push_back(rooms.problem());
        return {};
    }
    const std::vector<std::string>& said = rooms.navigation().said();
    left_out.insert(left_out.end(), said.begin(), said.end());
    unreachable = navigation::unreachable_words(rooms.out_of_reach());
    return std::move(rooms.graph());
}

std::optional<std::string> rooms_sentence(const navigation::RoomGraph& graph) {
    constexpr std::size_t kMostNamed = 20;
    if (graph.rooms.empty()) return std::nullopt;
    std::vector<std::string> names;
    for (const navigation::Room& room : graph.rooms)
        if (names.size() < kMostNamed) names.push_back(room.name);
    const std::string list = fmt::format("{}", fmt::join(names, "; "));
    const std::size_t rooms = graph.rooms.size(), ways = graph.portals.size();
    if (rooms > kMostNamed)
        return phrase("found_rooms.first",
                      {{"rooms", rooms}, {"ways", ways}, {"names", list}, {"more", rooms - kMostNamed}});
    return phrase("found_rooms.all", {{"rooms", rooms}, {"ways", ways}, {"names", list}});
}

// Returns the scale in world metres per hand metre. `requested` is the name of a scale or a number. "building" fits the
// whole building into the workspace of a Touch.
std::optional<double> scale_of(const std::string& requested, const Aabb& bounds_m) {
    constexpr double kReach_hand_m = 0.075;
    const std::string word = lower_ascii(requested);
    const std::array names{"building", "floor", "room", "detail"};
    for (std::size_t i = 0; i < names.size(); ++i)
        if (word == names[i])
            return core::world_m_per_hand_m(static_cast<core::NamedScale>(i), bounds_m, kReach_hand_m);
    double number = 0.0;
    if (!parse_finite(word, number) || number < 1.0 || number > 500.0) return std::nullopt;
    return number;
}

// Returns one sentence for each object that is simplified at the scale.
std::vector<std::string> simplified_at(const Scene& scene, double world_m_per_hand_m,
                                       const navigation::RoomGraph& graph) {
    const core::OpenPortals portals = core::open_portals(graph);
    compile::SimplifyOptions options;
    options.world_m_per_hand_m = world_m_per_hand_m;
    if (core::needs_openings(world_m_per_hand_m, settings::Settings{}.walk.body_radius_m))
        options.openings_m = portals.places_m;
    const compile::Simplification plan = compile::plan_simplification(scene, options);
    std::vector<std::string> sentences;
    for (const compile::NarrowOpening& opening : plan.openings)
        sentences.push_back(phrase("simplify.item", {{"name", core::opening_name(scene, opening, &graph, portals)},
                                                     {"what", core::opening_words(opening)}}));
    for (const FeatureId id : plan.left_out)
        sentences.push_back(
            phrase("simplify.item", {{"name", core::sentence_case(spoken_name(scene.features[id.value]))},
                                     {"what", phrase("simplify.is_left_out")}}));
    return sentences;
}

// Prints whether a hand can tell the materials of this world apart. Returns 1 if it cannot.
int print_lint(const Scene& scene, std::ostream& out) {
    const LintReport lint = lint_materials(scene);
    for (const std::string& problem : lint.problems) out << one_line(problem) << '\n';
    for (const std::string& warning : lint.warnings) out << one_line(warning) << '\n';
    if (lint.problems.empty()) out << phrase("program.told_apart") << '\n';
    return lint.problems.empty() ? 0 : 1;
}

// Prints a room description of the rooms that the file states. If it states none, describes the rooms that Handrail
// finds.
int print_as_words(const Scene& scene, const std::string& requested, const LongWork& progress, std::ostream& out,
                   std::ostream& err) {
    const std::string code = requested.empty() ? spoken_language() : requested;
    const words::WordLanguage language = code == "de" ? words::WordLanguage::German : words::WordLanguage::English;
    if (scene.stated && !scene.stated->rooms.empty()) {
        progress.done();
        out << exports::text_of(exports::stated_house(scene, language), scene, language);
        return 0;
    }
    progress.at(phrase("progress.rooms"));
    const core::WalkerSize size = core::walker_size(scene, settings::Settings{}.walk.body_radius_m);
    const Result<navigation::WalkSpace> space = navigation::make_walk_space(
        scene, navigation::walker_measures(scene, size.radius_m, size.height_m, size.step_up_m));
    if (!space) {
        progress.done();
        err << space.error().sentence() << '\n';
        return 1;
    }
    const std::string text = exports::text_of(
        exports::found_house(scene, navigation::make_rooms(scene, *space), *space, language), scene, language);
    progress.done();
    out << text;
    return 0;
}

}  // namespace

int run_info(const InfoArguments& arguments, std::ostream& out, std::ostream& err, const LongWork& waiting) {
    const Result<std::filesystem::path> world = world_given(arguments.world);
    if (!world) {
        err << world.error().sentence() << '\n';
        return 1;
    }
    const readers::ReadOptions options = arguments.common.read_options(*world);
    if (!std::isfinite(options.map_metres_per_unit) || options.map_metres_per_unit <= 0.0) {
        err << phrase("program.map_scale") << '\n';
        return 2;
    }
    const SteadyClock clock;
    const double begun_s = clock.now_s();
    const LongWork progress = arguments.json ? LongWork() : waiting;
    Result<importing::ImportedWorld> imported_world = imported(*world, progress.followed(options));
    Cost cost{clock.now_s() - begun_s, 0.0, 0, imported_world && imported_world->kept};
    Result<Scene> read = mended_and_valid(std::move(imported_world), *world, arguments.common);
    if (!read) {
        progress.done();
        err << read.error().sentence() << '\n';
        return 1;
    }
    if (arguments.lint) {
        progress.done();
        return print_lint(*read, out);
    }
    if (arguments.as_words) return print_as_words(*read, arguments.language, progress, out, err);
    std::optional<double> scale;
    if (!arguments.scale.empty() && !(scale = scale_of(arguments.scale, building_bounds_m(*read)))) {
        progress.done();
        err << phrase("program.info_scale", {{"scale", arguments.scale}}) << '\n';
        return 2;
    }
    const auto scene = std::make_shared<Scene>(std::move(*read));
    // Prepare the world as a session does, so that the time for this is measured.
    progress.at(phrase("progress.touch"));
    compile::CompileReport compiled;
    const settings::Settings defaults;
    const core::EnteringWorld entered = core::make_ready(scene);
    const double felt_scale = scale.value_or(defaults.workspace.scale);
    const double proxy_radius_m =
        core::proxy_radius_m(*entered.scene, defaults.haptic.ball_diameter_mm * 1e-3, felt_scale);
    compile::CompileOptions felt =
        compile::exploring(core::felt_rounding_m(defaults.haptic.edge_rounding_mm, felt_scale, proxy_radius_m), 0,
                           defaults.haptic.mesh_tolerance_mm * 1e-3 * felt_scale);
    felt.own_rounding =
        core::felt_own_rounding(*entered.scene, defaults.haptic.edge_rounding_mm, felt_scale, proxy_radius_m);
    felt.simplifies = [&](FeatureId feature, std::size_t triangles) {
        progress.at(phrase("progress.simplify",
                           {{"name", spoken_name(entered.scene->features[feature.value])}, {"triangles", triangles}}));
    };
    const compile::TouchModel touch = compile::touch_model(*compile::compile_haptic(*entered.scene, felt, &compiled));
    for (std::string& sentence : compiled.mesh.sentences()) scene->report.simplified.push_back(std::move(sentence));
    for (const compile::CoarserMesh& mesh : compiled.coarser)
        scene->report.simplified.push_back(phrase(
            "simplify.item", {{"name", core::sentence_case(spoken_name(entered.scene->features[mesh.feature.value]))},
                              {"what", core::coarser_words(mesh, felt_scale)}}));
    for (std::string& sentence : compiled.rounding.sentences()) scene->report.simplified.push_back(std::move(sentence));
    progress.at(phrase("progress.rooms"));
    std::string unreachable;
    const navigation::RoomGraph graph = rooms_of(scene, unreachable, scene->report.left_out);
    if (scale)
        for (std::string& sentence : simplified_at(*entered.scene, *scale, graph))
            scene->report.simplified.push_back(std::move(sentence));
    if (auto rooms = rooms_sentence(graph)) scene->report.guessed.push_back(std::move(*rooms));
    if (!unreachable.empty()) scene->report.guessed.push_back(std::move(unreachable));
    cost.all_s = clock.now_s() - begun_s;
    cost.peak_memory_bytes = peak_memory_bytes();
    progress.done();
    if (arguments.json) out << json_of(*scene, touch, cost).dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
    else print_facts(*scene, touch, cost, out);
    return 0;
}

}  // namespace handrail::program
