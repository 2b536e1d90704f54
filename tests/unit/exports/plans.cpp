#include "tests/unit/exports/plans.h"
#include "tests/support/project_root.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <map>

#include "tests/support/lay_floor.h"
#include "tests/support/names.h"
#include "tests/support/real_worlds.h"
#include "worlds/navigation/navigation.h"
#include "worlds/readers/reader.h"

namespace handrail::test {

const NamedStoreys* storeys_of(const std::string& file) {
    static std::map<std::string, NamedStoreys> known;
    if (const auto it = known.find(file); it != known.end()) return &it->second;
    std::filesystem::path path = test::project_root() / "worlds" / "maps" / file;
    if (file == "small_house.ifc") path = test::project_root() / "tests" / "unit" / "ifc" / "worlds" / file;
    if (!std::filesystem::exists(path)) {
        const auto real = real_world(file);
        if (!real) return nullptr;
        path = *real;
    }
    NamedStoreys& made = known[file];
    made.world = file;
    const auto scene = read_world(path);
    if (!scene) return ADD_FAILURE() << scene.error().sentence(), &made;
    const WalkerMeasures body =
        scene->game_map ? walker_measures(*scene, 0.25, 1.7, 0.57) : walker_measures(*scene, 0.25, 1.8, 0.25);
    const auto ways = Navigation::make(*scene, body);
    if (!ways) return ADD_FAILURE() << ways.error().sentence(), &made;
    const RoomGraph graph = make_rooms(*scene, (*ways)->space());
    for (int i = 1; i <= storey_count(graph); ++i)
        if (auto storey = storey_of(*scene, graph, (*ways)->space(), i)) {
            auto upper = upper_part_of(*scene, graph, (*ways)->space(), *storey);
            made.storeys.push_back(std::move(*storey));
            if (upper) made.storeys.push_back(std::move(*upper));
        }
    return &made;
}

Storey two_rooms() {
    Storey storey;
    storey.world = "Test";
    storey.min_m = {-0.5, -0.5};
    storey.max_m = {9.7, 4.7};
    const auto wall = [&](double x0, double y0, double x1, double y1) {
        storey.walls_m.push_back({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}});
    };
    wall(-0.2, -0.2, 9.4, 0.0);
    wall(-0.2, 4.0, 9.4, 4.2);
    wall(-0.2, 0.0, 0.0, 4.0);
    wall(9.2, 0.0, 9.4, 4.0);
    wall(6.0, 0.0, 6.2, 1.5);
    wall(6.0, 2.5, 6.2, 4.0);
    const auto room = [&](const std::string& name, double x0, double x1) {
        StoreyRoom made;
        made.room = static_cast<std::uint32_t>(storey.rooms.size());
        made.name = name;
        made.loops_m = {{{x0, 0.25}, {x1, 0.25}, {x1, 3.75}, {x0, 3.75}}};
        made.area_m2 = (x1 - x0) * 3.5;
        made.min_m = {x0, 0.25};
        made.max_m = {x1, 3.75};
        made.middle_m = 0.5 * (made.min_m + made.max_m);
        storey.rooms.push_back(std::move(made));
    };
    room("Kitchen", 0.25, 5.75);
    room("Room 12", 6.45, 8.95);
    lay_floor(storey);
    storey.things.push_back({FeatureId{1}, "Table", {{1.5, 2.0}, {1.0, 0.0}, {1.0, 0.5}}, false});
    storey.gaps.push_back({PassageKind::Door, "Kitchen door", {6.1, 2.0}, {0.0, 1.0}, 1.0});
    storey.portals.push_back({PassageKind::Door, {0, 1}, {6.1, 2.0}, 1.0});
    storey.base = StoreyBase{{4.0, 2.0}, kPi / 2.0};
    return storey;
}

}  // namespace handrail::test
