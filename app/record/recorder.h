// Records a session into a new folder while it runs. docs/recordings.md is the reference. The files:
// - events.jsonl: a line for each input and each event
// - hand.csv.gz and left.csv.gz: each tick of a hand
// - frames.csv.gz: each tick of the session
// - cues.csv.gz: each step of the ears
// A separate thread compresses and writes the files: lines every kLines_s, tables every kPieces_s. So at most half a
// second is lost, however the program ends. If writing fails, the recording ends and reports that once; the session
// continues.
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

// The contents of the first line of events.jsonl.
struct RecordingHead {
    // Version of the format. Version 2 adds what the engine of free bodies reads, and what the hands and the session
    // read from the engine.
    static constexpr int kForm = 2;

    int form = kForm;
    std::string program;  // version of the program
    std::string language;
    std::string begun_utc;  // time of day, such as "2026-11-22T17:30:00Z"
    // Time on the session's clock at which the recording began; times "t" in the files begin there.
    double begun_s = 0.0;
    bool virtual_time = false;    // true if the session ran without threads, on a virtual clock
    settings::Settings settings;  // settings at the beginning of the session
};

class Recorder {
public:
    static constexpr double kLines_s = 0.05, kPieces_s = 0.4, kSync_s = 10.0;

    // Creates a folder below `recordings`. The name of the new folder contains the time and random letters. Only the
    // person can access it (0700, files 0600). Fills in the time of day in `head`. If the function fails, it returns a
    // sentence and leaves nothing behind.
    static Result<std::unique_ptr<Recorder>> begin(const std::filesystem::path& recordings, RecordingHead head);
    // Calls end() if nobody has called it.
    ~Recorder();
    Recorder(const Recorder&) = delete;
    Recorder& operator=(const Recorder&) = delete;

    const std::filesystem::path& folder() const;

    // App thread. Call input, not_taken, frame and handed_over in the order in which the session received the inputs
    // and did these things.
    void input(const core::SessionInput& input, double now_s);
    void not_taken();                 // call if the session refused the last input
    void frame(const FrameRow& row);  // call after the session's tick
    // Call if the session handed results to the servos and the ears at another time than after a frame.
    void handed_over();
    void event(const core::SessionEvent& event, const Scene* scene);
    // Records another action of the app that must be repeated when the session is computed again. The line contains
    // `is` as "is" and `number`.
    void note(const char* is, double now_s, std::uint64_t number);

    // Records a step of the ears. Call it on the thread of the ears (AudioThread).
    void cue_step(const CueRow& row);
    // Records a line that was said. `voiced`: a voice spoke the line; otherwise it was only written.
    void said(double now_s, const cues::Utterance& utterance, bool voiced);
    // Records a sentence that a sink reported about itself before `step`. `from_voice`: the voice reported it;
    // otherwise the sink for sounds did.
    void sink_news(double now_s, std::uint64_t step, bool from_voice, const std::string& text);

    // Returns the ring into which a servo writes its ticks. `which` is 0 for the right or only hand, 1 for the left
    // one.
    servo::HandRing& hand(std::size_t which);
    // Returns the object into which the engine of free bodies writes its steps.
    dynamics::EngineRecording& bodies();

    // If the recording has ended early, returns the reason once; otherwise nothing. App thread.
    std::optional<std::string> take_problem();
    // Writes everything that is waiting, and the last line. After that, nothing is recorded.
    void end(double now_s);

private:
    struct State;
    explicit Recorder(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

}  // namespace handrail::record
