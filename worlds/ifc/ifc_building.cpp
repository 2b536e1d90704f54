#include "worlds/ifc/ifc_building.h"

#include <algorithm>
#include <array>

#include "worlds/geometry/box_index.h"
#include "worlds/geometry/clip.h"
#include "worlds/ifc/ifc_made_parts.h"
#include "worlds/ifc/ifc_scene.h"
#include "worlds/ifc/ifc_spaces.h"

namespace handrail::ifc {
namespace {

// Removes the path from a name. Some programs write the path of the file as the name of the building:
// "D:\temp\file.ifc" becomes "file".
std::string without_path(std::string name) {
    if (name.find('\\') == std::string::npos && !name.starts_with('/')) return name;
    name.erase(0, name.find_last_of("\\/") + 1);
    if (const std::size_t dot = name.rfind('.'); dot != std::string::npos && dot > 0) name.erase(dot);
    std::replace(name.begin(), name.end(), '_', ' ');
    return name;
}

// Length by which an opening is extended at each end, so that it cuts through its wall.
constexpr double kThrough_m = 1.0;
// Limits for a door leaf. A shape that is narrower or thicker than these limits is not a leaf, or shows the door open.
constexpr double kNarrowestLeaf_m = 0.4, kThickestLeaf_m = 0.6;

bool is_part(PartRole role) { return role != PartRole::Opening && role != PartRole::Space && role != PartRole::Storey; }

// Returns true if parts of this role cannot swing or slide out of the way. Returns false for furniture: furniture next
// to a door is not cut, but the trial with the walker reports it.
bool blocks(PartRole role) {
    switch (role) {
        case PartRole::Wall:
        case PartRole::Slab:
        case PartRole::Roof:
        case PartRole::Cover:
        case PartRole::Structure:
        case PartRole::Panel:
        case PartRole::Column:
        case PartRole::Beam:
        case PartRole::Window:
        case PartRole::Other:
            return true;
        default:
            return false;
    }
}

// Makes the frame upright, so that a door's width is horizontal whatever its placement states.
Frame upright(const Frame& frame) {
    Frame axes = frame;
    axes.z = {0, 0, 1};
    Vec3 x{frame.x.x, frame.x.y, 0.0};
    if (glm::length(x) < 0.1) x = {1, 0, 0};
    axes.x = x / glm::length(x);
    axes.y = glm::cross(axes.z, axes.x);
    return axes;
}

class Reader {
public:
    Reader(IfcModel& model, const IfcRelations& relations, const std::function<void(double)>& progress,
           std::stop_token stop)
        : model_(model), relations_(relations), progress_(progress), shapes_(model, stop), stop_(std::move(stop)) {}

