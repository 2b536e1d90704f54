// Writes a building in other file formats, for tests that compare the formats.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <functional>
#include <optional>
#include <string>

#include "tests/support/map_text.h"
#include "tests/support/names.h"
#include "worlds/exports/as_words.h"
#include "worlds/floorplan/local_plane.h"
#include "worlds/scene/scene.h"
#include "worlds/scene/stated_building.h"

namespace handrail::test {

template <class Value>
inline void append(std::string& bytes, Value value) {
    std::array<char, sizeof(Value)> raw{};
    std::memcpy(raw.data(), &value, sizeof(Value));
    bytes.append(raw.data(), raw.size());
}

// Returns the building as a map. Walls become brushes and leaves become doors. If `names` is empty, the rooms get the
// names in `scene.stated`.
inline std::string map_of(const Scene& scene, std::vector<RoomName> names = {}) {
    constexpr double kUnits = 32.0;  // units per metre
    std::string walls, rest;
    for (const Solid& solid : scene.solids) {
        std::string brush = "{\n";
        for (std::size_t f = 0; f < solid.shape.faces.size(); ++f) {
            std::array<Vec3, 3> p{};
            for (std::size_t i = 0; i < 3; ++i) p[i] = solid.shape.faces[f].points_m[i] * kUnits;
            if (glm::dot(glm::cross(p[0] - p[1], p[2] - p[1]), solid.shape.planes[f].normal) < 0.0)
                std::swap(p[0], p[2]);
            for (const Vec3& point : p) brush += fmt::format("( {:.9f} {:.9f} {:.9f} ) ", point.x, point.y, point.z);
            brush += "plain 0 0 0 1 1\n";
        }
        brush += "}\n";
        const Feature* feature = scene.find(solid.feature);
        if (solid.role == SolidRole::Mover)
            rest += entity("func_door",
                           key("name", feature->name) + key("hinge", feature->hinge) + key("handle", feature->handle),
                           brush);
        else if (solid.role == SolidRole::Solid) walls += brush;
    }
    const auto origin = [](const Vec3& at_m) {
        const Vec3 at = at_m * kUnits;
        return key("origin", fmt::format("{} {} {}", at.x, at.y, at.z));
    };
    if (names.empty())
        for (const StatedRoom& room : scene.stated->rooms) names.push_back({room.at_m, room.name, {}});
    for (const RoomName& name : names)
        rest += entity("info_room", key("name", name.name) + origin(name.at_m + Vec3(0.0, 0.0, 0.5)));
    for (const Start& start : scene.starts)
        rest += entity("info_player_start", origin(start.feet_m + Vec3(0.0, 0.0, 0.75)));
    return entity("worldspawn", key("message", "House") + key("building", "1"), walls) + rest;
}

// Returns the building as a glTF file. Boxes become meshes of twelve triangles with y up. The leaves are omitted,
// because a mesh knows no doors.
inline std::string glb_of(const Scene& scene) {
    std::string points, nodes, meshes, accessors, views;
    int count = 0;
    for (const Solid& solid : scene.solids) {
        if (solid.role != SolidRole::Solid) continue;
        const std::size_t from = points.size();
        std::size_t corners = 0;
        for (std::size_t f = 0; f < solid.shape.faces.size(); ++f) {
            std::vector<Vec3> face = solid.shape.faces[f].points_m;
            if (glm::dot(glm::cross(face[1] - face[0], face[2] - face[0]), solid.shape.planes[f].normal) < 0)
                std::reverse(face.begin(), face.end());
            for (std::size_t i = 2; i < face.size(); ++i)
                for (const Vec3& p : {face[0], face[i - 1], face[i]}) {
                    append(points, static_cast<float>(p.x));
                    append(points, static_cast<float>(p.z));
                    append(points, static_cast<float>(-p.y));
                    ++corners;
                }
        }
        const std::string comma = count > 0 ? "," : "";
        views +=
            fmt::format("{}{{\"buffer\":0,\"byteOffset\":{},\"byteLength\":{}}}", comma, from, points.size() - from);
        accessors += fmt::format("{}{{\"bufferView\":{},\"componentType\":5126,\"count\":{},\"type\":\"VEC3\"}}", comma,
                                 count, corners);
        meshes += fmt::format("{}{{\"primitives\":[{{\"attributes\":{{\"POSITION\":{}}}}}]}}", comma, count);
        nodes += fmt::format("{}{{\"name\":\"part {}\",\"mesh\":{}}}", comma, count, count);
        ++count;
    }
    std::string roots;
    for (int i = 0; i < count; ++i) roots += (i > 0 ? "," : "") + std::to_string(i);
    std::string json = fmt::format(
        "{{\"asset\":{{\"version\":\"2.0\"}},\"scene\":0,\"scenes\":[{{\"nodes\":[{}]}}],\"nodes\":[{}],\"meshes\":[{}]"
        ","
        "\"accessors\":[{}],\"bufferViews\":[{}],\"buffers\":[{{\"byteLength\":{}}}]}}",
        roots, nodes, meshes, accessors, views, points.size());
    while (json.size() % 4 != 0) json += ' ';
    std::string glb = "glTF";
    append(glb, std::uint32_t{2});
    append(glb, static_cast<std::uint32_t>(28 + json.size() + points.size()));
    append(glb, static_cast<std::uint32_t>(json.size()));
    glb += "JSON" + json;
    append(glb, static_cast<std::uint32_t>(points.size()));
    glb += std::string("BIN\0", 4) + points;
    return glb;
}

// Returns the rooms extended to the middle of walls: by half the gap between two rooms, or by half of an outer wall.
inline WordsHouse to_the_middle_of_walls(WordsHouse house) {
    constexpr double kOuterWall_m = 0.2, kThickest_m = 0.5;
    const WordsHouse before = house;
    for (std::size_t r = 0; r < house.rooms.size(); ++r)
        for (Vec2& corner : house.rooms[r].rings[0]) {
            Vec2 middle(0.0);
            for (const Vec2& p : before.rooms[r].rings[0]) middle += p * 0.25;
            for (int axis = 0; axis < 2; ++axis) {
                double gap = kOuterWall_m;
                for (std::size_t o = 0; o < house.rooms.size(); ++o)
                    for (const Vec2& p : before.rooms[o].rings[0])
                        if (const double far = (p[axis] - corner[axis]) * (corner[axis] > middle[axis] ? 1.0 : -1.0);
                            o != r && far > 0.01 && far < kThickest_m)
                            gap = std::min(gap, far);
                corner[axis] += (corner[axis] > middle[axis] ? 0.5 : -0.5) * gap;
            }
        }
    return house;
}

inline std::string osm_of(const WordsHouse& house) {
    const Vec2 origin(13.0, 51.0);
    const Vec2 a_degree = LocalPlane(origin).place_m(origin + 1.0);
    std::string nodes, ways, relations;
    int number = 0;
    std::vector<int> door_nodes;
    const auto node = [&](const Vec2& at, const std::string& tags = {}) {
        nodes += fmt::format("<node id='{}' lat='{:.11f}' lon='{:.11f}'>{}</node>\n", ++number,
                             origin.y + at.y / a_degree.y, origin.x + at.x / a_degree.x, tags);
        return number;
    };
    for (const WordsHouse::Door& door : house.doors)
        door_nodes.push_back(node(
            door.at_m, fmt::format("<tag k='door' v='{}'/><tag k='width' v='{}'/>{}", door.opening ? "no" : "hinged",
                                   door.width_m, door.rooms.size() == 1 ? "<tag k='entrance' v='main'/>" : "")));
    // Returns references to the outline's corners and, between the corners, to the doors on the outline's edges. If
    // another room of the storey has a corner on this outline, the outline gets a corner there, too, as mappers draw
    // it.
    const auto refs_of = [&](const std::vector<Vec2>& ring, std::size_t r) {
        const WordsHouse::Room& room = house.rooms[r];
        std::string refs;
        int first = 0;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Vec2 from = ring[i], way = ring[(i + 1) % ring.size()] - from;
            const int corner = node(from);
            if (i == 0) first = corner;
            refs += fmt::format("<nd ref='{}'/>", corner);
            std::vector<std::pair<double, int>> on_edge;
            const auto lies_on = [&](const Vec2& p, double near_m) -> std::optional<double> {
                const double along = glm::dot(p - from, way) / glm::dot(way, way);
                if (!(along > 0.0 && along < 1.0) || glm::length(p - from - way * along) >= near_m) return std::nullopt;
                return along;
            };
            for (std::size_t d = 0; d < house.doors.size(); ++d) {
                const std::vector<std::size_t>& rooms = house.doors[d].rooms;
                if (std::find(rooms.begin(), rooms.end(), r) == rooms.end()) continue;
                if (const auto along = lies_on(house.doors[d].at_m, 0.15)) on_edge.emplace_back(*along, door_nodes[d]);
            }
            for (const WordsHouse::Room& other : house.rooms) {
                if (&other == &room || other.storey > std::max(room.storey, room.to_storey) ||
                    room.storey > std::max(other.storey, other.to_storey))
                    continue;
                for (const std::vector<Vec2>& other_ring : other.rings)
                    for (const Vec2& p : other_ring)
                        if (const auto along = lies_on(p, 0.02)) on_edge.emplace_back(*along, node(p));
            }
            std::sort(on_edge.begin(), on_edge.end());
            for (const auto& [along, ref] : on_edge) refs += fmt::format("<nd ref='{}'/>", ref);
        }
        return refs + fmt::format("<nd ref='{}'/>", first);
    };
    for (std::size_t r = 0; r < house.rooms.size(); ++r) {
        const WordsHouse::Room& room = house.rooms[r];
        const std::string level = room.to_storey > room.storey ? fmt::format("{}-{}", room.storey, room.to_storey)
                                                               : std::to_string(room.storey);
        const std::string tags =
            fmt::format("<tag k='indoor' v='room'/><tag k='level' v='{}'/>{}<tag k='name' v=\"{}\"/>", level,
                        room.to_storey > room.storey ? "<tag k='stairs' v='yes'/>" : "", room.name);
        const std::size_t way = 100'000 + 100 * r;
        const bool holes = room.rings.size() > 1;
        ways += fmt::format("<way id='{}'>{}{}</way>\n", way, refs_of(room.rings[0], r), holes ? "" : tags);
        if (!holes) continue;
        relations += fmt::format("<relation id='{}'><member type='way' ref='{}' role='outer'/>", way, way);
        for (std::size_t h = 1; h < room.rings.size(); ++h) {
            ways += fmt::format("<way id='{}'>{}</way>\n", way + h, refs_of(room.rings[h], r));
            relations += fmt::format("<member type='way' ref='{}' role='inner'/>", way + h);
        }
        relations += "<tag k='type' v='multipolygon'/>" + tags + "</relation>\n";
    }
    return "<osm version='0.6'>\n" + nodes + ways + relations + "</osm>\n";
}

