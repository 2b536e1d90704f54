// Simulates a person at the keyboard of a session in virtual time, who presses a key, waits, and presses the next one.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "app/core/session/headless_session.h"
#include "audio-cues/plan/speakable.h"
#include "audio-cues/sinks/recording_sinks.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/unit/heard/heard.h"
#include "worlds/readers/reader.h"

namespace handrail::test {

class Typing {
public:
    // The pauses after the keys are `pauses_s` in turn. The class calls `each_ms` after every millisecond of the
    // session.
    Typing(AudioSink& audio, SpeechSink& speech, std::vector<double> pauses_s, std::function<void()> each_ms = {})
        : speech_(speech),
          pauses_s_(std::move(pauses_s)),
          each_ms_(std::move(each_ms)),
          session_(Settings{}, HandFacts{}, audio, speech) {}

    // Enters a bundled world or a world of the scenarios.
    void enter(const std::string& file) {
        const std::filesystem::path ours = bundled_world(file),
                                    of_scenarios = project_root() / "tests" / "scenarios" / "worlds" / file;
        auto scene = read_world((std::filesystem::exists(ours) ? ours : of_scenarios).string());
        if (!scene) throw std::runtime_error(scene.error().sentence());
        session_.app().apply(WorldEntered{make_ready(std::make_shared<const Scene>(std::move(*scene)))}, now_s());
        wait(kAfterLastKey_s);
        entered_s = now_s();
    }
    Session& app() { return session_.app(); }
    double now_s() const { return session_.now_s(); }
    void wait(double seconds) {
        for (const double until_s = now_s() + seconds; now_s() < until_s - 1e-9;) {
            session_.advance();
            if (each_ms_) each_ms_();
            for (SessionEvent& event : app().take_events())
                if (const auto* room = std::get_if<RoomEntered>(&event.what))
                    rooms.push_back({event.time_s, room->name});
        }
    }
    void pause() { wait(pauses_s_[next_pause_++ % pauses_s_.size()]); }
    void press(Command command, int times = 1) {
        for (int i = 0; i < times; ++i) {
            session_.press(command);
            app().apply(CommandUp{command}, now_s());
            pause();
        }
    }
    void key(const std::string& name) {
        EXPECT_TRUE(session_.tap_key(name)) << name;
        pause();
    }
    // Types a line and listens until the voice is silent.
    void type(const std::string& line) {
        session_.type(line);
        listen();
    }
    // Waits until the voice has been silent for 1.5 s. Within that time, the session repeats a line that was cut.
    void listen() {
        constexpr double kSilence_s = 1.5, kMost_s = 120.0;
        const double began_s = now_s();
        for (double silent_s = 0.0; silent_s < kSilence_s && now_s() - began_s < kMost_s;) {
            wait(0.005);
            silent_s = speech_.speaking() ? 0.0 : silent_s + 0.005;
        }
    }
    void finish() { wait(kAfterLastKey_s); }

    struct Entered {
        double time_s;
        std::string name;
    };
    std::vector<Entered> rooms;
    double entered_s = 0.0;

private:
    SpeechSink& speech_;
    std::vector<double> pauses_s_;
    std::size_t next_pause_ = 0;
    std::function<void()> each_ms_;
    HeadlessSession session_;
};

struct KeptSinks {
    explicit KeptSinks(double words_per_minute) : voice(words_per_minute) {}
    RecordingAudio audio;
    RecordingSpeech voice;
};

// A typist with a voice that takes realistic time, and without sounds.
class Typist : public KeptSinks, public Typing {
public:
    Typist(const std::string& file, double words_per_minute, double pause_s)
        : KeptSinks(words_per_minute), Typing(audio, voice, {pause_s}) {
        enter(file);
    }

    // Returns the rooms whose names were not heard while the typist was in them. Omits rooms that the typist left in
    // less than `stay_s`.
    std::vector<std::string> rooms_not_heard(double stay_s) const {
        std::vector<std::string> missing;
        for (std::size_t i = 0; i < rooms.size(); ++i) {
            const double left_s = i + 1 < rooms.size() ? rooms[i + 1].time_s : now_s();
            if (rooms[i].time_s < entered_s || left_s - rooms[i].time_s < stay_s) continue;
            const std::string name = sentence_case(rooms[i].name);
            const auto& lines = voice.lines();
            const bool heard = std::any_of(lines.begin(), lines.end(), [&](const HeardSpeech& said) {
                return said.time_s >= rooms[i].time_s - 0.1 && said.time_s < left_s && in_full(said, now_s()) &&
                       said.utterance.text.find(name) != std::string::npos;
            });
            if (!heard) missing.push_back(fmt::format("{} at {:.1f} s", name, rooms[i].time_s));
        }
        return missing;
    }
    std::string all() const { return told(voice); }
};

}  // namespace handrail::test
