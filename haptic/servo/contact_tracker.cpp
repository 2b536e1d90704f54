#include "haptic/servo/contact_tracker.h"

#include <algorithm>
#include <cmath>

#include "haptic/servo/vectors.h"

namespace handrail::servo {
namespace {

constexpr double kSlidePoleS = 0.005;

}  // namespace

void ContactTracker::end(std::size_t index, double now_s, TickEvents& events) noexcept {
    const Held& held = held_[index];
    events.push({ContactEventKind::End, now_s, held.feature, held.material, held.position_m, 0.0, 0.0, Fault::None});
    for (std::size_t i = index + 1; i < count_; ++i) held_[i - 1] = held_[i];
    --count_;
}

void ContactTracker::update(const render::TouchResult& touch, const Vec3& velocity_m_per_s, double world_m_per_hand_m,
                            double now_s, double dt_s, TickEvents& events) noexcept {
    // A soft surface is added to the contacts, as a hard one is.
    const double contact_n = length(touch.contact_force_n), soft_n = length(touch.soft_force_n);
    std::array<render::Contact, 4> felt;
    std::size_t count = 0;
    for (; count < touch.contacts.count; ++count) felt[count] = touch.contacts.contacts[count];
    const std::size_t hard = count;
    const auto same = [&](const render::Contact& contact) {
        return contact.feature == touch.soft;
    };  // true for a soft patch whose hard floor is touched too
    if (soft_n > 0.0 && std::none_of(felt.begin(), felt.begin() + hard, same))
        felt[count++] = {touch.soft, touch.soft_material, touch.soft_force_n / soft_n, 1.0};
    for (std::size_t i = 0; i < count; ++i) {
        const render::Contact& contact = felt[i];
        const double force_n = i < hard ? contact_n : soft_n;
        std::size_t index = 0;
        while (index < count_ &&
               !(held_[index].feature == contact.feature && held_[index].material == contact.material))
            ++index;
        if (index == count_) {
            if (count_ == held_.size()) {
                std::size_t oldest = 0;
                for (std::size_t k = 1; k < count_; ++k)
                    if (held_[k].seen_s < held_[oldest].seen_s) oldest = k;
                end(oldest, now_s, events);
            }
            index = count_++;
            held_[index] = {contact.feature, contact.material, touch.proxy_m, now_s, now_s, 0.0, false};
            const double approach = std::max(0.0, -glm::dot(velocity_m_per_s, contact.normal));
            events.push({ContactEventKind::Begin, now_s, contact.feature, contact.material, touch.proxy_m, approach,
                         force_n * contact.share, Fault::None});
        }
        Held& held = held_[index];
        held.seen_s = now_s;
        held.position_m = touch.proxy_m;
        const Vec3 along = touch.slide_m - contact.normal * glm::dot(touch.slide_m, contact.normal);
        const double speed = length(along) / (world_m_per_hand_m * dt_s);
        held.slide_m_per_s += (speed - held.slide_m_per_s) * (dt_s / (kSlidePoleS + dt_s));
        if (held.sliding && held.slide_m_per_s < kSlideStopsMPerS) {
            held.sliding = false;
            events.push({ContactEventKind::Slide, now_s, held.feature, held.material, touch.proxy_m, 0.0,
                         force_n * contact.share, Fault::None});
        } else if (held.slide_m_per_s > (held.sliding ? kSlideStopsMPerS : kSlideStartsMPerS) &&
                   now_s - held.reported_s >= kSlideEveryS - 1e-6) {
            held.sliding = true;
            held.reported_s = now_s;
            events.push({ContactEventKind::Slide, now_s, held.feature, held.material, touch.proxy_m, held.slide_m_per_s,
                         force_n * contact.share, Fault::None});
        }
    }
    for (std::size_t i = count_; i-- > 0;)
        if (now_s - held_[i].seen_s > kLetGoS) end(i, now_s, events);

    if (touch.liquid == liquid_) {
        liquid_seen_s_ = now_s;
        liquid_position_m_ = touch.proxy_m;
    } else if (!liquid_ || now_s - liquid_seen_s_ > kLetGoS) {
        const double speed = length(velocity_m_per_s);
        if (liquid_)
            events.push({ContactEventKind::LeaveLiquid, now_s, liquid_, kDefaultMaterial, touch.proxy_m, speed, 0.0,
                         Fault::None});
        liquid_ = touch.liquid;
        liquid_seen_s_ = now_s;
        liquid_position_m_ = touch.proxy_m;
        if (liquid_)
            events.push({ContactEventKind::EnterLiquid, now_s, liquid_, kDefaultMaterial, touch.proxy_m, speed, 0.0,
                         Fault::None});
    }
}

void ContactTracker::clear(double now_s, TickEvents& events) noexcept {
    while (count_ > 0) end(count_ - 1, now_s, events);
    if (liquid_)
        events.push({ContactEventKind::LeaveLiquid, now_s, liquid_, kDefaultMaterial, liquid_position_m_, 0.0, 0.0,
                     Fault::None});
    liquid_ = kNoFeature;
}

}  // namespace handrail::servo
