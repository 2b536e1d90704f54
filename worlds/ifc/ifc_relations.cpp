#include "worlds/ifc/ifc_relations.h"

#include <algorithm>
#include <array>

namespace handrail::ifc {
namespace {

struct RoleRow {
    std::string_view name;
    PartRole role;
};
constexpr std::array kRoles{
    RoleRow{"IFCWALL", PartRole::Wall},
    RoleRow{"IFCWALLSTANDARDCASE", PartRole::Wall},
    RoleRow{"IFCWALLELEMENTEDCASE", PartRole::Wall},
    RoleRow{"IFCCURTAINWALL", PartRole::Wall},
    RoleRow{"IFCSLAB", PartRole::Slab},
    RoleRow{"IFCSLABSTANDARDCASE", PartRole::Slab},
    RoleRow{"IFCSLABELEMENTEDCASE", PartRole::Slab},
    RoleRow{"IFCROOF", PartRole::Roof},
    RoleRow{"IFCCOVERING", PartRole::Cover},
    RoleRow{"IFCFOOTING", PartRole::Structure},
    RoleRow{"IFCCHIMNEY", PartRole::Structure},
    RoleRow{"IFCPLATE", PartRole::Panel},
    RoleRow{"IFCPLATESTANDARDCASE", PartRole::Panel},
    RoleRow{"IFCMEMBER", PartRole::Panel},
    RoleRow{"IFCMEMBERSTANDARDCASE", PartRole::Panel},
    RoleRow{"IFCBUILDINGELEMENTPART", PartRole::Panel},
    RoleRow{"IFCDOOR", PartRole::Door},
    RoleRow{"IFCDOORSTANDARDCASE", PartRole::Door},
    RoleRow{"IFCWINDOW", PartRole::Window},
    RoleRow{"IFCWINDOWSTANDARDCASE", PartRole::Window},
    RoleRow{"IFCOPENINGELEMENT", PartRole::Opening},
    RoleRow{"IFCOPENINGSTANDARDCASE", PartRole::Opening},
    RoleRow{"IFCSPACE", PartRole::Space},
    RoleRow{"IFCBUILDINGSTOREY", PartRole::Storey},
    RoleRow{"IFCSTAIR", PartRole::Stairs},
    RoleRow{"IFCSTAIRFLIGHT", PartRole::Stairs},
    RoleRow{"IFCRAMP", PartRole::Ramp},
    RoleRow{"IFCRAMPFLIGHT", PartRole::Ramp},
    RoleRow{"IFCTRANSPORTELEMENT", PartRole::Lift},
    RoleRow{"IFCRAILING", PartRole::Railing},
    RoleRow{"IFCFURNISHINGELEMENT", PartRole::Furniture},
    RoleRow{"IFCFURNITURE", PartRole::Furniture},
    RoleRow{"IFCSYSTEMFURNITUREELEMENT", PartRole::Furniture},
    RoleRow{"IFCSANITARYTERMINAL", PartRole::Fixture},
    RoleRow{"IFCFLOWTERMINAL", PartRole::Fixture},
    RoleRow{"IFCELECTRICAPPLIANCE", PartRole::Fixture},
    RoleRow{"IFCCOLUMN", PartRole::Column},
    RoleRow{"IFCCOLUMNSTANDARDCASE", PartRole::Column},
    RoleRow{"IFCBEAM", PartRole::Beam},
    RoleRow{"IFCBEAMSTANDARDCASE", PartRole::Beam},
    RoleRow{"IFCBUILDINGELEMENTPROXY", PartRole::Other},
    RoleRow{"IFCBUILTELEMENT", PartRole::Other},
};

constexpr std::array<std::string_view, 9> kSpatial{"IFCPROJECT",        "IFCSITE",  "IFCBUILDING",
                                                   "IFCBUILDINGSTOREY", "IFCSPACE", "IFCOPENINGELEMENT",
                                                   "IFCVIRTUALELEMENT", "IFCGRID",  "IFCANNOTATION"};

}  // namespace

std::optional<PartRole> role_of(std::string_view name) {
    for (const RoleRow& row : kRoles)
        if (row.name == name) return row.role;
    return {};
}

IfcRelations::IfcRelations(const IfcModel& model) {
    const auto element = [&](std::uint64_t id) {
        const std::string_view name = model.name(id);
        if (name.starts_with("IFC") && !role_of(name) &&
            std::find(kSpatial.begin(), kSpatial.end(), name) == kSpatial.end())
            ++skipped[std::string(name)];
    };
    for (const StepInstance& instance : model.file().instances()) {
        if (!instance.name.starts_with("IFCREL")) continue;
        const Values v = model.file().values_of(instance);
        if (instance.name == "IFCRELVOIDSELEMENT") {
            const std::uint64_t host = reference_at(v, 4), opening = reference_at(v, 5);
            if (host && opening && host_of.emplace(opening, host).second) openings[host].push_back(opening);
        } else if (instance.name == "IFCRELFILLSELEMENT") {
            opening_of.emplace(reference_at(v, 5), reference_at(v, 4));
            filled_by.emplace(reference_at(v, 4), reference_at(v, 5));
        } else if (instance.name == "IFCRELAGGREGATES" || instance.name == "IFCRELNESTS") {
            for (const std::uint64_t part : references_at(v, 5)) {
                whole_of.emplace(part, reference_at(v, 4));
                element(part);
            }
        } else if (instance.name == "IFCRELCONTAINEDINSPATIALSTRUCTURE") {
            for (const std::uint64_t part : references_at(v, 4)) {
                whole_of.emplace(part, reference_at(v, 5));
                element(part);
            }
        } else if (instance.name == "IFCRELASSIGNSTOGROUP") {
            if (const std::uint64_t zone = reference_at(v, 6); model.name(zone) == "IFCZONE")
                for (const std::uint64_t space : references_at(v, 4)) spaces_of_zone[zone].push_back(space);
        } else if (instance.name == "IFCRELREFERENCEDINSPATIALSTRUCTURE") {
            if (const std::uint64_t zone = reference_at(v, 5); model.name(zone) == "IFCSPATIALZONE")
                for (const std::uint64_t space : references_at(v, 4)) spaces_of_zone[zone].push_back(space);
        } else if (instance.name == "IFCRELDEFINESBYTYPE") {
            for (const std::uint64_t one : references_at(v, 4)) type_of.emplace(one, reference_at(v, 5));
        } else if (instance.name == "IFCRELASSOCIATESMATERIAL") {
            for (const std::uint64_t one : references_at(v, 4)) material_of.emplace(one, reference_at(v, 5));
        } else if (instance.name.starts_with("IFCRELSPACEBOUNDARY")) {
            const std::uint64_t space = reference_at(v, 4), at = reference_at(v, 5);
            std::vector<std::uint64_t>& spaces = spaces_at[at];
            if (space && word_at(v, 7) == "VIRTUAL") open_at.emplace(space, instance.id);
            if (space && at && std::find(spaces.begin(), spaces.end(), space) == spaces.end()) spaces.push_back(space);
        }
    }
}

std::uint64_t IfcRelations::whole_named(const IfcModel& model, std::uint64_t part, std::string_view name) const {
    for (int depth = 0; depth < 20; ++depth) {
        if (model.name(part) == name) return part;
        const auto whole = whole_of.find(part);
        if (whole == whole_of.end()) return 0;
        part = whole->second;
    }
    return 0;
}

std::vector<std::string> material_words(const IfcModel& model, const IfcRelations& relations, std::uint64_t element) {
    const auto material_at = [&](std::uint64_t id) {
        const auto found = relations.material_of.find(id);
        return found == relations.material_of.end() ? 0 : found->second;
    };
    std::uint64_t at = material_at(element);
    if (const auto type = relations.type_of.find(element); at == 0 && type != relations.type_of.end())
        at = material_at(type->second);
    std::vector<std::string> words;
    std::vector<std::uint64_t> open{at};
    for (int steps = 0; !open.empty() && steps < 64; ++steps) {
        const std::uint64_t id = open.back();
        open.pop_back();
        const std::string_view kind = model.name(id);
        const Values v = model.values(id);
        if (kind == "IFCMATERIAL") words.push_back(text_at(v, 0));
        // A layer, constituent or profile refers to its material. Sets and usages contain lists of layers, constituents
        // or profiles.
        else if (kind == "IFCMATERIALLAYER" || kind == "IFCMATERIALLAYERSETUSAGE" ||
                 kind == "IFCMATERIALPROFILESETUSAGE")
            open.push_back(reference_at(v, 0));
        else if (kind == "IFCMATERIALCONSTITUENT" || kind == "IFCMATERIALPROFILE") open.push_back(reference_at(v, 2));
        else if (kind == "IFCMATERIALLAYERSET" || kind == "IFCMATERIALLIST")
            // The stack is processed from its end, so the last layer of the list comes first.
            for (const std::uint64_t one : references_at(v, 0)) open.push_back(one);
        else if (kind == "IFCMATERIALCONSTITUENTSET" || kind == "IFCMATERIALPROFILESET")
            for (const std::uint64_t one : references_at(v, 2)) open.push_back(one);
    }
    return words;
}

}  // namespace handrail::ifc
