// Declares the inputs that the owner of a session passes to the audio thread. AudioThread handles them in its next
// step. PlayedEars counts them in order to replay a recording. Call these functions from the app thread.
#pragma once

#include <memory>

#include "audio-cues/plan/cue_planner.h"
#include "audio-cues/plan/sinks.h"
#include "settings/settings.h"
#include "worlds/scene/scene.h"

namespace handrail::cues {

class EarsInbox {
public:
    virtual ~EarsInbox() = default;
    virtual void post(CueRequest request) = 0;
    virtual void set_settings(const settings::Settings& settings) = 0;
    virtual void enter_world(std::shared_ptr<const Scene> scene) = 0;
    virtual void follow_edit(std::shared_ptr<const Scene> scene) = 0;  // see CuePlanner::follow_edit()
    virtual void set_two_hands(bool two) = 0;
    virtual void set_hand_stands_in(bool stands_in) = 0;  // see CuePlanner::set_hand_stands_in()
    virtual void set_listener(const Listener& listener) = 0;
    // Returns the topics of lines that were cut off and must be spoken again. The session composes these lines again
    // (SpeechOrder::take_owed).
    virtual SpeechTopics take_owed() { return {}; }
};

}  // namespace handrail::cues
