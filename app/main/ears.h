// Owns all outputs for hearing and reading: the audio thread and, with a window, the accessible list and the braille
// display. App thread.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/accessible/accessible.h"
#include "app/core/session/session.h"
#include "app/main/session_recording.h"
#include "audio-cues/plan/audio_thread.h"
#include "audio-cues/sinks/braille_display.h"
#include "worlds/base/clock.h"

namespace handrail::program {

class Ears {
public:
    // Opens all outputs that exist, and adds sentences about them to `news`. The clock, the rings and the recording
    // must outlive this object. `with_window`: a window will open.
    Ears(const settings::Settings& settings, bool with_window, Clock& clock,
         cues::AudioThread::ContactRing& left_contacts, SessionRecording& recording, std::vector<std::string>& news);

    cues::AudioThread& sound() { return *sound_; }
    cues::AudioThread::ContactRing& contacts() { return contacts_; }  // contacts of the hand that leads the session
    bool has_sound() const { return has_sound_; }                     // true if there is a sound device
    // Null without a window. If the window failed to open, call close_accessible.
    accessible::Accessible* accessible() { return accessible_.get(); }
    sinks::BrailleLink* braille() { return braille_.get(); }
    void close_accessible() { accessible_.reset(); }

    // Returns the name of the voice that will speak. Waits at most 1.5 s for a better voice that is still opening,
    // because the welcome is due within two seconds.
    std::string voice_that_speaks();
    // Passes the open list to the screen reader and the braille display. Passes the walker's heading to the braille
    // display.
    void show(const core::Session& app);
    void follow_hands(bool two, bool stands_in);
    // Stores the sentences that were spoken last; messages() returns them, the oldest first.
    void note_spoken();
    const std::vector<std::string>& messages() const { return messages_; }

private:
    Clock& clock_;
    SessionRecording& recording_;
    std::unique_ptr<accessible::Accessible> accessible_;
    std::shared_ptr<sinks::BrailleLink> braille_;
    core::DialogueView shown_dialogue_;  // the list as last passed to accessible_ and braille_
    bool has_sound_ = false;
    cues::AudioThread::ContactRing contacts_;
    std::unique_ptr<cues::AudioThread> sound_;
    bool two_hands_ = false, hand_stands_in_ = false;
    std::vector<std::string> messages_;  // at most core::kShownMessages
};

}  // namespace handrail::program
