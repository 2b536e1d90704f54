// Lines of words, carried out one after the other: each when what the one before began is over, so that a script reads
// as it is lived. App thread.
#pragma once

#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "app/core/session/session.h"
#include "app/main/session_voice.h"
#include "app/main/world_visits.h"
#include "app/wizard/wizard_session.h"

namespace handrail {

class CarriedLines {
public:
    // All outlive this object. by_person: typed by somebody who does not wait for a world in vain, as a script does.
    CarriedLines(Session& app, WorldVisits& worlds, const SessionVoice& say, bool by_person)
        : app_(app), worlds_(worlds), say_(say), by_person_(by_person) {}

    void add(std::string line) { lines_.push_back(std::move(line)); }
    std::size_t waiting() const { return lines_.size(); }
    // What has not been done yet is not to be done any more.
    void drop();
    // The same, for somebody else to do.
    std::vector<std::string> take_rest();
    // Once a frame: does what is next, for the wizard where there is one. While a world is read, a person's words are
    // done at once, in the world they are still in, and a script waits for it. False when there was nothing to do and
    // nothing is waited for.
    bool take(double now_s, WizardSession* wizard);
    // A line left the program.
    bool left() const { return left_; }

private:
    bool answer(WizardSession& wizard, double now_s);
    bool means_room(const std::string& choice) const;
    void carry_out(const std::string& line, double now_s);
    void tap(Command command, int times, double now_s);

    Session& app_;
    WorldVisits& worlds_;
    const SessionVoice& say_;
    const bool by_person_;
    std::deque<std::string> lines_;
    Command repeat_command_ = Command::Forward;
    int repeat_left_ = 0;
    std::string choice_;             // to be made in the list that the last command opens
    bool looked_elsewhere_ = false;  // for what was to be chosen: in the other list too
    double settle_until_s_ = 0.0;
    bool left_ = false;
};

}  // namespace handrail
