// The engines of a recording, of what was free to move, step by step as they were: each step takes what it took then of
// the app and of both hands, and the others read of it what they read then. Whatever a step or a reader needs that is
// not there yet is computed first; what cannot be computed so fails, once and for all. One thread.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <set>

#include "app/record/recording.h"
#include "haptic/dynamics/body_engine.h"
#include "haptic/servo/hand_engine.h"

namespace handrail {

class PlayedBodies {
public:
    // step_hand: one more tick of a hand, 0 or 1; false where it cannot be made. The recording outlives it.
    PlayedBodies(const Recording& recording, std::function<bool(std::size_t which)> step_hand);
    ~PlayedBodies();

    // Recordings of other worlds, and older ones, have none.
    bool recorded() const { return !recording_.bodies.empty(); }
    // The next one that the session had. No longer than this.
    std::unique_ptr<BodyEngine> make(std::shared_ptr<const DynamicsScene> scene, double begin_s);

    // Before a tick of the session: what it read.
    void session_reads(const FrameRow& row);
    // Before and after a tick of a hand's servo. False: what it read cannot be there.
    bool before_tick(std::size_t which, const HandRow& row);
    void after_tick(std::size_t which, const HandRow& row, HandEngine* engine);

    // Something could not be computed.
    bool failed() const { return failed_; }
    // Nothing more is to be computed.
    void close() { closed_ = true; }

private:
    class Engine;
    struct Book;

    Book& book(std::uint32_t engine);

    const Recording& recording_;
    const std::function<bool(std::size_t which)> step_hand_;
    std::map<std::uint32_t, std::unique_ptr<Book>> books_;  // by EngineRow::engine
    std::uint32_t made_ = 0;
    std::uint64_t orders_ = 0;         // asked for so far
    std::set<std::uint64_t> refused_;  // which of them found no room
    FrameRow due_;                     // what the session's tick reads
    bool failed_ = false, closed_ = false;
};

}  // namespace handrail
