// Builds the touchable panel of the desk, which is upright in front of the person and carries the controls. The panel
// is a Scene that is compiled like any world. Each kind of control has its own shape, and each position of a slider or
// knob is between two ridges. If there are too many controls, the panel has several pages, and the last place of each
// page is a button that turns the pages. Coordinates are in the device frame in hand metres: x right, y away from the
// person, z up. Pure functions for the app thread.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "app/core/desk/desk.h"
#include "haptic/device/device_spec.h"
#include "haptic/render/haptic_scene.h"
#include "worlds/scene/scene.h"

namespace handrail::core {

inline constexpr double kControlM = 0.013;      // least width and height of a control
inline constexpr double kControlGapM = 0.0064;  // free space between two controls
inline constexpr double kDeskProxyM = 0.002;    // radius of the proxy at the desk, as in servo_tick
inline constexpr int kKnobDetents = 12;         // detents per whole turn of the knob

// A control on the panel.
struct PlacedControl {
    // Index of the control in the desk; none: this is the button that turns the pages.
    std::optional<std::size_t> control;
    FeatureId feature;  // feature of the control in the panel's scene
    DeskKind kind = DeskKind::Button;
    int positions = 0;
    double x_m = 0.0, z_m = 0.0;  // coordinates of the control's middle
    double width_m = kControlM, height_m = kControlM;
    double face_y_m = 0.0;  // coordinate of the control's front

    // Both are for a slider. x_of() returns the x coordinate of a position. position_at() returns the position at an x
    // coordinate, as a fraction between two positions.
    double x_of(int position) const;
    double position_at(double x_m) const;
    // Returns the centre of the proxy when the proxy touches the front of the control, with this offset from the
    // control's middle.
    Vec3 touch_m(double across_m = 0.0, double up_m = 0.0) const {
        return {x_m + across_m, face_y_m - kDeskProxyM, z_m + up_m};
    }
};

struct DeskPanel {
    std::shared_ptr<const Scene> scene;
    std::shared_ptr<const render::HapticScene> haptic;
    std::vector<PlacedControl> placed;
    std::size_t page = 0, pages = 1;

    const PlacedControl* find(FeatureId feature) const;
    const PlacedControl* of(std::size_t control) const;  // null: the control is on another page
};

// The number of columns and rows that fit into the workspace of a device.
struct DeskGrid {
    int columns = 1, rows = 1;
};
DeskGrid desk_grid(const device::DeviceSpec& spec);
// Returns the page of each control.
std::vector<std::size_t> desk_pages(std::span<const DeskControl> controls, const DeskGrid& grid);
// Builds one page of the panel. If `page` is beyond the last page, counting continues at the first page.
DeskPanel lay_out_desk(std::span<const DeskControl> controls, const device::DeviceSpec& spec, std::size_t page);

}  // namespace handrail::core
