#include "tests/support/office_ifc.h"
#include "tests/support/names.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <vector>

namespace handrail::test {
namespace {

constexpr double kRoom_m = 5.0, kCorridor_m = 2.4, kWall_m = 0.2, kSlab_m = 0.3, kTall_m = 3.0, kHall_m = 8.0;
constexpr double kStorey_m = kTall_m + kSlab_m, kLane_m = 2.0 * kRoom_m + kCorridor_m + 4.0 * kWall_m;

class Writer {
public:
    explicit Writer(const OfficeIfcSize& size) : size_(size) {}

    OfficeIfc write() {
        office_.text =
            "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('office.ifc','',(''),(''),'','','');\n"
            "FILE_SCHEMA(('IFC2X3'));\nENDSEC;\nDATA;\n";
        origin_ = put("IFCCARTESIANPOINT((0.,0.,0.))");
        up_ = put("IFCDIRECTION((0.,0.,1.))");
        along_[0] = put("IFCDIRECTION((1.,0.,0.))");
        along_[1] = put("IFCDIRECTION((0.,1.,0.))");
        axes_ = put("IFCAXIS2PLACEMENT3D(#{},$,$)", origin_);
        context_ = put("IFCGEOMETRICREPRESENTATIONCONTEXT($,'Model',3,1.E-05,#{},$)", axes_);
        const int metre = put("IFCSIUNIT(*,.LENGTHUNIT.,$,.METRE.)");
        const int units = put("IFCUNITASSIGNMENT((#{}))", metre);
        const int project = put("IFCPROJECT('{}',$,'Office',$,$,$,$,(#{}),#{})", guid(), context_, units);
        const int placed = put("IFCLOCALPLACEMENT($,#{})", axes_);
        const int building = put("IFCBUILDING('{}',$,'Large office',$,$,#{},$,$,.ELEMENT.,$,$,$)", guid(), placed);
        put("IFCRELAGGREGATES('{}',$,$,$,#{},(#{}))", guid(), project, building);
        std::vector<int> storeys;
        for (int s = 0; s < size_.storeys; ++s) storeys.push_back(storey(s));
        put("IFCRELAGGREGATES('{}',$,$,$,#{},({}))", guid(), building, list(storeys));
        office_.text += "ENDSEC;\nEND-ISO-10303-21;\n";
        return std::move(office_);
    }

private:
    template <class... T>
    int put(fmt::format_string<T...> text, T&&... values) {
        fmt::format_to(std::back_inserter(office_.text), "#{}=", ++id_);
        fmt::format_to(std::back_inserter(office_.text), text, std::forward<T>(values)...);
        office_.text += ";\n";
        return id_;
    }
    std::string guid() { return fmt::format("{:022}", ++guid_); }
    static std::string list(const std::vector<int>& ids) {
        std::string text;
        for (const int id : ids) text += fmt::format("{}#{}", text.empty() ? "" : ",", id);
        return text;
    }

