// Typed access to an IFC file: attributes by position, lengths in metres, angles in radians, placements from the
// world's origin. Positions are those that IFC 2x3, 4, 4x2 and 4x3 share; where they differ, the caller checks the
// name. One reading thread uses it, because frequent queries are cached. Source: buildingSMART, IFC 4.3.2 (ISO 16739-1)
// and IFC2x3 TC1.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <unordered_map>

#include "worlds/geometry/convex.h"
#include "worlds/ifc/step_file.h"

namespace handrail::ifc {

// Axes, which may be scaled, and an origin. Right-handed, except in mirrored copies.
struct Frame {
    Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, origin_m{0.0};

    Vec3 turned(const Vec3& v) const { return x * v.x + y * v.y + z * v.z; }
    Vec3 at(const Vec3& p) const { return origin_m + turned(p); }
    Frame of(const Frame& inner) const {
        return {turned(inner.x), turned(inner.y), turned(inner.z), at(inner.origin_m)};
    }
    bool mirrored() const { return glm::dot(glm::cross(x, y), z) < 0.0; }
};

using Values = std::vector<StepValue>;

// Attribute `i`; Nothing if there are fewer attributes.
const StepValue& value_at(const Values& values, std::size_t i);
double number_at(const Values& values, std::size_t i, double otherwise = 0.0);
std::string text_at(const Values& values, std::size_t i);         // decoded, as one line; empty for Nothing
std::string_view word_at(const Values& values, std::size_t i);    // the text of a .WORD. without its dots
std::uint64_t reference_at(const Values& values, std::size_t i);  // 0: none
std::vector<std::uint64_t> references_at(const Values& values, std::size_t i);  // from a list or a single reference
std::vector<double> numbers_of(const StepValue& list);

class IfcModel {
public:
    explicit IfcModel(const StepFile& file);

    const StepFile& file() const { return file_; }
    // Attributes of an instance; empty if the instance does not exist.
    Values values(std::uint64_t id) const;
    std::string_view name(std::uint64_t id) const;  // such as "IFCWALL"; empty if the instance does not exist
    int line(std::uint64_t id) const;

    double metres_per_unit() const { return metres_per_unit_; }
    bool unit_stated() const { return unit_stated_; }
    double radians_per_unit() const { return radians_per_unit_; }

    // Position of an IfcCartesianPoint with two or three numbers, in metres.
    Vec3 point(std::uint64_t id) const;
    // Unit vector of an IfcDirection; `otherwise` if it does not exist or has no length.
    Vec3 direction(std::uint64_t id, const Vec3& otherwise) const;
    // Frame of an IfcAxis2Placement2D, IfcAxis2Placement3D or IfcAxis1Placement; the identity for 0.
    Frame axes(std::uint64_t id) const;
    // Frame of an IfcCartesianTransformationOperator2D or 3D and of their non-uniform kinds.
    Frame transformation(std::uint64_t id) const;
    // Frame of an IfcObjectPlacement, as a whole from the file's origin. Cycles and chains of more than 100 are cut off
    // where they are noticed, and are counted in odd_placements().
    Frame placement(std::uint64_t id);
    int odd_placements() const { return odd_placements_; }

private:
    void read_units();
    Frame on_grid(const Values& values);  // frame of an IfcGridPlacement
    double length_of_unit(std::uint64_t id, int depth) const;

    const StepFile& file_;
    double metres_per_unit_ = 1.0, radians_per_unit_ = 1.0;
    bool unit_stated_ = false;
    std::unordered_map<std::uint64_t, Frame> placements_;
    std::unordered_map<std::uint64_t, std::uint64_t> grid_of_;  // grid of each axis; filled at the first use
    int odd_placements_ = 0;
};

}  // namespace handrail::ifc
