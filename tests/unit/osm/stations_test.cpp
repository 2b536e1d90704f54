// Stations and campuses as mappers draw them: doors beside outlines, platforms, lifts and ways without rooms.
#include <gmock/gmock.h>

#include "tests/unit/osm/osm_text.h"
#include "worlds/navigation/navigation.h"
#include "worlds/scene/honest_report.h"

namespace handrail {
namespace osm_stations_test {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

// Writes a file of nodes and ways from places in metres.
class Drawing {
public:
    using Tags = std::vector<std::pair<std::string, std::string>>;

    int node(double east_m, double north_m, const Tags& tags = {}) {
        constexpr double kDegree_m = 111'319.49;
        const double lat = 51.0 + north_m / kDegree_m, lon = 7.0 + east_m / (kDegree_m * std::cos(51.0 * kPi / 180.0));
        std::ostringstream text;
        text.precision(12);
        text << "<node id='" << ++ids_ << "' lat='" << lat << "' lon='" << lon << "'>" << words(tags) << "</node>\n";
        nodes_ += text.str();
        return ids_;
    }
    int way(const std::vector<int>& nodes, const Tags& tags) {
        ways_ += "<way id='" + std::to_string(++ids_) + "'>";
        for (const int n : nodes) ways_ += "<nd ref='" + std::to_string(n) + "'/>";
        ways_ += words(tags) + "</way>\n";
        return ids_;
    }
    int box(double west_m, double south_m, double east_m, double north_m, const Tags& tags) {
        const int first = node(west_m, south_m);
        return way({first, node(east_m, south_m), node(east_m, north_m), node(west_m, north_m), first}, tags);
    }
    void relation(const std::string& members, const Tags& tags) {
        relations_ += "<relation id='" + std::to_string(++ids_) + "'>" + members + words(tags) + "</relation>\n";
    }
    Scene scene() const {
        Result<Scene> scene =
            read_osm("<osm version='0.6'>\n" + nodes_ + ways_ + relations_ + "</osm>\n", "station.osm");
        EXPECT_TRUE(scene.has_value()) << scene.error().sentence();
        if (!scene) return {};
        const Result<void> valid = validate(*scene);
        EXPECT_TRUE(valid.has_value()) << valid.error().sentence();
        return std::move(*scene);
    }

private:
    static std::string words(const Tags& tags) {
        std::string text;
        for (const auto& [key, value] : tags) text += "<tag k='" + key + "' v='" + value + "'/>";
        return text;
    }

    int ids_ = 0;
    std::string nodes_, ways_, relations_;
};

TEST(OsmDoors, up_to_0_3_m_beside_outlines_they_join_the_rooms_there) {
    for (const double beside_m : {-0.29, -0.1, -0.004, 0.0, 0.01, 0.2, 0.29, -0.5, 0.5}) {
        Drawing drawing;
        for (const char* level : {"0", "1"}) {
            drawing.box(0, 0, 6, 4, {{"indoor", "room"}, {"level", level}, {"name", std::string("West ") + level}});
            drawing.box(6, 0, 12, 4, {{"indoor", "room"}, {"level", level}, {"name", std::string("East ") + level}});
        }
        drawing.node(6 + beside_m, 2, {{"door", "hinged"}, {"level", "0;1"}});
        const std::vector<std::string> joins = test::joins_of(drawing.scene(), StatedPortalKind::Door);
        if (std::abs(beside_m) < 0.3)
            EXPECT_THAT(joins, UnorderedElementsAre("West 0 | East 0", "West 1 | East 1")) << beside_m;
        else EXPECT_THAT(joins, IsEmpty()) << beside_m;
    }
}

TEST(OsmDoors, a_node_of_one_level_serves_the_outline_beside_it_on_the_other) {
    Drawing drawing;
    const int door = drawing.node(6, 2, {{"door", "yes"}, {"level", "0;1"}});
    const int first = drawing.node(0, 0);
    drawing.way({first, drawing.node(6, 0), door, drawing.node(6, 4), drawing.node(0, 4), first},
                {{"indoor", "room"}, {"level", "0"}, {"name", "West 0"}});
    drawing.box(6, 0, 12, 4, {{"indoor", "room"}, {"level", "0"}, {"name", "East 0"}});
    drawing.box(0, 0, 6.1, 4, {{"indoor", "room"}, {"level", "1"}, {"name", "West 1"}});
    drawing.box(6.1, 0, 12, 4, {{"indoor", "room"}, {"level", "1"}, {"name", "East 1"}});
    EXPECT_THAT(test::joins_of(drawing.scene(), StatedPortalKind::Door),
                UnorderedElementsAre("West 0 | East 0", "West 1 | East 1"));
}

}  // namespace osm_stations_test
}  // namespace handrail
