// The window as screen readers see it: a frame with one focused area whose name is the current message. It speaks the
// text of ReaderChannel and offers the reader each key first.
//
// An open list or question has its own objects in the frame and takes the keyboard. The current item is focused, so the
// reader announces it like an item of any list. Other words become that item's description, and Orca 43 reads each
// change of it.
//
// Runs on a separate thread with GLib's default context, which nothing else in the program uses, so that a slow screen
// reader or bus delays neither window nor sound nor hand. It starts no other program: without a session bus, or without
// anybody on it who listens to names and focus, it only looks again every two seconds.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "app/core/dialogue/dialogue.h"
#include "app/window/key_gate.h"
#include "audio-cues/sinks/reader_voice.h"

namespace handrail::accessible {

class Accessible {
public:
    static constexpr double kLooksEvery_s = 2.0;
    // A text is lost if it comes before the reader has noticed the window and its focus, so words wait this long after
    // both. Measured with Orca 43: 0.6 s.
    static constexpr double kSettles_s = 0.8;

    // Reads the environment, so call it before other threads change that. Until the first search for a reader, the
    // channel's voice counts as opening.
    static std::unique_ptr<Accessible> start(std::shared_ptr<sinks::ReaderChannel> channel);
    ~Accessible();
    Accessible(const Accessible&) = delete;
    Accessible& operator=(const Accessible&) = delete;

    // Called by the app thread; each call returns at once. `focused`: our window has the keyboard.
    void set_focus(bool focused);
    // Sets what is open; call it before the words about it are spoken. Costs a comparison if nothing has changed.
    void show(const core::DialogueView& dialogue);
    // What a reader did with items since the last call: "press" chooses, "increase" and "decrease" change a value, and
    // the value of a quantity can be set directly.
    std::vector<core::ItemAct> take_acts();
    // Offers a key to the reader, see KeyReader. Returns 0 if no reader listens, or if it has left an earlier key
    // unanswered.
    std::uint64_t offer(const window::KeyStroke& stroke);
    window::KeyVerdict verdict(std::uint64_t ticket);

private:
    class Impl;
    explicit Accessible(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace handrail::accessible
