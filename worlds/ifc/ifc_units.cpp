// Reads the units of length and angle of the file: an IfcUnitAssignment with SI units and conversion-based units.
#include <array>

#include "worlds/base/text.h"
#include "worlds/ifc/ifc_model.h"

namespace handrail::ifc {
namespace {

double prefix(std::string_view word) {
    struct Row {
        std::string_view word;
        double factor;
    };
    constexpr std::array<Row, 10> kRows{{{"KILO", 1e3},
                                         {"HECTO", 1e2},
                                         {"DECA", 1e1},
                                         {"DECI", 1e-1},
                                         {"CENTI", 1e-2},
                                         {"MILLI", 1e-3},
                                         {"MICRO", 1e-6},
                                         {"NANO", 1e-9},
                                         {"MEGA", 1e6},
                                         {"GIGA", 1e9}}};
    for (const Row& row : kRows)
        if (row.word == word) return row.factor;
    return 1.0;
}

// Returns the factor of a unit by its name, for units that do not state their factor.
double known_unit(const std::string& name) {
    if (name.find("foot") != std::string::npos || name.find("feet") != std::string::npos) return 0.3048;
    if (name.find("inch") != std::string::npos) return 0.0254;
    if (name.find("yard") != std::string::npos) return 0.9144;
    if (name.find("degree") != std::string::npos) return kPi / 180.0;
    return 1.0;
}

bool sensible(double factor) { return std::isfinite(factor) && factor > 1e-9 && factor < 1e9; }

}  // namespace

double IfcModel::length_of_unit(std::uint64_t id, int depth) const {
    const std::string_view kind = name(id);
    const Values values = this->values(id);
    if (kind == "IFCSIUNIT") return prefix(word_at(values, 2));
    if (!kind.starts_with("IFCCONVERSIONBASEDUNIT") || depth > 8) return 1.0;
    const std::uint64_t measure = reference_at(values, 3);
    const Values of_measure = this->values(measure);
    const double factor = number_at(of_measure, 0, 0.0);
    if (!sensible(factor)) return known_unit(lower_ascii(text_at(values, 2)));
    const double one = length_of_unit(reference_at(of_measure, 1), depth + 1);
    return sensible(factor * one) ? factor * one : 1.0;
}

void IfcModel::read_units() {
    std::uint64_t assignment = 0;
    for (const StepInstance& instance : file_.instances()) {
        if (instance.name == "IFCPROJECT") {
            const Values values = file_.values_of(instance);
            if (const std::uint64_t stated = reference_at(values, 8)) assignment = stated;
            break;
        }
        if (instance.name == "IFCUNITASSIGNMENT" && assignment == 0) assignment = instance.id;
    }
    const Values of_assignment = values(assignment);
    for (const std::uint64_t unit : references_at(of_assignment, 0)) {
        const Values values = this->values(unit);
        const std::string_view what = word_at(values, 1);
        if (what == "LENGTHUNIT") {
            metres_per_unit_ = length_of_unit(unit, 0);
            unit_stated_ = true;
        } else if (what == "PLANEANGLEUNIT") {
            radians_per_unit_ = length_of_unit(unit, 0);
        }
    }
}

}  // namespace handrail::ifc
