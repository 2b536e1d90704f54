// Somebody who has never been there and sees nothing: presses keys by their names and knows what was spoken and what
// was heard, in the order in which it came. Never looks into the scene or at where the body is. The sounds tell what
// ears tell: which sound, from which side, how muffled.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/core/session/headless_session.h"
#include "audio-cues/sinks/recording_sinks.h"
#include "tests/support/heard_legs.h"

namespace handrail::test {

class Newcomer {
public:
    // hand: none, or the simulated hand of a device; it rests where it is.
    explicit Newcomer(std::shared_ptr<const Scene> world, const std::filesystem::path& records = {},
                      const HandFacts& hand = {});

    void wait(double seconds);
    void tap(const std::string& key, double then_s = 0.4);
    void hold(const std::string& key, double seconds);
    // What is spoken after a key, all of it in one text.
    std::string ask(const std::string& key, double listen_s = 0.4);
    bool heard(const std::string& words, std::size_t since = 0) const;
    std::size_t lines() const { return speech_.lines().size(); }
    std::string line(std::size_t i) const { return speech_.lines()[i].utterance.text; }
    std::string last_lines(std::size_t count) const;
    double now_s() const { return session_->now_s(); }

    // Turns by so many degrees to the right, by asking for the heading.
    void turn(double right_deg);
    // So many steps ahead; less where something is met, and then true. Doors that are met are opened and gone through.
    bool walk(int steps);  // an edge counts as met, unless the way that was told leads over it
    // Obeys one direction, "5 steps, 30 degrees right": turns and walks most of it; makes the lift go that one is told
    // to stand in, and takes the stairs that one is told to stand at. False: it says neither distance nor direction.
    bool obey(const std::string& direction);

    // All entries of a list that a key opens, read one after the other; the list is left again.
    std::vector<std::string> entries(const std::string& key);
    // Opens the list and chooses the first entry that begins so. What is said then; empty: there is none.
    std::string choose(const std::string& key, const std::string& begin);

    // To a room by its name: chosen from the list of ways, then asked again and again where the way goes on. True when
    // it is told that one is there; false before a locked door too, which `locked` then tells of.
    bool go_to_room(const std::string& room);
    // To a thing by its name, in words as to a room: the second of the ways to find it.
    bool go_by_words_to_thing(const std::string& thing);
    // To a thing by its name: the beacon is set on it and followed by ear until it is told that one is there.
    bool go_to_thing(const std::string& thing);

    // What was told of the locked door that ended the last way, and of its button; none: no such door did.
    struct Locked {
        std::string door, button, where;
    };
    const std::optional<Locked>& locked() const { return locked_; }

    // How the world's own sounds of a kind come to the ears: which of them, degrees to the right, and decibels lost on
    // the way through walls.
    struct Heard {
        std::uint32_t which = 0;
        double right_deg = 0.0, muffled_db = 0.0;
    };
    std::vector<Heard> listen_to(SoundKind kind) const;
    // Turns to where something is heard and goes two steps.
    void obey_ears(double right_deg);

    // For whoever judges the newcomer, who does not know it.
    Vec3 feet_m() const { return session_->app().feet_m(); }

private:
    bool bumped_since(std::size_t sounds) const;
    bool door_ahead();
    void get_round();
    void ride();
    bool told_of_lock(std::size_t since);
    bool follow_words_to(const std::string& goal, std::size_t since);
    double right_of_ears_deg(const Vec3& place_m) const;
    double heading_deg();

    RecordingAudio audio_;
    RecordingSpeech speech_;
    std::unique_ptr<HeadlessSession> session_;
    int met_ = 0;
    bool over_edges_ = false;
    std::optional<Locked> locked_;
};

}  // namespace handrail::test
