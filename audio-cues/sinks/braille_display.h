// A braille display through BRLTTY's BrlAPI, used if no screen reader writes braille already. It shows every message
// with the heading in front. Runs on a separate thread, because the library waits for its server. While there is no
// display it reports nothing. The loss of a display is announced once, and the display is looked for again.
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

// Shared by the app and the display; any thread.
struct BrailleLink {
    // The open list: the words spoken about the current item, and all items as braille shows them. Empty: no list.
    struct List {
        std::string said;
        std::vector<std::string> items;
        std::size_t at = 0;
    };
    // Call it before the words about the item are spoken.
    void set_list(List list) {
        const std::lock_guard lock(list_mutex_);
        list_ = std::move(list);
    }
    List list() const {
        const std::lock_guard lock(list_mutex_);
        return list_;
    }

    std::atomic<double> heading_rad{0.0};
    // The X id of our window: the display shows Handrail while this window has the keyboard. 0: not known yet.
    std::atomic<unsigned> window{0};
    // Counts presses of a routing key, each a request for more about the current message.
    std::atomic<int> more_asked{0};

private:
    mutable std::mutex list_mutex_;
    List list_;
};

// Owned and called by the audio thread; each call returns at once.
class BrailleDisplay final : public BrailleSink {
public:
    static constexpr double kRetry_s = 5.0;
    // How often the size is queried, because a display may come and go while its server stays.
    static constexpr double kSizeEvery_s = 0.5;

    // Reads the environment (BRLAPI_HOST, WINDOWPATH), so call it before other threads change the environment.
    BrailleDisplay(std::shared_ptr<BrailleLink> link, const settings::Settings::Speech& settings);
    // Waits at most half a second for the server. A thread that still waits then is left behind and ends when it can.
    ~BrailleDisplay() override;
    BrailleDisplay(const BrailleDisplay&) = delete;
    BrailleDisplay& operator=(const BrailleDisplay&) = delete;

    void want(bool wanted) override;
    void say(const cues::Utterance& utterance) override { write(utterance); }
    void write(const cues::Utterance& utterance) override;  // the newest message stays until the next one
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