    int place(double x, double y, double z, int way = 0) {
        const int at = put("IFCCARTESIANPOINT(({:.4f},{:.4f},{:.4f}))", x, y, z);
        return put("IFCLOCALPLACEMENT($,#{})", put("IFCAXIS2PLACEMENT3D(#{},#{},#{})", at, up_, along_[way]));
    }
    int shape(const char* kind, const std::vector<int>& items) {
        const int of = put("IFCSHAPEREPRESENTATION(#{},'Body','{}',({}))", context_, kind, list(items));
        return put("IFCPRODUCTDEFINITIONSHAPE($,$,(#{}))", of);
    }
    int block(double x, double y, double z, double wide, double deep, double tall) {
        std::vector<int> corners;
        for (const auto& [i, j] : {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1), std::pair(0, 1)})
            corners.push_back(put("IFCCARTESIANPOINT(({:.4f},{:.4f}))", x + i * wide, y + j * deep));
        corners.push_back(corners.front());
        const int outline = put("IFCPOLYLINE(({}))", list(corners));
        const int profile = put("IFCARBITRARYCLOSEDPROFILEDEF(.AREA.,$,#{})", outline);
        const int at = put("IFCAXIS2PLACEMENT3D(#{},$,$)", put("IFCCARTESIANPOINT((0.,0.,{:.4f}))", z));
        return put("IFCEXTRUDEDAREASOLID(#{},#{},#{},{:.4f})", profile, at, up_, tall);
    }
    // Writes a star-shaped prism, which is closed and not convex, and returns its number. Its sides are cut into
    // `facets` triangles, as in exported furniture.
    int star(int facets) {
        const int n = std::max(6, facets / 4);
        const double turn = 2.0 * std::acos(-1.0) / n;
        std::vector<int> low, high, faces;
        for (int i = 0; i < n; ++i) {
            const double r = i % 2 == 0 ? 0.4 : 0.3;
            for (const double z : {0.0, 0.75})
                (z == 0.0 ? low : high)
                    .push_back(put("IFCCARTESIANPOINT(({:.6f},{:.6f},{:.4f}))", r * std::cos(i * turn),
                                   r * std::sin(i * turn), z));
        }
        const auto face = [&](const std::vector<int>& ring) {
            const int loop = put("IFCPOLYLOOP(({}))", list(ring));
            faces.push_back(put("IFCFACE((#{}))", put("IFCFACEOUTERBOUND(#{},.T.)", loop)));
        };
        face({low.rbegin(), low.rend()});
        face(high);
        for (std::size_t i = 0, j = 1; i < low.size(); ++i, j = (i + 1) % low.size()) {
            face({low[i], low[j], high[j]});
            face({low[i], high[j], high[i]});
        }
        return put("IFCFACETEDBREP(#{})", put("IFCCLOSEDSHELL(({}))", list(faces)));
    }

    int product(const char* kind, const char* name, int at, int of, const char* more = "") {
        const int id = put("{}('{}',$,'{}',$,$,#{},#{},${})", kind, guid(), name, at, of, more);
        within_.push_back(id);
        return id;
    }
    // Writes a wall that starts at (x, y). If `filled` is "door" or "window", the wall has an opening of that kind in
    // its middle.
    void wall(double x, double y, double wide, double deep, const char* filled) {
        const int wall =
            product("IFCWALL", "wall", place(x, y, z_), shape("SweptSolid", {block(0, 0, 0, wide, deep, kTall_m)}));
        if (!*filled) return;
        const bool door = *filled == 'd', upright = deep > wide;
        const double width = door ? 1.0 : 1.6, tall = door ? 2.1 : 1.2, middle = 0.5 * (upright ? deep : wide);
        const int at = upright ? place(x + kWall_m / 2, y + middle - width / 2, z_ + (door ? 0.0 : 0.9), 1)
                               : place(x + middle - width / 2, y + kWall_m / 2, z_ + (door ? 0.0 : 0.9));
        const int hole = put("IFCOPENINGELEMENT('{}',$,'hole',$,$,#{},#{},$)", guid(), at,
                             shape("SweptSolid", {block(0, -kWall_m / 2, 0, width, kWall_m, tall)}));
        put("IFCRELVOIDSELEMENT('{}',$,$,$,#{},#{})", guid(), wall, hole);
        const int fill = put("{}('{}',$,'{}',$,$,#{},$,$,{:.1f},{:.1f})", door ? "IFCDOOR" : "IFCWINDOW", guid(),
                             door ? "door" : "window", at, tall, width);
        put("IFCRELFILLSELEMENT('{}',$,$,$,#{},#{})", guid(), hole, fill);
        within_.push_back(fill);
        ++(door ? office_.doors : office_.windows);
    }
    void space(double x, double y, double wide, double deep, const std::string& name) {
        spaces_.push_back(put("IFCSPACE('{}',$,'{}',$,$,#{},#{},$,.ELEMENT.,.INTERNAL.,$)", guid(), name,
                              place(x, y, z_), shape("SweptSolid", {block(0, 0, 0, wide, deep, kTall_m)})));
        ++office_.rooms;
    }

