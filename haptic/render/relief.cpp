#include "haptic/render/relief.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "haptic/render/tick_assert.h"

namespace handrail::render {
namespace {

// Averages one row of samples to a new length; each new sample covers an equal part of the old row.
void average_row(std::span<const float> from, std::span<float> to) {
    const double ratio = static_cast<double>(from.size()) / static_cast<double>(to.size());
    for (std::size_t i = 0; i < to.size(); ++i) {
        const double begin = static_cast<double>(i) * ratio, end = begin + ratio;
        double sum = 0.0;
        for (auto k = static_cast<std::size_t>(begin); k < from.size() && static_cast<double>(k) < end; ++k)
            sum += static_cast<double>(from[k]) *
                   (std::min(end, static_cast<double>(k + 1)) - std::max(begin, static_cast<double>(k)));
        to[i] = static_cast<float>(sum / ratio);
    }
}

HeightField::Level averaged(const HeightField::Level& fine, int width, int height) {
    HeightField::Level coarse;
    coarse.width = width;
    coarse.height = height;
    const auto w = static_cast<std::size_t>(width), h = static_cast<std::size_t>(height),
               fine_w = static_cast<std::size_t>(fine.width), fine_h = static_cast<std::size_t>(fine.height);
    std::vector<float> narrow(w * fine_h);
    for (std::size_t row = 0; row < fine_h; ++row)
        average_row(std::span(fine.depths).subspan(row * fine_w, fine_w), std::span(narrow).subspan(row * w, w));
    coarse.depths.resize(w * h);
    std::vector<float> column(fine_h), shorter(h);
    for (std::size_t x = 0; x < w; ++x) {
        for (std::size_t row = 0; row < fine_h; ++row) column[row] = narrow[row * w + x];
        average_row(column, shorter);
        for (std::size_t row = 0; row < h; ++row) coarse.depths[row * w + x] = shorter[row];
    }
    return coarse;
}

// Computes the largest first and second differences. They bound the spline's slopes and curvatures, because a
// B-spline's derivatives are averages of the differences of its coefficients.
void bound(HeightField::Level& level, double aspect) {
    const int w = level.width, h = level.height;
    const auto at = [&](int x, int y) {
        return static_cast<double>(level.depths[static_cast<std::size_t>((y + h) % h) * static_cast<std::size_t>(w) +
                                                static_cast<std::size_t>((x + w) % w)]);
    };
    double u = 0.0, v = 0.0, uu = 0.0, vv = 0.0, uv = 0.0;
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x) {
            const double here = at(x, y), right = at(x + 1, y), below = at(x, y + 1);
            u = std::max(u, std::abs(right - here));
            v = std::max(v, std::abs(below - here));
            uu = std::max(uu, std::abs(right - 2.0 * here + at(x - 1, y)));
            vv = std::max(vv, std::abs(below - 2.0 * here + at(x, y - 1)));
            uv = std::max(uv, std::abs(at(x + 1, y + 1) - right - below + here));
        }
    const double per_u = w, per_v = h / aspect;
    level.slope = std::sqrt(u * u * per_u * per_u + v * v * per_v * per_v);
    level.curvature = std::max(uu * per_u * per_u, vv * per_v * per_v) + uv * per_u * per_v;
}

// smooth_step() and its slope for arguments that are already between 0 and 1, without clamping.
double flank_step(double x) noexcept { return x * x * (3.0 - 2.0 * x); }
double flank_step_slope(double x) noexcept { return 6.0 * x * (1.0 - x); }

// The value of a wave with period 1 and values between 0 and 1, and its slope.
struct Wave {
    double value, slope;
};

// (1 + sin(2 pi p)) / 2, approximated by an odd polynomial to within 2e-5. Its value, slope and curvature at the crest
// are exact, so the wave has no kink.
Wave sine_wave(double p) noexcept {
    double x = p - std::floor(p + 0.5), sense = 1.0;
    if (x > 0.25) {
        x = 0.5 - x;
        sense = -1.0;
    } else if (x < -0.25) {
        x = -0.5 - x;
        sense = -1.0;
    }
    const double y = 4.0 * x, y2 = y * y;
    const double sine =
        y * (1.5707963267948966 + y2 * (-0.6458141179187324 + y2 * (0.0792392554527749 + y2 * -0.0042214643289391)));
    const double slope =
        1.5707963267948966 + y2 * (-1.9374423537561972 + y2 * (0.3961962772638745 + y2 * -0.0295502503025737));
    return {0.5 + 0.5 * sine, 2.0 * sense * slope};
}

// A square wave: 0 in the first half of the period, 1 in the second. `flank` is the width of each flank as a share of
// the period.
Wave square_wave(double p, double flank) noexcept {
    const double x = p - std::floor(p);
    const bool second = x >= 0.5;
    const double t = ((second ? x - 0.5 : x) - 0.25) / flank + 0.5;
    if (t <= 0.0) return {second ? 1.0 : 0.0, 0.0};
    if (t >= 1.0) return {second ? 0.0 : 1.0, 0.0};
    const double value = flank_step(t), slope = flank_step_slope(t) / flank;
    return second ? Wave{1.0 - value, -slope} : Wave{value, slope};
}

// Returns the lowest coordinate of the relief's box along a direction.
double least(const Vec3& along, const Relief& relief) noexcept {
    const Vec3 a = along * relief.low_m, b = along * relief.high_m;
    return std::min(a.x, b.x) + std::min(a.y, b.y) + std::min(a.z, b.z);
}

constexpr double kTwoPi = 2.0 * kPi;
constexpr double kAtBorder_m = 1e-9;  // greatest distance from a border at which a point is treated as on the border

}  // namespace

