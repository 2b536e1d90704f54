// Records a session into a folder of its own while it runs: events.jsonl (a line for everything that reached it and
// that it told of), hand.csv.gz and left.csv.gz (each tick of a hand), frames.csv.gz (each tick of the session) and
// cues.csv.gz (each step of the ears). docs/recordings.md is the reference. A thread of its own compresses and writes:
// lines every kLines_s, tables every kPieces_s, so that not more than half a second is lost however the program ends.
// Where writing fails the recording ends and says so once; whoever is recorded goes on.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "app/core/context/session_event.h"
#include "app/core/session/session_input.h"
#include "app/record/rows.h"
#include "audio-cues/plan/sinks.h"
#include "haptic/servo/hand_recording.h"

namespace handrail {

// What stands in the first line.
struct RecordingHead {
    // 2: with what the engine of free bodies reads and is read of.
    static constexpr int kForm = 2;

    int form = kForm;
    std::string program;  // version
    std::string language;
    std::string begun_utc;      // "2026-11-22T17:30:00Z"
    double begun_s = 0.0;       // of the session's clock: times "t" count from here
    bool virtual_time = false;  // a session without threads
    Settings settings;          // it began with
};

class Recorder {
public:
    static constexpr double kLines_s = 0.05, kPieces_s = 0.4, kSync_s = 10.0;

    // A new folder below `recordings`, named by time and chance, for nobody but the person (0700, files 0600); the
    // head's time of day is filled in. Fails with a sentence and has begun nothing then.
    static Result<std::unique_ptr<Recorder>> begin(const std::filesystem::path& recordings, RecordingHead head);
    // As end().
    ~Recorder();
    Recorder(const Recorder&) = delete;
    Recorder& operator=(const Recorder&) = delete;

    const std::filesystem::path& folder() const;

    // App thread, in the order in which all this reached the session.
    void input(const SessionInput& input, double now_s);
    void not_taken();                 // the last one was refused
    void frame(const FrameRow& row);  // after the session's tick
    // What the session had to hand over went to servos and ears otherwise than after a frame.
    void handed_over();
    void event(const SessionEvent& event, const Scene* scene);
    // What else the app did that computing again must know of: "is" and one whole number.
    void note(const char* is, double now_s, std::uint64_t number);

    // The thread of the ears.
    void cue_step(const CueRow& row);
    // voiced: by a voice, else written only.
    void said(double now_s, const Utterance& utterance, bool voiced);
    // A sentence of a sink about itself, before which step it came. from_voice: else the sounds'.
    void sink_news(double now_s, std::uint64_t step, bool from_voice, const std::string& text);

    // For the servo of the only or right hand (0) and of the left one (1).
    HandRing& hand(std::size_t which);
    // For the engine of what is free to move.
    EngineRecording& bodies();

    // App thread. The recording has ended before its time, in words; told once.
    std::optional<std::string> take_problem();
    // Writes the rest and the last line. Nothing is recorded from here on.
    void end(double now_s);

private:
    struct State;
    explicit Recorder(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

}  // namespace handrail
