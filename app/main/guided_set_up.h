// The wizard's turn: while it leads through the set-up it alone is answered, moves the hand and speaks, in a world or
// without one. App thread.
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

namespace handrail {

class GuidedSetUp {
public:
    // All outlive this object.
    struct Parts {
        const SettingsStore& settings;
        const ServoSwitches& switches;
        Session& app;
        SessionDriver& driver;
        HandInUse& hand;
        Ears& ears;
        KeptSettings& kept;
        const SessionVoice& say;
        bool alone;  // without a world: it looks for the hand itself, when it comes to it, so that what the search
                     // tells is heard in its place
    };
    explicit GuidedSetUp(const Parts& parts) : parts_(parts) {}

    void begin(std::span<const WizardPart> wanted);
    // Once a frame: begins where the person asked for it.
    void begin_if_asked();
    // Null: nobody is led. What is answered goes to it.
    WizardSession* session() { return session_.get(); }
    bool under_way() const { return session_ != nullptr; }

    // Once a frame while it is under way: look (alone only), sense, then hand_over and end_if_finished.
    void look_for_hand();
    void sense(double now_s);
    void hand_over();
    void end_if_finished(double now_s);

private:
    WizardSearch search() const;

    Parts parts_;
    std::unique_ptr<WizardSession> session_;
    bool searched_ = false;
    std::vector<std::string> news_;
    std::uint32_t stops_ = 0, let_go_ = 0;
};

}  // namespace handrail
