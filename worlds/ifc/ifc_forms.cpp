// Evaluates a boolean result of the file point by point, without building a solid. It tests whether the outlines of
// sweeps, the planes of half-spaces and the faces of closed skins contain a point. The answers are compared with the
// shape that was built.
#include <algorithm>
#include <array>

#include "worlds/ifc/ifc_curves.h"
#include "worlds/ifc/ifc_shapes.h"

namespace handrail::ifc {
namespace {

constexpr int kDeepestForm = 40;
constexpr std::size_t kMostLooks = 60'000'000;  // greatest number of triangle tests for one part

bool is_result(std::string_view kind) { return kind == "IFCBOOLEANRESULT" || kind == "IFCBOOLEANCLIPPINGRESULT"; }

// Returns the position relative to `frame`, along its axes.
Vec3 within(const Frame& frame, const Vec3& at_m) {
    const Vec3 off = at_m - frame.origin_m;
    return {glm::dot(off, frame.x), glm::dot(off, frame.y), glm::dot(off, frame.z)};
}

// Returns the i-th of a sequence of evenly spread points in a box. The sequence is always the same: it uses multiples
// of powers of the root of x^4 = x + 1.
Vec3 place_in(const Aabb& box, std::size_t i) {
    constexpr std::array kSteps{0.8191725133961645, 0.6710436067037893, 0.5497004779019703};
    Vec3 at = box.min_m;
    for (int axis = 0; axis < 3; ++axis) {
        const double turns = 0.5 + static_cast<double>(i + 1) * kSteps[static_cast<std::size_t>(axis)];
        at[axis] += (turns - std::floor(turns)) * box.size_m()[axis];
    }
    return at;
}

}  // namespace

// One operand of a boolean result. The result is a chain of operands, of which the first has the operation Take.
struct IfcShapes::Form {
    enum class Operation : std::uint8_t { Take, Add, Less, Common };
    enum class Kind : std::uint8_t { Sweep, Turn, Pipe, HalfSpace, Skin, Result };
    Operation operation = Operation::Take;
    Kind kind = Kind::Sweep;
    Frame frame;        // frame of a sweep or a turn, or of the outline of a half-space
    Vec3 way{0.0};      // path of a sweep, or direction of the axis of a turn
    Vec3 axis_at{0.0};  // a point on the axis of a turn, in `frame`
    double turn_rad = 0.0;
    std::vector<Vec3> line;                // centre line of a pipe
    double inner_m = 0.0, outer_m = 0.0;   // inner and outer radius of a pipe
    std::vector<std::vector<Ring>> areas;  // profile of a sweep or turn, or the outline that bounds a half-space
    bool bounded = false;
    Plane plane;
    std::vector<std::array<Vec3, 3>> skin;
    std::vector<Form> chain;

