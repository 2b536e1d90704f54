// Reads the shells, loops and tessellations of IFC.
#include <algorithm>

#include "worlds/geometry/clip.h"
#include "worlds/geometry/flat_parts.h"
#include "worlds/ifc/ifc_shapes.h"

namespace handrail::ifc {
namespace {

// Cuts a curved face into strips. It pairs the corners of the outline across the face so that the strips are as narrow
// as possible.
std::vector<FlatFace> strips_of(const std::vector<Vec3>& ring) {
    const std::size_t n = ring.size();
    std::size_t best = 0;
    double least = 1e300;
    for (std::size_t s = 0; s < n; ++s) {
        double sum = 0.0;
        for (std::size_t i = 0; i < n / 2; ++i) sum += glm::length(ring[(s + i) % n] - ring[(s + n - 1 - i) % n]);
        if (sum < least) least = sum, best = s;
    }
    std::vector<FlatFace> strips;
    for (std::size_t i = 0; i + 1 < n - 1 - i; ++i) {
        const Vec3 &a = ring[(best + i) % n], &b = ring[(best + i + 1) % n], &c = ring[(best + n - 2 - i) % n],
                   &d = ring[(best + n - 1 - i) % n];
        strips.push_back({{{a, b, d}}});
        if (i + 1 < n - 2 - i) strips.push_back({{{b, c, d}}});
    }
    return strips;
}

double off_plane(const std::vector<Vec3>& ring) {
    Vec3 area{0.0};
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) area += glm::cross(ring[i] - ring[0], ring[i + 1] - ring[0]);
    if (!(glm::length(area) > 1e-12)) return 0.0;
    area = area / glm::length(area);
    double most = 0.0;
    for (const Vec3& p : ring) most = std::max(most, std::abs(glm::dot(p - ring[0], area)));
    return most;
}

}  // namespace

std::vector<Vec3> IfcShapes::loop(std::uint64_t id) {
    const std::string_view kind = model_.name(id);
    const Values values = model_.values(id);
    std::vector<Vec3> ring;
    if (kind == "IFCPOLYLOOP") {
        for (const std::uint64_t p : references_at(values, 0)) ring.push_back(model_.point(p));
    } else if (kind == "IFCEDGELOOP") {
        for (const std::uint64_t oriented : references_at(values, 0)) {
            const Values edge = model_.values(reference_at(model_.values(oriented), 2));
            const bool forward = word_at(model_.values(oriented), 3) != "F";
            const auto corner = [&](std::size_t i) {
                return model_.point(reference_at(model_.values(reference_at(edge, i)), 0));
            };
            const Vec3 from = corner(forward ? 0 : 1), to = corner(forward ? 1 : 0);
            ring.push_back(from);
            const std::uint64_t geometry = reference_at(edge, 2);
            if (const std::string_view curve = model_.name(geometry); curve == "IFCCIRCLE") {
                const Values circle = model_.values(geometry);
                const Frame frame = model_.axes(reference_at(circle, 0));
                const double radius = number_at(circle, 1) * model_.metres_per_unit();
                const auto angle = [&](const Vec3& p) {
                    return std::atan2(glm::dot(p - frame.origin_m, frame.y), glm::dot(p - frame.origin_m, frame.x));
                };
                const bool along = (word_at(edge, 3) != "F") == forward;
                double turn = std::remainder(angle(to) - angle(from), 2.0 * kPi);
                if (along && turn <= 1e-9) turn += 2.0 * kPi;
                if (!along && turn >= -1e-9) turn -= 2.0 * kPi;
                const int steps = std::clamp(static_cast<int>(std::abs(turn) / radians_from_degrees(15.0)), 1, 24);
                for (int i = 1; i < steps; ++i) {
                    const double at = angle(from) + turn * i / steps;
                    ring.push_back(frame.at({radius * std::cos(at), radius * std::sin(at), 0.0}));
                }
            }
        }
    }
    faces_ += ring.size() / 3;
    if (ring.size() > kMostCorners) {
        ring.clear();
        ++account_.lost_faces;
    }
    return ring;
}

FlatFace IfcShapes::face(std::uint64_t id) {
    FlatFace face;
    const Values values = model_.values(id);
    for (const std::uint64_t bound : references_at(values, 0)) {
        const Values of_bound = model_.values(bound);
        std::vector<Vec3> ring = loop(reference_at(of_bound, 0));
        if (ring.size() < 3) continue;
        if (word_at(of_bound, 1) == "F") std::reverse(ring.begin(), ring.end());
        const bool outer = model_.name(bound) == "IFCFACEOUTERBOUND" && !face.rings.empty();
        face.rings.insert(outer ? face.rings.begin() : face.rings.end(), std::move(ring));
    }
    return face;
}