// Writes the building as IFC. All solids become closed faces, leaves become doors of their size, and rooms become
// spaces over their outlines. Lengths are in metres or millimetres.
class IfcOf {
public:
    IfcOf(const Scene& scene, const WordsHouse& house, bool millimetres)
        : scene_(scene), house_(house), unit_(millimetres ? 1000.0 : 1.0) {
        origin_ = put("IFCCARTESIANPOINT((0.,0.,0.))");
        up_ = put("IFCDIRECTION((0.,0.,1.))");
        along_[0] = put("IFCDIRECTION((1.,0.,0.))");
        along_[1] = put("IFCDIRECTION((0.,1.,0.))");
        axes_ = put(fmt::format("IFCAXIS2PLACEMENT3D(#{},$,$)", origin_));
        context_ = put(fmt::format("IFCGEOMETRICREPRESENTATIONCONTEXT($,'Model',3,1.E-05,#{},$)", axes_));
        const int unit = put(fmt::format("IFCSIUNIT(*,.LENGTHUNIT.,{},.METRE.)", millimetres ? ".MILLI." : "$"));
        const int project = put(fmt::format("IFCPROJECT({},'House',$,$,$,$,(#{}),#{})", guid(), context_,
                                            put(fmt::format("IFCUNITASSIGNMENT((#{}))", unit))));
        zero_ = put(fmt::format("IFCLOCALPLACEMENT($,#{})", axes_));
        const int building =
            put(fmt::format("IFCBUILDING({},'{}',$,$,#{},$,$,.ELEMENT.,$,$,$)", guid(), house.name, zero_));
        put(fmt::format("IFCRELAGGREGATES({},$,$,#{},(#{}))", guid() + ",$", project, building));
        std::vector<int> storeys;
        for (std::size_t s = 0; s < house.storeys.size(); ++s)
            storeys.push_back(put(fmt::format("IFCBUILDINGSTOREY({},'Storey {}',$,$,#{},$,$,.ELEMENT.,{:.6f})", guid(),
                                              s, zero_, house.storeys[s].floor_m * unit_)));
        relate("IFCRELAGGREGATES", building, storeys);
        std::vector<std::vector<int>> spaces(storeys.size());
        for (const WordsHouse::Room& room : house.rooms) spaces[room.storey].push_back(space(room));
        std::vector<int> parts;
        for (const Solid& solid : scene.solids)
            if (solid.role == SolidRole::Solid || solid.role == SolidRole::Mover) parts.push_back(part(solid));
        put(fmt::format("IFCRELCONTAINEDINSPATIALSTRUCTURE({},$,$,({}),#{})", guid() + ",$", list(parts), storeys[0]));
        for (std::size_t s = 0; s < storeys.size(); ++s) relate("IFCRELAGGREGATES", storeys[s], spaces[s]);
    }

