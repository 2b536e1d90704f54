// Simulates a person who has never been in the world and sees nothing. The newcomer presses keys by their names. It
// knows only what was announced and what it heard, in that order, and never reads the scene or the walker's position.
// From each sound, it learns what ears would: which sound it is, from which side it comes, and how muffled it is.
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
    // `hand` is absent, or the simulated hand of a device, which does not move.
    explicit Newcomer(std::shared_ptr<const Scene> world, const std::filesystem::path& records = {},
                      const HandFacts& hand = {});

    void wait(double seconds);
    void tap(const std::string& key, double then_s = 0.4);
    void hold(const std::string& key, double seconds);
    // Presses a key, and returns everything spoken after that as one text.
    std::string request(const std::string& key, double listen_s = 0.4);
    bool heard(const std::string& words, std::size_t since = 0) const;
    std::size_t lines() const { return speech_.lines().size(); }
    std::string line(std::size_t i) const { return speech_.lines()[i].utterance.text; }
    std::string last_lines(std::size_t count) const;
    double now_s() const { return session_->now_s(); }

    // Turns to the right by this many degrees, with the help of the announced heading.
    void turn(double right_deg);
    // Walks this many steps ahead. If something blocks the newcomer, walks fewer and returns true. Opens doors that it
    // meets and goes through them.
    bool walk(int steps);  // an edge blocks the newcomer, unless the directions lead over it
    // Follows one direction, such as "5 steps, 30 degrees right": turns and walks most of the distance. If the
    // directions say so, starts the lift in which it stands, or climbs the stairs at which it stands. Returns false if
    // the text contains neither distance nor direction.
    bool obey(const std::string& direction);

    // Opens a list by a key, reads all its entries one after the other, and leaves the list.
    std::vector<std::string> entries(const std::string& key);
    // Opens a list by a key. Returns the announcement of its first entry, or of the present one.
    std::string open_list(const std::string& key);
    // Opens a list by a key, and chooses the first entry that begins with `begin`. Returns what is said after that, or
    // an empty text if there is no such entry.
    std::string choose(const std::string& key, const std::string& begin);

    // Goes to a room: chooses it by name from the list of routes, then requests the next directions again and again.
    // Returns true when the arrival is announced. Returns false in front of a locked door, which locked() then
    // describes.
    bool go_to_room(const std::string& room);
    // Goes to a thing by its name, guided by words as to a room. That guidance is the second of the tools to find the
    // thing.
    bool go_by_words_to_thing(const std::string& thing);
    // Goes to a thing by its name: sets the beacon on the thing, and follows the beacon by ear until the arrival is
    // announced.
    bool go_to_thing(const std::string& thing);

    // What was said about the locked door that ended the last walk, and about its button. No value if the last walk did
    // not end at a locked door.
    struct Locked {
        std::string door, button, where;
    };
    const std::optional<Locked>& locked() const { return locked_; }

    // How the world's own sounds of one kind reach the ears: the source, its direction in degrees to the right, and the
    // loss through walls in decibels.
    struct Heard {
        std::uint32_t which = 0;
        double right_deg = 0.0, muffled_db = 0.0;
    };
    std::vector<Heard> listen_to(SoundKind kind) const;
    // Turns towards a sound and walks two steps.
    void obey_ears(double right_deg);

    // Only the test calls it, to check the newcomer's position. The newcomer itself does not use it.
    Vec3 feet_m() const { return session_->app().feet_m(); }

private:
    bool bumped_since(std::size_t sounds) const;
    bool door_ahead();
    void get_round();
    void ride();
    bool heard_of_lock(std::size_t since);
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
