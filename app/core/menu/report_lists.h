// Reports on the program itself, as lists that are read line by line: what is plugged in, what is known of a session
// that broke off, and what is wrong in the person's settings. App thread only.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "app/core/context/session_part.h"

namespace handrail {

class ReportLists : SessionPart {
public:
    explicit ReportLists(const SessionContext& context) : SessionPart(context) {}

    // Looking takes a moment, so the owner of the session does it and tells open_devices().
    void ask_for_devices(double now_s);
    // sentences: of what is plugged in. Before them stands which hand is in use.
    void open_devices(const std::vector<std::string>& sentences, double now_s);
    // Nobody waits for what is plugged in: it has been told, or its owner tells nothing.
    bool idle(double now_s) const { return now_s - asked_s_ > kAnswered_s; }

    void know_crash(std::vector<std::string> lines) { crash_ = std::move(lines); }
    bool has_crash() const { return !crash_.empty(); }
    void open_crash(double now_s);
    void know_settings_faults(std::vector<std::string> faults) { faults_ = std::move(faults); }
    bool has_settings_faults() const { return !faults_.empty(); }
    void open_settings_faults(double now_s);

private:
    // Enter says a line again. A list ends no item with a stop of its own.
    void open(std::string title, const std::vector<std::string>& lines, double now_s);

    static constexpr double kAnswered_s = 3.0;

    std::vector<std::string> crash_, faults_;
    double asked_s_ = -1e9;  // for devices that have not been told yet
};

}  // namespace handrail
