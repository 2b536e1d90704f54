// Shows every message on a braille display, with the heading in front. It uses BRLTTY's BrlAPI, and only if no screen
// reader writes braille already. The code runs on a separate thread, because the library waits for its server. If there
// is no display, the sink reports nothing. If a display is lost, the sink announces that once and searches for a
// display again.
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "audio-cues/sinks/voice_router.h"

namespace handrail::sinks {

// Data that the app and the braille display share. Any thread may use it.
struct BrailleLink {
    // The open list: the text spoken about the current item, and all items as braille shows them. Both empty: no list
    // is open.
    struct List {
        std::string said;
        std::vector<std::string> items;
        std::size_t at = 0;
    };
    // Sets the open list. Call it before the text about its item is spoken.
    void set_list(List list) {
        const std::lock_guard lock(list_mutex_);
        list_ = std::move(list);
    }
    List list() const {
        const std::lock_guard lock(list_mutex_);
        return list_;
    }

    std::atomic<double> heading_rad{0.0};
    // X id of Handrail's window; the display shows Handrail while this window has the keyboard focus. 0: not known yet.
    std::atomic<unsigned> window{0};
    // Number of presses of a routing key. Each press requests more about the current message.
    std::atomic<int> more_requested{0};

private:
    mutable std::mutex list_mutex_;
    List list_;
};

// The audio thread owns and calls it. Each call returns at once.
class BrailleDisplay final : public BrailleSink {
public:
    static constexpr double kRetry_s = 5.0;
    // How often the display's size is queried. A display may connect or disconnect while its server keeps running.
    static constexpr double kSizeEvery_s = 0.5;

    // Reads the environment (BRLAPI_HOST, WINDOWPATH), so create it before other threads change the environment.
    BrailleDisplay(std::shared_ptr<BrailleLink> link, const settings::Settings::Speech& settings);
    // Waits at most half a second for the thread. If the thread is still waiting for the server after that, it is left
    // behind and ends when it can.
    ~BrailleDisplay() override;
    BrailleDisplay(const BrailleDisplay&) = delete;
    BrailleDisplay& operator=(const BrailleDisplay&) = delete;

    void want(bool wanted) override;
    void say(const cues::Utterance& utterance) override { write(utterance); }
    // The newest message stays on the display until the next one.
    void write(const cues::Utterance& utterance) override;
    void stop() override {}
    bool speaking() const override { return false; }
    void tick(double now_s) override;
    void set_speech(const settings::Settings::Speech& settings) override;
    std::optional<std::string> news() override;

private:
    struct Shared;
    struct Worker;

    std::shared_ptr<Shared> shared_;
    std::thread thread_;
    double shown_heading_rad_ = 0.0;
};

}  // namespace handrail::sinks