    bool in_areas(const Vec2& at) const {
        return std::any_of(areas.begin(), areas.end(),
                           [&](const std::vector<Ring>& rings) { return inside(rings, at); });
    }
    bool holds(const Vec3& at_m) const {
        if (kind == Kind::Sweep) {
            const Vec3 at = within(frame, at_m);
            const double part = at.z / way.z;
            return part >= 0.0 && part <= 1.0 && in_areas({at.x - way.x * part, at.y - way.y * part});
        }
        if (kind == Kind::HalfSpace) {
            const Vec3 at = within(frame, at_m);
            return signed_distance(plane, at_m) <= 0.0 && (!bounded || in_areas({at.x, at.y}));
        }
        if (kind == Kind::Turn) return in_turn(within(frame, at_m));
        if (kind == Kind::Pipe) return in_pipe(at_m);
        if (kind == Kind::Skin) return crossings(at_m) % 2 == 1;
        bool held = false;
        for (const Form& one : chain) {
            const bool takes = one.operation == Operation::Less || one.operation == Operation::Common;
            if (takes == held) held = one.holds(at_m) != (one.operation == Operation::Less);
        }
        return held;
    }
    // Turns the point back into the plane of the profile, where the result may be on either side of the axis.
    bool in_turn(const Vec3& at) const {
        const Vec3 arm = at - axis_at, along = way * glm::dot(way, arm), off = arm - along;
        const Vec3 side = glm::cross(Vec3(0.0, 0.0, 1.0), way);
        const double angle = std::atan2(glm::dot(off, glm::cross(way, side)), glm::dot(off, side));
        for (const double sign : {1.0, -1.0}) {
            double turned = (sign > 0.0 ? angle : angle + kPi) * (turn_rad < 0.0 ? -1.0 : 1.0);
            turned -= 2.0 * kPi * std::floor(turned / (2.0 * kPi));
            const Vec3 flat = axis_at + along + side * (sign * glm::length(off));
            if (turned <= std::abs(turn_rad) && in_areas({flat.x, flat.y})) return true;
        }
        return false;
    }
    bool in_pipe(const Vec3& at) const {
        for (std::size_t i = 0; i + 1 < line.size(); ++i) {
            const Vec3 way_on = line[i + 1] - line[i], arm = at - line[i];
            const double part = glm::dot(arm, way_on) / glm::dot(way_on, way_on);
            const double off_m = glm::length(arm - way_on * part);
            if (part >= 0.0 && part <= 1.0 && off_m <= outer_m && off_m >= inner_m) return true;
        }
        return false;
    }
    // Counts how often a ray from the point crosses the skin. The direction of the ray is unusual, so that edges hardly
    // ever run along it.
    int crossings(const Vec3& at_m) const {
        const Vec3 way_out(0.5377, 0.2893, 0.7919);
        int count = 0;
        for (const std::array<Vec3, 3>& t : skin) {
            const Vec3 a = t[0] - at_m, b = t[1] - at_m, c = t[2] - at_m;
            const double u = glm::dot(way_out, glm::cross(b, c)), v = glm::dot(way_out, glm::cross(c, a)),
                         w = glm::dot(way_out, glm::cross(a, b));
            const bool hit = (u > 0.0 && v > 0.0 && w > 0.0) || (u < 0.0 && v < 0.0 && w < 0.0);
            if (hit &&
                (u * glm::dot(a, way_out) + v * glm::dot(b, way_out) + w * glm::dot(c, way_out)) / (u + v + w) > 0.0)
                ++count;
        }
        return count;
    }
    std::size_t looks() const {
        std::size_t sum = 1 + skin.size() + line.size();
        for (const std::vector<Ring>& rings : areas)
            for (const Ring& ring : rings) sum += ring.size();
        for (const Form& one : chain) sum += one.looks();
        return sum;
    }
};

std::optional<IfcShapes::Form> IfcShapes::skin_form(const std::vector<FlatFace>& faces) const {
    if (!enclosed_m3(faces)) return {};
    Form form;
    form.kind = Form::Kind::Skin;
    // A ray through a hole crosses the outline and the hole, which cancel each other out.
    for (const FlatFace& face : faces)
        for (const std::vector<Vec3>& ring : face.rings)
            for (std::size_t k = 1; k + 1 < ring.size(); ++k) form.skin.push_back({ring[0], ring[k], ring[k + 1]});
    return form;
}

std::optional<IfcShapes::Form> IfcShapes::form_of(std::uint64_t id, int depth) {
    const std::string_view kind = model_.name(id);
    const Values values = model_.values(id);
    if (depth > kDeepestForm || spent()) return {};
    if (is_result(kind)) return result_form(id, depth);
    if (kind == "IFCCSGSOLID") return form_of(reference_at(values, 0), depth + 1);
    if (std::optional<Form> solid = solid_form(kind, values)) return solid;
    Form form;
    if (kind == "IFCHALFSPACESOLID" || kind == "IFCPOLYGONALBOUNDEDHALFSPACE" || kind == "IFCBOXEDHALFSPACE") {
        const std::uint64_t surface = reference_at(values, 0);
        if (model_.name(surface) != "IFCPLANE") return {};
        const Frame plane = model_.axes(reference_at(model_.values(surface), 0));
        const Vec3 normal = word_at(values, 1) == "F" ? -plane.z : plane.z;
        form.kind = Form::Kind::HalfSpace;
        form.plane = {normal, glm::dot(normal, plane.origin_m)};
        form.bounded = kind == "IFCPOLYGONALBOUNDEDHALFSPACE";
        if (!form.bounded) return form;
        form.frame = model_.axes(reference_at(values, 2));
        Ring outline;
        for (const Vec3& p : curve_points(model_, reference_at(values, 3))) outline.emplace_back(p.x, p.y);
        form.areas = {{outline}};
        return form;
    }
    // The account is restored below, because the volume of these faces was already added when the solids were built.
    const Account before = account_;
    std::vector<FlatFace> faces;
    if (kind == "IFCTRIANGULATEDFACESET" || kind == "IFCPOLYGONALFACESET" ||
        kind == "IFCTRIANGULATEDIRREGULARNETWORK") {
        faces = tessellated_faces(kind, values);
    } else if (kind.find("BREP") != std::string_view::npos) {
        add_faces(reference_at(values, 0), faces);
        if (kind.ends_with("VOIDS"))
            for (const std::uint64_t hollow : references_at(values, 1)) add_faces(hollow, faces);
    } else if (kind.ends_with("SURFACEMODEL")) {
        for (const std::uint64_t shell : references_at(values, 0)) add_faces(shell, faces);
    } else if (kind.ends_with("SHELL") || kind == "IFCCONNECTEDFACESET") {
        add_faces(id, faces);
    }
    account_ = before;
    return skin_form(faces);
}

std::optional<IfcShapes::Form> IfcShapes::solid_form(std::string_view kind, const Values& values) const {
    constexpr int kRoundCorners = 96;
    const auto n = [&](std::size_t i) { return number_at(values, i) * model_.metres_per_unit(); };
    Form form;
    if (kind == "IFCEXTRUDEDAREASOLID") {
        form.frame = model_.axes(reference_at(values, 1));
        form.way = model_.direction(reference_at(values, 2), {0, 0, 1}) * n(3);
        form.areas = profile_rings(model_, reference_at(values, 0));
    } else if (kind == "IFCBLOCK") {
        form.frame = model_.axes(reference_at(values, 0));
        form.way = {0.0, 0.0, n(3)};
        form.areas = {{{{0.0, 0.0}, {n(1), 0.0}, {n(1), n(2)}, {0.0, n(2)}}}};
    } else if (kind == "IFCRIGHTCIRCULARCYLINDER") {
        form.frame = model_.axes(reference_at(values, 0));
        form.way = {0.0, 0.0, n(1)};
        form.areas = {{regular_ring(n(2), kRoundCorners)}};
    } else if (kind == "IFCREVOLVEDAREASOLID") {
        const Values axis = model_.values(reference_at(values, 2));
        form.kind = Form::Kind::Turn;
        form.frame = model_.axes(reference_at(values, 1));
        form.axis_at = model_.point(reference_at(axis, 0));
        form.way = model_.direction(reference_at(axis, 1), {0, 0, 1});
        form.turn_rad = std::clamp(number_at(values, 3) * model_.radians_per_unit(), -2.0 * kPi, 2.0 * kPi);
        form.areas = profile_rings(model_, reference_at(values, 0));
        if (std::abs(form.way.z) > 1e-9) return {};  // the axis is not parallel to the plane of the profile
        return form;
    } else if (kind.starts_with("IFCSWEPTDISKSOLID")) {
        form.kind = Form::Kind::Pipe;
        form.line = curve_points(model_, reference_at(values, 0));
        form.outer_m = n(1);
        form.inner_m = n(2);
        return form;
    }
    if (!(std::abs(form.way.z) > 1e-9)) return {};
    return form;
}

// The chain of first operands can be long, so this function follows it without recursion.
std::optional<IfcShapes::Form> IfcShapes::result_form(std::uint64_t id, int depth) {
    constexpr std::size_t kMostOperands = 5'000;
    Form form;
    form.kind = Form::Kind::Result;
    std::uint64_t at = id;
    for (; is_result(model_.name(at)); at = reference_at(model_.values(at), 1)) {
        const Values values = model_.values(at);
        const std::string_view word = word_at(values, 0);
        std::optional<Form> second = form_of(reference_at(values, 2), depth + 1);
        if (!second || form.chain.size() > kMostOperands) return {};
        second->operation = word == "UNION"        ? Form::Operation::Add
                            : word == "DIFFERENCE" ? Form::Operation::Less
                                                   : Form::Operation::Common;
        form.chain.push_back(std::move(*second));
    }
    std::optional<Form> first = form_of(at, depth + 1);
    if (!first) return {};
    form.chain.push_back(std::move(*first));
    std::reverse(form.chain.begin(), form.chain.end());
    return form;
}

void IfcShapes::compare_result(std::uint64_t id, const Body& body, Aabb box) {
    constexpr std::size_t kPlaces = 3'000, kLeastHeld = 200;
    if (!body.sheets.empty() && !encloses(body)) return;
    const std::optional<Form> form = form_of(id, 0);
    Form skin;  // the sheets of the body that did not become solids
    for (const Polygon& sheet : body.sheets)
        for (std::size_t k = 1; k + 1 < sheet.points_m.size(); ++k)
            skin.skin.push_back({sheet.points_m[0], sheet.points_m[k], sheet.points_m[k + 1]});
    if (!form || (form->looks() + skin.looks()) * kPlaces > kMostLooks || body.solids.size() * kPlaces > kMostLooks)
        return;
    const Aabb of_body = body.bounds_m();
    if (!of_body.empty()) box.include(of_body.min_m), box.include(of_body.max_m);
    if (box.empty() || !is_finite(box.min_m) || !is_finite(box.max_m)) return;
    std::size_t stated = 0, lost = 0, surplus = 0;
    for (std::size_t i = 0; i < kPlaces; ++i) {
        const Vec3 at_m = place_in(box, i);
        const bool said = form->holds(at_m);
        const bool made = skin.crossings(at_m) % 2 == 1 ||
                          std::any_of(body.solids.begin(), body.solids.end(),
                                      [&](const ConvexSolid& solid) { return contains(solid, at_m); });
        stated += said ? 1 : 0;
        lost += said && !made ? 1 : 0;
        surplus += made && !said ? 1 : 0;
    }
    if (stated < kLeastHeld) return;  // With so few points inside, a comparison would not be reliable.
    const double share = (static_cast<double>(lost) - static_cast<double>(surplus)) / static_cast<double>(stated);
    if (std::abs(share) > std::abs(account_.result_share)) account_.result_share = share;
}

}  // namespace handrail::ifc
