// Who belongs to whom in an IFC file, and what each class of part is to a building. One pass over the instances.
#pragma once

#include <map>
#include <set>

#include "worlds/ifc/ifc_model.h"

namespace handrail {

enum class PartRole : std::uint8_t {
    Wall,
    Slab,
    Roof,
    Cover,
    Structure,  // the building itself: named by side, "north wall"
    Panel,      // of a curtain wall, stairs or a roof; alone it is no building
    Door,
    Window,
    Opening,
    Space,
    Storey,
    Stairs,
    Ramp,
    Lift,
    Escalator,
    Walkway,  // a moving one
    Railing,
    Furniture,
    Fixture,
    Column,
    Beam,
    Other
};

// Nothing: no class that buildings are made of.
std::optional<PartRole> role_of(std::string_view name);

struct IfcRelations {
    explicit IfcRelations(const IfcModel& model);

    std::map<std::uint64_t, std::uint64_t> host_of;                // of an opening
    std::map<std::uint64_t, std::vector<std::uint64_t>> openings;  // of a host, in file order
    std::map<std::uint64_t, std::uint64_t> opening_of;             // of a door or window
    std::map<std::uint64_t, std::uint64_t> filled_by;              // of an opening
    std::map<std::uint64_t, std::uint64_t> whole_of;  // of a part: the aggregate, or the storey that it stands in
    std::map<std::uint64_t, std::uint64_t> type_of, material_of;  // of elements, and materials of types too
    std::map<std::uint64_t, std::vector<std::uint64_t>>
        spaces_at;  // of a door, window, or virtual element: the spaces that it bounds
    std::map<std::uint64_t, std::uint64_t>
        open_at;  // of a space with a border that is no wall: the first such boundary
    std::map<std::string, int, std::less<>> skipped;  // classes that are no building, with how many

    // Up the aggregates to the first of that class; 0: none.
    std::uint64_t whole_named(const IfcModel& model, std::uint64_t part, std::string_view name) const;
};

// The words that say what an element is made of, the innermost layer first; empty: the file says nothing.
std::vector<std::string> material_words(const IfcModel& model, const IfcRelations& relations, std::uint64_t element);

}  // namespace handrail
