#include "app/main/left_hand.h"

#include <fmt/format.h>

#include <utility>

#include "haptic/device/simulated_device.h"
#include "worlds/base/language.h"

namespace handrail::program {
namespace {

constexpr double kPeriod_s = 1e-3;

void move_into(std::vector<std::string>& all, std::vector<std::string> more) {
    for (std::string& sentence : more) all.push_back(std::move(sentence));
}

}  // namespace

void LeftHand::look_for(const std::string& wanted) {
    if (wanted == "none") return;
    simulated_ = hand_without_looking(wanted);
    if (!simulated_) search_.emplace(wanted);
}

bool LeftHand::take_change(std::vector<std::string>& news) {
    if (guarded_) move_into(news, guarded_->take_news());
    if (simulated_) return use(std::exchange(simulated_, std::nullopt)->facts, nullptr, news);
    if (!search_) return false;
    const bool ready = search_->ready();
    move_into(news, search_->take_news());
    if (!ready) return false;
    auto found = search_->take();
    search_.reset();
    if (!found) {
        news.push_back(phrase("program.for_left_hand", {{"problem", found.error().sentence()}}));
        return false;
    }
    return found->device && use(found->facts, std::move(found->device), news);
}

bool LeftHand::use(const core::HandFacts& facts, std::unique_ptr<drivers::GuardedDevice> device,
                   std::vector<std::string>& news) {
    guarded_ = device.get();
    std::unique_ptr<device::HapticDevice> held = std::move(device);
    if (facts.simulated)
        held = std::make_unique<device::SimulatedDevice>(facts.spec, std::make_shared<device::SimulatedHand>());
    servo_ = std::make_unique<servo::ServoLoop>(std::move(held), clock_, kPeriod_s,
                                                servo::ServoLoop::Links{&switches_, &contacts_, recording_});
    if (const auto opened = servo_->open(); !opened) {
        news.push_back(phrase("program.for_left_hand", {{"problem", opened.error().sentence()}}));
        guarded_ = nullptr;
        servo_.reset();
        return false;
    }
    facts_ = facts;
    servo_->start();
    news.push_back(phrase("program.in_left_hand", {{"device", facts_.spec.spoken_name()}}));
    return true;
}

const servo::ToolState& LeftHand::tool() { return servo_ ? servo_->tool() : none_; }

void LeftHand::stop() {
    search_.reset();
    if (servo_) servo_->stop();
}

}  // namespace handrail::program