    IfcBuilding read() {
        building_.schema = model_.file().schema();
        find_origin();
        read_names();
        read_parts();
        read_spaces(building_, model_, relations_, shapes_);
        building_.walls_made = make_walls(building_);
        for (const std::uint32_t room : make_floors(building_))
            building_.floors_made.push_back(building_.rooms[room].name);
        std::vector<Aabb> boxes;
        boxes.reserve(building_.parts.size());
        for (const IfcPart& part : building_.parts) boxes.push_back(part.box);
        building_.by_place = std::make_shared<const BoxIndex>(boxes);
        if (progress_) progress_(0.7);
        for (std::size_t i = 0; i < building_.parts.size() && !stop_.stop_requested(); ++i) {
            cut_openings(building_.parts[i]);
            if (progress_ && (i & 0xff) == 0)
                progress_(0.7 + 0.2 * static_cast<double>(i) / static_cast<double>(building_.parts.size()));
        }
        for (std::size_t i = 0; i < building_.parts.size() && !stop_.stop_requested(); ++i) {
            find_gap(i);
            if (progress_ && (i & 0xff) == 0)
                progress_(0.9 + 0.1 * static_cast<double>(i) / static_cast<double>(building_.parts.size()));
        }
        for (auto& [i, gap] : building_.gaps)
            if (!gap.cut && building_.parts[i].role == PartRole::Door && !stop_.stop_requested()) cut_leaf(i, gap);
        if (progress_) progress_(1.0);
        building_.skipped = relations_.skipped;
        building_.not_read = shapes_.not_read();
        building_.approximated = shapes_.approximated() + boxed_;
        building_.odd_placements = model_.odd_placements();
        building_.too_large = shapes_.too_large();
        return std::move(building_);
    }

private:
    Frame frame_of(std::uint64_t product) {
        Frame frame = model_.placement(reference_at(model_.values(product), 5));
        frame.origin_m -= building_.origin_m;
        return frame;
    }
    // Compares the shape that the file states for a part with the shape that was built. Adds the part to the missing
    // parts if too much is lost.
    void note_missing(const IfcPart& part, double own_m3, int far) {
        constexpr double kLostShare = 0.05, kLeastStated_m3 = 1e-6, kLeastStated_m2 = 1e-4;
        const IfcShapes::Account& account = shapes_.account();
        if (!account.formed || part.prefab || stop_.stop_requested()) return;
        MissingPart missing;
        const double stated_m3 = account.stated_m3;
        const double lost_m2 = account.stated_m2 - account.made_m2;
        const double lost_m3 = stated_m3 - account.made_m3 + std::max(0.0, own_m3 - volume_m3(part.body));
        if (far > 0) missing.reason = "ifc.lost_far";
        else if (!account.unread.empty() && (part.body.empty() || lost_m3 <= kLostShare * stated_m3))
            missing.reason = "ifc.lost_unread", missing.detail = account.unread;
        else if (part.body.empty()) missing.reason = "ifc.lost_empty";
        else if (stated_m3 > kLeastStated_m3 && lost_m3 > kLostShare * stated_m3)
            missing.reason = "ifc.lost_share", missing.share = std::min(1.0, lost_m3 / stated_m3);
        else if (stated_m3 > kLeastStated_m3 && -lost_m3 > kLostShare * stated_m3)
            missing.reason = "ifc.lost_surplus", missing.share = -lost_m3 / stated_m3;
        else if (std::abs(account.result_share) > kLostShare)
            missing.reason = account.result_share > 0.0 ? "ifc.lost_share" : "ifc.lost_surplus",
            missing.share = std::abs(account.result_share);
        else if (!account.uncut.empty()) missing.reason = "ifc.lost_uncut", missing.detail = account.uncut;
        else if (account.stated_m2 > kLeastStated_m2 && lost_m2 > kLostShare * account.stated_m2)
            missing.reason = "ifc.lost_area", missing.share = lost_m2 / account.stated_m2;
        else if (account.lost_faces > 0)
            missing.reason = "ifc.lost_faces", missing.detail = std::to_string(account.lost_faces);
        else return;
        missing.name = part.name;
        missing.guid = part.guid;
        missing.storey = text_at(model_.values(relations_.whole_named(model_, part.id, "IFCBUILDINGSTOREY")), 2);
        missing.at_m = is_finite(part.frame.origin_m) ? part.frame.origin_m : Vec3(0.0);
        missing.source = {part.line, 0};
        building_.missing.push_back(std::move(missing));
    }

    Body body_of(std::uint64_t product, const Frame& frame) {
        Body body = transformed(shapes_.body_of(reference_at(model_.values(product), 6)), frame);
        building_.far += drop_far(body);
        return body;
    }

    // Chooses the world's origin. Positions in georeferenced files are thousands of kilometres from zero. Doubles are
    // still precise at that distance, but planes lose accuracy. The origin is the position of the site or building, or
    // else of the first part that is far away.
    void find_origin() {
        const auto consider = [&](const Vec3& at) {
            if (building_.origin_m == Vec3(0.0) && is_finite(at) && glm::length(at) > kFarAway_m)
                building_.origin_m = at;
        };
        for (const std::string_view wanted : {"IFCSITE", "IFCBUILDING"})
            for (const StepInstance& instance : model_.file().instances())
                if (instance.name == wanted)
                    consider(model_.placement(reference_at(model_.values(instance.id), 5)).origin_m);
        const auto consider_first = [&](auto&& wanted) {
            for (const StepInstance& instance : model_.file().instances()) {
                const std::optional<PartRole> role = role_of(instance.name);
                if (!role || !wanted(*role)) continue;
                const Frame frame = model_.placement(reference_at(model_.values(instance.id), 5));
                const Aabb box = shapes_.body_of(reference_at(model_.values(instance.id), 6)).bounds_m();
                if (box.empty()) continue;
                if (const Vec3 at = frame.at({box.centre_m().x, box.centre_m().y, box.min_m.z});
                    glm::length(at - building_.origin_m) > kFarAway_m && is_finite(at))
                    building_.origin_m = at;
                return true;
            }
            return false;
        };
        if (!consider_first([](PartRole role) { return role == PartRole::Wall || role == PartRole::Slab; }) &&
            !consider_first(is_part))
            consider_first([](PartRole role) { return role == PartRole::Space; });
    }

