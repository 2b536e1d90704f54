// Runs the set-up wizard in a session, with or without a world. During the set-up, only the wizard receives the
// answers, moves the hand and speaks. App thread.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "app/core/session/session_driver.h"
#include "app/main/ears.h"
#include "app/main/hand_in_use.h"
#include "app/main/kept_settings.h"
#include "app/main/session_voice.h"
#include "app/wizard/wizard_session.h"

namespace handrail::program {

class GuidedSetUp {
public:
    // The parts that this class uses. All of them must outlive the GuidedSetUp.
    struct Parts {
        const settings::SettingsStore& settings;
        const servo::ServoSwitches& switches;
        core::Session& app;
        core::SessionDriver& driver;
        HandInUse& hand;
        Ears& ears;
        KeptSettings& kept;
        const SessionVoice& say;
        // True if there is no world. The set-up then searches for the hand only when it reaches that step, so that the
        // person hears the news of the search at the right place.
        bool alone;
    };
    explicit GuidedSetUp(const Parts& parts) : parts_(parts) {}

    void begin(std::span<const wizard::WizardPart> wanted);
    // Call once a frame. Begins the set-up if the person has requested it.
    void begin_if_requested();
    // Returns the wizard that receives the person's answers; null if no set-up is under way.
    wizard::WizardSession* session() { return session_.get(); }
    bool under_way() const { return session_ != nullptr; }

    // During a set-up, call these functions once a frame and in this order: look_for_hand (only if `alone`), sense,
    // hand_over, end_if_finished.
    void look_for_hand();
    void sense(double now_s);
    void hand_over();
    void end_if_finished(double now_s);

private:
    wizard::WizardSearch search() const;

    Parts parts_;
    std::unique_ptr<wizard::WizardSession> session_;
    bool searched_ = false;
    std::vector<std::string> news_;
    std::uint32_t stops_ = 0, let_go_ = 0;
};

}  // namespace handrail::program
