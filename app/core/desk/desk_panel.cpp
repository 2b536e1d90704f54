#include "app/core/desk/desk_panel.h"

#include <algorithm>
#include <cmath>

#include "haptic/compile/compile_haptic.h"
#include "worlds/base/contract.h"
#include "worlds/base/language.h"
#include "worlds/scene/primitive.h"

namespace handrail::core {
namespace {

constexpr double kPitchM = kControlM + kControlGapM;
// Distance of the panel beyond the middle of the workspace, as a share of the reach. It leaves room behind the panel,
// so that the hand can push the panel.
constexpr double kPanelAt = 0.1;
constexpr double kPanelThickM = 0.02;
// The corners of the outermost controls are at most this share of the reach from the middle.
constexpr double kMostReach = 0.95;
constexpr double kButtonHighM = 0.004;  // how far a button stands out of the panel
constexpr double kSliderHighM = 0.002, kKnobHighM = 0.002, kDomeHighM = 0.003;
// Radius and height of the post in the middle of a knob; the hand turns round it.
constexpr double kKnobPostM = 0.0022, kKnobPostHighM = 0.005;
// Height and width of the ridges between positions. If the ridges were higher, they would hold back the hand of a soft
// device by more than a position.
constexpr double kRidgeHighM = 0.0002, kRidgeWideM = 0.0006;
constexpr double kFriction = 0.1;  // friction of all surfaces; low, so that a slider or knob follows the hand easily
constexpr double kListGapM = 0.002;
constexpr double kSliderEndM = 0.0025;  // distance from the end of a slider to its first position

int width_in_cells(DeskKind kind, const DeskGrid& grid) {
    return kind == DeskKind::Slider && (grid.columns > 2 || (grid.columns == 2 && grid.rows > 1)) ? 2 : 1;
}

struct Cell {
    std::size_t page;
    int column, row, wide;
};

// Places the controls row by row. If there are several pages, the last place of each page belongs to the button that
// turns the pages.
std::vector<Cell> cells_of(std::span<const DeskControl> controls, const DeskGrid& grid, bool paged) {
    std::vector<Cell> cells;
    std::size_t page = 0;
    int column = 0, row = 0;
    for (const DeskControl& control : controls) {
        const int wide = width_in_cells(control.kind, grid);
        const auto room = [&] {
            return row < grid.rows && column + wide <= grid.columns - (paged && row == grid.rows - 1 ? 1 : 0);
        };
        if (!room() && row < grid.rows) column = 0, ++row;
        if (!room()) ++page, column = 0, row = 0;
        cells.push_back({page, column, row, wide});
        column += wide;
    }
    return cells;
}

std::vector<Cell> cells_of(std::span<const DeskControl> controls, const DeskGrid& grid) {
    std::vector<Cell> cells = cells_of(controls, grid, false);
    return !cells.empty() && cells.back().page > 0 ? cells_of(controls, grid, true) : cells;
}

class PanelBuilder {
public:
    PanelBuilder() {
        scene_.name = "desk";
        scene_.materials.emplace_back();
        scene_.materials.front().friction_mu = kFriction;
    }
    FeatureId feature(std::string name, FeatureKind kind) {
        Feature one;
        one.kind = kind;
        one.name = std::move(name);
        scene_.features.push_back(std::move(one));
        return FeatureId{static_cast<std::uint32_t>(scene_.features.size() - 1)};
    }
    void add(FeatureId feature, PrimitiveKind kind, const Vec3& at_m, const Vec3& size_m, const Rotation& turned = {}) {
        auto solid = make_solid({kind, size_m, Vec3(1.0), {at_m, turned, 1.0}});
        contract_pre(solid.has_value());
        solid->feature = feature;
        std::fill(solid->face_features.begin(), solid->face_features.end(), feature);
        scene_.features[feature.value].bounds_m.include(solid->shape.bounds_m);
        scene_.bounds_m.include(solid->shape.bounds_m);
        scene_.solids.push_back(std::move(*solid));
    }
    std::shared_ptr<const Scene> take() { return std::make_shared<const Scene>(std::move(scene_)); }

private:
    Scene scene_;
};

// Adds a box that stands out of the panel by `high_m` towards the person. Its middle is at `x_m` and `z_m`.
void raise(PanelBuilder& to, FeatureId feature, double x_m, double z_m, double width_m, double height_m,
           double panel_y_m, double high_m, double turned_rad = 0.0) {
    to.add(feature, PrimitiveKind::Box, {x_m, panel_y_m - 0.5 * high_m, z_m}, {width_m, high_m, height_m},
           rotation_about({0.0, 1.0, 0.0}, turned_rad));
}

void shape(PanelBuilder& to, PlacedControl& control, double panel_y_m) {
    const FeatureId own = control.feature;
    const double x = control.x_m, z = control.z_m;
    const Rotation forward = rotation_about({1.0, 0.0, 0.0}, 0.5 * kPi);  // turns the axis of a cylinder from z to y
    double high = kButtonHighM;
    switch (control.kind) {
        case DeskKind::Button:
        case DeskKind::Assign:
            raise(to, own, x, z, control.width_m, control.height_m, panel_y_m, high);
            break;
        case DeskKind::Slider:
            high = kSliderHighM;
            raise(to, own, x, z, control.width_m, control.height_m, panel_y_m, high);
            for (int i = 0; i + 1 < control.positions; ++i)
                raise(to, own, 0.5 * (control.x_of(i) + control.x_of(i + 1)), z, kRidgeWideM, control.height_m,
                      panel_y_m, high + kRidgeHighM);
            break;
        case DeskKind::Knob: {
            high = kKnobHighM;
            const double radius = 0.5 * kControlM;
            to.add(own, PrimitiveKind::Cylinder, {x, panel_y_m - 0.5 * high, z}, {2.0 * radius, 2.0 * radius, high},
                   forward);
            to.add(own, PrimitiveKind::Cylinder, {x, panel_y_m - 0.5 * kKnobPostHighM, z},
                   {2.0 * kKnobPostM, 2.0 * kKnobPostM, kKnobPostHighM}, forward);
            for (int i = 0; i < kKnobDetents; ++i) {
                const double angle = 2.0 * kPi * (i + 0.5) / kKnobDetents, middle = 0.5 * (kKnobPostM + radius);
                // The ridge is a horizontal box that is rotated about y, so that it points along (cos, -sin) of the
                // angle.
                raise(to, own, x + middle * std::sin(angle), z + middle * std::cos(angle), radius - kKnobPostM,
                      kRidgeWideM, panel_y_m, high + kRidgeHighM, angle - 0.5 * kPi);
            }
            break;
        }
        case DeskKind::List:
            for (const double side : {-1.0, 1.0})
                raise(to, own, x, z + side * 0.25 * (control.height_m + kListGapM), control.width_m,
                      0.5 * (control.height_m - kListGapM), panel_y_m, high);
            break;
        case DeskKind::Indicator: {
            high = kDomeHighM;
            const double half = 0.5 * kControlM, radius = (half * half + high * high) / (2.0 * high);
            to.add(own, PrimitiveKind::Sphere, {x, panel_y_m - high + radius, z}, Vec3(2.0 * radius));
            break;
        }
    }
    control.face_y_m = panel_y_m - high;
}

}  // namespace

double PlacedControl::x_of(int position) const {
    const double half = 0.5 * width_m - kSliderEndM;
    return positions > 1 ? x_m - half + 2.0 * half * position / (positions - 1) : x_m;
}

double PlacedControl::position_at(double at_m) const {
    const double half = 0.5 * width_m - kSliderEndM;
    return positions > 1 ? std::clamp((at_m - x_m + half) / (2.0 * half), 0.0, 1.0) * (positions - 1) : 0.0;
}

const PlacedControl* DeskPanel::find(FeatureId feature) const {
    const auto found =
        std::find_if(placed.begin(), placed.end(), [&](const PlacedControl& one) { return one.feature == feature; });
    return found == placed.end() ? nullptr : &*found;
}

const PlacedControl* DeskPanel::of(std::size_t control) const {
    const auto found =
        std::find_if(placed.begin(), placed.end(), [&](const PlacedControl& one) { return one.control == control; });
    return found == placed.end() ? nullptr : &*found;
}

DeskGrid desk_grid(const device::DeviceSpec& spec) {
    const double reach = kMostReach * spec.workspace_radius_m,
                 most = std::sqrt(std::max(0.0, reach * reach - std::pow(kPanelAt * spec.workspace_radius_m, 2)));
    const auto half = [](int cells) { return 0.5 * (cells * kPitchM - kControlGapM); };
    DeskGrid best;
    for (int rows = 1; half(rows) < most; ++rows)
        for (int columns = 1; std::hypot(half(columns), half(rows)) <= most; ++columns)
            if (columns * rows >= best.columns * best.rows && columns >= rows) best = {columns, rows};
    return best;
}

std::vector<std::size_t> desk_pages(std::span<const DeskControl> controls, const DeskGrid& grid) {
    std::vector<std::size_t> pages;
    for (const Cell& cell : cells_of(controls, grid)) pages.push_back(cell.page);
    return pages;
}

DeskPanel lay_out_desk(std::span<const DeskControl> controls, const device::DeviceSpec& spec, std::size_t page) {
    const DeskGrid grid = desk_grid(spec);
    const std::vector<Cell> cells = cells_of(controls, grid);
    DeskPanel panel;
    panel.pages = cells.empty() ? 1 : cells.back().page + 1;
    panel.page = page % panel.pages;
    const double reach = spec.workspace_radius_m, panel_y = kPanelAt * reach;
    const double left = -0.5 * (grid.columns - 1) * kPitchM, top = 0.5 * (grid.rows - 1) * kPitchM;

    PanelBuilder builder;
    // A control keeps its feature on every page, because the hand still touches the previous page for a moment.
    const FeatureId desk = builder.feature("desk", FeatureKind::Wall),
                    turn = builder.feature(phrase("desk.next_page"), FeatureKind::Button);
    std::vector<FeatureId> features;
    for (const DeskControl& control : controls) features.push_back(builder.feature(control.name, FeatureKind::Button));
    builder.add(desk, PrimitiveKind::Box, {0.0, panel_y + 0.5 * kPanelThickM, 0.0},
                {4.0 * reach, kPanelThickM, 4.0 * reach});
    const auto place = [&](const std::optional<std::size_t>& control, DeskKind kind, int positions, const Cell& cell,
                           FeatureId feature) {
        PlacedControl one;
        one.control = control;
        one.kind = kind;
        one.positions = positions;
        one.width_m = cell.wide * kPitchM - kControlGapM;
        one.x_m = left + (cell.column + 0.5 * (cell.wide - 1)) * kPitchM;
        one.z_m = top - cell.row * kPitchM;
        one.feature = feature;
        shape(builder, one, panel_y);
        panel.placed.push_back(one);
    };
    for (std::size_t i = 0; i < controls.size(); ++i)
        if (cells[i].page == panel.page) place(i, controls[i].kind, controls[i].positions, cells[i], features[i]);
    if (panel.pages > 1)
        place(std::nullopt, DeskKind::Button, 0, {panel.page, grid.columns - 1, grid.rows - 1, 1}, turn);
    panel.scene = builder.take();
    panel.haptic = compile::compile_haptic(*panel.scene, compile::MaterialSource::KeysOnly);
    return panel;
}

}  // namespace handrail::core