    void read_names() {
        for (const std::string_view wanted : {"IFCBUILDING", "IFCPROJECT"})
            for (const StepInstance& instance : model_.file().instances()) {
                if (instance.name != wanted) continue;
                const Values v = model_.file().values_of(instance);
                for (const std::size_t i : {std::size_t{wanted == "IFCBUILDING" ? 7U : 5U}, std::size_t{2}}) {
                    const std::string name = without_path(text_at(v, i));
                    const bool word = std::count_if(name.begin(), name.end(),
                                                    [](char c) { return (c < '0' || c > '9') && c != ' '; }) >= 3;
                    if (building_.name.empty() && word) building_.name = name;
                }
            }
    }

    void read_parts() {
        const std::size_t all = model_.file().instances().size();
        for (std::size_t i = 0; i < all; ++i) {
            if (stop_.stop_requested()) return;
            if (progress_ && (i & 0xff) == 0) progress_(0.6 * static_cast<double>(i) / static_cast<double>(all));
            const StepInstance& instance = model_.file().instances()[i];
            const std::optional<PartRole> role = role_of(instance.name);
            if (!role || !is_part(*role)) continue;
            const Values v = model_.file().values_of(instance);
            IfcPart part;
            part.role = *role;
            part.id = instance.id;
            part.line = instance.line;
            part.guid = text_at(v, 0);
            part.name = text_at(v, 2);
            if (part.role == PartRole::Lift) part.role = kind_of_transport(part, v);
            part.frame = frame_of(instance.id);
            const Body own = shapes_.body_of(reference_at(v, 6));
            part.body = transformed(own, part.frame);
            const int far = drop_far(part.body);
            building_.far += far;
            part.same_as = building_.parts.size();
            if (part.body.empty()) take_prefab(part, v);
            note_missing(part, volume_m3(own), far);
            for (const std::string& word : material_words(model_, relations_, instance.id))
                part.words += (part.words.empty() ? "" : "; ") + word;
            if (part.role == PartRole::Door || part.role == PartRole::Window) {
                part.height_m = number_at(v, 8) * model_.metres_per_unit();
                part.width_m = number_at(v, 9) * model_.metres_per_unit();
                part.operation = operation_of(instance.id, v);
            }
            note_repetition(part);
            part.box = part.body.bounds_m();
            part.whole = building_.parts.size();
            place_.emplace(instance.id, building_.parts.size());
            building_.parts.push_back(std::move(part));
        }
        for (std::size_t i = 0; i < building_.parts.size(); ++i) {
            join_to_whole(i);
            if (const auto whole = relations_.whole_of.find(building_.parts[i].id); whole != relations_.whole_of.end())
                pieces_of_[whole->second].push_back(i);
        }
    }

    // Finds parts that repeat an earlier one. Faulty exports contain the same part many times, and a hand cannot
    // distinguish the copies. Doors and windows in openings are exempt, because each is tested separately.
    void note_repetition(IfcPart& part) {
        const bool leaf = part.role == PartRole::Door || part.role == PartRole::Window;
        if ((part.body.empty() && !leaf) || relations_.opening_of.contains(part.id)) return;
        const auto same = [](const IfcPart& a, const IfcPart& b) {
            return a.role == b.role && a.width_m == b.width_m && a.height_m == b.height_m &&
                   a.frame.origin_m == b.frame.origin_m && a.frame.x == b.frame.x && a.frame.z == b.frame.z &&
                   same_body(a.body, b.body);
        };
        Body where = part.body;
        where.sheets.push_back({{part.frame.origin_m, part.frame.x}});
        std::vector<std::size_t>& alike = by_body_[number_of(where)];
        for (const std::size_t other : alike) {
            if (!same(building_.parts[other], part)) continue;
            part.same_as = other;
            part.body = {};
            ++building_.repeated;
            return;
        }
        alike.push_back(building_.parts.size());
    }

