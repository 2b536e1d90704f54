// Opens reports about the program itself, as lists that the person reads line by line: connected devices, what is known
// of a crashed session, and errors in the person's settings. Use it on the app thread only.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "app/core/context/session_part.h"

namespace handrail::core {

class ReportLists : SessionPart {
public:
    explicit ReportLists(const SessionContext& context) : SessionPart(context) {}

    // Requests the list of connected devices. Finding the devices takes a moment, so the owner of the session does it
    // and then calls open_devices().
    void request_devices(double now_s);
    // Opens the list of connected devices. `sentences` has one sentence for each device. The list begins with the hand
    // in use.
    void open_devices(const std::vector<std::string>& sentences, double now_s);
    // Returns true if nobody is waiting for the list of devices: the list has been announced, or the owner has not
    // answered in time.
    bool idle(double now_s) const { return now_s - requested_s_ > kAnswered_s; }

    void know_crash(std::vector<std::string> lines) { crash_ = std::move(lines); }
    bool has_crash() const { return !crash_.empty(); }
    void open_crash(double now_s);
    void know_settings_faults(std::vector<std::string> faults) { faults_ = std::move(faults); }
    bool has_settings_faults() const { return !faults_.empty(); }
    void open_settings_faults(double now_s);

private:
    // Opens a list of lines. Enter repeats a line. Items of a list have no full stop at the end, so this function
    // removes it.
    void open(std::string title, const std::vector<std::string>& lines, double now_s);

    static constexpr double kAnswered_s = 3.0;

    std::vector<std::string> crash_, faults_;
    double requested_s_ = -1e9;  // time when the person requested the devices; reset once they have been announced
};

}  // namespace handrail::core
