// Builds small IFC files from boxes. With them, tests check how the reader reads each kind of part.
#pragma once

#include <sstream>

#include "tests/support/names.h"
#include "tests/unit/ifc/ifc_text.h"
#include "worlds/geometry/flat_parts.h"
#include "worlds/geometry/mass_properties.h"

namespace handrail::test {

class Hut {
public:
    // Writes an instance and returns its number.
    int add(const std::string& text) {
        data_ << '#' << ++last_ << '=' << text << ";\n";
        return last_;
    }
    static std::string ref(int id) { return '#' + std::to_string(id); }
    static std::string refs(const std::vector<int>& ids) {
        std::string all;
        for (const int id : ids) all += (all.empty() ? "(" : ",") + ref(id);
        return all + ")";
    }
    int point(const Vec3& p) {
        std::ostringstream text;
        text.precision(12);
        text << std::showpoint << "IFCCARTESIANPOINT((" << p.x << ',' << p.y << ',' << p.z << "))";
        return add(text.str());
    }
    int placed(const Vec3& at) { return add("IFCAXIS2PLACEMENT3D(" + ref(point(at)) + ",$,$)"); }
    int block(const Vec3& least, const Vec3& most) {
        std::ostringstream text;
        text.precision(12);
        text << std::showpoint << "IFCBLOCK(" << ref(placed(least)) << ',' << most.x - least.x << ','
             << most.y - least.y << ',' << most.z - least.z << ')';
        return add(text.str());
    }
    int face(const std::vector<Vec3>& ring) {
        std::vector<int> points;
        for (const Vec3& p : ring) points.push_back(point(p));
        return add("IFCFACE((" +
                   ref(add("IFCFACEOUTERBOUND(" + ref(add("IFCPOLYLOOP(" + refs(points) + ")")) + ",.T.)")) + "))");
    }
    // Adds a closed shell. Its outline, as seen from above, need not be convex.
    int brep(const Ring& outline, double low, double high) {
        std::vector<Vec3> lower, upper;
        for (const Vec2& p : outline) {
            lower.insert(lower.begin(), {p.x, p.y, low});
            upper.push_back({p.x, p.y, high});
        }
        std::vector<int> faces{face(lower), face(upper)};
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const Vec2 &a = outline[i], &b = outline[(i + 1) % outline.size()];
            faces.push_back(face({{a.x, a.y, low}, {b.x, b.y, low}, {b.x, b.y, high}, {a.x, a.y, high}}));
        }
        return add("IFCFACETEDBREP(" + ref(add("IFCCLOSEDSHELL(" + refs(faces) + ")")) + ")");
    }
    // Adds open faces, which enclose no volume.
    int sheet(const std::vector<std::vector<Vec3>>& rings) {
        std::vector<int> faces;
        for (const std::vector<Vec3>& ring : rings) faces.push_back(face(ring));
        return add("IFCSHELLBASEDSURFACEMODEL((" + ref(add("IFCOPENSHELL(" + refs(faces) + ")")) + "))");
    }
    int less(int from, int what) { return add("IFCBOOLEANRESULT(.DIFFERENCE.," + ref(from) + "," + ref(what) + ")"); }
    // Adds a part of the class `kind`. `more` contains the attributes that follow the tag.
    int part(const std::string& kind, const std::string& name, int item, const std::string& more = {},
             int placement = kPlacement) {
        const int shape = add("IFCPRODUCTDEFINITIONSHAPE($,$,(" +
                              ref(add("IFCSHAPEREPRESENTATION(#5,'Body','Brep',(" + ref(item) + "))")) + "))");
        parts_.push_back(add(kind + "('E" + std::to_string(last_ + 1) + "',$,'" + name + "',$,$," + ref(placement) +
                             "," + ref(shape) + ",$" + more + ")"));
        return parts_.back();
    }
    // Adds a space to the storey with index `storey`.
    void space(const std::string& name, int item, int placement = kPlacement, int storey = 0) {
        const int made = part("IFCSPACE", name, item, {}, placement);
        parts_.pop_back();
        if (storey)
            add("IFCRELAGGREGATES('R" + std::to_string(made) + "',$,$,$," + ref(storey) + "," + refs({made}) + ")");
        else spaces_.push_back(made);
    }
    // Adds a storey. `elevation` is the value of the storey's attribute; if empty, that value is `height`.
    int storey(const std::string& name, double height, std::optional<double> elevation = std::nullopt) {
        const int at = add("IFCLOCALPLACEMENT($," + ref(placed({0.0, 0.0, height})) + ")");
        const int made = add("IFCBUILDINGSTOREY('S" + std::to_string(last_ + 1) + "',$,'" + name + "',$,$," + ref(at) +
                             ",$,$,.ELEMENT.," + std::to_string(elevation.value_or(height)) + ")");
        add("IFCRELAGGREGATES('R" + std::to_string(made) + "',$,$,$,#8," + refs({made}) + ")");
        return made;
    }
    void opening(int host, int item, int filling = 0) {
        const int made = part("IFCOPENINGELEMENT", "Opening", item, ",$");
        parts_.pop_back();
        add("IFCRELVOIDSELEMENT('V" + std::to_string(last_) + "',$,$,$," + ref(host) + "," + ref(made) + ")");
        if (filling)
            add("IFCRELFILLSELEMENT('F" + std::to_string(last_) + "',$,$,$," + ref(made) + "," + ref(filling) + ")");
    }
    // Returns the file as text. `storey_m` is the placement of the first storey.
    std::string text(const std::string& schema = "IFC4", const Vec3& storey_m = Vec3(0.0)) const {
        std::ostringstream at;
        at.precision(12);
        at << std::showpoint << '(' << storey_m.x << ',' << storey_m.y << ',' << storey_m.z << ')';
        return "ISO-10303-21;\nHEADER;\nFILE_SCHEMA(('" + schema +
               "'));\nENDSEC;\nDATA;\n#1=IFCCARTESIANPOINT((0.,0.,0.));\n#2=IFCAXIS2PLACEMENT3D(#1,$,$);\n"
               "#3=IFCSIUNIT(*,.LENGTHUNIT.,$,.METRE.);\n#4=IFCUNITASSIGNMENT((#3));\n"
               "#5=IFCGEOMETRICREPRESENTATIONCONTEXT($,'Model',3,1.E-5,#2,$);\n"
               "#6=IFCPROJECT('P',$,'Plan',$,$,$,$,(#5),#4);\n#7=IFCLOCALPLACEMENT($,#2);\n"
               "#8=IFCBUILDING('B',$,'Hut',$,$,#7,$,$,.ELEMENT.,$,$,$);\n"
               "#9=IFCBUILDINGSTOREY('S',$,'Ground',$,$,#14,$,$,.ELEMENT.,0.);\n"
               "#12=IFCCARTESIANPOINT(" +
               at.str() +
               ");\n#13=IFCAXIS2PLACEMENT3D(#12,$,$);\n#14=IFCLOCALPLACEMENT($,#13);\n"
               "#10=IFCRELAGGREGATES('R1',$,$,$,#6,(#8));\n#11=IFCRELAGGREGATES('R2',$,$,$,#8,(#9));\n" +
               data_.str() +
               (spaces_.empty() ? "" : "#999998=IFCRELAGGREGATES('R3',$,$,$,#9," + refs(spaces_) + ");\n") +
               (parts_.empty() ? ""
                               : "#999999=IFCRELCONTAINEDINSPATIALSTRUCTURE('C',$,$,$," + refs(parts_) + ",#9);\n") +
               "ENDSEC;\nEND-ISO-10303-21;\n";
    }
    Scene scene(const std::string& schema = "IFC4", const Vec3& storey_m = Vec3(0.0)) const {
        Result<Scene> read = read_world_bytes("hut.ifc", text(schema, storey_m), {});
        EXPECT_TRUE(read.has_value()) << (read ? "" : read.error().message);
        return read ? *std::move(read) : Scene{};
    }
    static constexpr int kPlacement = 7;

private:
    std::ostringstream data_;
    int last_ = 20;
    std::vector<int> parts_, spaces_;
};

