// A simulated person who has never been there and sees nothing. It presses keys by their names, and knows only what was
// announced to it and what it heard, in that order. It never looks into the scene or at the walker's position. From
// sounds it learns what ears would: which sound, from which side, how muffled.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/core/session/headless_session.h"
#include "audio-cues/sinks/recording_sinks.h"
#include "tests/support/heard_legs.h"
#include "tests/support/names.h"

namespace handrail::test {

class Newcomer {
public:
    // `hand`: none, or the simulated hand of a device, which stays where it is.
    explicit Newcomer(std::shared_ptr<const Scene> world, const std::filesystem::path& records = {},
                      const HandFacts& hand = {});

    void wait(double seconds);
    void tap(const std::string& key, double then_s = 0.4);
    void hold(const std::string& key, double seconds);
    // Returns everything spoken after a key, in one text.
    std::string ask(const std::string& key, double listen_s = 0.4);
    bool heard(const std::string& words, std::size_t since = 0) const;
    std::size_t lines() const { return speech_.lines().size(); }
    std::string line(std::size_t i) const { return speech_.lines()[i].utterance.text; }
    std::string last_lines(std::size_t count) const;
    double now_s() const { return session_->now_s(); }

    // Turns to the right by this many degrees, using the announced heading.
    void turn(double right_deg);
    // Walks this many steps ahead, or fewer if something is in the way, and then returns true. Opens doors that it
    // meets and goes through them.
    bool walk(int steps);  // an edge counts as an obstacle, unless the directions lead over it
    // Obeys one direction, such as "5 steps, 30 degrees right": turns and walks most of it. If the directions say so,
    // it starts the lift in which it stands, or takes the stairs at which it stands. Returns false if the text has
    // neither distance nor direction.
    bool obey(const std::string& direction);

    // Reads all entries of the list that a key opens, one after the other, and leaves the list.
    std::vector<std::string> entries(const std::string& key);
    // Opens the list and chooses the first entry with this beginning. Returns what is said then; empty if there is no
    // such entry.
    std::string choose(const std::string& key, const std::string& begin);

    // Course to a room by its name: chooses it from the list of routes, then requests the next directions again and
    // again. Returns true when the arrival is announced, and false also in front of a locked door, which `locked` then
    // describes.
    bool go_to_room(const std::string& room);
    // Course to a thing by its name, guided by words as to a room: the second of the ways to find it.
    bool go_by_words_to_thing(const std::string& thing);
    // Course to a thing by its name: sets the beacon on it and follows that by ear until the arrival is announced.
    bool go_to_thing(const std::string& thing);

    // What was said about the locked door that ended the last walk, and about its button; none if no such door did.
    struct Locked {
        std::string door, button, where;
    };
    const std::optional<Locked>& locked() const { return locked_; }

    // How the world's own sounds of one kind reach the ears: which source, degrees to the right, and decibels lost on
    // the path through walls.
    struct Heard {
        std::uint32_t which = 0;
        double right_deg = 0.0, muffled_db = 0.0;
    };
    std::vector<Heard> listen_to(SoundKind kind) const;
    // Turns towards a sound and walks two steps.
    void obey_ears(double right_deg);

    // For the test that judges the newcomer, who does not know this.
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
