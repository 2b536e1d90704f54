#include "worlds/readers/foreign_formats.h"

#include <algorithm>
#include <array>

#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail::readers {
namespace {

// The property by which the format of a file is recognised.
enum class Sign {
    None,    // only the ending of the file name shows the format, not the bytes
    Begins,  // the bytes begin with `mark`
    // The file is a ZIP archive that contains a file or a folder named `mark`, or a file with the ending `mark`.
    Zip,
    Markup  // the file is XML with `mark` in its first lines
};

struct ForeignFormat {
    std::string_view ending, programs, instead;
    Sign sign = Sign::None;
    std::string_view mark{};
};

constexpr std::array kFormats{
    ForeignFormat{".sh3d", "Sweet Home 3D", ".obj", Sign::Zip, "Home"},
    ForeignFormat{".sh3d", "Sweet Home 3D", ".obj", Sign::Zip, "Home.xml"},
    ForeignFormat{".usdz", "RoomPlan, Blender", ".glb", Sign::Zip, ".usdc"},
    ForeignFormat{".usdz", "RoomPlan, Blender", ".glb", Sign::Zip, ".usda"},
    ForeignFormat{".usdz", "RoomPlan, Blender", ".glb", Sign::Zip, ".usd"},
    ForeignFormat{".usdc", "Blender, Omniverse", ".glb", Sign::Begins, "PXR-USDC"},
    ForeignFormat{".usda", "Blender, Omniverse", ".glb", Sign::Begins, "#usda"},
    ForeignFormat{".usd", "Blender, Omniverse", ".glb"},
    ForeignFormat{".3mf", "PrusaSlicer, Cura", ".stl", Sign::Zip, "3D/"},
    ForeignFormat{".kmz", "Google Earth", ".osm", Sign::Zip, ".kml"},
    ForeignFormat{".kml", "Google Earth", ".osm", Sign::Markup, "<kml"},
    ForeignFormat{".dae", "SketchUp, Blender", ".glb", Sign::Markup, "<COLLADA"},
    ForeignFormat{".ifcxml", "Revit, Archicad", ".ifc", Sign::Markup, "ifcXML"},
    ForeignFormat{".gml", "FME, 3DCityDB", ".obj", Sign::Markup, "CityModel"},
    ForeignFormat{".citygml", "FME, 3DCityDB", ".obj", Sign::Markup, "opengis.net/gml"},
    ForeignFormat{".gbxml", "Revit", ".ifc", Sign::Markup, "<gbXML"},
    ForeignFormat{".x3d", "Blender", ".glb", Sign::Markup, "<X3D"},
    ForeignFormat{".svg", "Inkscape", ".osm", Sign::Markup, "<svg"},
    ForeignFormat{".svg", "Inkscape", ".osm", Sign::Begins, "<svg"},
    ForeignFormat{".dae", "SketchUp, Blender", ".glb", Sign::Begins, "<COLLADA"},
    ForeignFormat{".kml", "Google Earth", ".osm", Sign::Begins, "<kml"},
    ForeignFormat{".wrl", "Blender, FreeCAD", ".obj", Sign::Begins, "#VRML"},
    ForeignFormat{".rvt", "Revit", ".ifc", Sign::Begins, "\xD0\xCF\x11\xE0"},
    ForeignFormat{".rfa", "Revit", ".ifc"},
    ForeignFormat{".skp", "SketchUp", ".ifc", Sign::Begins, std::string_view("\xFF\xFE\xFF\x0ES\0k\0", 8)},
    ForeignFormat{".dwg", "AutoCAD, BricsCAD", ".ifc", Sign::Begins, "AC10"},
    ForeignFormat{".dxf", "AutoCAD, QCAD, LibreCAD", ".obj", Sign::Begins, "AutoCAD Binary DXF"},
    ForeignFormat{".dxf", "AutoCAD, QCAD, LibreCAD", ".obj", Sign::Begins, "0\nSECTION"},
    ForeignFormat{".dxf", "AutoCAD, QCAD, LibreCAD", ".obj", Sign::Begins, "0\r\nSECTION"},
    ForeignFormat{".dxf", "AutoCAD, QCAD, LibreCAD", ".obj", Sign::Begins, "  0\nSECTION"},
    ForeignFormat{".dxf", "AutoCAD, QCAD, LibreCAD", ".obj", Sign::Begins, "  0\r\nSECTION"},
    ForeignFormat{".fbx", "Maya, Blender", ".glb", Sign::Begins, "Kaydara FBX Binary"},
    ForeignFormat{".fbx", "Maya, Blender", ".glb", Sign::Begins, "; FBX"},
    ForeignFormat{".blend", "Blender", ".glb", Sign::Begins, "BLENDER"},
    ForeignFormat{".vmf", "Hammer", ".map", Sign::Begins, "versioninfo"},
    ForeignFormat{".3ds", "3ds Max", ".obj"},
    ForeignFormat{".max", "3ds Max", ".obj"},
    ForeignFormat{".3dm", "Rhino", ".obj", Sign::Begins, "3D Geometry File Format"},
    ForeignFormat{".pln", "Archicad", ".ifc"},
    ForeignFormat{".vwx", "Vectorworks", ".ifc"},
    ForeignFormat{".fcstd", "FreeCAD", ".ifc", Sign::Zip, "Document.xml"},
    ForeignFormat{".step", "FreeCAD, SolidWorks", ".stl"},
    ForeignFormat{".stp", "FreeCAD, SolidWorks", ".stl"},
};

// Files that contain no building, or a building compiled for a game. Their first bytes identify them.
struct ForeignFile {
    std::string_view first_bytes, says;  // `says` is the key of the text about this format
};
constexpr std::array kFiles{
    ForeignFile{"version https://git-lfs", "reader.lfs_pointer"},
    ForeignFile{std::string_view("\x1D\0\0\0", 4), "reader.compiled_quake"},
    ForeignFile{std::string_view("\x1E\0\0\0", 4), "reader.compiled_half_life"},
    ForeignFile{"IBSP", "reader.compiled_game"},
    ForeignFile{"VBSP", "reader.compiled_source"},
    ForeignFile{"BSP2", "reader.compiled_quake"},
    ForeignFile{"PACK", "reader.game_archive"},
    ForeignFile{"PK\x03\x04", "reader.zip"},
    ForeignFile{"WAD2", "reader.textures"},
    ForeignFile{"WAD3", "reader.textures"},
    ForeignFile{"\x1F\x8B", "reader.compressed"},
    ForeignFile{"%PDF", "reader.document"},
    ForeignFile{"\x89PNG", "reader.picture"},
    ForeignFile{"<?xml", "reader.xml"},
};

// True for RMF, Worldcraft's own format. It begins with a number, which these three letters follow.
bool is_rmf(std::string_view bytes) { return bytes.size() > 7 && bytes.substr(4, 3) == "RMF"; }

std::string sentence_of(const ForeignFormat& format) {
    return phrase("reader.foreign",
                  {{"format", format.ending}, {"programs", format.programs}, {"instead", format.instead}});
}

std::size_t number_at(std::string_view bytes, std::size_t at) {
    return static_cast<std::size_t>(static_cast<unsigned char>(bytes[at])) |
           static_cast<std::size_t>(static_cast<unsigned char>(bytes[at + 1])) << 8U;
}

// True if the list of files at the end of a ZIP archive contains `mark`. Each entry of that list has 46 bytes, two of
// which hold the length of the name, and then the name.
bool holds(std::string_view archive, std::string_view mark) {
    constexpr std::size_t kList_bytes = 65'536, kBefore = 46, kLength = 28;
    const std::string_view list = archive.substr(archive.size() - std::min(archive.size(), kList_bytes));
    for (std::size_t at = list.find("PK\x01\x02"); at != std::string_view::npos && at + kBefore <= list.size();
         at = list.find("PK\x01\x02", at + kBefore)) {
        const std::string_view name = list.substr(at + kBefore, number_at(list, at + kLength));
        if (name == mark || (mark.front() == '.' && name.ends_with(mark)) ||
            (mark.back() == '/' && name.starts_with(mark)))
            return true;
    }
    return false;
}

bool is_of(const ForeignFormat& format, std::string_view bytes) {
    constexpr std::size_t kFirst_bytes = 4096;
    switch (format.sign) {
        case Sign::None:
            return false;
        case Sign::Begins:
            return bytes.starts_with(format.mark);
        case Sign::Zip:
            return bytes.starts_with("PK\x03\x04") && holds(bytes, format.mark);
        case Sign::Markup:
            return bytes.starts_with("<?xml") &&
                   bytes.substr(0, kFirst_bytes).find(format.mark) != std::string_view::npos;
    }
    return false;
}

}  // namespace

std::string foreign_by_content(std::string_view bytes) {
    if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
    for (const ForeignFormat& format : kFormats)
        if (is_of(format, bytes)) return sentence_of(format);
    for (const ForeignFile& file : kFiles)
        if (bytes.starts_with(file.first_bytes)) return phrase(file.says);
    return is_rmf(bytes) ? phrase("reader.worldcraft") : std::string();
}

std::string foreign_by_ending(const std::filesystem::path& path) {
    const std::string ending = lower_ascii(path.extension().string());
    const auto* const found = std::find_if(kFormats.begin(), kFormats.end(),
                                           [&](const ForeignFormat& format) { return format.ending == ending; });
    return found == kFormats.end() ? std::string() : sentence_of(*found);
}

}  // namespace handrail::readers