// Returns a hall of 8 by 6 m, which is entered from the west. A wall divides it. Its widest walkable area is a gallery
// without stairs.
inline Hut hall_with_gallery() {
    Hut hut;
    hut.part("IFCSLAB", "Floor", hut.block({-6.0, -2.0, -0.2}, {8.0, 6.0, 0.0}), ",$");
    hut.part("IFCSLAB", "Gallery", hut.block({0.0, 0.0, 2.4}, {8.0, 6.0, 2.6}), ",$");
    hut.part("IFCSLAB", "Ceiling", hut.block({0.0, 0.0, 6.0}, {8.0, 6.0, 6.2}), ",$");
    for (const Aabb& wall : {Aabb{{0.0, -0.2, 0.0}, {8.0, 0.0, 6.0}}, Aabb{{0.0, 6.0, 0.0}, {8.0, 6.2, 6.0}},
                             Aabb{{8.0, -0.2, 0.0}, {8.2, 6.2, 6.0}}, Aabb{{-0.2, 1.2, 0.0}, {0.0, 6.2, 6.0}},
                             Aabb{{0.0, 1.2, 0.0}, {8.0, 1.4, 2.4}}})
        hut.part("IFCWALL", "Wall", hut.block(wall.min_m, wall.max_m), ",$");
    hut.space("Hall", hut.block({0.0, 0.0, 0.0}, {8.0, 6.0, 6.0}));
    return hut;
}

// Returns the volume of the solids that are wholly inside a box.
inline double volume_within_m3(const Scene& scene, const Aabb& box) {
    double sum = 0.0;
    for (const Solid& solid : scene.solids)
        if (solid.shape.bounds_m.min_m.x >= box.min_m.x - 1e-3 && solid.shape.bounds_m.max_m.x <= box.max_m.x + 1e-3 &&
            solid.shape.bounds_m.min_m.y >= box.min_m.y - 1e-3 && solid.shape.bounds_m.max_m.y <= box.max_m.y + 1e-3 &&
            solid.shape.bounds_m.min_m.z >= box.min_m.z - 1e-3 && solid.shape.bounds_m.max_m.z <= box.max_m.z + 1e-3)
            sum += mass_properties(solid.shape).volume_m3;
    return sum;
}

}  // namespace handrail::test
