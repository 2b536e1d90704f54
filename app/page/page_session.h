// A session in a page of a browser. The page gives it a packed world, lines and keys, and the time that has passed. It
// returns what is said and what the page shows. One thread, the page's worker, uses it; background tasks run at once.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "app/core/session/headless_session.h"
#include "app/core/whereabouts/rooms_kept.h"
#include "audio-cues/plan/sinks.h"

namespace handrail::page {

// Collects what is said until the page takes it. A screen reader speaks it, so the session does not know when a line
// has been spoken, as with any sink of text.
class PageSpeech final : public cues::SpeechSink {
public:
    void say(const cues::Utterance& utterance) override { lines_.push_back(utterance); }
    void write(const cues::Utterance& utterance) override { lines_.push_back(utterance); }
    void stop() override {}
    bool speaking() const override { return false; }
    std::vector<cues::Utterance> take() { return std::exchange(lines_, {}); }

private:
    std::vector<cues::Utterance> lines_;
};

class NoSound final : public cues::AudioSink {
public:
    void play(const cues::SoundCue& /*cue*/) override {}
    void set_loop(const cues::SoundCue& /*cue*/) override {}
    void set_listener(const cues::Listener& /*listener*/) override {}
    void stop_all() override {}
    void tick(double /*now_s*/) override {}
};

class PageSession {
public:
    // Makes a session and enters the world. `scene` is the result of stored::stored(), `navigation` that of
    // stored::stored_navigation(). Without a usable `navigation`, the session searches for the rooms itself. Fails with
    // one sentence if the scene is damaged.
    static Result<std::unique_ptr<PageSession>> begin(std::string_view scene, std::string_view navigation);

    core::HeadlessSession& session() { return session_; }
    // Advances the session by this time. Returns true if something is still under way: a line, steps, an answer.
    bool advance(int ms);
    // Returns what was said since the last call as a JSON array of objects with `text` and `urgent`. Urgent lines are
    // alarms and warnings.
    std::string take_said();
    // Returns the open list or question as a JSON object with `kind` ("none", "list" or "text"), `title`, `items`, `at`
    // and `text`.
    std::string view();

private:
    PageSession() = default;

    NoSound audio_;
    PageSpeech speech_;
    core::RoomsKept rooms_;
    core::HeadlessSession session_{{}, {}, audio_, speech_, {.rooms_kept = &rooms_}};
};

// Returns the commands as a JSON array of objects with `word` (what a person types), `key` and `help`.
std::string commands_json();

}  // namespace handrail::page
