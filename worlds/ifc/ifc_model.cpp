#include "worlds/ifc/ifc_model.h"

#include <algorithm>

#include "worlds/base/text.h"

namespace handrail {

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

// Right-handed unit axes from a z and a wish for x.
Frame frame_of(const Vec3& z, const Vec3& wish_x, const Vec3& origin_m) {
    Frame frame;
    frame.origin_m = origin_m;
    frame.z = z;
    Vec3 x = wish_x - z * glm::dot(wish_x, z);
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
        y = -y;  // a mirror image
    const bool uneven = kind.ends_with("NONUNIFORM");
    frame.y = y * (uneven ? number_at(values, flat ? 4 : 5, scale) : scale);
    frame.z *= uneven && !flat ? number_at(values, 6, scale) : flat ? 1.0 : scale;
    frame.x *= scale;
    frame.origin_m = point(reference_at(values, 2));
    return frame;
}

Frame IfcModel::placement(std::uint64_t id) {
    constexpr std::size_t kLongest = 100;
    std::vector<std::pair<std::uint64_t, Frame>> chain;  // from the inner to the outer, with their own frames
    Frame outer;
    for (std::uint64_t at = id; at != 0;) {
        if (const auto known = placements_.find(at); known != placements_.end()) {
            outer = known->second;
            break;
        }
        const bool again = std::any_of(chain.begin(), chain.end(), [&](const auto& link) { return link.first == at; });
        const std::string_view kind = name(at);
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

}  // namespace handrail
