// A braille display, through BRLTTY's BrlAPI, where no screen reader brailles already: shows every message with the
// heading before it. On a thread of its own, since the library waits for its server. Nothing is said while none is
// there; a display that goes is told of once, and looked for again.
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "audio-cues/sinks/voice_router.h"

namespace handrail {

// Between the app and the display; any thread.
struct BrailleLink {
    // The list that is open: what is said of the item one is at, and all items as they are brailled. Empty: none.
    struct List {
        std::string said;
        std::vector<std::string> items;
        std::size_t at = 0;
    };
    // Set before the words about it are spoken.
    void set_list(List list) {
        const std::lock_guard lock(list_mutex_);
        list_ = std::move(list);
    }
    List list() const {
        const std::lock_guard lock(list_mutex_);
        return list_;
    }

    std::atomic<double> heading_rad{0.0};
    // X's number of our window: the display shows us while that has the keyboard. 0: not yet.
    std::atomic<unsigned> window{0};
    std::atomic<int> more_asked{0};  // a routing key was pressed, so often: more about this

private:
    mutable std::mutex list_mutex_;
    List list_;
};

// Owned and called by the audio thread; each call returns at once.
class BrailleDisplay final : public BrailleSink {
public:
    static constexpr double kRetry_s = 5.0;
    static constexpr double kSizeEvery_s = 0.5;  // a display may come and go while its server stays

    // Reads the environment (BRLAPI_HOST, WINDOWPATH): before other threads change it.
    BrailleDisplay(std::shared_ptr<BrailleLink> link, const Settings::Speech& settings);
    // Waits at most half a second for the server; a thread that still waits then is left to end by itself.
    ~BrailleDisplay() override;
    BrailleDisplay(const BrailleDisplay&) = delete;
    BrailleDisplay& operator=(const BrailleDisplay&) = delete;

    void want(bool wanted) override;
    void say(const Utterance& utterance) override { write(utterance); }
    void write(const Utterance& utterance) override;  // the newest stays until the next
    void stop() override {}
    bool speaking() const override { return false; }
    void tick(double now_s) override;
    void set_speech(const Settings::Speech& settings) override;
    std::optional<std::string> news() override;

private:
    struct Shared;
    struct Worker;

    std::shared_ptr<Shared> shared_;
    std::thread thread_;
    double shown_heading_rad_ = 0.0;
};

}  // namespace handrail
