// The way of a voice into the sound sink: whoever synthesises speech puts samples in, OpenALSink takes them out on its
// own thread. One voice at a time: beginning a new utterance cuts the one before. Any thread; each call holds a mutex
// for microseconds.
#pragma once

#include <cstdint>
#include <mutex>
#include <span>
#include <vector>

namespace handrail {

class VoiceChannel {
public:
    using Ticket = std::uint64_t;  // names an utterance; later ones are larger

    // The voice's side. Samples may come in pieces while the first already sound; `end` says there are no more.
    Ticket begin(int rate_hz, double gain);
    bool append(Ticket ticket, std::span<const std::int16_t> samples);  // false when that utterance has been cut
    bool cut(Ticket ticket) const;                                      // another one has begun, or stop()
    void end(Ticket ticket);
    void stop();
    bool playing() const;  // from begin() until the sink has played the last sample, or stop()

    // The sink's side: what has come since the last call. A ticket other than before: the utterance before is cut.
    struct Update {
        Ticket ticket = 0;
        int rate_hz = 0;
        double gain = 1.0;
        std::vector<std::int16_t> samples;
        bool ended = false;
    };
    Update take();
    void finished(Ticket ticket);

private:
    mutable std::mutex mutex_;  // guards all below
    Update now_;
    Ticket finished_ = 0;
};

}  // namespace handrail