    // Returns the kind of a part that carries people. IFC has one class for all kinds, so the words about the part
    // determine the kind.
    PartRole kind_of_transport(const IfcPart& part, const Values& v) const {
        for (const std::string& word : kind_words(part, v)) {
            if (word == "ESCALATOR") return PartRole::Escalator;
            if (word == "MOVINGWALKWAY") return PartRole::Walkway;
        }
        return PartRole::Lift;
    }

    // Furniture that has a position and a kind but no shape gets the prefab of its kind. The front of the prefab faces
    // the y axis of the placement.
    void take_prefab(IfcPart& part, const Values& v) {
        if (part.role != PartRole::Furniture && part.role != PartRole::Fixture && part.role != PartRole::Lift) return;
        if (!reference_at(v, 5) || !is_finite(part.frame.origin_m)) return;
        part.prefab = prefab_for(kind_words(part, v));
        if (part.prefab && (part.prefab->name == "lift_cabin") != (part.role == PartRole::Lift)) part.prefab = nullptr;
        if (!part.prefab) return;
        const Frame axes = upright(part.frame);
        for (const PrefabPart& box : part.prefab->parts)
            if (std::optional<ConvexSolid> solid = box_solid(box.box_m.min_m, box.box_m.max_m, axes))
                part.body.solids.push_back(std::move(*solid));
        if (const int far = drop_far(part.body); far > 0 || part.body.solids.size() != part.prefab->parts.size()) {
            part.prefab = nullptr;
            part.body = {};
            building_.far += far > 0 ? 1 : 0;
        }
    }

    // Returns the words that state the kind of a part, the most reliable first: predefined types, then the name of its
    // type and the part's own name.
    std::vector<std::string> kind_words(const IfcPart& part, const Values& v) const {
        std::vector<std::string> words;
        const auto type = relations_.type_of.find(part.id);
        const Values of_type = type == relations_.type_of.end() ? Values{} : model_.values(type->second);
        for (const Values* values : {&v, &of_type})
            for (std::size_t i = 8; i < values->size(); ++i)
                if (const std::string_view word = word_at(*values, i); !word.empty()) words.emplace_back(word);
        for (const std::string& text : {text_at(of_type, 2), text_at(of_type, 8), text_at(v, 4), part.name})
            words.push_back(text);
        return words;
    }

    std::string operation_of(std::uint64_t door, const Values& v) const {
        if (const std::string_view own = word_at(v, 11); !own.empty()) return std::string(own);
        const auto type = relations_.type_of.find(door);
        if (type == relations_.type_of.end()) return {};
        const Values of_type = model_.values(type->second);
        return std::string(word_at(of_type, model_.name(type->second) == "IFCDOORSTYLE" ? 8 : 10));
    }

    // Makes flights, landings and stringers parts of the stairs to which they belong.
    void join_to_whole(std::size_t i) {
        IfcPart& part = building_.parts[i];
        std::uint64_t at = part.id;
        for (int depth = 0; depth < 8; ++depth) {
            const auto whole = relations_.whole_of.find(at);
            if (whole == relations_.whole_of.end()) break;
            at = whole->second;
            const auto found = place_.find(at);
            if (found == place_.end()) break;
            const PartRole role = building_.parts[found->second].role;
            if ((role == PartRole::Stairs || role == PartRole::Ramp) && part.role != PartRole::Railing)
                part.whole = found->second;
        }
    }

