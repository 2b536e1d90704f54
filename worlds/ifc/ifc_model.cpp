#include "worlds/ifc/ifc_model.h"

#include <algorithm>

#include "worlds/base/text.h"
#include "worlds/ifc/ifc_curves.h"

namespace handrail::ifc {

const StepValue& value_at(const Values& values, std::size_t i) {
    static const StepValue kNothing;
    return i < values.size() ? values[i] : kNothing;
}
double number_at(const Values& values, std::size_t i, double otherwise) {
    const StepValue& value = value_at(values, i);
    return value.kind == StepValue::Kind::Number ? value.number : otherwise;
}
std::string text_at(const Values& values, std::size_t i) {
    const StepValue& value = value_at(values, i);
    if (value.kind != StepValue::Kind::Text) return {};
    std::string text = one_line(decoded(value.text.substr(0, 1000)));
    while (!text.empty() && text.back() == ' ') text.pop_back();
    while (!text.empty() && text.front() == ' ') text.erase(0, 1);
    return text;
}
std::string_view word_at(const Values& values, std::size_t i) {
    const StepValue& value = value_at(values, i);
    return value.kind == StepValue::Kind::Word ? value.text : std::string_view{};
}
std::uint64_t reference_at(const Values& values, std::size_t i) {
    const StepValue& value = value_at(values, i);
    return value.kind == StepValue::Kind::Reference ? value.reference : 0;
}
std::vector<std::uint64_t> references_at(const Values& values, std::size_t i) {
    const StepValue& value = value_at(values, i);
    if (value.kind == StepValue::Kind::Reference) return {value.reference};
    std::vector<std::uint64_t> found;
    for (const StepValue& item : value.items)
        if (item.kind == StepValue::Kind::Reference) found.push_back(item.reference);
    return found;
}
std::vector<double> numbers_of(const StepValue& list) {
    std::vector<double> numbers;
    for (const StepValue& item : list.items)
        if (item.kind == StepValue::Kind::Number) numbers.push_back(item.number);
    return numbers;
}

IfcModel::IfcModel(const StepFile& file) : file_(file) { read_units(); }

Values IfcModel::values(std::uint64_t id) const {
    const StepInstance* instance = file_.find(id);
    return instance ? file_.values_of(*instance) : Values{};
}
std::string_view IfcModel::name(std::uint64_t id) const {
    const StepInstance* instance = file_.find(id);
    return instance ? instance->name : std::string_view{};
}
int IfcModel::line(std::uint64_t id) const {
    const StepInstance* instance = file_.find(id);
    return instance ? instance->line : 0;
}

Vec3 IfcModel::point(std::uint64_t id) const {
    const Values values = this->values(id);
    const std::vector<double> numbers = numbers_of(value_at(values, 0));
    Vec3 p{0.0};
    for (std::size_t i = 0; i < std::min<std::size_t>(3, numbers.size()); ++i)
        p[static_cast<int>(i)] = numbers[i] * metres_per_unit_;
    return p;
}

Vec3 IfcModel::direction(std::uint64_t id, const Vec3& otherwise) const {
    if (id == 0) return otherwise;
    const Values values = this->values(id);
    const std::vector<double> numbers = numbers_of(value_at(values, 0));
    Vec3 d{0.0};
    for (std::size_t i = 0; i < std::min<std::size_t>(3, numbers.size()); ++i) d[static_cast<int>(i)] = numbers[i];
    const double length = glm::length(d);
    return std::isfinite(length) && length > 1e-12 ? d / length : otherwise;
}

namespace {

double cross(const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; }

// Returns the corners of a grid axis, shifted to its left by the given distance.
std::vector<Vec2> grid_axis(const IfcModel& model, std::uint64_t axis, double left_m) {
    const Values values = model.values(axis);
    const std::uint64_t curve = reference_at(values, 1);
    std::vector<Vec2> line;
    if (model.name(curve) == "IFCLINE") {
        const Values of_line = model.values(curve);
        const Vec3 from = model.point(reference_at(of_line, 0));
        const Values vector = model.values(reference_at(of_line, 1));
        const Vec3 way = model.direction(reference_at(vector, 0), {1, 0, 0});
        line = {{from.x, from.y}, {from.x + way.x, from.y + way.y}};
    } else {
        for (const Vec3& p : curve_points(model, curve)) line.emplace_back(p.x, p.y);
    }
    if (word_at(values, 2) == "F") std::reverse(line.begin(), line.end());
    std::vector<Vec2> moved = line;
    for (std::size_t i = 0; i < line.size() && line.size() > 1; ++i) {
        const Vec2 way = line[std::min(i + 1, line.size() - 1)] - line[i == 0 ? 0 : i - 1];
        moved[i] += Vec2(-way.y, way.x) * (left_m / std::max(glm::length(way), 1e-12));
    }
    return moved;
}

struct GridCrossing {
    Vec2 at{0.0}, along{1.0, 0.0};
};

// Returns the crossing of two axes, which may end before they cross. It chooses the two pieces that have to be
// lengthened least to cross.
std::optional<GridCrossing> crossing_of(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
    std::optional<GridCrossing> best;
    double least_m = 1e300;
    for (std::size_t i = 0; i + 1 < a.size(); ++i)
        for (std::size_t j = 0; j + 1 < b.size(); ++j) {
            const Vec2 p = a[i + 1] - a[i], q = b[j + 1] - b[j], off = b[j] - a[i];
            const double across = cross(p, q);
            if (std::abs(across) <= 1e-9 * glm::length(p) * glm::length(q)) continue;
            const double s = cross(off, q) / across, t = cross(off, p) / across;
            const double beyond_m =
                std::max({0.0, -s, s - 1.0}) * glm::length(p) + std::max({0.0, -t, t - 1.0}) * glm::length(q);
            if (beyond_m >= least_m) continue;
            least_m = beyond_m;
            best = GridCrossing{a[i] + p * s, p / glm::length(p)};
        }
    return best;
}

// Returns right-handed unit axes from a z axis and a preferred x axis.
Frame frame_of(const Vec3& z, const Vec3& wanted_x, const Vec3& origin_m) {
    Frame frame;
    frame.origin_m = origin_m;
    frame.z = z;
    Vec3 x = wanted_x - z * glm::dot(wanted_x, z);
    frame.x = glm::length(x) > 1e-9 ? x / glm::length(x) : any_perpendicular(z);
    frame.y = glm::cross(frame.z, frame.x);
    return frame;
}

}  // namespace

Frame IfcModel::axes(std::uint64_t id) const {
    const std::string_view kind = name(id);
    if (kind.empty()) return {};
    const Values values = this->values(id);
    const Vec3 origin_m = point(reference_at(values, 0));
    if (kind == "IFCAXIS2PLACEMENT2D") {
        const Vec3 x = direction(reference_at(values, 1), {1, 0, 0});
        return frame_of({0, 0, 1}, {x.x, x.y, 0.0}, origin_m);
    }
    const Vec3 z = direction(reference_at(values, 1), {0, 0, 1});
    if (kind == "IFCAXIS1PLACEMENT") return frame_of(z, any_perpendicular(z), origin_m);
    return frame_of(z, direction(reference_at(values, 2), {1, 0, 0}), origin_m);
}

Frame IfcModel::transformation(std::uint64_t id) const {
    const std::string_view kind = name(id);
    if (!kind.starts_with("IFCCARTESIANTRANSFORMATIONOPERATOR")) return {};
    const Values values = this->values(id);
    const bool flat = kind.find("2D") != std::string_view::npos;
    Frame frame;
    const double scale = number_at(values, 3, 1.0);
    frame.z = flat ? Vec3(0, 0, 1) : direction(reference_at(values, 4), {0, 0, 1});
    Vec3 x = direction(reference_at(values, 0), {1, 0, 0});
    x -= frame.z * glm::dot(x, frame.z);
    frame.x = glm::length(x) > 1e-9 ? x / glm::length(x) : any_perpendicular(frame.z);
    Vec3 y = glm::cross(frame.z, frame.x);
    if (const std::uint64_t stated = reference_at(values, 1); stated != 0 && glm::dot(direction(stated, y), y) < 0.0)
        y = -y;  // Reverses y, because the transformation mirrors.
    const bool uneven = kind.ends_with("NONUNIFORM");
    frame.y = y * (uneven ? number_at(values, flat ? 4 : 5, scale) : scale);
    frame.z *= uneven && !flat ? number_at(values, 6, scale) : flat ? 1.0 : scale;
    frame.x *= scale;
    frame.origin_m = point(reference_at(values, 2));
    return frame;
}

// Returns the frame at the crossing of two grid axes. The axes are shifted sideways by the stated distances; x runs
// along the first axis.
Frame IfcModel::on_grid(const Values& values) {
    if (grid_of_.empty())
        for (const StepInstance& instance : file_.instances())
            if (instance.name == "IFCGRID") {
                const Values grid = file_.values_of(instance);
                for (const std::size_t axes : {7U, 8U, 9U})
                    for (const std::uint64_t axis : references_at(grid, axes)) grid_of_.emplace(axis, instance.id);
            }
    // In IFC 4.3 the reference placement comes before the two other attributes, so the first virtual intersection is
    // searched.
    std::size_t first = 0;
    while (first < values.size() && name(reference_at(values, first)) != "IFCVIRTUALGRIDINTERSECTION") ++first;
    const Values crossing = this->values(reference_at(values, first));
    const std::vector<std::uint64_t> axes = references_at(crossing, 0);
    const std::vector<double> offsets = numbers_of(value_at(crossing, 1));
    const auto grid = axes.size() == 2 ? grid_of_.find(axes[0]) : grid_of_.end();
    if (grid == grid_of_.end()) {
        ++odd_placements_;
        return {};
    }
    const auto line_of = [&](std::size_t i) {
        return grid_axis(*this, axes[i], i < offsets.size() ? offsets[i] * metres_per_unit_ : 0.0);
    };
    const std::optional<GridCrossing> found = crossing_of(line_of(0), line_of(1));
    if (!found) {
        ++odd_placements_;
        return {};
    }
    Vec3 x{found->along.x, found->along.y, 0.0};
    const std::uint64_t stated = reference_at(values, first + 1);
    if (name(stated) == "IFCDIRECTION") x = direction(stated, x);
    const Frame own =
        frame_of({0, 0, 1}, x, {found->at.x, found->at.y, offsets.size() > 2 ? offsets[2] * metres_per_unit_ : 0.0});
    const std::uint64_t of_grid = reference_at(this->values(grid->second), 5);
    return (name(of_grid) == "IFCLOCALPLACEMENT" ? placement(of_grid) : Frame{}).of(own);
}

Frame IfcModel::placement(std::uint64_t id) {
    constexpr std::size_t kLongest = 100;
    // The placements from the inner to the outer one, each with its own frame.
    std::vector<std::pair<std::uint64_t, Frame>> chain;
    Frame outer;
    for (std::uint64_t at = id; at != 0;) {
        if (const auto known = placements_.find(at); known != placements_.end()) {
            outer = known->second;
            break;
        }
        const bool again = std::any_of(chain.begin(), chain.end(), [&](const auto& link) { return link.first == at; });
        const std::string_view kind = name(at);
        if (kind == "IFCGRIDPLACEMENT" && !again && chain.size() < kLongest) {
            chain.emplace_back(at, Frame{});
            outer = on_grid(values(at));
            break;
        }
        if (again || chain.size() >= kLongest || kind != "IFCLOCALPLACEMENT") {
            ++odd_placements_;
            break;
        }
        const Values values = this->values(at);
        chain.emplace_back(at, axes(reference_at(values, 1)));
        at = reference_at(values, 0);
    }
    for (auto link = chain.rbegin(); link != chain.rend(); ++link) {
        outer = outer.of(link->second);
        placements_.emplace(link->first, outer);
    }
    return outer;
}

}  // namespace handrail::ifc
