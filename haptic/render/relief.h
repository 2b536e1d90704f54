// Computes height and friction textures: small depths below a plain surface, felt as if the surface were really lower
// there. The proxy stays on the plain surface, and the depth h reduces the press. This gives a potential 1/2 K (pen -
// h)^2 with its gradient as force: K (pen - h) along the normal and K (pen - h) grad h along the surface. Without the
// second part a texture would give the hand energy (test: property_surfaces).
//
// The depth h is a function of the hand's own position, projected straight onto flat faces and, by angle, onto round
// ones. It thus has the same value at the hand as at the proxy's resting place, so its gradient needs no correction for
// depth. Plain data built at set-up. relief_at() is real-time safe: noexcept, no allocation, no library mathematics but
// floor and square root. Lengths with _hand_ in their name are hand travel. They are multiplied by the scale, so that a
// texture feels the same at every zoom.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "worlds/base/vec.h"

namespace handrail::render {

// The depths of a picture, from 0 (plain) to 1 (deepest), at several resolutions, each half of the one before. The
// values are coefficients of a cubic B-spline, so depth and slope change without a step. The largest differences bound
// the slope and curvature everywhere. The picture repeats in both directions.
class HeightField {
public:
    // Greatest width and height of a picture. Pictures with more samples are averaged, because a hand feels no finer
    // detail.
    static constexpr int kLargestSide = 1024;
    // `depths` has width * height values, row by row with the top row first. Width and height are at least 1.
    HeightField(int width, int height, std::span<const float> depths);

    struct Level {
        int width = 0, height = 0;
        double slope = 0.0, curvature = 0.0;  // upper bounds of slope and curvature, for depth 1 and picture width 1
        std::vector<float> depths;
    };
    struct Value {
        double depth = 0.0, along_u = 0.0, along_v = 0.0;  // the depth, and its slopes along u and v
    };
    const std::vector<Level>& levels() const noexcept { return levels_; }
    // Returns the value at a position: u to the right, v up, in picture widths from the lower left corner.
    Value at(const Level& level, double u, double v) const noexcept;
    double aspect() const noexcept { return aspect_; }  // height divided by width

private:
    std::vector<Level> levels_;
    double aspect_ = 1.0;
};

enum class ReliefKind : std::uint8_t {
    Level,    // no depth; only the friction may vary
    Sine,     // depth/2 (1 + sin): a sine wave along u
    Square,   // half of the period is plain, half deep; the flanks are as steep as kSteepest allows
    Picture,  // depths from a HeightField
};

struct Relief {
    // Steepest slope of a texture. With it, a step of 2 mm takes at least 10 mm of hand travel.
    static constexpr double kSteepest = 0.3;
    // Up to this force a texture raises the stiffness by at most half. A texture that would raise it more gets less
    // depth.
    static constexpr double kFullForce_n = 3.0;

    ReliefKind kind = ReliefKind::Level;
    double depth_hand_m = 0.0;    // greatest depth below the plain surface
    double period_hand_m = 0.01;  // period of sine, square and friction waves
    double friction_share = 0.0;  // m: along u the friction varies from 1 - m to 1 + m times that of the material
    double turn_cos = 1.0, turn_sin = 0.0;  // angle by which u is rotated towards v
    Vec3 low_m{0.0},
        // For pictures only. The picture's lower left corner is at the lower left corner of this box, as seen on each
        // face.
        high_m{0.0};
    double size_m = 1.0;  // width of one copy of the picture
    std::shared_ptr<const HeightField> picture;
};

// The two directions along which a texture is laid onto a face, seen from outside: on walls u to the right and v up, on
// floors u east and v north.
struct ReliefAxes {
    Vec3 u{1.0, 0.0, 0.0}, v{0.0, 1.0, 0.0};
};
ReliefAxes relief_axes(const Vec3& face_normal) noexcept;

struct ReliefValue {
    double depth_m = 0.0;         // depth below the plain surface, world metres, 0 or more
    Vec3 gradient{0.0};           // gradient of the depth
    double friction = 1.0;        // factor by which the friction is multiplied
    double swing_to_depth = 0.0;  // derivative of the depth with respect to `swing`
};

// Returns the texture at a place in the scene's coordinates. `stiffness_n_per_m` is that of the surface, per hand
// metre. `swing` is 1 for the whole wave and 0 for its mean depth.
ReliefValue relief_at(const Relief& relief, const ReliefAxes& axes, const Vec3& local_m, double world_m_per_hand_m,
                      double stiffness_n_per_m, double swing) noexcept;

// Fades the depth of a texture smoothly to zero towards the borders of its face, so that the face's edges stay where
// they are. The slope never exceeds kSteepest.
class ReliefBorder {
public:
    ReliefBorder(ReliefValue& value, double world_m_per_hand_m) noexcept
        : value_(value), start_m_(kStart_hand_m * world_m_per_hand_m) {}
    // Adds a border at this distance. `away` is a unit vector in the face that points away from the border.
    void add(double distance_m, const Vec3& away) noexcept;
    void apply() noexcept;  // call it after the last border

private:
    // Distance from a border over which the slope rises to its full value.
    static constexpr double kStart_hand_m = 1e-3;
    ReliefValue& value_;
    double start_m_;
    bool outside_ = false;
    double sum_ = 1.0;  // sum of 4th powers of the ratio of depth to bound; the depth itself counts as 1
    Vec3 gradient_{0.0};
};

}  // namespace handrail::render
