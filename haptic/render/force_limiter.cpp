#include "haptic/render/force_limiter.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "haptic/render/tick_assert.h"

namespace handrail::render {

Vec3 ForceLimiter::limit(const Vec3& wanted_n, double ceiling_n, ForceFlow flow, double dt_s, double fade_s) noexcept {
    tick_assert(dt_s >= 0.0 && fade_s > 0.0);
    broken_ = !is_finite(wanted_n);
    if (broken_) flow = ForceFlow::Cut;

    switch (flow) {
        case ForceFlow::Run:
            gain_ = std::min(1.0, gain_ + dt_s / kRampS);
            break;
        case ForceFlow::Fade:
            gain_ = std::max(0.0, gain_ - dt_s / fade_s);
            break;
        case ForceFlow::Cut:
            gain_ = 0.0;
            break;
    }
    dropout_gain_ = dropped_ ? 0.0 : std::min(1.0, dropout_gain_ + dt_s / kDropoutReturnS);
    dropped_ = false;
    const double gain = gain_ * dropout_gain_;
    if (!(gain > 0.0) || !(ceiling_n > 0.0)) {
        resume_offset_n_ = 0.0;
        resume_pending_ = false;
        last_n_ = Vec3(0.0);
        return last_n_;
    }

    // Divided by the largest component first, so that squaring a force near the largest double does not overflow.
    const double largest = std::max({std::abs(wanted_n.x), std::abs(wanted_n.y), std::abs(wanted_n.z)});
    if (!(largest > 0.0)) {
        resume_pending_ = false;
        resume_offset_n_ = 0.0;
        last_n_ = Vec3(0.0);
        return last_n_;
    }
    const Vec3 scaled = wanted_n / largest;
    const double scaled_length = std::sqrt(glm::dot(scaled, scaled));
    const Vec3 direction = scaled / scaled_length;
    const double wanted_length = std::min(largest * scaled_length, std::numeric_limits<double>::max());
    const double allowed = std::min(wanted_length, ceiling_n) * gain;

    if (resume_pending_) {
        resume_offset_n_ = std::max(0.0, allowed - std::max(0.0, glm::dot(last_n_, direction)));
        resume_pending_ = false;
    } else {
        resume_offset_n_ *= kResumeDecayS / (kResumeDecayS + dt_s);
        if (resume_offset_n_ < 1e-6) resume_offset_n_ = 0.0;  // 1e-6 N is far below one step of the motor's force
    }
    // A force that needs no change passes bit-identical. Splitting it into length and direction would round it.
    const bool untouched = resume_offset_n_ == 0.0 && gain == 1.0 && wanted_length <= ceiling_n;
    last_n_ = untouched ? wanted_n : direction * std::max(0.0, allowed - resume_offset_n_);
    tick_assert(gain_ >= 0.0 && gain_ <= 1.0 && resume_offset_n_ >= 0.0);
    tick_assert(is_finite(last_n_) && std::hypot(last_n_.x, last_n_.y, last_n_.z) <= ceiling_n * (1.0 + 1e-9));
    return last_n_;
}

void ForceLimiter::drop_out() noexcept { dropped_ = true; }

}  // namespace handrail::render
