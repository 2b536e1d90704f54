#include "tests/support/known_buildings.h"

#include "tests/support/office_ifc.h"
#include "tests/support/project_root.h"
#include "tests/support/real_worlds.h"

namespace handrail::test {

std::vector<KnownBuilding> known_buildings(const TemporaryFolder& folder) {
    const OfficeIfc office = office_ifc({2, 1, 4, 24});
    std::vector<KnownBuilding> buildings{
        {folder.write("office.ifc", office.text), static_cast<std::size_t>(office.doors)},
        {project_root() / "tests/unit/ifc/worlds/small_house.ifc", 2},
        {project_root() / "tests/unit/osm/worlds/test_house.osm", 9}};
    const std::vector<KnownBuilding> real{{"duplex-apartment.ifc", 14},
                                          {"fzk-haus.ifc", 5},
                                          {"institute.ifczip", 77, true},
                                          {"apb-tu-dresden.osm", 498, true},
                                          {"delft-station.osm", 0},
                                          {"minimal.imdf.zip", 0},
                                          {"room.glb", 0},
                                          {"wall-door-column-ifc4x3.ifc", 1}};
    for (KnownBuilding building : real)
        for (const std::filesystem::path& file : with_real_worlds({}, {building.file.string()})) {
            building.file = file;
            buildings.push_back(building);
        }
    return buildings;
}

}  // namespace handrail::test
