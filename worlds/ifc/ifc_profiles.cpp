// Reads profile definitions of IFC as outlines. Fillets and slopes of rolled steel are left out, because they are
// smaller than a finger.
#include <algorithm>

#include "worlds/ifc/ifc_curves.h"

namespace handrail::ifc {
namespace {

constexpr int kDeepestProfile = 8;

Ring box(double x, double y) {
    return {{-0.5 * x, -0.5 * y}, {0.5 * x, -0.5 * y}, {0.5 * x, 0.5 * y}, {-0.5 * x, 0.5 * y}};
}

Ring oval(double a, double b) {
    constexpr int kCorners = 24;
    Ring ring;
    for (int i = 0; i < kCorners; ++i)
        ring.emplace_back(a * std::cos(2.0 * kPi * i / kCorners), b * std::sin(2.0 * kPi * i / kCorners));
    return ring;
}

Ring rounded_box(double x, double y, double r) {
    Ring ring;
    r = std::clamp(r, 0.0, 0.5 * std::min(x, y));
    for (int corner = 0; corner < 4; ++corner)
        for (int i = 0; i <= 4; ++i) {
            const double angle = 0.5 * kPi * (corner + 0.25 * i);
            const Vec2 middle{(corner == 0 || corner == 3 ? 1 : -1) * (0.5 * x - r),
                              (corner < 2 ? 1 : -1) * (0.5 * y - r)};
            ring.push_back(middle + r * Vec2(std::cos(angle), std::sin(angle)));
        }
    return ring;
}

Ring flat(const std::vector<Vec3>& points) {
    Ring ring;
    for (const Vec3& p : points) ring.emplace_back(p.x, p.y);
    return ring;
}

// Returns a strip of the given width along a line.
Ring along(const Ring& line, double width) {
    Ring left, right;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const Vec2 before = i > 0 ? line[i] - line[i - 1] : line[i + 1] - line[i],
                   after = i + 1 < line.size() ? line[i + 1] - line[i] : before;
        const Vec2 d0 = before / std::max(glm::length(before), 1e-9), d1 = after / std::max(glm::length(after), 1e-9);
        const Vec2 n0{-d0.y, d0.x}, n1{-d1.y, d1.x};
        Vec2 mitre = n0 + n1;
        const double stretch = glm::dot(mitre, n0);
        mitre = stretch > 0.2 ? mitre / stretch : n0;
        left.push_back(line[i] + mitre * (0.5 * width));
        right.push_back(line[i] - mitre * (0.5 * width));
    }
    left.insert(left.end(), right.rbegin(), right.rend());
    return left;
}

using Parts = std::vector<std::vector<Ring>>;

// Returns the outline of a steel profile. The attributes from 3 on are its dimensions in the file's unit; `unit`
// converts them to metres.
Ring steel(std::string_view kind, const Values& v, double unit) {
    const auto n = [&](std::size_t i) { return number_at(v, i) * unit; };
    if (kind == "IFCISHAPEPROFILEDEF" || kind == "IFCASYMMETRICISHAPEPROFILEDEF") {
        // Asymmetric profiles state bottom width, depth, web, bottom flange, fillet, top width and top flange. IFC 2x3
        // has the same numbers in the same places.
        const bool odd = kind.starts_with("IFCASYM");
        const double b = 0.5 * n(3), h = 0.5 * n(4), w = 0.5 * n(5), low = n(6), top = odd ? 0.5 * n(8) : b,
                     high = odd && n(9) > 0.0 ? n(9) : low;
        return {{-b, -h}, {b, -h},   {b, -h + low},    {w, -h + low},  {w, h - high},  {top, h - high},
                {top, h}, {-top, h}, {-top, h - high}, {-w, h - high}, {-w, -h + low}, {-b, -h + low}};
    }
    if (kind == "IFCLSHAPEPROFILEDEF") {
        const double h = 0.5 * n(3), b = n(4) > 0.0 ? 0.5 * n(4) : h, t = n(5);
        return {{-b, -h}, {b, -h}, {b, -h + t}, {-b + t, -h + t}, {-b + t, h}, {-b, h}};
    }
    if (kind == "IFCTSHAPEPROFILEDEF") {
        const double h = 0.5 * n(3), b = 0.5 * n(4), w = 0.5 * n(5), f = n(6);
        return {{-w, -h}, {w, -h}, {w, h - f}, {b, h - f}, {b, h}, {-b, h}, {-b, h - f}, {-w, h - f}};
    }
    if (kind == "IFCUSHAPEPROFILEDEF") {
        const double h = 0.5 * n(3), b = 0.5 * n(4), w = n(5), f = n(6);
        return {{-b, -h}, {b, -h}, {b, -h + f}, {-b + w, -h + f}, {-b + w, h - f}, {b, h - f}, {b, h}, {-b, h}};
    }
    if (kind == "IFCCSHAPEPROFILEDEF") {
        const double h = 0.5 * n(3), b = 0.5 * n(4), t = n(5), g = n(6);
        return {{-b, -h},        {b, -h},        {b, -h + g},    {b - t, -h + g}, {b - t, -h + t}, {-b + t, -h + t},
                {-b + t, h - t}, {b - t, h - t}, {b - t, h - g}, {b, h - g},      {b, h},          {-b, h}};
    }
    if (kind == "IFCZSHAPEPROFILEDEF") {
        const double h = 0.5 * n(3), b = n(4), w = 0.5 * n(5), f = n(6);
        return {{-w, -h}, {b - w, -h}, {b - w, -h + f}, {w, -h + f}, {w, h}, {w - b, h}, {w - b, h - f}, {-w, h - f}};
    }
    return {};
}

Parts rings_of(const IfcModel& model, std::uint64_t profile, int depth) {
    const std::string_view kind = model.name(profile);
    if (depth > kDeepestProfile || kind.empty()) return {};
    const Values v = model.values(profile);
    const double unit = model.metres_per_unit();
    const auto n = [&](std::size_t i) { return number_at(v, i) * unit; };
    if (kind == "IFCARBITRARYCLOSEDPROFILEDEF" || kind == "IFCARBITRARYPROFILEDEFWITHVOIDS") {
        std::vector<Ring> rings{flat(curve_points(model, reference_at(v, 2)))};
        if (kind.ends_with("VOIDS"))
            for (const std::uint64_t hole : references_at(v, 3)) rings.push_back(flat(curve_points(model, hole)));
        return {rings};
    }
    if (kind == "IFCCENTERLINEPROFILEDEF") {
        const Ring line = flat(curve_points(model, reference_at(v, 2)));
        return line.size() < 2 ? Parts{} : Parts{{along(line, n(3))}};
    }
    if (kind == "IFCCOMPOSITEPROFILEDEF") {
        Parts parts;
        for (const std::uint64_t part : references_at(v, 2))
            for (std::vector<Ring>& rings : rings_of(model, part, depth + 1)) parts.push_back(std::move(rings));
        return parts;
    }
    if (kind == "IFCDERIVEDPROFILEDEF" || kind == "IFCMIRROREDPROFILEDEF") {
        Parts parts = rings_of(model, reference_at(v, 2), depth + 1);
        Frame frame = model.transformation(reference_at(v, 3));
        if (kind == "IFCMIRROREDPROFILEDEF") frame.x = -frame.x;
        for (std::vector<Ring>& rings : parts)
            for (Ring& ring : rings)
                for (Vec2& p : ring) {
                    const Vec3 at = frame.at({p.x, p.y, 0.0});
                    p = {at.x, at.y};
                }
        return parts;
    }
    std::vector<Ring> rings;
    if (kind == "IFCRECTANGLEPROFILEDEF") rings = {box(n(3), n(4))};
    else if (kind == "IFCROUNDEDRECTANGLEPROFILEDEF") rings = {rounded_box(n(3), n(4), n(5))};
    else if (kind == "IFCRECTANGLEHOLLOWPROFILEDEF")
        rings = {box(n(3), n(4)), box(n(3) - 2.0 * n(5), n(4) - 2.0 * n(5))};
    else if (kind == "IFCCIRCLEPROFILEDEF") rings = {oval(n(3), n(3))};
    else if (kind == "IFCCIRCLEHOLLOWPROFILEDEF") rings = {oval(n(3), n(3)), oval(n(3) - n(4), n(3) - n(4))};
    else if (kind == "IFCELLIPSEPROFILEDEF") rings = {oval(n(3), n(4))};
    else if (kind == "IFCTRAPEZIUMPROFILEDEF") {
        const double b = n(3), t = n(4), h = n(5), o = n(6);
        rings = {{{-0.5 * b, -0.5 * h}, {0.5 * b, -0.5 * h}, {-0.5 * b + o + t, 0.5 * h}, {-0.5 * b + o, 0.5 * h}}};
    } else if (const Ring ring = steel(kind, v, unit); !ring.empty()) rings = {ring};
    if (rings.empty()) return {};
    const Frame frame = model.axes(reference_at(v, 2));
    for (Ring& ring : rings)
        for (Vec2& p : ring) {
            const Vec3 at = frame.at({p.x, p.y, 0.0});
            p = {at.x, at.y};
        }
    return {rings};
}

}  // namespace

std::vector<std::vector<Ring>> profile_rings(const IfcModel& model, std::uint64_t profile) {
    std::vector<std::vector<Ring>> parts = rings_of(model, profile, 0);
    for (std::vector<Ring>& rings : parts)
        for (Ring& ring : rings)
            if (std::any_of(ring.begin(), ring.end(), [](const Vec2& p) {
                    return !std::isfinite(p.x) || !std::isfinite(p.y) || glm::length(p) > 1e7;
                }))
                ring.clear();
    for (std::vector<Ring>& rings : parts) std::erase_if(rings, [](const Ring& ring) { return ring.size() < 3; });
    std::erase_if(parts, [](const std::vector<Ring>& rings) { return rings.empty(); });
    return parts;
}

}  // namespace handrail::ifc