    int storey(int s) {
        z_ = s * kStorey_m;
        within_.clear();
        spaces_.clear();
        const double deep = size_.corridors * kLane_m, wide = size_.rooms_along * (kRoom_m + kWall_m);
        const int id = put("IFCBUILDINGSTOREY('{}',$,'Level {}',$,$,#{},$,$,.ELEMENT.,{:.4f})", guid(), s + 1,
                           place(0, 0, z_), z_);
        const int slab =
            product("IFCSLAB", "slab", place(0, 0, z_),
                    shape("SweptSolid",
                          {block(-kHall_m, -kWall_m, -kSlab_m, wide + kHall_m + kWall_m, deep + 2 * kWall_m, kSlab_m)}),
                    ",.FLOOR.");
        if (s > 0) {  // the hole above the flight that leads up to this storey
            const int hole = put("IFCOPENINGELEMENT('{}',$,'hole',$,$,#{},#{},$)", guid(), place(0, 0, z_),
                                 shape("SweptSolid", {block(-7.0, 0.5, -kSlab_m, 6.0, 1.4, kSlab_m)}));
            put("IFCRELVOIDSELEMENT('{}',$,$,$,#{},#{})", guid(), slab, hole);
        }
        if (s + 1 < size_.storeys) {
            constexpr int kSteps = 20;
            std::vector<int> steps;
            for (int i = 0; i < kSteps; ++i)
                steps.push_back(block(-7.0 + 0.3 * i, 0.5, 0.0, 0.3, 1.4, kStorey_m * (i + 1) / kSteps));
            product("IFCSTAIRFLIGHT", "flight", place(0, 0, z_), shape("SweptSolid", steps));
            ++office_.flights;
        }
        wall(-kHall_m, -kWall_m, kHall_m, kWall_m, "");
        wall(-kHall_m, deep, kHall_m, kWall_m, "");
        wall(-kHall_m, 0, kWall_m, deep, s == 0 ? "door" : "window");
        space(-kHall_m + kWall_m, 0, kHall_m - kWall_m, deep, "Hall");
        for (int c = 0; c < size_.corridors; ++c) lane(c, wide);
        office_.floor_m2 += (wide + kHall_m) * deep;
        put("IFCRELCONTAINEDINSPATIALSTRUCTURE('{}',$,$,$,({}),#{})", guid(), list(within_), id);
        put("IFCRELAGGREGATES('{}',$,$,$,#{},({}))", guid(), id, list(spaces_));
        return id;
    }
    // Writes a corridor along x, with rooms to its south and north.
    void lane(int c, double wide) {
        const double y = c * kLane_m, middle = y + kRoom_m + 2 * kWall_m;
        space(0, middle, wide, kCorridor_m, "Corridor");
        wall(wide, middle, kWall_m, kCorridor_m, "window");
        for (const bool north : {false, true}) {
            const double inner = north ? middle + kCorridor_m : middle - kWall_m,
                         room = north ? inner + kWall_m : y + kWall_m, outer = north ? room + kRoom_m : y;
            for (int i = 0; i < size_.rooms_along; ++i) {
                const double x = i * (kRoom_m + kWall_m);
                wall(x, inner, kRoom_m + kWall_m, kWall_m, "door");
                wall(x, outer, kRoom_m + kWall_m, kWall_m, "window");
                wall(x, room, kWall_m, kRoom_m, "");
                space(x + kWall_m, room, kRoom_m, kRoom_m, fmt::format("{}", 1000 + office_.rooms));
                if (size_.facets_of_furniture > 0)
                    product("IFCFURNISHINGELEMENT", "Armchair", place(x + 3.5, room + 3.5, z_),
                            shape("Brep", {star(size_.facets_of_furniture)}));
            }
            wall(wide, room, kWall_m, kRoom_m, "");
        }
    }

    const OfficeIfcSize& size_;
    OfficeIfc office_;
    int id_ = 0, guid_ = 0, origin_ = 0, up_ = 0, along_[2] = {}, axes_ = 0, context_ = 0;
    double z_ = 0.0;
    std::vector<int> within_, spaces_;
};

}  // namespace

OfficeIfc office_ifc(const OfficeIfcSize& size) { return Writer(size).write(); }

}  // namespace handrail::test
