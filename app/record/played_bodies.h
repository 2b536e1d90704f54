// Computes the recorded engines of free bodies again, step by step. Each step takes what it took then from the app and
// from both hands, and the others read from it what they read then. If a step or a reader needs something that is not
// there yet, it is computed first. If that is impossible, everything has failed for good. One thread.
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
    // `step_hand` computes one more tick of hand 0 or 1, and returns false if it cannot. The recording must outlive
    // this object.
    PlayedBodies(const Recording& recording, std::function<bool(std::size_t which)> step_hand);
    ~PlayedBodies();

    // False for worlds without free bodies and for older recordings.
    bool recorded() const { return !recording_.bodies.empty(); }
    // Makes the next engine that the session had. This object must outlive it.
    std::unique_ptr<dynamics::BodyEngine> make(std::shared_ptr<const render::DynamicsScene> scene, double begin_s);

    // Call before a tick of the session, with what it read.
    void session_reads(const FrameRow& row);
    // Call before and after a tick of a hand's servo. Returns false if what the tick read cannot be computed.
    bool before_tick(std::size_t which, const servo::HandRow& row);
    void after_tick(std::size_t which, const servo::HandRow& row, servo::HandBodyServo* engine);

    // Returns true if something could not be computed.
    bool failed() const { return failed_; }
    // Stops computing.
    void close() { closed_ = true; }

private:
    class Engine;
    struct Book;

    Book& book(std::uint32_t engine);

    const Recording& recording_;
    const std::function<bool(std::size_t which)> step_hand_;
    std::map<std::uint32_t, std::unique_ptr<Book>> books_;  // by EngineRow::engine
    std::uint32_t made_ = 0;
    std::uint64_t orders_ = 0;         // number of orders given
    std::set<std::uint64_t> refused_;  // numbers of the orders for which there was no room
    FrameRow due_;                     // what the session's next tick reads
    bool failed_ = false, closed_ = false;
};

}  // namespace handrail::record
