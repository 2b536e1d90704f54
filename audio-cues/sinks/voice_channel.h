// Carries a voice's samples to the sound sink: the synthesiser puts samples in, and OpenALSink takes them out on its
// own thread. One voice at a time: a new utterance cuts the one before. Any thread; each call holds a mutex for
// microseconds.
#pragma once

#include <cstdint>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

namespace handrail::sinks {

class VoiceChannel {
public:
    using Ticket = std::uint64_t;  // identifies an utterance; later ones are larger

    // The voice's side. Samples may come in pieces while the first already sound; `end` says there are no more.
    // right_rad: it comes from there, to the right of ahead; none: from the middle.
    Ticket begin(int rate_hz, double gain, std::optional<double> right_rad = {});
    bool append(Ticket ticket, std::span<const std::int16_t> samples);  // false when that utterance has been cut
    bool cut(Ticket ticket) const;                                      // another one has begun, or stop()
    void end(Ticket ticket);
    void stop();
    bool playing() const;  // from begin() until the sink has played the last sample, or stop()

    // For the sink: the samples since the last call. A new ticket means that the previous utterance was cut.
    struct Update {
        Ticket ticket = 0;
        int rate_hz = 0;
        double gain = 1.0;
        std::optional<double> right_rad = {};
        std::vector<std::int16_t> samples;
        bool ended = false;
    };
    Update take();
    void finished(Ticket ticket);

private:
    mutable std::mutex mutex_;  // protects all members below
    Update now_;
    Ticket finished_ = 0;
};

}  // namespace handrail::sinks