    void cut_openings(const IfcPart& voided) {
        IfcPart& host = building_.parts[voided.same_as];
        const auto openings = relations_.openings.find(voided.id);
        if (openings == relations_.openings.end()) return;
        for (const std::uint64_t opening : openings->second) {
            if (stop_.stop_requested()) return;
            // An opening in furniture, such as a niche in a cabinet, is not an opening of the building.
            const bool building = blocks(host.role);
            building_.openings += building ? 1 : 0;
            Body shape = body_of(opening, frame_of(opening));
            fill(shape);
            const std::vector<ConvexSolid> solids = solids_around(shape, frame_of(opening));
            const bool passage = is_passage(opening);
            bool cut = false;
            for (IfcPart* const part : bodies_of(host)) {
                if (!shape.sheets.empty()) {
                    if (const std::optional<bool> exactly = cut_skin(*part, shape, frame_of(opening), passage)) {
                        cut = *exactly || cut;
                        continue;
                    }
                    ++boxed_;
                }
                for (const ConvexSolid& solid : solids)
                    cut = cut_through(part->body, solid, frame_of(opening), passage, part->role) || cut;
            }
            cut = cut || is_open_already(host, solids, upright(frame_of(opening)));
            building_.openings_cut += cut && building ? 1 : 0;
            if (!cut && building) building_.openings_uncut.push_back(static_cast<std::size_t>(model_.line(opening)));
        }
    }
    // Returns true if the opening exists already: it is within the extent of its host, and nothing fills it. Many
    // programs export walls that are already cut, and the openings as well.
    bool is_open_already(const IfcPart& host, const std::vector<ConvexSolid>& solids, const Frame& axes) const {
        if (solids.empty()) return false;
        std::vector<const Body*> of_host{&host.body};
        if (const auto pieces = pieces_of_.find(host.id); pieces != pieces_of_.end())
            for (const std::size_t piece : pieces->second) of_host.push_back(&building_.parts[piece].body);
        for (const Vec3& way : {axes.x, axes.y, axes.z}) {
            std::optional<Reach> whole, opening;
            const auto include = [](std::optional<Reach>& all, const Reach& one) {
                all = all ? Reach{std::min(all->least, one.least), std::max(all->most, one.most)} : one;
            };
            for (const Body* const body : of_host)
                if (const std::optional<Reach> reach = reach_along(*body, way)) include(whole, *reach);
            for (const ConvexSolid& solid : solids) include(opening, reach_along(solid, way));
            const double middle = 0.5 * (opening->least + opening->most);
            if (!whole || middle < whole->least || middle > whole->most) return false;
        }
        return true;
    }
    // Returns the host itself, or its pieces if it has no shape of its own.
    std::vector<IfcPart*> bodies_of(IfcPart& host) {
        if (!host.body.empty()) return {&host};
        std::vector<IfcPart*> bodies;
        if (const auto pieces = pieces_of_.find(host.id); pieces != pieces_of_.end())
            for (const std::size_t i : pieces->second)
                if (!building_.parts[i].body.empty()) bodies.push_back(&building_.parts[i]);
        return bodies;
    }
    // Cuts an opening that convex solids cannot represent, such as a round arch. Returns whether something was cut, or
    // nothing if the cut cannot be computed.
    std::optional<bool> cut_skin(IfcPart& host, Body shape, const Frame& opening, bool passage) {
        constexpr double kAtEnd_m = 1e-3, kCut_m3 = 1e-6;
        const Vec3 way = way_through_host(host.body, upright(opening), host.role);
        const std::vector<ConvexSolid> around = solids_around({{}, shape.sheets}, opening);
        const std::optional<Reach> ends = reach_along(shape, way);
        if (around.empty() || !ends) return std::nullopt;
        const double longer_m = longer_by_m(host.body, around[0], way, passage);
        for (Polygon& sheet : shape.sheets)
            for (Vec3& p : sheet.points_m) {
                const double at = glm::dot(p, way);
                if (at > ends->most - kAtEnd_m) p += way * longer_m;
                else if (at < ends->least + kAtEnd_m) p -= way * longer_m;
            }
        std::optional<Body> left = cut_exactly(host.body, shape, ExactCut::TakeAway, shapes_.exact_limits(), stop_);
        if (!left) return std::nullopt;
        const bool cut = volume_m3(host.body) - volume_m3(*left) > kCut_m3;
        if (cut) host.body = std::move(*left);
        return cut;
    }

    // Returns true if a door or window fills the opening. If a cupboard or a radiator fills the opening, it is a niche,
    // and the wall behind it stays.
    bool is_passage(std::uint64_t opening) const {
        const auto filling = relations_.filled_by.find(opening);
        if (filling == relations_.filled_by.end()) return false;
        const std::optional<PartRole> role = role_of(model_.name(filling->second));
        return role == PartRole::Door || role == PartRole::Window;
    }

