#include "worlds/ifc/ifc_curves.h"

#include <algorithm>

namespace handrail::ifc {
namespace {

constexpr int kDeepestCurve = 8;
constexpr std::size_t kMostPoints = 20'000;

double arc_step(double radius_m) { return radians_from_degrees(radius_m < 0.5 ? 15.0 : 7.5); }

// Adds an arc with both of its ends. The arc begins at the angle `from` and turns by `turn`.
void add_arc(std::vector<Vec3>& points, const Frame& frame, double a_m, double b_m, double from, double turn) {
    const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(turn) / arc_step(std::max(a_m, b_m)) - 1e-9)));
    for (int i = 0; i <= steps; ++i) {
        const double angle = from + turn * i / steps;
        points.push_back(frame.at({a_m * std::cos(angle), b_m * std::sin(angle), 0.0}));
    }
}

// Adds the arc through three points, or a straight line if the points are collinear.
void add_arc_through(std::vector<Vec3>& points, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 ab = b - a, ac = c - a, normal = glm::cross(ab, ac);
    const double square = glm::dot(normal, normal);
    if (!(square > 1e-18)) {
        points.insert(points.end(), {a, b, c});
        return;
    }
    const Vec3 to_middle =
        (glm::cross(normal, ab) * glm::dot(ac, ac) + glm::cross(ac, normal) * glm::dot(ab, ab)) / (2.0 * square);
    Frame frame;
    frame.origin_m = a + to_middle;
    const double radius = glm::length(to_middle);
    frame.z = normal / std::sqrt(square);
    frame.x = -to_middle / radius;
    frame.y = glm::cross(frame.z, frame.x);
    double end = std::atan2(glm::dot(c - frame.origin_m, frame.y), glm::dot(c - frame.origin_m, frame.x));
    if (end <= 0.0) end += 2.0 * kPi;
    add_arc(points, frame, radius, radius, 0.0, end);
}

class CurveReader {
public:
    explicit CurveReader(const IfcModel& model) : model_(model) {}

    std::vector<Vec3> points(std::uint64_t curve, int depth) const {
        const std::string_view kind = model_.name(curve);
        if (depth > kDeepestCurve) return {};
        const Values values = model_.values(curve);
        std::vector<Vec3> found;
        if (kind == "IFCPOLYLINE") {
            for (const std::uint64_t p : references_at(values, 0)) found.push_back(model_.point(p));
        } else if (kind == "IFCINDEXEDPOLYCURVE") {
            found = indexed(values);
        } else if (kind == "IFCCIRCLE" || kind == "IFCELLIPSE") {
            const double a = number_at(values, 1) * model_.metres_per_unit(),
                         b = kind == "IFCCIRCLE" ? a : number_at(values, 2) * model_.metres_per_unit();
            if (a > 0.0 && b > 0.0 && std::isfinite(a + b))
                add_arc(found, model_.axes(reference_at(values, 0)), a, b, 0.0, 2.0 * kPi);
        } else if (kind == "IFCTRIMMEDCURVE") {
            found = trimmed(values, depth);
        } else if (kind == "IFCCOMPOSITECURVE" || kind == "IFC2DCOMPOSITECURVE" || kind == "IFCBOUNDARYCURVE" ||
                   kind == "IFCOUTERBOUNDARYCURVE") {
            for (const std::uint64_t segment : references_at(values, 0)) {
                const Values of_segment = model_.values(segment);
                std::vector<Vec3> part = points(reference_at(of_segment, 2), depth + 1);
                if (word_at(of_segment, 1) == "F") std::reverse(part.begin(), part.end());
                found.insert(found.end(), part.begin(), part.end());
                if (found.size() > kMostPoints) return {};
            }
        } else if (kind.starts_with("IFCBSPLINECURVE") || kind.starts_with("IFCRATIONALBSPLINECURVE")) {
            for (const std::uint64_t p : references_at(values, 1))
                found.push_back(model_.point(p));  // the curve is replaced with the line through its control points
        }
        if (found.size() > kMostPoints) return {};
        std::vector<Vec3> kept;
        for (const Vec3& p : found)
            if (is_finite(p) && (kept.empty() || glm::length(p - kept.back()) > 1e-7)) kept.push_back(p);
        if (kept.size() > 1 && depth == 0 && glm::length(kept.front() - kept.back()) <= 1e-6) kept.pop_back();
        return kept;
    }

private:
    std::vector<Vec3> indexed(const Values& values) const {
        const Values list = model_.values(reference_at(values, 0));
        std::vector<Vec3> all;
        for (const StepValue& row : value_at(list, 0).items) {
            const std::vector<double> numbers = numbers_of(row);
            Vec3 p{0.0};
            for (std::size_t i = 0; i < std::min<std::size_t>(3, numbers.size()); ++i)
                p[static_cast<int>(i)] = numbers[i] * model_.metres_per_unit();
            all.push_back(p);
        }
        const StepValue& segments = value_at(values, 1);
        if (segments.items.empty()) return all;
        std::vector<Vec3> found;
        for (const StepValue& segment : segments.items) {
            // IFCLINEINDEX((1,2,3)) and IFCARCINDEX((1,2,3)) contain a list within a typed list.
            std::vector<double> indices = numbers_of(segment);
            if (indices.empty() && !segment.items.empty()) indices = numbers_of(segment.items[0]);
            std::vector<Vec3> at;
            for (const double index : indices)
                if (index >= 1.0 && index <= static_cast<double>(all.size()))
                    at.push_back(all[static_cast<std::size_t>(index) - 1]);
            if (segment.type == "IFCARCINDEX" && at.size() == 3) add_arc_through(found, at[0], at[1], at[2]);
            else found.insert(found.end(), at.begin(), at.end());
        }
        return found;
    }

