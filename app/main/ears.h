// All that is heard, shown in braille or read by another program's voice: the audio thread, and beside a window the
// accessible list and the braille display. App thread.
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

namespace handrail {

class Ears {
public:
    // Opens what there is; `news` get what that is. Clock, rings and recording outlive this
    // object. `with_window`: there will be
    // one.
    Ears(const Settings& settings, bool with_window, Clock& clock, AudioThread::ContactRing& left_contacts,
         SessionRecording& recording, std::vector<std::string>& news);

    AudioThread& sound() { return *sound_; }
    AudioThread::ContactRing& contacts() { return contacts_; }  // of the hand in use
    bool has_sound() const { return has_sound_; }               // there is a sound device
    // Beside the window, else null. No window came after all: close_accessible.
    Accessible* accessible() { return accessible_.get(); }
    BrailleLink* braille() { return braille_.get(); }
    void close_accessible() { accessible_.reset(); }

    // Once that is decided: a better voice may still be opening. The welcome is due within two seconds, so it waits no
    // longer than 1.5 s.
    std::string voice_that_speaks();
    // The list that is open and the heading, for the screen reader and the braille display.
    void show(const Session& app);
    void follow_hands(bool two, bool stands_in);
    // The last sentence that was said, as of note_spoken.
    void note_spoken();
    const std::string& last_spoken() const { return last_spoken_; }

private:
    Clock& clock_;
    SessionRecording& recording_;
    std::unique_ptr<Accessible> accessible_;
    std::shared_ptr<BrailleLink> braille_;
    DialogueView shown_dialogue_;  // as these two have it
    bool has_sound_ = false;
    AudioThread::ContactRing contacts_;
    std::unique_ptr<AudioThread> sound_;
    bool two_hands_ = false, hand_stands_in_ = false;
    std::string last_spoken_;
};

}  // namespace handrail