    // Returns the solids of an opening. If the opening encloses no volume, returns the box around its corners, in the
    // axes of its placement.
    static std::vector<ConvexSolid> solids_around(const Body& shape, const Frame& opening) {
        if (!shape.solids.empty() || shape.sheets.empty()) return shape.solids;
        const Frame axes = upright(opening);
        Vec3 least, most;
        for (int axis = 0; axis < 3; ++axis) {
            const Vec3 way = axis == 0 ? axes.x : axis == 1 ? axes.y : axes.z;
            const Reach reach = *reach_along(shape, way);
            least[axis] = reach.least - glm::dot(axes.origin_m, way);
            most[axis] = reach.most - glm::dot(axes.origin_m, way);
        }
        if (std::optional<ConvexSolid> solid = box_solid(least, most, axes)) return {*solid};
        return {};
    }

    // Returns true if a solid extends from one face of a wall to the other at the place where wall and solid overlap.
    static bool reaches_both_faces(const Body& body, const ConvexSolid& solid, const Vec3& way) {
        constexpr double kNearFace_m = 0.03;
        std::vector<Plane> beside = solid.planes;
        std::erase_if(beside, [&](const Plane& plane) { return std::abs(glm::dot(plane.normal, way)) > 0.9; });
        Body within = body;
        keep_within(within, beside);
        const std::optional<Reach> host = reach_along(within, way);
        const Reach own = reach_along(solid, way);
        return host && own.least < host->least + kNearFace_m && own.most > host->most - kNearFace_m;
    }

    // Returns the direction in which openings go through the host. It is vertical for slabs and roofs. For walls it is
    // the horizontal axis of the opening along which the wall is thinner.
    static Vec3 way_through_host(const Body& body, const Frame& axes, PartRole role) {
        if (role == PartRole::Slab || role == PartRole::Roof) return {0, 0, 1};
        const std::optional<Reach> x = reach_along(body, axes.x), y = reach_along(body, axes.y);
        return x && y && x->most - x->least < y->most - y->least ? axes.x : axes.y;
    }
    static double longer_by_m(const Body& body, const ConvexSolid& solid, const Vec3& way, bool passage) {
        return passage && reaches_both_faces(body, solid, way) ? kThrough_m : 2e-3;
    }

    static bool cut_through(Body& body, const ConvexSolid& solid, const Frame& opening, bool passage, PartRole role) {
        const Vec3 way = way_through_host(body, upright(opening), role);
        std::vector<Plane> planes = solid.planes;
        const double longer_m = longer_by_m(body, solid, way, passage);
        for (Plane& plane : planes)
            if (std::abs(glm::dot(plane.normal, way)) > 0.9) plane.offset_m += longer_m;
        const bool hollow = body.solids.empty();
        const std::optional<Reach> host = reach_along(body, way);
        if (!cut_away(body, planes)) return false;
        if (hollow && host) add_jambs(body, planes, way, *host);
        return true;
    }
    // Adds the faces of the doorway as sheets. Without these faces, a wall that consists only of its surface would be
    // open to its inside.
    static void add_jambs(Body& body, const std::vector<Plane>& planes, const Vec3& way, const Reach& host) {
        std::vector<Plane> within = planes;
        std::erase_if(within, [&](const Plane& p) { return std::abs(glm::dot(p.normal, way)) > 0.9; });
        within.push_back({way, host.most});
        within.push_back({-way, -host.least});
        const Aabb box = body.bounds_m();
        const std::optional<ConvexSolid> gap = solid_within(within, box.centre_m(), glm::length(box.size_m()));
        if (!gap) return;
        for (std::size_t i = 0; i < gap->planes.size(); ++i)
            if (std::abs(glm::dot(gap->planes[i].normal, way)) < 0.9) body.sheets.push_back(gap->faces[i]);
    }

