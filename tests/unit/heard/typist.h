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
#include "worlds/base/language.h"
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
        for (const Feature& feature : scene->features)
            if (feature.kind == FeatureKind::Door && !feature.bounds_m.empty())
                frames_.push_back({feature.name, feature.bounds_m});
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
            for (SessionEvent& event : app().take_events()) note(event);
            note_doors();
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

    // Returns the names of the rooms that the person must hear while in them. Omits rooms that the person left in less
    // than `stay_s`.
    std::vector<MustHear> rooms_to_hear(double stay_s) const {
        std::vector<MustHear> all;
        for (std::size_t i = 0; i < rooms.size(); ++i) {
            const double left_s = i + 1 < rooms.size() ? rooms[i + 1].time_s : now_s();
            if (rooms[i].time_s < entered_s || left_s - rooms[i].time_s < stay_s) continue;
            all.push_back({rooms[i].time_s - 0.1, left_s, sentence_case(rooms[i].name), SpeechTopic::Place});
        }
        return all;
    }

    struct Entered {
        double time_s;
        std::string name;
    };
    std::vector<Entered> rooms;
    std::vector<std::string> doors;  // the doors through which the walker went
    // The summaries of routes that began, and the announcements of arrivals.
    std::vector<MustHear> summaries, arrivals;
    double entered_s = 0.0;

private:
    void note(const SessionEvent& event) {
        constexpr double kHolds_s = 20.0;  // a line that was cut is said again within this time
        const double from_s = event.time_s - 0.1, until_s = event.time_s + kHolds_s;
        if (const auto* room = std::get_if<RoomEntered>(&event.what)) rooms.push_back({event.time_s, room->name});
        if (const auto* led = std::get_if<Led>(&event.what); led && led->by == LedBy::Ear)
            summaries.push_back({from_s, until_s, fmt::format("To {}.", led->goal)});
        if (const auto* arrived = std::get_if<Arrived>(&event.what))
            arrivals.push_back({from_s, until_s,
                                arrived->by == LedBy::Ear
                                    ? phrase("route.arrived", {{"goal", sentence_case(arrived->goal)}})
                                    : phrase("lead.here", {{"goal", arrived->goal}})});
    }

    // The place of a door in the file, where every door is shut, and the side on which the walker was last.
    struct Frame {
        std::string name;
        Aabb box_m;
        int side = 0;
    };
    // Notes each door whose middle plane the walker has just crossed within its frame.
    void note_doors() {
        const Vec3 feet_m = app().feet_m();
        for (Frame& door : frames_) {
            const Aabb& box_m = door.box_m;
            const bool faces_north = box_m.max_m.x - box_m.min_m.x > box_m.max_m.y - box_m.min_m.y;
            const Vec3 off_m = feet_m - box_m.centre_m();
            const int side = (faces_north ? off_m.y : off_m.x) > 0.0 ? 1 : -1;
            const bool in_frame = faces_north ? feet_m.x > box_m.min_m.x && feet_m.x < box_m.max_m.x
                                              : feet_m.y > box_m.min_m.y && feet_m.y < box_m.max_m.y;
            const bool on_storey = feet_m.z > box_m.min_m.z - 0.5 && feet_m.z < box_m.max_m.z;
            if (std::exchange(door.side, side) == -side && in_frame && on_storey) doors.push_back(door.name);
        }
    }

    SpeechSink& speech_;
    std::vector<double> pauses_s_;
    std::size_t next_pause_ = 0;
    std::function<void()> each_ms_;
    std::vector<Frame> frames_;
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

    // Returns the lines as the typist heard them.
    std::vector<Spoken> spoken() const {
        std::vector<Spoken> lines;
        for (const HeardSpeech& said : voice.lines())
            lines.push_back({said.time_s, said.utterance.text, in_full(said, now_s()), said.utterance.topic});
        return lines;
    }
    std::string all() const { return said_by(voice); }
};

}  // namespace handrail::test
