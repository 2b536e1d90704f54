// What a recording keeps of each engine step: how much input it had from the app and both hands until then, and which
// results others could see, so that the step can be computed again. The engine only adds rows to the ring; the recorder
// takes them out.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <vector>

#include "worlds/base/spsc_ring.h"

namespace handrail::dynamics {

struct EngineRow {
    static constexpr double kNoHand_s = -1.0;

    std::uint32_t engine = 0;   // which of the session's engines, counted from 1
    std::uint64_t step = 0;     // DynamicsFrame::number of the resulting frame
    double time_s = 0.0;        // time of the end of the step
    std::uint64_t skipped = 0;  // steps that were dropped before it, because they could not be made up for
    std::uint32_t orders = 0;   // requests of the app taken in this step
    std::uint32_t driven = 0;   // number of drive() calls received so far
    // HandPlace::time_s of the newest place known of each hand; 0: none yet; kNoHand_s: the hand is away.
    std::array<double, 2> places_s{};
    std::array<std::uint32_t, 2> pushes{};  // pushes of each hand taken in this step
    std::uint32_t events = 0;               // events that found room
    bool published = false;                 // the result of this step was published
};

// Passes rows from one engine at a time to the recorder.
struct EngineRecording {
    static constexpr std::size_t kRows = 1024;  // 4 s
    SpscRing<EngineRow, kRows> rows;
    std::atomic<std::uint64_t> lost{0};  // rows that found no room

    // App thread.
    std::uint32_t engines = 0;           // number of engines that were given the ring so far
    std::uint64_t orders = 0;            // number of requests so far, over all engines
    std::vector<std::uint64_t> refused;  // numbers, from 1, of the requests that found no room

    void push(const EngineRow& row) {
        if (!rows.push(row)) lost.fetch_add(1, std::memory_order_relaxed);
    }
};

}  // namespace handrail::dynamics
