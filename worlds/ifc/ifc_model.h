// Gives typed access to an IFC file: attributes by position, lengths in metres, angles in radians, and placements
// relative to the file's origin. Positions are those that IFC 2x3, 4, 4x2 and 4x3 share; where the versions differ, the
// caller checks the name of the class. Used on the reading thread only, because it caches frequent queries. Source:
// buildingSMART, IFC 4.3.2 (ISO 16739-1) and IFC2x3 TC1.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <unordered_map>

#include "worlds/geometry/convex.h"
#include "worlds/ifc/step_file.h"

namespace handrail::ifc {

// Axes and an origin. The axes may be scaled. They are right-handed, except in mirrored copies.
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

// Returns the attribute with the index `i`, or Nothing if there are fewer attributes.
const StepValue& value_at(const Values& values, std::size_t i);
double number_at(const Values& values, std::size_t i, double otherwise = 0.0);
std::string text_at(const Values& values, std::size_t i);  // returns the decoded text as one line; empty for Nothing
std::string_view word_at(const Values& values, std::size_t i);    // returns the text of a .WORD. without its dots
std::uint64_t reference_at(const Values& values, std::size_t i);  // returns 0 if there is no reference
// Returns the references in a list, or a single reference.
std::vector<std::uint64_t> references_at(const Values& values, std::size_t i);
std::vector<double> numbers_of(const StepValue& list);

class IfcModel {
public:
    explicit IfcModel(const StepFile& file);

    const StepFile& file() const { return file_; }
    // Returns the attributes of an instance; empty if the instance does not exist.
    Values values(std::uint64_t id) const;
    // Returns the class, such as "IFCWALL"; empty if the instance does not exist.
    std::string_view name(std::uint64_t id) const;
    int line(std::uint64_t id) const;

    double metres_per_unit() const { return metres_per_unit_; }
    bool unit_stated() const { return unit_stated_; }
    double radians_per_unit() const { return radians_per_unit_; }

    // Returns the position of an IfcCartesianPoint with two or three numbers, in metres.
    Vec3 point(std::uint64_t id) const;
    // Returns the unit vector of an IfcDirection, or `otherwise` if it does not exist or has no length.
    Vec3 direction(std::uint64_t id, const Vec3& otherwise) const;
    // Returns the frame of an IfcAxis2Placement2D, IfcAxis2Placement3D or IfcAxis1Placement; the identity for 0.
    Frame axes(std::uint64_t id) const;
    // Returns the frame of an IfcCartesianTransformationOperator2D or 3D, or of their non-uniform kinds.
    Frame transformation(std::uint64_t id) const;
    // Returns the frame of an IfcObjectPlacement relative to the file's origin. Cycles, and chains of more than 100
    // placements, are cut off where the function notices them, and odd_placements() counts them.
    Frame placement(std::uint64_t id);
    int odd_placements() const { return odd_placements_; }

private:
    void read_units();
    Frame on_grid(const Values& values);  // returns the frame of an IfcGridPlacement
    double length_of_unit(std::uint64_t id, int depth) const;

    const StepFile& file_;
    double metres_per_unit_ = 1.0, radians_per_unit_ = 1.0;
    bool unit_stated_ = false;
    std::unordered_map<std::uint64_t, Frame> placements_;
    std::unordered_map<std::uint64_t, std::uint64_t> grid_of_;  // the grid of each axis; filled at the first use
    int odd_placements_ = 0;
};

}  // namespace handrail::ifc