HeightField::HeightField(int width, int height, std::span<const float> depths) {
    aspect_ = static_cast<double>(height) / width;
    Level level;
    level.width = width;
    level.height = height;
    level.depths.assign(depths.begin(), depths.end());
    const auto smaller = [](int side) { return std::max(1, (side + 1) / 2); };
    while (std::max(level.width, level.height) > kLargestSide)
        level = averaged(level, smaller(level.width), smaller(level.height));
    while (true) {
        bound(level, aspect_);
        levels_.push_back(std::move(level));
        const Level& last = levels_.back();
        if (last.width == 1 && last.height == 1) break;
        level = averaged(last, smaller(last.width), smaller(last.height));
    }
}

HeightField::Value HeightField::at(const Level& level, double u, double v) const noexcept {
    // The centre of a sample is half a sample inside the border. Rows run downwards.
    const double x = u * level.width - 0.5, y = (1.0 - v / aspect_) * level.height - 0.5;
    const double fx = std::floor(x), fy = std::floor(y);
    const auto weights = [](double t, std::array<double, 4>& w, std::array<double, 4>& d) {
        const double s = 1.0 - t, t2 = t * t;
        w = {s * s * s / 6.0, (4.0 - 6.0 * t2 + 3.0 * t2 * t) / 6.0, (4.0 - 6.0 * s * s + 3.0 * s * s * s) / 6.0,
             t2 * t / 6.0};
        d = {-0.5 * s * s, t * (1.5 * t - 2.0), -s * (1.5 * s - 2.0), 0.5 * t2};
    };
    std::array<double, 4> wx, dx, wy, dy;
    weights(x - fx, wx, dx);
    weights(y - fy, wy, dy);
    const auto wrapped = [](double first, int k, int size) {
        const double index = first + k;
        return static_cast<std::size_t>(index - std::floor(index / size) * size);
    };
    Value value;
    std::array<std::size_t, 4> columns;
    for (int k = 0; k < 4; ++k) columns[static_cast<std::size_t>(k)] = wrapped(fx, k - 1, level.width);
    for (int row = 0; row < 4; ++row) {
        const auto r = static_cast<std::size_t>(row);
        const float* samples =
            level.depths.data() + wrapped(fy, row - 1, level.height) * static_cast<std::size_t>(level.width);
        double sum = 0.0, slope = 0.0;
        for (std::size_t k = 0; k < 4; ++k) {
            const double sample = static_cast<double>(samples[columns[k]]);
            sum += wx[k] * sample;
            slope += dx[k] * sample;
        }
        value.depth += wy[r] * sum;
        value.along_u += wy[r] * slope;
        value.along_v += dy[r] * sum;
    }
    value.along_u *= level.width;
    value.along_v *= -level.height / aspect_;
    return value;
}

ReliefAxes relief_axes(const Vec3& n) noexcept {
    // On walls, u points to the right as seen from outside. On faces that are more horizontal than vertical, u points
    // east.
    Vec3 u = std::abs(n.z) < 0.8 ? Vec3(-n.y, n.x, 0.0) : Vec3(1.0, 0.0, 0.0) - n * n.x;
    u /= std::sqrt(glm::dot(u, u));
    return {u, glm::cross(n, u)};
}

