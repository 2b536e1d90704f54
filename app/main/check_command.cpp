#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/core/whereabouts/rooms_of_world.h"
#include "app/core/world/walker.h"
#include "app/main/commands.h"
#include "app/main/world_files.h"
#include "settings/settings.h"
#include "worlds/base/language.h"
#include "worlds/check/faults.h"

namespace handrail::program {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Scene& scene, const std::vector<check::WorldFault>& faults, const navigation::RoomGraph& graph) {
    Json list = Json::array();
    for (const check::WorldFault& fault : faults) {
        Json candidates = Json::array();
        for (const FeatureId id : fault.candidates) candidates.push_back(spoken_name(scene.features[id.value]));
        list.push_back({{"kind", check::row_of(fault.kind).word},
                        {"blocks", check::blocks(fault)},
                        {"what", check::fault_words(scene, fault)},
                        {"do", check::fault_advice(scene, fault)},
                        {"file", scene.source_file},
                        {"line", fault.source.line},
                        {"at_m", check::has_place(fault) ? Json::array({fault.at_m.x, fault.at_m.y, fault.at_m.z})
                                                         : Json(nullptr)},
                        {"room", fault.room < graph.rooms.size() ? Json(graph.rooms[fault.room].name) : Json(nullptr)},
                        {"candidates", std::move(candidates)}});
    }
    return {{"name", scene.name},
            {"file", scene.source_file},
            {"rooms", graph.rooms.size()},
            {"blocking", std::count_if(faults.begin(), faults.end(), check::blocks)},
            {"faults", std::move(list)}};
}

void print_faults(const Scene& scene, const std::vector<check::WorldFault>& faults, std::ostream& out) {
    out << phrase("check.summary", {{"world", spoken_name(scene)},
                                    {"file", scene.source_file},
                                    {"count", faults.size()},
                                    {"blocking", std::count_if(faults.begin(), faults.end(), check::blocks)}})
        << '\n';
    for (std::size_t i = 0; i < faults.size(); ++i)
        out << phrase("check.item", {{"number", i + 1},
                                     {"what", check::fault_words(scene, faults[i])},
                                     {"do", check::fault_advice(scene, faults[i])},
                                     {"line", faults[i].source.line},
                                     {"placed", check::has_place(faults[i]) ? "yes" : "no"},
                                     {"east", faults[i].at_m.x},
                                     {"north", faults[i].at_m.y},
                                     {"up", faults[i].at_m.z}})
            << '\n';
}

}  // namespace

int run_check(const CheckArguments& arguments, std::ostream& out, std::ostream& err, const LongWork& waiting) {
    const LongWork progress = arguments.json ? LongWork() : waiting;
    const Result<std::filesystem::path> world = world_given(arguments.world);
    if (!world) {
        err << world.error().sentence() << '\n';
        return 1;
    }
    Result<Scene> read = mended_and_valid(imported(*world, progress.followed(arguments.common.read_options(*world))),
                                          *world, arguments.common);
    if (!read) {
        progress.done();
        err << read.error().sentence() << '\n';
        return 1;
    }
    const auto scene = std::make_shared<const Scene>(std::move(*read));
    progress.at(phrase("progress.rooms"));
    const core::WalkerSize size = core::walker_size(*scene, settings::Settings{}.walk.body_radius_m);
    core::RoomsOfWorld rooms(scene, navigation::walker_measures(*scene, size.radius_m, size.height_m, size.step_up_m),
                             at_once());
    const bool found = rooms.ready() && rooms.found();
    progress.at(phrase("progress.faults"));
    const std::vector<check::WorldFault> faults =
        found ? check::find_faults(*scene, &rooms.navigation().space(), &rooms.graph())
              : check::find_faults(*scene, nullptr, nullptr);
    progress.done();
    if (arguments.json)
        out << json_of(*scene, faults, rooms.graph()).dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
    else print_faults(*scene, faults, out);
    return std::any_of(faults.begin(), faults.end(), check::blocks) ? 1 : 0;
}

}  // namespace handrail::program
