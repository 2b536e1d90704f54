#include "app/core/scenario/log_measures.h"

#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <utility>
#include <variant>

#include "worlds/base/contract.h"
#include "worlds/scene/primitive.h"

namespace handrail::core {
namespace {

std::vector<std::string> words_of(const std::string& text) {
    std::vector<std::string> words;
    std::string word;
    const auto flush = [&] {
        if (!word.empty()) words.push_back(std::exchange(word, {}));
    };
    for (const char c : text) {
        const unsigned char u = static_cast<unsigned char>(c);
        if (std::isalnum(u) || u >= 128 || c == '-') word += static_cast<char>(std::tolower(u));
        else flush();
    }
    flush();
    return words;
}

}  // namespace

bool words_in_order(const std::string& wanted, const std::string& line) {
    const auto want = words_of(wanted), have = words_of(line);
    std::size_t next = 0;
    for (const std::string& word : have)
        if (next < want.size() && word == want[next]) ++next;
    return next == want.size();
}

double overlap_m(const Scene& scene, const Vec3& centre_m, double radius_m) {
    double deepest = 0.0;
    for (const Solid& solid : scene.solids) {
        if (solid.role != SolidRole::Solid && solid.role != SolidRole::Mover) continue;
        const Aabb& box = solid.shape.bounds_m;
        if (glm::any(glm::lessThan(centre_m, box.min_m - radius_m)) ||
            glm::any(glm::greaterThan(centre_m, box.max_m + radius_m)))
            continue;
        if (!std::holds_alternative<std::monostate>(solid.round)) {
            deepest = std::max(deepest, radius_m - signed_distance(solid.round, centre_m));
            continue;
        }
        // Computes the distance from `centre_m` to the convex solid by alternating projection onto the violated planes
        // (Dykstra). This is slow but simple.
        double outside = -std::numeric_limits<double>::infinity();
        for (const Plane& plane : solid.shape.planes) outside = std::max(outside, signed_distance(plane, centre_m));
        if (outside <= 0.0) {
            deepest = std::max(deepest, radius_m - outside);
            continue;
        }
        if (outside >= radius_m) continue;
        std::vector<Vec3> correction(solid.shape.planes.size(), Vec3(0.0));
        Vec3 x = centre_m;
        for (int round = 0; round < 200; ++round)
            for (std::size_t i = 0; i < solid.shape.planes.size(); ++i) {
                const Vec3 y = x + correction[i];
                const Vec3 projected =
                    y - solid.shape.planes[i].normal * std::max(0.0, signed_distance(solid.shape.planes[i], y));
                correction[i] = y - projected;
                x = projected;
            }
        deepest = std::max(deepest, radius_m - glm::length(x - centre_m));
    }
    return deepest;
}

double line_amplitude(const std::vector<double>& samples, double dt_s, double from_hz, double to_hz) {
    contract_pre(dt_s > 0.0);
    contract_pre(from_hz >= 0.0 && from_hz <= to_hz);
    const std::size_t n = samples.size();
    if (n < 16) return 0.0;
    // Subtract the least-squares straight line, and apply a Hann window.
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const double x = static_cast<double>(i);
        sx += x, sy += samples[i], sxx += x * x, sxy += x * samples[i];
    }
    const double count = static_cast<double>(n);
    const double slope = (count * sxy - sx * sy) / (count * sxx - sx * sx), offset = (sy - slope * sx) / count;
    std::vector<double> windowed(n);
    for (std::size_t i = 0; i < n; ++i) {
        const double hann = 0.5 - 0.5 * std::cos(2.0 * kPi * static_cast<double>(i) / (count - 1.0));
        windowed[i] = (samples[i] - offset - slope * static_cast<double>(i)) * hann;
    }
    const double spacing_hz = 1.0 / (count * dt_s);
    double worst = 0.0;
    for (double hz = from_hz; hz <= to_hz + 1e-9; hz += spacing_hz) {
        // Goertzel's recurrence computes the amplitude at one frequency in one pass.
        const double w = 2.0 * kPi * hz * dt_s, k = 2.0 * std::cos(w);
        double s1 = 0.0, s2 = 0.0;
        for (const double v : windowed) {
            const double s0 = v + k * s1 - s2;
            s2 = s1;
            s1 = s0;
        }
        const double power = s1 * s1 + s2 * s2 - k * s1 * s2;
        worst = std::max(worst, 4.0 * std::sqrt(std::max(0.0, power)) / count);
    }
    return worst;
}

}  // namespace handrail::core
