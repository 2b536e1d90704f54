#include "worlds/scene/prefab.h"

#include <algorithm>
#include <array>

namespace handrail {
namespace {

// Returns a part of a piece of furniture: `x` and `y` are its middle in plan, `wide` its width to the right, `deep` its
// depth to the front, `from` and `to` its lower and upper height.
PrefabPart part(double x, double y, double wide, double deep, double from, double to, std::string_view material) {
    return {{{x - 0.5 * wide, y - 0.5 * deep, from}, {x + 0.5 * wide, y + 0.5 * deep, to}}, material};
}

const std::array kTable{part(0, 0, 1.2, 0.8, 0.70, 0.74, "wood"), part(-0.56, -0.36, 0.06, 0.06, 0, 0.70, "wood"),
                        part(0.56, -0.36, 0.06, 0.06, 0, 0.70, "wood"), part(-0.56, 0.36, 0.06, 0.06, 0, 0.70, "wood"),
                        part(0.56, 0.36, 0.06, 0.06, 0, 0.70, "wood")};
const std::array kDesk{part(0, 0, 1.4, 0.7, 0.70, 0.74, "wood"), part(-0.68, 0, 0.04, 0.7, 0, 0.70, "wood"),
                       part(0.68, 0, 0.04, 0.7, 0, 0.70, "wood"), part(0, -0.33, 1.32, 0.04, 0.30, 0.70, "wood")};
const std::array kChair{part(0, 0, 0.44, 0.44, 0.43, 0.47, "wood"),      part(0, -0.20, 0.44, 0.04, 0.47, 0.90, "wood"),
                        part(-0.20, -0.20, 0.04, 0.04, 0, 0.43, "wood"), part(0.20, -0.20, 0.04, 0.04, 0, 0.43, "wood"),
                        part(-0.20, 0.20, 0.04, 0.04, 0, 0.43, "wood"),  part(0.20, 0.20, 0.04, 0.04, 0, 0.43, "wood")};
const std::array kSofa{part(0, 0.05, 1.5, 0.75, 0, 0.42, "cloth"), part(0, -0.375, 1.5, 0.10, 0, 0.85, "cloth"),
                       part(-0.825, 0, 0.15, 0.85, 0, 0.60, "cloth"), part(0.825, 0, 0.15, 0.85, 0, 0.60, "cloth")};
const std::array kBed{part(0, 0.02, 0.9, 1.96, 0, 0.30, "wood"), part(0, 0.02, 0.9, 1.96, 0.30, 0.50, "cloth"),
                      part(0, -0.98, 0.9, 0.04, 0, 0.90, "wood")};
const std::array kToilet{part(0, 0.10, 0.38, 0.50, 0, 0.42, "tile"), part(0, -0.25, 0.40, 0.20, 0, 0.80, "tile")};
const std::array kBasin{part(0, 0, 0.55, 0.45, 0.73, 0.85, "tile"), part(0, -0.10, 0.20, 0.20, 0, 0.73, "tile")};
const std::array kBathtub{part(0, 0, 1.7, 0.75, 0, 0.12, "tile"), part(-0.82, 0, 0.06, 0.75, 0.12, 0.55, "tile"),
                          part(0.82, 0, 0.06, 0.75, 0.12, 0.55, "tile"),
                          part(0, -0.345, 1.58, 0.06, 0.12, 0.55, "tile"),
                          part(0, 0.345, 1.58, 0.06, 0.12, 0.55, "tile")};
const std::array kStove{part(0, 0, 0.6, 0.6, 0, 0.90, "metal"), part(0, 0.33, 0.5, 0.06, 0.72, 0.76, "metal")};
const std::array kFridge{part(0, 0, 0.6, 0.65, 0, 1.80, "metal"), part(0.24, 0.35, 0.03, 0.05, 0.90, 1.50, "metal")};
const std::array kShelf{part(0, -0.165, 0.86, 0.02, 0, 1.90, "wood"),  part(-0.44, 0, 0.02, 0.35, 0, 1.90, "wood"),
                        part(0.44, 0, 0.02, 0.35, 0, 1.90, "wood"),    part(0, 0.01, 0.86, 0.33, 0.04, 0.06, "wood"),
                        part(0, 0.01, 0.86, 0.33, 0.50, 0.52, "wood"), part(0, 0.01, 0.86, 0.33, 0.96, 0.98, "wood"),
                        part(0, 0.01, 0.86, 0.33, 1.42, 1.44, "wood"), part(0, 0.01, 0.86, 0.33, 1.88, 1.90, "wood")};
const std::array kWardrobe{part(0, 0, 1.2, 0.6, 0, 2.0, "wood"), part(-0.05, 0.32, 0.02, 0.04, 0.95, 1.15, "metal"),
                           part(0.05, 0.32, 0.02, 0.04, 0.95, 1.15, "metal")};
const std::array kBench{part(0, 0, 1.5, 0.4, 0.41, 0.45, "wood"), part(-0.65, 0, 0.06, 0.36, 0, 0.41, "wood"),
                        part(0.65, 0, 0.06, 0.36, 0, 0.41, "wood")};
const std::array kCounter{part(0, 0, 2.0, 0.6, 0, 1.0, "wood"), part(0, 0.05, 2.1, 0.7, 1.0, 1.04, "wood")};
const std::array kBin{part(0, 0, 0.3, 0.3, 0, 0.6, "plastic")};
// The cabin is open to the front and measures 1.1 by 1.4 m inside.
const std::array kLiftCabin{part(0, 0, 1.2, 1.5, 0, 0.02, "metal"), part(0, -0.725, 1.1, 0.05, 0.02, 2.2, "metal"),
                            part(-0.575, 0, 0.05, 1.5, 0.02, 2.2, "metal"),
                            part(0.575, 0, 0.05, 1.5, 0.02, 2.2, "metal"), part(0, 0, 1.2, 1.5, 2.2, 2.25, "metal")};
// The gate is a passage 0.9 m wide between two cabinets, with a bar across it.
const std::array kTicketGate{part(-0.55, 0, 0.2, 1.2, 0, 1.0, "metal"), part(0.55, 0, 0.2, 1.2, 0, 1.0, "metal"),
                             part(0, 0, 0.9, 0.05, 0.75, 0.95, "plastic")};

const std::array kPrefabs{Prefab{"table", kTable},
                          Prefab{"desk", kDesk},
                          Prefab{"chair", kChair},
                          Prefab{"sofa", kSofa},
                          Prefab{"bed", kBed},
                          Prefab{"toilet", kToilet},
                          Prefab{"basin", kBasin},
                          Prefab{"bathtub", kBathtub},
                          Prefab{"stove", kStove},
                          Prefab{"fridge", kFridge},
                          Prefab{"shelf", kShelf},
                          Prefab{"wardrobe", kWardrobe},
                          Prefab{"bench", kBench},
                          Prefab{"counter", kCounter},
                          Prefab{"bin", kBin},
                          Prefab{"lift_cabin", kLiftCabin},
                          Prefab{"ticket_gate", kTicketGate}};

}  // namespace

std::span<const Prefab> prefabs() { return kPrefabs; }

const Prefab* find_prefab(std::string_view name) {
    const auto* const found =
        std::find_if(kPrefabs.begin(), kPrefabs.end(), [&](const Prefab& one) { return one.name == name; });
    return found == kPrefabs.end() ? nullptr : found;
}

}  // namespace handrail