ReliefValue relief_at(const Relief& relief, const ReliefAxes& axes, const Vec3& local_m, double scale, double stiffness,
                      double swing) noexcept {
    tick_assert(scale > 0.0 && stiffness >= 0.0 && swing >= 0.0 && swing <= 1.0);
    ReliefValue out;
    const Vec3 along_u = axes.u * relief.turn_cos + axes.v * relief.turn_sin;
    const double period_m = relief.period_hand_m * scale;
    const double phase = glm::dot(along_u, local_m) / period_m;
    if (relief.friction_share > 0.0) {
        const Wave wave = relief.kind == ReliefKind::Square ? square_wave(phase, 0.5) : sine_wave(phase);
        out.friction = 1.0 + relief.friction_share * (2.0 * wave.value - 1.0);
    }
    // Curvature that a texture may have, in 1 per hand metre, so that it raises the stiffness by at most half.
    const double bend = 0.5 * stiffness / Relief::kFullForce_n;
    double depth = relief.depth_hand_m;
    switch (relief.kind) {
        case ReliefKind::Level:
            return out;
        case ReliefKind::Sine:
        case ReliefKind::Square: {
            const double period = relief.period_hand_m;
            Wave wave{};
            if (relief.kind == ReliefKind::Sine) {
                const double turn = kTwoPi / period;
                depth = std::min({depth, 2.0 * Relief::kSteepest / turn, 2.0 * bend / (turn * turn)});
                wave = sine_wave(phase);
            } else {
                // A smooth step over the width w has a slope of at most 1.5 / w and a curvature of at most 6 / w^2.
                const double flank = std::min(
                    0.5 * period,
                    std::max(1.5 * depth / Relief::kSteepest, bend > 0.0 ? std::sqrt(6.0 * depth / bend) : period));
                depth = std::min({depth, flank * Relief::kSteepest / 1.5, bend * flank * flank / 6.0});
                wave = square_wave(phase, std::max(flank / period, 1e-6));
            }
            const double depth_m = depth * scale;
            out.depth_m = depth_m * (0.5 + swing * (wave.value - 0.5));
            out.gradient = along_u * (depth_m * swing * wave.slope / period_m);
            out.swing_to_depth = depth_m * (wave.value - 0.5);
            tick_assert(out.depth_m >= 0.0 && glm::length(out.gradient) <= Relief::kSteepest * (1.0 + 1e-9));
            return out;
        }
        case ReliefKind::Picture: {
            const HeightField& field = *relief.picture;
            const double size_hand = relief.size_m / scale;
            const HeightField::Level* level = &field.levels().back();
            for (const HeightField::Level& finer : field.levels())
                if (depth * finer.slope <= Relief::kSteepest * size_hand &&
                    depth * finer.curvature <= bend * size_hand * size_hand) {
                    level = &finer;
                    break;
                }
            const Vec3 along_v = axes.v * relief.turn_cos - axes.u * relief.turn_sin;
            const HeightField::Value value =
                field.at(*level, (glm::dot(along_u, local_m) - least(along_u, relief)) / relief.size_m,
                         (glm::dot(along_v, local_m) - least(along_v, relief)) / relief.size_m);
            const double depth_m = depth * scale;
            out.depth_m = depth_m * value.depth;
            out.gradient = (along_u * value.along_u + along_v * value.along_v) * (depth_m / relief.size_m);
            return out;
        }
    }
    return out;
}

// Bound for the depth at distance d from a border: b(d) = 0.3 d^2 / (d + start). The bound is flat at the border and
// has a slope of 0.3 further in.
void ReliefBorder::add(double distance_m, const Vec3& away) noexcept {
    if (distance_m <= kAtBorder_m || value_.depth_m <= 0.0) {
        outside_ = true;
        return;
    }
    const double sum = distance_m + start_m_;
    const double bound = Relief::kSteepest * distance_m * distance_m / sum;
    const double slope = Relief::kSteepest * distance_m * (distance_m + 2.0 * start_m_) / (sum * sum);
    const double ratio = value_.depth_m / bound, fourth = ratio * ratio * ratio * ratio;
    sum_ += fourth;
    gradient_ += away * (slope * fourth * ratio);
}

// Combines the depth and the bounds by a smooth minimum, (sum of their -4th powers)^(-1/4). Its gradient mixes their
// gradients with weights whose sum never exceeds 1, so the depth never becomes steeper.
void ReliefBorder::apply() noexcept {
    if (outside_) {
        value_.depth_m = value_.swing_to_depth = 0.0;
        value_.gradient = Vec3(0.0);
        return;
    }
    // The weight of the depth itself is (result / depth)^5.
    const double shrunk = 1.0 / std::sqrt(std::sqrt(sum_)), weight = shrunk / sum_;
    value_.depth_m *= shrunk;
    value_.gradient = (value_.gradient + gradient_) * weight;
    value_.swing_to_depth *= weight;
}

}  // namespace handrail::render