    // Finds the gap of a door or window. If the file states an opening for it, the gap is that opening, narrowed to the
    // thickness of the wall. Otherwise the gap comes from the shape of the door or window itself.
    void find_gap(std::size_t i) {
        const IfcPart& part = building_.parts[i];
        if ((part.role != PartRole::Door && part.role != PartRole::Window) || part.same_as != i) return;
        WallGap gap;
        gap.axes = upright(part.frame);
        Body shape;
        const IfcPart* host = nullptr;
        if (const auto opening = relations_.opening_of.find(part.id); opening != relations_.opening_of.end()) {
            shape = body_of(opening->second, frame_of(opening->second));
            if (const auto of = relations_.host_of.find(opening->second); of != relations_.host_of.end())
                if (const auto at = place_.find(of->second); at != place_.end())
                    host = &building_.parts[building_.parts[at->second].same_as];
        }
        if (shape.empty()) shape = part.body;
        if (host && !host->body.empty())  // turns the axes of a door whose width is along y of its placement
            if (const auto x = reach_along(shape, gap.axes.x), y = reach_along(shape, gap.axes.y);
                x && y && y->most - y->least > 1.5 * (x->most - x->least)) {
                const auto hx = reach_along(host->body, gap.axes.x), hy = reach_along(host->body, gap.axes.y);
                if (hx->most - hx->least < hy->most - hy->least)
                    gap.axes.x = gap.axes.y, gap.axes.y = glm::cross(gap.axes.z, gap.axes.x);
            }
        for (int axis = 0; axis < 3; ++axis) {
            const Vec3 way = axis == 0 ? gap.axes.x : axis == 1 ? gap.axes.y : gap.axes.z;
            std::optional<Reach> reach = reach_along(shape, way);
            const double at = glm::dot(gap.axes.origin_m, way);
            if (!reach) reach = Reach{at, at + (axis == 0 ? part.width_m : axis == 1 ? 0.1 : part.height_m)};
            if (axis == 1 && host)
                if (const std::optional<Reach> wall = reach_along(host->body, way);
                    wall && wall->most - wall->least < 1.5) {
                    reach->least = std::max(reach->least, wall->least);
                    reach->most = std::min(reach->most, wall->most);
                    if (reach->least > reach->most) *reach = *wall;
                }
            gap.least_m[axis] = reach->least - at;
            gap.most_m[axis] = reach->most - at;
        }
        gap.cut = host != nullptr;
        const double reach_m = glm::length(gap.axes.origin_m) + glm::length(gap.least_m) + glm::length(gap.most_m);
        if (reach_m < kFarthestPart_m && gap.most_m.x - gap.least_m.x > 0.05 && gap.most_m.z - gap.least_m.z > 0.05)
            building_.gaps.emplace(i, gap);
    }

    // Cuts a door that has no opening through the walls that contain it or are close to it. The cut has the outline of
    // the door's leaf.
    void cut_leaf(std::size_t i, WallGap& gap) {
        constexpr double kNear_m = 0.1, kWithin_m = 1.0, kThickest_m = 1.5;
        Vec3 least = gap.least_m, most = gap.most_m;
        if (most.x - least.x < kNarrowestLeaf_m || most.y - least.y > kThickestLeaf_m) return;
        const auto box = [&](double out_m) {
            return box_solid({least.x, least.y - out_m, least.z}, {most.x, most.y + out_m, most.z}, gap.axes);
        };
        const std::optional<ConvexSolid> leaf = box(kNear_m), column = box(kWithin_m);
        if (!leaf || !column) return;
        std::vector<std::uint32_t> near;
        building_.by_place->find(leaf->bounds_m, near);
        const double at = glm::dot(gap.axes.origin_m, gap.axes.y);
        for (const std::uint32_t p : near) {
            IfcPart& part = building_.parts[p];
            const bool wall = part.role == PartRole::Wall || part.role == PartRole::Panel ||
                              part.role == PartRole::Structure || part.role == PartRole::Other;
            if (!wall || !overlap(part.box, leaf->bounds_m) || !meets(part.body, *leaf)) continue;
            Body within = part.body;
            keep_within(within, column->planes);
            const std::optional<Reach> reach = reach_along(within, gap.axes.y);
            if (!reach || reach->most - reach->least > kThickest_m) continue;
            gap.least_m.y = std::min(gap.least_m.y, reach->least - at);
            gap.most_m.y = std::max(gap.most_m.y, reach->most - at);
            const std::optional<ConvexSolid> hole = box_solid({least.x, reach->least - at - kFlush_m, least.z},
                                                              {most.x, reach->most - at + kFlush_m, most.z}, gap.axes);
            if (hole && cut_away(part.body, hole->planes)) building_.cut_as_leaf[i].push_back(part.name);
        }
    }

