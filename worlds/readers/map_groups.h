// Reads the groups that a map's author made in an editor. A group is a func_group with a name: TrenchBroom writes
// `_tb_name` and `_tb_id`, and `_tb_group` names the group that contains an entity; other editors and authors write
// `name`. TrenchBroom's layers are no groups. Used on the reading thread only.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "worlds/readers/map_syntax.h"
#include "worlds/scene/scene.h"

namespace handrail::readers {

class MapGroups {
public:
    MapGroups() = default;
    // Finds the groups of the file. `file` must outlive this object.
    explicit MapGroups(const MapFile& file);
    const std::vector<Group>& groups() const { return groups_; }
    // Returns the index of the group that contains the entity's brushes, or kNoGroup.
    std::uint32_t group_of(const MapEntity& entity) const;

private:
    std::vector<Group> groups_;
    std::map<const MapEntity*, std::uint32_t> of_entity_;      // groups, by the entity that makes them
    std::map<std::string, std::uint32_t, std::less<>> of_id_;  // groups, by their `_tb_id`
};

}  // namespace handrail::readers
