// Computes the recorded physics engines of free bodies again, step by step. Each step reads from the app and from both
// hands what it read during the recording. The app and the hands in turn read from the engine what they read during the
// recording. If a step or a reader needs a result that does not exist yet, that result is computed first. If that is
// impossible, failed() returns true from then on. One thread.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <set>

#include "app/record/recording.h"
#include "haptic/dynamics/body_engine.h"
#include "haptic/servo/hand_body_servo.h"

namespace handrail::record {

class PlayedBodies {
public:
    // `step_hand` computes one more tick of hand 0 or 1, and returns false if it cannot. `recording` must outlive this
    // object.
    PlayedBodies(const Recording& recording, std::function<bool(std::size_t which)> step_hand);
    ~PlayedBodies();

    // Returns true if the recording contains engines. Worlds without free bodies and older recordings have none.
    bool recorded() const { return !recording_.bodies.empty(); }
    // Makes the next of the session's engines. This object must outlive that engine.
    std::unique_ptr<dynamics::BodyEngine> make(std::shared_ptr<const render::DynamicsScene> scene, double begin_s);

    // Call before a tick of the session. `row` contains what the tick read.
    void session_reads(const FrameRow& row);
    // Call before_tick before a tick of a hand's servo, and after_tick after that tick. before_tick returns false if a
    // result that the tick read cannot be computed.
    bool before_tick(std::size_t which, const servo::HandRow& row);
    void after_tick(std::size_t which, const servo::HandRow& row, servo::HandBodyServo* engine);

    // Returns true if a required result could not be computed.
    bool failed() const { return failed_; }
    // Stops all computation.
    void close() { closed_ = true; }

private:
    class Engine;
    struct Book;

    Book& book(std::uint32_t engine);

    const Recording& recording_;
    const std::function<bool(std::size_t which)> step_hand_;
    std::map<std::uint32_t, std::unique_ptr<Book>> books_;  // keys are EngineRow::engine
    std::uint32_t made_ = 0;
    std::uint64_t orders_ = 0;         // number of orders that the session has given to the engine
    std::set<std::uint64_t> refused_;  // numbers of the orders that were refused because the queue was full
    FrameRow due_;                     // what the session's next tick reads from the engine
    bool failed_ = false, closed_ = false;
};

}  // namespace handrail::record
