// The relations between the instances of an IFC file, and the role of each class of part in a building. Filled in one
// pass over the instances.
#pragma once

#include <map>
#include <set>

#include "worlds/ifc/ifc_model.h"

namespace handrail::ifc {

enum class PartRole : std::uint8_t {
    Wall,
    Slab,
    Roof,
    Cover,
    Structure,  // the building itself; announced by side, such as "north wall"
    Panel,      // of a curtain wall, stairs or a roof; alone it makes no building
    Door,
    Window,
    Opening,
    Space,
    Storey,
    Stairs,
    Ramp,
    Lift,
    Escalator,
    Walkway,  // a moving walkway
    Railing,
    Furniture,
    Fixture,
    Column,
    Beam,
    Other
};

// Returns nothing if buildings are not made of this class.
std::optional<PartRole> role_of(std::string_view name);

struct IfcRelations {
    explicit IfcRelations(const IfcModel& model);

    std::map<std::uint64_t, std::uint64_t> host_of;                // opening to host
    std::map<std::uint64_t, std::vector<std::uint64_t>> openings;  // host to its openings, in file order
    std::map<std::uint64_t, std::uint64_t> opening_of;             // door or window to its opening
    std::map<std::uint64_t, std::uint64_t> filled_by;              // opening to the element that fills it
    std::map<std::uint64_t, std::uint64_t> whole_of;               // part to its aggregate, or to its storey
    std::map<std::uint64_t, std::uint64_t> type_of, material_of;   // of elements; types also have materials
    std::map<std::uint64_t, std::vector<std::uint64_t>>
        spaces_at;  // door, window or virtual element to the spaces that it bounds
    std::map<std::uint64_t, std::uint64_t>
        open_at;  // space with a border that is not a wall, to the first such boundary
    std::map<std::string, int, std::less<>> skipped;  // classes that are not part of a building, with their counts

    // Course up the aggregates to the first instance of that class; 0 if there is none.
    std::uint64_t whole_named(const IfcModel& model, std::uint64_t part, std::string_view name) const;
};

// The words that state what an element is made of, the innermost layer first. Empty if the file states nothing.
std::vector<std::string> material_words(const IfcModel& model, const IfcRelations& relations, std::uint64_t element);

}  // namespace handrail::ifc
