// Defines the recording's row for each step of the engine. A row says how much input of the app and of both hands had
// arrived by then, and which results other threads could see. With it, the step can be computed again. The engine only
// adds rows to the ring, and the recorder removes them.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <vector>

#include "worlds/base/spsc_ring.h"

namespace handrail::dynamics {

struct EngineRow {
    static constexpr double kNoHand_s = -1.0;

    std::uint32_t engine = 0;   // number of the engine in the session, counted from 1
    std::uint64_t step = 0;     // DynamicsFrame::number of the resulting frame
    double time_s = 0.0;        // time of the end of the step
    std::uint64_t skipped = 0;  // steps dropped before this one, because the loop could not make up for them
    std::uint32_t orders = 0;   // number of the app's requests that this step carried out
    std::uint32_t driven = 0;   // number of drive() calls received so far
    // HandPlace::time_s of the newest place of each hand that the step used. 0: none yet; kNoHand_s: the hand is away.
    std::array<double, 2> places_s{};
    std::array<std::uint32_t, 2> pushes{};  // number of pushes of each hand that this step received
    std::uint32_t events = 0;               // number of events for which the event ring had room
    bool published = false;                 // true if this step published its result
};

// Passes rows from one engine at a time to the recorder.
struct EngineRecording {
    static constexpr std::size_t kRows = 1024;  // enough rows for 4 s
    SpscRing<EngineRow, kRows> rows;
    std::atomic<std::uint64_t> lost{0};  // number of rows for which the ring had no room

    // Used by the app thread only.
    std::uint32_t engines = 0;           // number of engines that were given the ring so far
    std::uint64_t orders = 0;            // number of requests so far, over all engines
    std::vector<std::uint64_t> refused;  // numbers, from 1, of the requests for which the engine's queue had no room

    void push(const EngineRow& row) {
        if (!rows.push(row)) lost.fetch_add(1, std::memory_order_relaxed);
    }
};

}  // namespace handrail::dynamics
