#include "app/core/wayfinding/arrival.h"

#include <utility>

#include "app/core/wayfinding/finding.h"

namespace handrail::core {
namespace {

cues::SpeechTopic topic_of(const Arrival::How& how) {
    return how.room ? cues::SpeechTopic::Place : cues::SpeechTopic::Arrival;
}

}  // namespace

void Arrival::tell(std::string text, const How& how, double now_s) {
    context_.announce(topic_of(how), text, now_s, {.anew = true, .answers = how.answers});
    last_ = Last{std::move(text), how, context_.avatar.feet_m()};
}

bool Arrival::announce_anew(cues::SpeechTopic topic, bool led, double now_s) {
    if (!last_ || topic_of(last_->how) != topic || last_->how.led != led ||
        glm::length(context_.avatar.feet_m() - last_->feet_m) > Beacon::kArrived_m)
        return false;
    context_.announce(topic, last_->text, now_s, {.anew = true, .answers = last_->how.answers});
    return true;
}

}  // namespace handrail::core
