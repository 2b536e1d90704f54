// The window as screen readers see it: a frame with one focused area whose name is the message of the moment. Says what
// ReaderChannel brings, and gives the reader each key first. A list or question that is open stands beside it as
// objects of its own and has the keyboard: the item one is at is focused, so the reader tells it as it tells every
// list, and what else is to be said is that item's description, of which Orca 43 reads each change. On a thread of its
// own with GLib's default context, which nobody else in the program uses: what a screen reader or the bus is slow with
// holds up neither window nor ears nor hand.
//
// Nothing is started for it: where there is no session bus, or nobody on it listens to names and focus, it only looks
// again every two seconds.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "app/core/dialogue/dialogue.h"
#include "app/window/key_gate.h"
#include "audio-cues/sinks/reader_voice.h"

namespace handrail {

class Accessible {
public:
    static constexpr double kLooksEvery_s = 2.0;
    // What is told before a reader has heard of the window and its focus is lost, so words wait that long after both.
    // Measured with Orca 43: 0.6 s.
    static constexpr double kSettles_s = 0.8;

    // Reads the environment: before other threads change it. The channel's voice counts as opening until somebody has
    // been looked for.
    static std::unique_ptr<Accessible> start(std::shared_ptr<ReaderChannel> channel);
    ~Accessible();
    Accessible(const Accessible&) = delete;
    Accessible& operator=(const Accessible&) = delete;

    // App thread; each returns at once. The keyboard is in our window, or left it.
    void set_focus(bool focused);
    // What is open now, before the words about it are spoken; costs a comparison where nothing changed.
    void show(const DialogueView& dialogue);
    // What a reader did with items since it was asked last: "press" chooses, "increase" and "decrease" change a value,
    // and that of a quantity is set outright.
    std::vector<ItemAct> take_acts();
    // A key for the reader, see KeyReader; 0 where none listens, or it has left an earlier key without an answer.
    std::uint64_t offer(const KeyStroke& stroke);
    KeyVerdict verdict(std::uint64_t ticket);

private:
    class Impl;
    explicit Accessible(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace handrail
