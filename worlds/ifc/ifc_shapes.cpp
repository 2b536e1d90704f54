// Reads representations, mapped copies, sweeps and boolean results. ifc_faces.cpp reads faces.
#include "worlds/ifc/ifc_shapes.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "worlds/geometry/clip.h"
#include "worlds/ifc/ifc_curves.h"

namespace handrail::ifc {
namespace {

constexpr double kFarthest_m = 1e7;

Plane plane_through(const Vec3& normal, const Vec3& at_m) { return {normal, glm::dot(normal, at_m)}; }

// Returns the cost of cutting an outline into parts, which grows with the square of the number of corners.
std::size_t cost_of(const std::vector<Ring>& rings) {
    std::size_t corners = 0;
    for (const Ring& ring : rings) corners += ring.size();
    return corners * corners / 500;
}

bool is_boolean(std::string_view kind) { return kind == "IFCBOOLEANRESULT" || kind == "IFCBOOLEANCLIPPINGRESULT"; }

Frame across(const Vec3& from, const Vec3& to) {
    Frame frame;
    frame.origin_m = from;
    frame.z = (to - from) / std::max(glm::length(to - from), 1e-12);
    frame.x = any_perpendicular(frame.z);
    frame.y = glm::cross(frame.z, frame.x);
    return frame;
}

}  // namespace

Body IfcShapes::body_of(std::uint64_t shape) {
    const Values values = model_.values(shape);
    const std::vector<std::uint64_t> all = references_at(values, 2);
    // Names of representations. kWanted are solid forms. If there is none, any representation that is not in kNever is
    // used. kNever contains, for example, lines and bounding boxes.
    constexpr std::array<std::string_view, 4> kWanted{"Body", "Facetation", "Tessellation", "Body-FallBack"};
    constexpr std::array<std::string_view, 14> kNever{
        "Axis",     "FootPrint", "Box",     "Annotation",        "Profile",     "Reference", "Clearance",
        "Lighting", "CoG",       "Curve2D", "GeometricCurveSet", "BoundingBox", "Surface",   "Plan"};
    const auto called = [&](std::uint64_t id, std::string_view word) {
        const Values of = model_.values(id);
        return text_at(of, 1) == word || text_at(of, 2) == word;
    };
    account_ = {};
    const auto read = [&](std::uint64_t id) {
        account_.stated_m3 = account_.made_m3 = account_.stated_m2 = account_.made_m2 = 0.0;
        account_.lost_faces = 0;
        account_.formed = account_.formed || !references_at(model_.values(id), 3).empty();
        return representation(id, 0);
    };
    for (const std::string_view word : kWanted)
        for (const std::uint64_t id : all)
            if (called(id, word))
                if (Body body = read(id); !body.empty()) return body;
    for (const std::uint64_t id : all)
        if (std::none_of(kNever.begin(), kNever.end(), [&](std::string_view word) { return called(id, word); }))
            if (Body body = read(id); !body.empty()) return body;
    return {};
}

Body IfcShapes::representation(std::uint64_t id, int depth) {
    Body body;
    const Values values = model_.values(id);
    for (const std::uint64_t one : references_at(values, 3)) body.add(item(one, depth));
    return body;
}

void IfcShapes::note_unread(std::string_view kind) {
    account_.unread = kind.empty() ? "nothing" : kind;
    ++not_read_[account_.unread];
}

Body IfcShapes::item(std::uint64_t id, int depth) {
    Body body = read_item(id, depth);
    weigh(model_.name(id), model_.values(id), body);
    return body;
}

// Adds the volume of a solid to the account. The stated volume is computed from the outline and the lengths,
// independently of the parts that were built.
void IfcShapes::weigh(std::string_view kind, const Values& values, const Body& body) {
    const auto n = [&](std::size_t i) { return number_at(values, i) * model_.metres_per_unit(); };
    std::optional<double> stated_m3;
    if (kind.starts_with("IFCEXTRUDEDAREASOLID")) stated_m3 = swept_m3(kind, values);
    else if (kind == "IFCREVOLVEDAREASOLID") stated_m3 = turned_m3(values);
    else if (kind == "IFCBLOCK") stated_m3 = n(1) * n(2) * n(3);
    else if (kind == "IFCRIGHTCIRCULARCYLINDER") stated_m3 = kPi * n(1) * n(2) * n(2);
    else if (kind.starts_with("IFCSWEPTDISKSOLID")) {
        double length_m = 0.0;
        const std::vector<Vec3> line = curve_points(model_, reference_at(values, 0));
        for (std::size_t i = 0; i + 1 < line.size(); ++i) length_m += glm::length(line[i + 1] - line[i]);
        stated_m3 = kPi * (n(1) * n(1) - n(2) * n(2)) * length_m;
    }
    if (!stated_m3) return;
    account_.stated_m3 += std::abs(*stated_m3);
    account_.made_m3 += volume_m3(body);
}

// Returns the volume of a solid of revolution: its area times the path of the centroid around the axis (Pappus).
double IfcShapes::turned_m3(const Values& values) const {
    const Values axis = model_.values(reference_at(values, 2));
    const Vec3 at = model_.point(reference_at(axis, 0)), way = model_.direction(reference_at(axis, 1), {0, 0, 1});
    const double turn = std::clamp(number_at(values, 3) * model_.radians_per_unit(), -2.0 * kPi, 2.0 * kPi);
    const auto off_axis = [&](const Vec2& p) { return way.x * (p.y - at.y) - way.y * (p.x - at.x); };
    double moment_m3 = 0.0;
    for (const std::vector<Ring>& rings : profile_rings(model_, reference_at(values, 0))) {
        double sum = 0.0, largest = 0.0;
        for (const Ring& ring : rings) {
            double of_ring = 0.0;
            for (std::size_t k = 1; k + 1 < ring.size(); ++k) {
                const Vec2 p = ring[k] - ring[0], q = ring[k + 1] - ring[0];
                of_ring += 0.5 * (p.x * q.y - p.y * q.x) *
                           (off_axis(ring[0]) + off_axis(ring[k]) + off_axis(ring[k + 1])) / 3.0;
            }
            sum += std::abs(of_ring);
            largest = std::max(largest, std::abs(of_ring));
        }
        moment_m3 += std::max(0.0, 2.0 * largest - sum);  // every ring except the largest is a hole
    }
    return moment_m3 * std::abs(turn);
}

double IfcShapes::swept_m3(std::string_view kind, const Values& values) const {
    const bool tapered = kind.ends_with("TAPERED");
    const double up = std::abs(model_.direction(reference_at(values, 2), {0, 0, 1}).z);
    const double depth_m = std::abs(number_at(values, 3)) * model_.metres_per_unit();
    const auto area_of = [&](std::uint64_t profile) {
        double sum_m2 = 0.0;
        for (const std::vector<Ring>& rings : profile_rings(model_, profile)) {
            double area_m2 = 0.0, largest_m2 = 0.0;
            for (const Ring& ring : rings) {
                const double ring_m2 = std::abs(signed_area(ring));
                area_m2 += ring_m2;
                largest_m2 = std::max(largest_m2, ring_m2);
            }
            // The largest ring is the outline; all other rings are holes in it.
            sum_m2 += std::max(0.0, 2.0 * largest_m2 - area_m2);
        }
        return sum_m2;
    };
    const double from_m2 = area_of(reference_at(values, 0)),
                 to_m2 = tapered ? area_of(reference_at(values, 4)) : from_m2;
    return (from_m2 + to_m2 + std::sqrt(from_m2 * to_m2)) / 3.0 * depth_m * up;
}

Body IfcShapes::read_item(std::uint64_t id, int depth) {
    if (spent()) return {};
    ++items_;
    const std::string_view kind = model_.name(id);
    if (depth > kDeepest) {
        note_unread(kind);
        return {};
    }
    const Values values = model_.values(id);
    if (kind == "IFCMAPPEDITEM") return mapped(values, depth);
    if (kind == "IFCEXTRUDEDAREASOLID" || kind == "IFCEXTRUDEDAREASOLIDTAPERED") return extruded(kind, values);
    if (kind == "IFCREVOLVEDAREASOLID") return revolved(values);
    if (kind == "IFCSWEPTDISKSOLID" || kind == "IFCSWEPTDISKSOLIDPOLYGONAL") return swept_disk(values);
    if (is_boolean(kind)) return boolean(id, depth);
    if (kind == "IFCCSGSOLID") return item(reference_at(values, 0), depth + 1);
    if (kind == "IFCFACETEDBREP" || kind == "IFCMANIFOLDSOLIDBREP" || kind == "IFCADVANCEDBREP")
        return shells({reference_at(values, 0)});
    if (kind == "IFCFACETEDBREPWITHVOIDS" || kind == "IFCADVANCEDBREPWITHVOIDS") {
        std::vector<std::uint64_t> all{reference_at(values, 0)};
        for (const std::uint64_t hollow : references_at(values, 1)) all.push_back(hollow);
        std::vector<FlatFace> faces;
        for (const std::uint64_t shell : all) add_faces(shell, faces);
        Body body;
        // A part with cavities is not the union of its shells, so its faces stay sheets.
        for (const FlatFace& one : faces) body.add(body_of_faces({one}));
        weigh_faces(faces, body);
        return body;
    }
    if (kind == "IFCSHELLBASEDSURFACEMODEL" || kind == "IFCFACEBASEDSURFACEMODEL")
        return shells(references_at(values, 0));
    if (kind == "IFCCLOSEDSHELL" || kind == "IFCOPENSHELL" || kind == "IFCCONNECTEDFACESET") return shells({id});
    if (kind == "IFCTRIANGULATEDFACESET" || kind == "IFCPOLYGONALFACESET" || kind == "IFCTRIANGULATEDIRREGULARNETWORK")
        return spent() ? Body{} : body_of_skin(tessellated_faces(kind, values));
    if (kind == "IFCBLOCK" || kind == "IFCRIGHTCIRCULARCYLINDER") return primitive(kind, values);
    note_unread(kind);
    return {};
}

Body IfcShapes::mapped(const Values& values, int depth) {
    const std::uint64_t source = reference_at(values, 0);
    std::shared_ptr<const Mapped>& known = maps_[source];
    const Values of_source = model_.values(source);
    if (!known) {
        known = std::make_shared<const Mapped>();  // placeholder that ends the recursion if a map contains itself
        const Account before = std::exchange(account_, {});
        Mapped made{representation(reference_at(of_source, 1), depth + 1), {}};
        made.account = std::exchange(account_, before);
        maps_[source] = std::make_shared<const Mapped>(std::move(made));
    }
    const Mapped& map = *maps_[source];
    if (!map.account.unread.empty()) account_.unread = map.account.unread;
    if (!map.account.uncut.empty()) account_.uncut = map.account.uncut;
    if (map.account.result_share != 0.0) account_.result_share = map.account.result_share;
    faces_ += map.body.sheets.size() + map.body.solids.size();
    const Frame target = model_.transformation(reference_at(values, 1)),
                origin = model_.axes(reference_at(of_source, 0));
    if (spent()) return {};
    const Frame there = target.of(origin);
    const double larger = std::abs(glm::dot(glm::cross(there.x, there.y), there.z));
    Body body = transformed(map.body, there);
    account_.stated_m3 += map.account.stated_m3 * larger;
    account_.lost_faces += map.account.lost_faces;
    const double wider = std::cbrt(larger * larger);
    account_.stated_m2 += map.account.stated_m2 * wider;
    account_.made_m2 += map.account.made_m2 * wider;
    // Also subtracts what was lost in the copy, even if the original lost nothing.
    account_.made_m3 += map.account.made_m3 * larger - (volume_m3(map.body) * larger - volume_m3(body));
    return body;
}

Body IfcShapes::extruded(std::string_view kind, const Values& values) {
    const Frame frame = model_.axes(reference_at(values, 1));
    const Vec3 way =
        model_.direction(reference_at(values, 2), {0, 0, 1}) * (number_at(values, 3) * model_.metres_per_unit());
    if (kind.ends_with("TAPERED")) ++approximated_;
    Body body;
    for (const std::vector<Ring>& rings : profile_rings(model_, reference_at(values, 0))) {
        if (spent()) break;
        faces_ += cost_of(rings);
        for (const Ring& part : convex_parts(rings))
            if (std::optional<ConvexSolid> solid = prism(part, way, frame)) body.solids.push_back(std::move(*solid));
    }
    faces_ += body.solids.size();
    return body;
}

// Returns a solid of revolution about an axis in the plane of its profile, as wedges between two angles.
Body IfcShapes::revolved(const Values& values) {
    const Frame frame = model_.axes(reference_at(values, 1));
    const Values axis = model_.values(reference_at(values, 2));
    const Vec3 at = model_.point(reference_at(axis, 0)), way = model_.direction(reference_at(axis, 1), {0, 0, 1});
    const double turn = std::clamp(number_at(values, 3) * model_.radians_per_unit(), -2.0 * kPi, 2.0 * kPi);
    const int steps = std::clamp(static_cast<int>(std::ceil(std::abs(turn) / radians_from_degrees(7.5))), 1, 48);
    const auto turned = [&](const Vec2& p, double angle) {
        const Vec3 arm = Vec3(p.x, p.y, 0.0) - at;
        const Vec3 along = way * glm::dot(way, arm), off = arm - along;
        return frame.at(at + along + off * std::cos(angle) + glm::cross(way, off) * std::sin(angle));
    };
    Body body;
    for (const std::vector<Ring>& rings : profile_rings(model_, reference_at(values, 0)))
        for (const Ring& part : convex_parts(rings))
            for (int i = 0; i < steps; ++i) {
                const double a = turn * i / steps, b = turn * (i + 1) / steps;
                std::vector<FlatFace> faces(2);
                faces[0].rings.resize(1);
                faces[1].rings.resize(1);
                for (std::size_t k = 0; k < part.size(); ++k) {
                    const Vec2 &p = part[k], &q = part[(k + 1) % part.size()];
                    faces[0].rings[0].push_back(turned(p, a));
                    faces[1].rings[0].push_back(turned(p, b));
                    faces.push_back({{{turned(p, a), turned(q, a), turned(q, b), turned(p, b)}}});
                }
                faces_ += faces.size();
                body.add(body_of_faces(faces));
                if (spent()) return body;
            }
    return body;
}

Body IfcShapes::swept_disk(const Values& values) {
    const std::vector<Vec3> line = curve_points(model_, reference_at(values, 0));
    // The circle is replaced with an octagon of the same area.
    const double wider = std::sqrt(kPi / (4.0 * std::sin(0.25 * kPi)));
    const double radius = number_at(values, 1) * model_.metres_per_unit(),
                 inner = number_at(values, 2) * model_.metres_per_unit();
    Body body;
    if (!(radius > 0.0) || line.size() > 2000) return body;
    std::vector<Ring> rings{regular_ring(radius * wider, 8)};
    if (inner > 0.0 && inner < radius) rings.push_back(regular_ring(inner * wider, 8));
    const std::vector<Ring> parts = convex_parts(rings);
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
        for (const Ring& part : parts)
            if (std::optional<ConvexSolid> solid =
                    prism(part, {0.0, 0.0, glm::length(line[i + 1] - line[i])}, across(line[i], line[i + 1])))
                body.solids.push_back(std::move(*solid));
    faces_ += body.solids.size();
    return body;
}

Body IfcShapes::primitive(std::string_view kind, const Values& values) {
    const auto n = [&](std::size_t i) { return number_at(values, i) * model_.metres_per_unit(); };
    const Frame frame = model_.axes(reference_at(values, 0));
    Body body;
    std::optional<ConvexSolid> solid;
    if (kind == "IFCBLOCK") solid = box_solid({0, 0, 0}, {n(1), n(2), n(3)}, frame);
    else if (kind == "IFCRIGHTCIRCULARCYLINDER") solid = prism(regular_ring(n(2), 24), {0.0, 0.0, n(1)}, frame);
    if (solid) body.solids.push_back(std::move(*solid));
    return body;
}

IfcShapes::Cutter IfcShapes::half_space(std::string_view kind, const Values& values) {
    const std::uint64_t surface = reference_at(values, 0);
    if (model_.name(surface) != "IFCPLANE") return {{}, false, {}};
    const Values of_surface = model_.values(surface);
    const Frame plane = model_.axes(reference_at(of_surface, 0));
    // .T. means that the normal of the plane points away from the material.
    if (!is_finite(plane.origin_m) || glm::length(plane.origin_m) > kFarthest_m) return {{}, false, {}};
    const Plane bound = plane_through(word_at(values, 1) == "F" ? -plane.z : plane.z, plane.origin_m);
    if (kind != "IFCPOLYGONALBOUNDEDHALFSPACE") return {{{bound}}, true, {}};
    const Frame frame = model_.axes(reference_at(values, 2));
    if (!is_finite(frame.origin_m) || glm::length(frame.origin_m) > kFarthest_m) return {{}, false, {}};
    Ring outline;
    for (const Vec3& p : curve_points(model_, reference_at(values, 3)))
        if (glm::length(p) < kFarthest_m) outline.emplace_back(p.x, p.y);
    Cutter cutter;
    for (const Ring& part : convex_parts({outline})) {
        std::vector<Plane> planes{bound};
        for (std::size_t i = 0; i < part.size(); ++i) {
            const Vec2 along = part[(i + 1) % part.size()] - part[i];
            const Vec3 out = frame.turned({along.y, -along.x, 0.0});
            planes.push_back(
                plane_through(out / std::max(glm::length(out), 1e-300), frame.at({part[i].x, part[i].y, 0.0})));
        }
        cutter.parts.push_back(std::move(planes));
    }
    return cutter;
}

IfcShapes::Cutter IfcShapes::cutter(std::uint64_t id, int depth) {
    const std::string_view kind = model_.name(id);
    if (kind == "IFCHALFSPACESOLID" || kind == "IFCPOLYGONALBOUNDEDHALFSPACE" || kind == "IFCBOXEDHALFSPACE") {
        ++items_;
        return half_space(kind, model_.values(id));
    }
    Cutter cutter;
    // The operand is subtracted from the shape, so its volume is not added to the account.
    const Account before = account_;
    Body body = item(id, depth + 1);
    account_ = before;
    fill(body);
    cutter.known = !body.empty();
    for (const ConvexSolid& solid : body.solids) cutter.parts.push_back(solid.planes);
    if (!body.sheets.empty()) cutter.skin = std::move(body);
    return cutter;
}

// Follows the chain of first operands without recursion, because a wall with many openings is a long chain.
Body IfcShapes::boolean(std::uint64_t id, int depth) {
    std::vector<std::uint64_t> chain;
    std::set<std::uint64_t> seen;
    std::uint64_t at = id;
    for (; is_boolean(model_.name(at)); at = reference_at(model_.values(at), 1)) {
        if (!seen.insert(at).second) {
            note_unread(model_.name(at));
            return {};
        }
        chain.push_back(at);
    }
    const bool outermost = !std::exchange(within_result_, true);
    Body body = item(at, depth + 1);
    const Aabb uncut = body.bounds_m();
    for (auto result = chain.rbegin(); result != chain.rend() && !spent(); ++result) {
        ++items_;
        combine(body, model_.values(*result), depth);
    }
    if (outermost) within_result_ = false;
    if (outermost && account_.uncut.empty() && !spent()) compare_result(id, body, uncut);
    return body;
}

void IfcShapes::combine(Body& first, const Values& values, int depth) {
    const std::string_view operation = word_at(values, 0);
    if (operation == "UNION") return first.add(item(reference_at(values, 2), depth + 1));
    const bool takes_away = operation == "DIFFERENCE";
    const Cutter second = cutter(reference_at(values, 2), depth + 1);
    fill(first);
    const bool convex = first.sheets.empty() && second.skin.empty();
    if (second.known && !convex &&
        combine_exactly(first, second, takes_away ? ExactCut::TakeAway : ExactCut::KeepWithin))
        return;
    // The shape stays uncut if the operand is unknown, or if an exact cut was needed and failed. An open skin has no
    // inside, so the code below cuts only its surface.
    if (!second.known || (!convex && (!second.skin.empty() || encloses(first)))) {
        ++approximated_;
        account_.uncut = model_.name(reference_at(values, 2));
        return;
    }
    if (takes_away) {
        for (const std::vector<Plane>& part : second.parts)
            if (!spent()) cut_away(first, part);
        return;
    }
    Body common;
    for (const std::vector<Plane>& part : second.parts) {
        Body within = first;
        keep_within(within, part);
        common.add(std::move(within));
    }
    first = std::move(common);
}

// Half-spaces are bounded slightly beyond the first operand, so that they become closed solids.
bool IfcShapes::combine_exactly(Body& first, const Cutter& second, ExactCut cut) {
    constexpr double kBeyond_m = 1.0;
    Body by = second.skin;
    if (by.empty()) {
        const Aabb box = grown(first.bounds_m(), kBeyond_m);
        for (std::vector<Plane> planes : second.parts) {
            for (int axis = 0; axis < 3; ++axis) {
                Vec3 out{0.0};
                out[axis] = 1.0;
                planes.push_back({out, box.max_m[axis]});
                planes.push_back({-out, -box.min_m[axis]});
            }
            if (std::optional<ConvexSolid> part =
                    solid_within(std::move(planes), box.centre_m(), glm::length(box.size_m())))
                by.solids.push_back(std::move(*part));
        }
    }
    std::optional<Body> result = cut_exactly(first, by, cut, exact_limits_, stop_);
    if (result) first = std::move(*result);
    return result.has_value();
}

}  // namespace handrail::ifc
