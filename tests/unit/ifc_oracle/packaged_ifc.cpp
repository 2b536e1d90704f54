#include "tests/unit/ifc_oracle/packaged_ifc.h"
#include "tests/support/names.h"

#include <ifcpp/IFC4/include/IfcGloballyUniqueId.h>
#include <ifcpp/IFC4/include/IfcProduct.h>
#include <ifcpp/geometry/Carve/GeometryConverter.h>
#include <ifcpp/model/BuildingModel.h>
#include <ifcpp/reader/ReaderSTEP.h>

#include <set>

namespace handrail::test {
namespace {

// Adds up the volumes of tetrahedra. Their common corner is the mesh's first point, so that a wall far from the origin
// keeps its precision.
void add_mesh(const carve::mesh::Mesh<3>& mesh, const carve::math::Matrix& placed, PackagedPart& part) {
    using Vertex = carve::mesh::Vertex<3>;
    const auto at = [&](const Vertex* v) {
        const auto p = placed * v->v;
        return Vec3(p.x, p.y, p.z);
    };
    double six = 0.0;
    bool begun = false;
    Vec3 from{0.0};
    for (const auto* face : mesh.faces) {
        std::vector<Vertex*> corners;
        face->getVertices(corners);
        for (const Vertex* corner : corners) part.box.include(at(corner));
        if (corners.empty()) continue;
        if (!std::exchange(begun, true)) from = at(corners[0]);
        for (std::size_t i = 2; i < corners.size(); ++i)
            six += glm::dot(at(corners[0]) - from, glm::cross(at(corners[i - 1]) - from, at(corners[i]) - from));
    }
    if (const_cast<carve::mesh::Mesh<3>&>(mesh).isClosed()) {
        part.closed_volume_m3 += six / 6.0;
    } else {
        ++part.open;
    }
}

}  // namespace

std::map<std::string, PackagedPart> parts_by_package(std::string_view file) {
    std::string content(file);
    shared_ptr<BuildingModel> model(new BuildingModel());
    ReaderSTEP reader;
    reader.loadModelFromString(content, model);
    GeometryConverter converter(model);
    converter.convertGeometry();
    const std::set<std::wstring> bodies{L"", L"Body", L"Facetation", L"Tessellation"};
    std::map<std::string, PackagedPart> parts;
    for (const auto& [id, shape] : converter.getShapeInputData()) {
        const auto product = dynamic_pointer_cast<IfcProduct>(shape->m_ifc_object_definition.lock());
        if (!product || !product->m_GlobalId) continue;
        const std::wstring& guid = product->m_GlobalId->m_value;
        PackagedPart& part = parts[std::string(guid.begin(), guid.end())];  // the key is the GlobalId in base 64
        part.kind = product->className();
        const carve::math::Matrix placed = shape->getTransform();
        for (const auto& representation : shape->m_vec_representations) {
            if (!bodies.contains(representation->m_representation_identifier)) continue;
            for (const auto& item : representation->m_vec_item_data)
                for (const auto* sets : {&item->m_meshsets, &item->m_meshsets_open})
                    for (const auto& set : *sets)
                        for (const auto* mesh : set->meshes) add_mesh(*mesh, placed, part);
        }
    }
    return parts;
}

}  // namespace handrail::test