    // One end of a trimmed curve. The file states a parameter, a point or both.
    struct Trim {
        std::optional<double> parameter;
        std::optional<Vec3> at;
    };
    Trim trim_of(const StepValue& list) const {
        Trim trim;
        for (const StepValue& item : list.items) {
            if (item.kind == StepValue::Kind::Number) trim.parameter = item.number;
            if (item.kind == StepValue::Kind::Reference) trim.at = model_.point(item.reference);
        }
        return trim;
    }
    std::vector<Vec3> trimmed(const Values& values, int depth) const {
        const std::uint64_t basis = reference_at(values, 0);
        const std::string_view kind = model_.name(basis);
        const Values of_basis = model_.values(basis);
        const Trim first = trim_of(value_at(values, 1)), second = trim_of(value_at(values, 2));
        const bool along = word_at(values, 3) != "F";
        if (kind == "IFCLINE") {
            const Vec3 from = model_.point(reference_at(of_basis, 0));
            const Values vector = model_.values(reference_at(of_basis, 1));
            const Vec3 step = model_.direction(reference_at(vector, 0), {1, 0, 0}) * number_at(vector, 1, 1.0) *
                              model_.metres_per_unit();
            const auto end = [&](const Trim& t) { return t.at ? *t.at : from + step * t.parameter.value_or(0.0); };
            return {end(first), end(second)};
        }
        if (kind != "IFCCIRCLE" && kind != "IFCELLIPSE") return points(basis, depth + 1);
        const double a = number_at(of_basis, 1) * model_.metres_per_unit(),
                     b = kind == "IFCCIRCLE" ? a : number_at(of_basis, 2) * model_.metres_per_unit();
        if (!(a > 0.0) || !(b > 0.0) || !std::isfinite(a + b)) return {};
        const Frame frame = model_.axes(reference_at(of_basis, 0));
        const bool by_points = word_at(values, 4) == "CARTESIAN";
        const auto angle = [&](const Trim& t) {
            if (t.at && (by_points || !t.parameter))
                return std::atan2(glm::dot(*t.at - frame.origin_m, frame.y) / b,
                                  glm::dot(*t.at - frame.origin_m, frame.x) / a);
            return t.parameter.value_or(0.0) * model_.radians_per_unit();
        };
        const double from = angle(first);
        double turn = std::remainder(angle(second) - from, 2.0 * kPi);
        if (!std::isfinite(turn) || !std::isfinite(from)) return {};
        if (along && turn <= 1e-9) turn += 2.0 * kPi;
        if (!along && turn >= -1e-9) turn -= 2.0 * kPi;
        std::vector<Vec3> found;
        add_arc(found, frame, a, b, from, turn);
        return found;
    }

    const IfcModel& model_;
};

}  // namespace

Ring regular_ring(double radius_m, int corners) {
    Ring ring;
    for (int i = 0; i < corners; ++i)
        ring.emplace_back(radius_m * std::cos(2.0 * kPi * i / corners), radius_m * std::sin(2.0 * kPi * i / corners));
    return ring;
}

std::vector<Vec3> curve_points(const IfcModel& model, std::uint64_t curve) {
    return CurveReader(model).points(curve, 0);
}

}  // namespace handrail::ifc
