#include "audio-cues/sinks/voice_channel.h"

#include <utility>

namespace handrail::sinks {

VoiceChannel::Ticket VoiceChannel::begin(int rate_hz, double gain, std::optional<double> right_rad) {
    const std::lock_guard lock(mutex_);
    now_ = {.ticket = now_.ticket + 1,
            .rate_hz = rate_hz,
            .gain = gain,
            .right_rad = right_rad,
            .samples = {},
            .ended = false};
    return now_.ticket;
}

bool VoiceChannel::append(Ticket ticket, std::span<const std::int16_t> samples) {
    const std::lock_guard lock(mutex_);
    if (ticket != now_.ticket) return false;
    now_.samples.insert(now_.samples.end(), samples.begin(), samples.end());
    return true;
}

bool VoiceChannel::cut(Ticket ticket) const {
    const std::lock_guard lock(mutex_);
    return ticket != now_.ticket;
}

void VoiceChannel::end(Ticket ticket) {
    const std::lock_guard lock(mutex_);
    if (ticket == now_.ticket) now_.ended = true;
}

void VoiceChannel::stop() {
    const std::lock_guard lock(mutex_);
    now_ = {
        .ticket = now_.ticket + 1, .rate_hz = now_.rate_hz, .gain = 0.0, .right_rad = {}, .samples = {}, .ended = true};
    finished_ = now_.ticket;
}

bool VoiceChannel::playing() const {
    const std::lock_guard lock(mutex_);
    return finished_ < now_.ticket;
}

VoiceChannel::Update VoiceChannel::take() {
    const std::lock_guard lock(mutex_);
    Update update{.ticket = now_.ticket,
                  .rate_hz = now_.rate_hz,
                  .gain = now_.gain,
                  .right_rad = now_.right_rad,
                  .samples = {},
                  .ended = now_.ended};
    update.samples.swap(now_.samples);
    return update;
}

void VoiceChannel::finished(Ticket ticket) {
    const std::lock_guard lock(mutex_);
    if (ticket > finished_) finished_ = ticket;
}

}  // namespace handrail::sinks
