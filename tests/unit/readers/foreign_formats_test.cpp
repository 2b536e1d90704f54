// Tests formats that the program recognises by file extension and content, but does not read.
#include "worlds/readers/foreign_formats.h"

#include <gmock/gmock.h>

#include "tests/support/names.h"
#include "tests/support/precompiled.h"
#include "worlds/readers/reader.h"

namespace handrail {
namespace foreign_formats_test {

using testing::HasSubstr;

std::string said_of(const std::string& name, std::string_view bytes) {
    const Result<Scene> scene = read_world_bytes(name, bytes, {});
    return scene ? "read as " + scene->report.format : scene.error().message;
}

// Returns the header of an archive's first entry, followed by the directory of an archive that contains one file called
// `name`.
std::string archive_with(const std::string& name) {
    std::string list(46, '\0');
    list.replace(0, 4, "PK\x01\x02");
    list[28] = static_cast<char>(name.size());
    return std::string("PK\x03\x04") + std::string(26, '\0') + list + name + std::string(8, '\0');
}

TEST(ForeignFormats, are_recognised_by_their_extension_and_get_advice_on_what_to_export) {
    for (const auto& [ending, program, instead] :
         {std::tuple{".sh3d", "Sweet Home 3D", ".obj"}, std::tuple{".usdz", "RoomPlan", ".glb"},
          std::tuple{".3mf", "PrusaSlicer", ".stl"}, std::tuple{".dae", "SketchUp", ".glb"},
          std::tuple{".gml", "3DCityDB", ".obj"}, std::tuple{".ifcxml", "Revit", ".ifc"},
          std::tuple{".kml", "Google Earth", ".osm"}, std::tuple{".rvt", "Revit", ".ifc"},
          std::tuple{".skp", "SketchUp", ".ifc"}, std::tuple{".dwg", "AutoCAD", ".ifc"},
          std::tuple{".dxf", "AutoCAD", ".obj"}, std::tuple{".svg", "Inkscape", ".osm"},
          std::tuple{".FBX", "Blender", ".glb"}, std::tuple{".vmf", "Hammer", ".map"}}) {
        const std::string text = said_of(std::string("a") + ending, "something");
        EXPECT_THAT(text, HasSubstr(program)) << ending;
        EXPECT_THAT(text, HasSubstr(std::string("as ") + instead)) << ending;
    }
}

TEST(ForeignFormats, are_recognised_by_their_content_under_any_name) {
    const std::string xml = "<?xml version=\"1.0\"?>\n";
    for (const auto& [bytes, format] :
         {std::pair{archive_with("Home"), ".sh3d"}, std::pair{archive_with("scan.usdc"), ".usdz"},
          std::pair{archive_with("3D/3dmodel.model"), ".3mf"}, std::pair{archive_with("doc.kml"), ".kmz"},
          std::pair{xml + "<COLLADA version=\"1.4.1\">", ".dae"}, std::pair{xml + "<kml>", ".kml"},
          std::pair{xml + "<core:CityModel>", ".gml"}, std::pair{xml + "<ifc:ifcXML>", ".ifcxml"},
          std::pair{xml + "<svg>", ".svg"}, std::pair{std::string("\xEF\xBB\xBF") + xml + "<svg>", ".svg"},
          std::pair{std::string("<svg width='1'>"), ".svg"}, std::pair{std::string("AC1032 and so on"), ".dwg"},
          std::pair{std::string("  0\r\nSECTION\r\n"), ".dxf"}, std::pair{std::string("Kaydara FBX Binary  "), ".fbx"},
          std::pair{std::string("versioninfo\n{\n}\n"), ".vmf"}})
        for (const std::string name : {"a.map", "a.zip", "a"})
            EXPECT_THAT(said_of(name, bytes), HasSubstr(std::string(format) + " files")) << format;
    EXPECT_THAT(said_of("a.zip", archive_with("Homework.txt")), HasSubstr("zip archive"));
    EXPECT_THAT(said_of("a.xml", xml + "<note>"), HasSubstr("XML file"));
}

TEST(ForeignFormats, cut_at_any_byte_are_survived) {
    const std::string whole = archive_with("3D/3dmodel.model");
    for (std::size_t n = 1; n < whole.size(); ++n)
        EXPECT_FALSE(foreign_by_content(whole.substr(0, n)).empty() && n > 4);
}

}  // namespace foreign_formats_test
}  // namespace handrail
