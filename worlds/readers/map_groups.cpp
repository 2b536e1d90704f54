#include "worlds/readers/map_groups.h"

#include "worlds/base/text.h"
#include "worlds/readers/map_keys.h"

namespace handrail::readers {
namespace {

constexpr int kDeepestGroup = 16;

bool is_group(const MapEntity& entity) {
    return lower_ascii(entity.value("classname").substr(0, 64)) == "func_group" &&
           entity.value("_tb_type") != "_tb_layer";
}

std::string name_of(const MapEntity& entity) {
    std::string name = text_of(entity, "_tb_name");
    return name.empty() ? text_of(entity, "name") : name;
}

}  // namespace

MapGroups::MapGroups(const MapFile& file) {
    struct Found {
        const MapEntity* entity;
        int depth = -1;  // number of groups around it; -1: not known yet
    };
    std::vector<Found> found;
    std::map<std::string, std::size_t, std::less<>> by_id;
    for (const MapEntity& entity : file.entities) {
        if (!is_group(entity) || name_of(entity).empty()) continue;
        if (const MapKey* id = entity.find("_tb_id")) by_id.emplace(trimmed(id->value), found.size());
        found.push_back({&entity});
    }
    const auto around = [&](std::size_t group) {
        const MapKey* id = found[group].entity->find("_tb_group");
        const auto outer = id ? by_id.find(trimmed(id->value)) : by_id.end();
        return outer == by_id.end() ? found.size() : outer->second;
    };
    // A group that is deeper than kDeepestGroup, or that contains itself because the file is faulty, is in no other
    // one.
    for (std::size_t i = 0; i < found.size(); ++i) {
        int depth = 0;
        for (std::size_t at = around(i); at < found.size() && depth <= kDeepestGroup; at = around(at)) ++depth;
        found[i].depth = depth > kDeepestGroup ? 0 : depth;
    }
    for (int depth = 0; depth <= kDeepestGroup; ++depth)
        for (std::size_t i = 0; i < found.size(); ++i) {
            if (found[i].depth != depth) continue;
            const std::size_t outer = around(i);
            const std::uint32_t inside =
                depth == 0 || outer >= found.size() ? kNoGroup : of_entity_.at(found[outer].entity);
            const auto index = static_cast<std::uint32_t>(groups_.size());
            of_entity_.emplace(found[i].entity, index);
            if (const MapKey* id = found[i].entity->find("_tb_id")) of_id_.emplace(trimmed(id->value), index);
            groups_.push_back({name_of(*found[i].entity), inside, false});
        }
}

std::uint32_t MapGroups::group_of(const MapEntity& entity) const {
    if (groups_.empty()) return kNoGroup;
    if (const auto found = of_entity_.find(&entity); found != of_entity_.end()) return found->second;
    const MapKey* id = entity.find("_tb_group");
    const auto found = id ? of_id_.find(trimmed(id->value)) : of_id_.end();
    return found == of_id_.end() ? kNoGroup : found->second;
}

}  // namespace handrail::readers
