// What a recording keeps of each step of the engine of what is free to move: how much it had of the app and of both
// hands until then, and what of the step others could hear, so that the same step can be computed again. Whoever
// records takes the rows out of the ring; the engine only puts them in.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <vector>

#include "worlds/base/spsc_ring.h"

namespace handrail {

struct EngineRow {
    static constexpr double kNoHand_s = -1.0;

    std::uint32_t engine = 0;               // which of those that a session had after each other, from 1
    std::uint64_t step = 0;                 // DynamicsFrame::number of what it came to
    double time_s = 0.0;                    // the end of the step
    std::uint64_t skipped = 0;              // steps' time that was let go before it, since nobody could make up for it
    std::uint32_t orders = 0;               // of the app, taken in this step
    std::uint32_t driven = 0;               // how often it had been told where driven things are
    std::array<double, 2> places_s{};       // HandPlace::time_s of the newest it knew of each hand; 0: of none yet,
                                            // kNoHand_s: that it is away
    std::array<std::uint32_t, 2> pushes{};  // of each hand, taken in this step
    std::uint32_t events = 0;               // that found room
    bool published = false;                 // the others could see how this step ended
};

// From one engine at a time to whoever records.
struct EngineRecording {
    static constexpr std::size_t kRows = 1024;  // 4 s
    SpscRing<EngineRow, kRows> rows;
    std::atomic<std::uint64_t> lost{0};  // that found no room

    // App thread.
    std::uint32_t engines = 0;           // that were given it so far
    std::uint64_t orders = 0;            // asked for so far, of all of them
    std::vector<std::uint64_t> refused;  // which of these found no room, from 1

    void push(const EngineRow& row) {
        if (!rows.push(row)) lost.fetch_add(1, std::memory_order_relaxed);
    }
};

}  // namespace handrail