    IfcModel& model_;
    const IfcRelations& relations_;
    const std::function<void(double)>& progress_;
    IfcShapes shapes_;
    std::stop_token stop_;
    int boxed_ = 0;  // number of openings that were cut as the box around their shape
    IfcBuilding building_;
    std::unordered_map<std::uint64_t, std::size_t> place_;  // index into `parts` by the id of the instance
    std::unordered_map<std::uint64_t, std::vector<std::size_t>> pieces_of_;
    // The first part with each shape, by the hash of the shape.
    std::unordered_map<std::uint64_t, std::vector<std::size_t>> by_body_;
};

// Returns the space that a walker needs to pass through a gap: 0.5 m wide and up to 1.8 m tall, above a threshold. With
// `standing`, the walker may stand on the threshold.
std::optional<ConvexSolid> direction_through(const WallGap& gap, bool standing = false) {
    constexpr double kWide_m = 0.5, kTall_m = 1.8, kThreshold_m = 0.2, kBeyond_m = 0.1;
    const double middle = 0.5 * (gap.least_m.x + gap.most_m.x),
                 half = 0.5 * std::min(kWide_m, gap.most_m.x - gap.least_m.x - 0.02);
    const Vec3 least{middle - half, gap.least_m.y - kBeyond_m, gap.least_m.z + kThreshold_m};
    const Vec3 most{middle + half, gap.most_m.y + kBeyond_m,
                    standing ? std::min(gap.least_m.z + kThreshold_m + kTall_m, gap.most_m.z)
                             : std::min(gap.least_m.z + kTall_m, gap.most_m.z - 0.02)};
    return box_solid(least, most, gap.axes);
}

}  // namespace

IfcBuilding read_building(IfcModel& model, const IfcRelations& relations, const std::function<void(double)>& progress,
                          const std::stop_token& stop) {
    return Reader(model, relations, progress, stop).read();
}

namespace {

// Returns the parts that are in the walker's way, in file order.
std::vector<std::uint32_t> blocking(const IfcBuilding& building, const ConvexSolid& body) {
    std::vector<std::uint32_t> near;
    building.by_place->find(body.bounds_m, near);
    std::erase_if(near, [&](std::uint32_t i) {
        const IfcPart& part = building.parts[i];
        return !blocks(part.role) || !overlap(part.box, body.bounds_m) || !meets(part.body, body);
    });
    return near;
}

}  // namespace

bool can_pass(const IfcBuilding& building, const WallGap& gap) {
    const std::optional<ConvexSolid> body = direction_through(gap);
    return body && blocking(building, *body).empty();
}

double sky_side(const IfcBuilding& building, const WallGap& gap) {
    constexpr double kOver_m = 1.0, kSky_m = 200.0, kBeyondFace_m = 0.05;
    // Tests several distances in front of the gap, because a porch or a balcony may cover the first ones.
    constexpr std::array kAway_m{1.0, 1.5, 2.0, 2.5};
    const double middle = 0.5 * (gap.least_m.x + gap.most_m.x);
    const auto is_free = [&](const Vec3& from, const Vec3& to) {
        std::vector<std::uint32_t> near;
        building.by_place->find({glm::min(from, to), glm::max(from, to)}, near);
        return std::none_of(near.begin(), near.end(),
                            [&](std::uint32_t i) { return crosses(building.parts[i].body, from, to); });
    };
    // Tests the line that leads straight out from the door and then up.
    const auto is_open = [&](double face, double out) {
        const double y = face + out;
        const Vec3 door = gap.axes.at({middle, face + std::copysign(kBeyondFace_m, out), gap.least_m.z + kOver_m}),
                   low = gap.axes.at({middle, y, gap.least_m.z + kOver_m});
        return is_free(door, low) && is_free(low, low + Vec3(0.0, 0.0, kSky_m));
    };
    for (const double away : kAway_m) {
        const bool before = is_open(gap.least_m.y, -away), behind = is_open(gap.most_m.y, away);
        if (before != behind) return before ? -1.0 : 1.0;
        if (before) break;
    }
    return 0.0;
}

std::vector<std::string> free_the_way(IfcBuilding& building, const WallGap& gap) {
    std::vector<std::string> cut;
    const std::optional<ConvexSolid> body = direction_through(gap, true);
    if (!body) return cut;
    for (const std::uint32_t i : blocking(building, *body)) {
        IfcPart& part = building.parts[i];
        cut_away(part.body, body->planes);
        cut.push_back(part.name);
    }
    return cut;
}

}  // namespace handrail::ifc