void IfcShapes::add_faces(std::uint64_t shell, std::vector<FlatFace>& faces) {
    const Values values = model_.values(shell);
    for (const std::uint64_t id : references_at(values, 0)) {
        if (spent()) return;
        FlatFace one = face(id);
        if (one.rings.empty()) continue;
        // A curved face has no single plane, so it is cut into strips across its outline.
        if (one.rings.size() == 1 && one.rings[0].size() > 3 && one.rings[0].size() <= 200 &&
            off_plane(one.rings[0]) > 2e-3) {
            ++approximated_;
            for (FlatFace& strip : strips_of(one.rings[0])) faces.push_back(std::move(strip));
        } else {
            faces.push_back(std::move(one));
        }
    }
}

Body IfcShapes::shells(const std::vector<std::uint64_t>& all) {
    Body body;
    for (const std::uint64_t shell : all) {
        std::vector<FlatFace> faces;
        add_faces(shell, faces);
        body.add(body_of_skin(faces));
    }
    return body;
}

Body IfcShapes::body_of_skin(const std::vector<FlatFace>& faces) {
    Body body = body_of_faces(faces);
    weigh_faces(faces, body);
    return body;
}

std::vector<Vec3> IfcShapes::point_list(std::uint64_t id) const {
    std::vector<Vec3> points;
    const Values values = model_.values(id);
    for (const StepValue& row : value_at(values, 0).items) {
        const std::vector<double> numbers = numbers_of(row);
        points.push_back(numbers.size() < 3 ? Vec3(std::nan(""))
                                            : Vec3(numbers[0], numbers[1], numbers[2]) * model_.metres_per_unit());
    }
    return points;
}

std::vector<FlatFace> IfcShapes::tessellated_faces(std::string_view kind, const Values& values) {
    const std::vector<Vec3> points = point_list(reference_at(values, 0));
    const bool triangles = kind != "IFCPOLYGONALFACESET";
    std::vector<double> through;  // PnIndex, which maps the indices in the faces to indices of points
    for (const double n : numbers_of(value_at(values, triangles ? 4 : 3))) through.push_back(n);
    const auto ring_of = [&](const std::vector<double>& indices) {
        std::vector<Vec3> ring;
        for (double index : indices) {
            if (!through.empty() && index >= 1.0 && index <= static_cast<double>(through.size()))
                index = through[static_cast<std::size_t>(index) - 1];
            if (!(index >= 1.0) || index > static_cast<double>(points.size())) {
                ++account_.lost_faces;
                return std::vector<Vec3>{};
            }
            ring.push_back(points[static_cast<std::size_t>(index) - 1]);
        }
        if (ring.size() > kMostCorners) {
            ring.clear();
            ++account_.lost_faces;
        }
        return ring;
    };
    std::vector<FlatFace> faces;
    if (triangles) {
        for (const StepValue& row : value_at(values, 3).items) faces.push_back({{ring_of(numbers_of(row))}});
    } else {
        for (const std::uint64_t id : references_at(values, 2)) {
            const Values of_face = model_.values(id);
            FlatFace face{{ring_of(numbers_of(value_at(of_face, 0)))}};
            for (const StepValue& hole : value_at(of_face, 1).items) face.rings.push_back(ring_of(numbers_of(hole)));
            faces.push_back(std::move(face));
        }
    }
    faces_ += faces.size();
    return faces;
}

// Adds the volume within a closed skin, computed from its faces alone. For an open skin, adds the area of its faces.
void IfcShapes::weigh_faces(const std::vector<FlatFace>& faces, const Body& body) {
    const std::optional<double> enclosed = enclosed_m3(faces);
    if (!enclosed) {
        for (const FlatFace& face : faces) {
            double sum_m2 = 0.0, largest_m2 = 0.0;
            for (const std::vector<Vec3>& ring : face.rings) {
                const double ring_m2 = ring.size() < 3 ? 0.0 : glm::length(area_vector_m2(ring));
                sum_m2 += std::isfinite(ring_m2) ? ring_m2 : 0.0;
                largest_m2 = std::max(largest_m2, std::isfinite(ring_m2) ? ring_m2 : 0.0);
            }
            account_.stated_m2 += std::max(0.0, 2.0 * largest_m2 - sum_m2);  // every ring except the largest is a hole
        }
        for (const Polygon& sheet : body.sheets) account_.made_m2 += glm::length(area_vector_m2(sheet.points_m));
        for (const ConvexSolid& solid : body.solids)
            for (const Polygon& side : solid.faces) account_.made_m2 += glm::length(area_vector_m2(side.points_m));
        return;
    }
    account_.stated_m3 += *enclosed;
    account_.made_m3 += volume_m3(body);
}

}  // namespace handrail::ifc