    std::string text() const {
        return "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('house.ifc','',(''),(''),'','','');\n"
               "FILE_SCHEMA(('IFC2X3'));\nENDSEC;\nDATA;\n" +
               text_ + "ENDSEC;\nEND-ISO-10303-21;\n";
    }

private:
    int put(const std::string& what) {
        text_ += fmt::format("#{}={};\n", ++id_, what);
        return id_;
    }
    std::string guid() { return fmt::format("'{:022}'", ++guid_); }
    static std::string list(const std::vector<int>& ids) {
        std::string text;
        for (const int id : ids) text += fmt::format("{}#{}", text.empty() ? "" : ",", id);
        return text;
    }
    void relate(const char* how, int whole, const std::vector<int>& parts) {
        if (!parts.empty()) put(fmt::format("{}({},$,$,#{},({}))", how, guid() + ",$", whole, list(parts)));
    }
    int point(const Vec3& p) {
        return put(fmt::format("IFCCARTESIANPOINT(({:.7f},{:.7f},{:.7f}))", p.x * unit_, p.y * unit_, p.z * unit_));
    }
    int placed(const Vec3& at, int way) {
        return put(fmt::format("IFCLOCALPLACEMENT($,#{})",
                               put(fmt::format("IFCAXIS2PLACEMENT3D(#{},#{},#{})", point(at), up_, along_[way]))));
    }
    int shape(const std::string& kind, int item) {
        const int body = put(fmt::format("IFCSHAPEREPRESENTATION(#{},'Body','{}',(#{}))", context_, kind, item));
        return put(fmt::format("IFCPRODUCTDEFINITIONSHAPE($,$,(#{}))", body));
    }
    int brep(const std::vector<Polygon>& faces, const std::function<Vec3(const Vec3&)>& local) {
        std::vector<int> made;
        for (const Polygon& face : faces) {
            std::vector<int> points;
            for (const Vec3& p : face.points_m) points.push_back(point(local(p)));
            const int loop = put(fmt::format("IFCPOLYLOOP(({}))", list(points)));
            made.push_back(put(fmt::format("IFCFACE((#{}))", put(fmt::format("IFCFACEOUTERBOUND(#{},.T.)", loop)))));
        }
        return put(fmt::format("IFCFACETEDBREP(#{})", put(fmt::format("IFCCLOSEDSHELL(({}))", list(made)))));
    }
    int part(const Solid& solid) {
        const Aabb& box = solid.shape.bounds_m;
        const Feature* feature = scene_.find(solid.feature);
        const std::string name = feature ? feature->name : "part";
        std::string spoken;  // doubles each apostrophe
        for (const char c : name) spoken += c == '\'' ? std::string("''") : std::string(1, c);
        if (solid.role == SolidRole::Mover) {
            const bool north = box.size_m().y > box.size_m().x;
            const Vec3 at(north ? box.max_m.x : box.min_m.x, box.min_m.y, box.min_m.z);
            const auto local = [&](const Vec3& p) {
                const Vec3 off = p - at;
                return north ? Vec3(off.y, -off.x, off.z) : off;
            };
            const int place = placed(at, north ? 1 : 0);
            return put(fmt::format("IFCDOOR({},$,'{}',$,$,#{},#{},$,{:.6f},{:.6f})", guid(), spoken, place,
                                   shape("Brep", brep(solid.shape.faces, local)), box.size_m().z * unit_,
                                   std::max(box.size_m().x, box.size_m().y) * unit_));
        }
        const int body = shape("Brep", brep(solid.shape.faces, [](const Vec3& p) { return p; }));
        const bool flat = box.size_m().z < 0.5 && std::min(box.size_m().x, box.size_m().y) > 1.0;
        if (!feature || feature->kind != FeatureKind::Object)
            return put(
                fmt::format("{}({},$,'{}',$,$,#{},#{},$)", flat ? "IFCSLAB" : "IFCWALL", guid(), spoken, zero_, body));
        if (name == "Stairs")
            return put(fmt::format("IFCSTAIRFLIGHT({},$,'{}',$,$,#{},#{},$,$,$,$,$)", guid(), spoken, zero_, body));
        return put(fmt::format("IFCFURNISHINGELEMENT({},$,'{}',$,$,#{},#{},$)", guid(), spoken, zero_, body));
    }
    int space(const WordsHouse::Room& room) {
        std::vector<int> curves;
        for (const std::vector<Vec2>& ring : room.rings) {
            std::vector<int> points;
            for (const Vec2& p : ring)
                points.push_back(put(fmt::format("IFCCARTESIANPOINT(({:.7f},{:.7f}))", p.x * unit_, p.y * unit_)));
            points.push_back(points.front());
            curves.push_back(put(fmt::format("IFCPOLYLINE(({}))", list(points))));
        }
        const std::vector<int> holes(curves.begin() + 1, curves.end());
        const int profile =
            holes.empty()
                ? put(fmt::format("IFCARBITRARYCLOSEDPROFILEDEF(.AREA.,$,#{})", curves[0]))
                : put(fmt::format("IFCARBITRARYPROFILEDEFWITHVOIDS(.AREA.,$,#{},({}))", curves[0], list(holes)));
        const double floor_m = house_.storeys[room.storey].floor_m,
                     top_m = house_.storeys[std::max(room.storey, room.to_storey)].floor_m + 2.6;
        const int solid = put(
            fmt::format("IFCEXTRUDEDAREASOLID(#{},#{},#{},{:.6f})", profile, axes_, up_, (top_m - floor_m) * unit_));
        std::string name;
        for (const char c : room.name) name += c == '\'' ? std::string("''") : std::string(1, c);
        const int place = placed({0.0, 0.0, floor_m}, 0);
        return put(fmt::format("IFCSPACE({},$,'{}',$,$,#{},#{},'{}',.ELEMENT.,.INTERNAL.,$)", guid(), ++number_, place,
                               shape("SweptSolid", solid), name));
    }

    const Scene& scene_;
    const WordsHouse& house_;
    double unit_;
    std::string text_;
    int id_ = 0, guid_ = 0, number_ = 0, origin_ = 0, up_ = 0, axes_ = 0, context_ = 0, zero_ = 0;
    std::array<int, 2> along_{};
};

}  // namespace handrail::test
