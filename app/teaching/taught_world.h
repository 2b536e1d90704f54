// Looks up the names of a lesson in its world. Does so for all names before the lesson runs. One thread owns and
// queries the object. Finding the rooms takes from milliseconds to seconds.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/core/whereabouts/rooms_of_world.h"
#include "app/teaching/lesson_file.h"
#include "worlds/scene/scene.h"

namespace handrail::teaching {

struct TaughtPlace {
    std::string name;    // the name as announced
    Vec3 stand_m{0.0};   // where the learner stands at this place
    Vec3 middle_m{0.0};  // the target when the learner points to this place
    Aabb box_m{};        // bounding box of the object; empty for a room or another place
};

class TaughtWorld {
public:
    // Looks up everything in the lesson. Fails with file and line if an object, room or door is not in the world; the
    // message suggests the nearest name. Also fails if nobody can walk a route, or if blocked doors leave no route.
    // `checksum` is the present checksum of the world's file; empty: unknown. `rooms_kept` contains the rooms for all
    // sessions that will enter the same scene; null: the rooms are found for this lesson alone.
    static Result<std::shared_ptr<TaughtWorld>> find(LessonFile lesson, const std::shared_ptr<const Scene>& scene,
                                                     const std::string& checksum = {},
                                                     core::RoomsKept* rooms_kept = nullptr);

    const LessonFile& lesson() const { return lesson_; }
    const std::shared_ptr<const Scene>& scene() const { return scene_; }
    const TaughtPlace& base() const { return base_; }
    double base_heading_rad() const { return base_heading_rad_; }
    // Returns the place that is called `name`, which may be any name in the lesson, or the name of a room. Returns null
    // if there is no such place.
    const TaughtPlace* place(std::string_view name) const;
    // Returns the places at which a route stops.
    std::vector<TaughtPlace> stops_of(const LessonRoute& route) const;
    std::optional<FeatureId> door(std::string_view name) const;
    // `nearest` returns the most similar of all names that place() knows. `nearest_door` returns the most similar of
    // the names of doors.
    std::string nearest(std::string_view name) const;
    std::string nearest_door(std::string_view name) const;
    // Returns the walking route through all stops while the given doors are blocked.
    navigation::Route way(const Vec3& from_m, const std::vector<TaughtPlace>& stops,
                          const std::vector<FeatureId>& blocked = {});
    // Returns a sentence about what has changed in the world since the lesson was written; empty if nothing has.
    const std::string& news() const { return news_; }

private:
    TaughtWorld() = default;
    // Returns the candidate that `place` means. If there are several candidates, `place.place_m` must decide between
    // them; otherwise the function fails.
    Result<TaughtPlace> one_of(const LessonPlace& place, const std::vector<TaughtPlace>& candidates) const;
    Result<TaughtPlace> look_up(const LessonPlace& place) const;
    Result<void> know(const LessonPlace& place);
    Result<void> know_requested(const std::string& name, int line);
    Result<void> check_requested(const TaughtStep& step) const;
    Result<void> check_step(const TaughtStep& step);
    std::vector<std::string> names() const;
    // Returns each door, once for each of its names: its own name, its kind if no other door is of that kind, and the
    // rooms that it joins.
    std::vector<std::pair<std::string, FeatureId>> doors() const;
    std::vector<std::string> door_names() const;
    tl::unexpected<Error> bad(int line, const char* key, const std::string& name,
                              const std::vector<std::string>& known) const;

    LessonFile lesson_;
    std::shared_ptr<const Scene> scene_;
    std::unique_ptr<core::RoomsOfWorld> rooms_;
    TaughtPlace base_;
    double base_heading_rad_ = 0.0;
    std::map<std::string, TaughtPlace, std::less<>> places_;  // all known places; keys are names in lower case
    std::string news_;
};

}  // namespace handrail::teaching
