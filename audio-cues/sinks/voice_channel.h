// Carries a voice's samples to the sound sink. The synthesiser puts samples in, and OpenALSink takes them out on its
// own thread. It carries one utterance at a time: a new one cuts off the last one. Any thread; each call holds a mutex
// for microseconds.
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

    // Functions for the voice. Samples may come in pieces while the first ones already sound; `end` says that there are
    // no more. `right_rad` is the direction from which the voice comes, to the right of straight ahead; nothing: the
    // middle.
    Ticket begin(int rate_hz, double gain, std::optional<double> right_rad = {});
    // Returns false if this utterance has been cut off.
    bool append(Ticket ticket, std::span<const std::int16_t> samples);
    bool cut(Ticket ticket) const;  // true if another utterance has begun, or stop() was called
    void end(Ticket ticket);
    void stop();
    bool playing() const;  // true from begin() until the sink has played the last sample or stop() was called

    // Data for the sink: the samples since the last call. A new ticket means that the last utterance was cut off.
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
