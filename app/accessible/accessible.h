// Shows the window to screen readers as a frame with one focused area, whose name is the current message. The class
// passes the text of ReaderChannel to the reader, and offers each key to the reader first.
//
// An open list or question has its own objects in the frame and receives the keyboard. The current item is focused, so
// the reader announces it like an item of any list. Any other text becomes the description of that item, and Orca 43
// reads each change of a description.
//
// The class runs on a separate thread with GLib's default context, which nothing else in the program uses. So a slow
// screen reader or bus delays neither window nor sound nor hand. The class starts no other program. If there is no
// session bus, or if nobody on the bus listens to names and focus, it only checks again every two seconds.
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
    // Delay between notifying the reader of the window and its focus, and the first text. A text that the reader
    // receives earlier is lost. With Orca 43, we measured that 0.6 s are needed.
    static constexpr double kSettles_s = 0.8;

    // Starts the thread. Reads environment variables, so call it before other threads change them. Until the first
    // search for a reader has ended, the state of the channel's voice is Opening.
    static std::unique_ptr<Accessible> start(std::shared_ptr<sinks::ReaderChannel> channel);
    ~Accessible();
    Accessible(const Accessible&) = delete;
    Accessible& operator=(const Accessible&) = delete;

    // The app thread calls the following functions. Each of them returns at once. `focused`: Handrail's window has the
    // keyboard.
    void set_focus(bool focused);
    // Sets the open list or question. Call it before the texts about that list are spoken. If nothing has changed, it
    // costs one comparison.
    void show(const core::DialogueView& dialogue);
    // Returns what a reader did with items since the last call. "press" chooses an item, "increase" and "decrease"
    // change its value, and a quantity can also be set to a number.
    std::vector<core::ItemAct> take_acts();
    // Offers a key to the reader; see KeyReader. Returns 0 if no reader listens, or if the reader has left an earlier
    // key unanswered.
    std::uint64_t offer(const window::KeyStroke& stroke);
    window::KeyVerdict verdict(std::uint64_t ticket);

private:
    class Impl;
    explicit Accessible(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace handrail::accessible
