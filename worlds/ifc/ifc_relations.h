// Reads the relations between the instances of an IFC file, and defines the role of each class of part in a building.
// The relations are read in one pass over the instances.
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
    Structure,  // part of the building itself; announced by side, such as "north wall"
    Panel,      // part of a curtain wall, stairs or a roof; alone it does not make a building
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

// Returns the role of parts of this class. Returns nothing for classes that are not parts of a building.
std::optional<PartRole> role_of(std::string_view name);

struct IfcRelations {
    explicit IfcRelations(const IfcModel& model);

    std::map<std::uint64_t, std::uint64_t> host_of;                // opening -> the element that it is cut into
    std::map<std::uint64_t, std::vector<std::uint64_t>> openings;  // element -> its openings, in file order
    std::map<std::uint64_t, std::uint64_t> opening_of;             // door or window -> the opening that it fills
    std::map<std::uint64_t, std::uint64_t> filled_by;              // opening -> the element that fills it
    std::map<std::uint64_t, std::uint64_t> whole_of;               // part -> its aggregate, or its storey
    // Element -> its type, and element or type -> its material.
    std::map<std::uint64_t, std::uint64_t> type_of, material_of;
    // Door, window or virtual element -> the spaces that it bounds.
    std::map<std::uint64_t, std::vector<std::uint64_t>> spaces_at;
    // Zone of a building -> the spaces in it, in file order. A space can be in several zones.
    std::map<std::uint64_t, std::vector<std::uint64_t>> spaces_of_zone;
    // Space with a border that is not a wall -> the first boundary of this kind.
    std::map<std::uint64_t, std::uint64_t> open_at;
    // Classes that are not part of a building, each with its number of instances.
    std::map<std::string, int, std::less<>> skipped;

    // Follows the aggregates upwards to the first instance of that class. Returns 0 if there is none.
    std::uint64_t whole_named(const IfcModel& model, std::uint64_t part, std::string_view name) const;
};

// Returns the words that state what an element is made of, the innermost layer first. Empty if the file states nothing.
std::vector<std::string> material_words(const IfcModel& model, const IfcRelations& relations, std::uint64_t element);

}  // namespace handrail::ifc
