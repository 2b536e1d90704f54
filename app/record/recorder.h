// Records a session into a new folder while it runs. docs/recordings.md is the reference. The files:
// - events.jsonl: a line for each input and each event
// - hand.csv.gz and left.csv.gz: each tick of a hand
// - frames.csv.gz: each tick of the session
// - cues.csv.gz: each step of the ears
// A separate thread compresses and writes: lines every kLines_s, tables every kPieces_s. So at most half a second is
// lost, however the program ends. If writing fails, the recording ends and reports it once; the session goes on.
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

namespace handrail::record {

// The contents of the first line.
struct RecordingHead {
    // 2: adds what the engine of free bodies reads, and what others read from it.
    static constexpr int kForm = 2;

    int form = kForm;
    std::string program;  // version of the program
    std::string language;
    std::string begun_utc;        // "2026-11-22T17:30:00Z"
    double begun_s = 0.0;         // of the session's clock; times "t" count from here
    bool virtual_time = false;    // the session ran without threads
    settings::Settings settings;  // settings at the beginning
};

class Recorder {
public:
    static constexpr double kLines_s = 0.05, kPieces_s = 0.4, kSync_s = 10.0;

    // Creates a folder below `recordings`, with a name from the time and random letters, that only the person can
    // access (0700, files 0600). Fills in the head's time of day. If it fails, it returns a sentence and leaves nothing
    // behind.
    static Result<std::unique_ptr<Recorder>> begin(const std::filesystem::path& recordings, RecordingHead head);
    // Calls end() if that was not done.
    ~Recorder();
    Recorder(const Recorder&) = delete;
    Recorder& operator=(const Recorder&) = delete;

    const std::filesystem::path& folder() const;

    // App thread. Call these in the order in which everything reached the session.
    void input(const core::SessionInput& input, double now_s);
    void not_taken();                 // the last input was refused
    void frame(const FrameRow& row);  // call after the session's tick
    // Call if the session handed something to servos and ears at any other time than after a frame.
    void handed_over();
    void event(const core::SessionEvent& event, const Scene* scene);
    // Records something else that the app did and that computing again needs: "is" and one whole number.
    void note(const char* is, double now_s, std::uint64_t number);

    // Call on the thread of the ears.
    void cue_step(const CueRow& row);
    // `voiced`: spoken by a voice; otherwise only written.
    void said(double now_s, const cues::Utterance& utterance, bool voiced);
    // A sink reported a sentence about itself before that step. `from_voice`: by the voice; otherwise by the sounds.
    void sink_news(double now_s, std::uint64_t step, bool from_voice, const std::string& text);

    // For the servo of the right or only hand (0) and of the left one (1).
    servo::HandRing& hand(std::size_t which);
    // For the engine of free bodies.
    dynamics::EngineRecording& bodies();

    // App thread. The reason if the recording has ended early; returned once.
    std::optional<std::string> take_problem();
    // Writes the rest and the last line. Nothing is recorded afterwards.
    void end(double now_s);

private:
    struct State;
    explicit Recorder(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

}  // namespace handrail::record
