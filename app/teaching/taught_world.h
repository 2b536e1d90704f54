// A lesson in its world: what it names, looked up there before anything runs. Owned and asked by one thread; finding
// the rooms takes from milliseconds to seconds.
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

namespace handrail {

struct TaughtPlace {
    std::string name;    // as it is told
    Vec3 stand_m{0.0};   // where one stands there
    Vec3 middle_m{0.0};  // what one points at
    Aabb box_m{};        // all of a thing; empty: of a room or a place
};

class TaughtWorld {
public:
    // Fails with file and line where a thing, room or door is not in the world (the nearest name is told), nobody can
    // walk a route, or a block leaves no way. checksum: of the world's file now; empty: unknown.
    static Result<std::shared_ptr<TaughtWorld>> find(LessonFile lesson, const std::shared_ptr<const Scene>& scene,
                                                     const std::string& checksum = {});

    const LessonFile& lesson() const { return lesson_; }
    const std::shared_ptr<const Scene>& scene() const { return scene_; }
    const TaughtPlace& base() const { return base_; }
    double base_heading_rad() const { return base_heading_rad_; }
    // By any name of the lesson, or of a room; null: there is none.
    const TaughtPlace* place(std::string_view name) const;
    // Its stops.
    std::vector<TaughtPlace> stops_of(const LessonRoute& route) const;
    std::optional<FeatureId> door(std::string_view name) const;
    // What is called most like it, of all that place() knows, and of the doors.
    std::string nearest(std::string_view name) const;
    std::string nearest_door(std::string_view name) const;
    // On foot through all of these, with doors blocked.
    Route way(const Vec3& from_m, const std::vector<TaughtPlace>& stops, const std::vector<FeatureId>& blocked = {});
    // A sentence on what is not as it was when the lesson was written; empty: nothing.
    const std::string& news() const { return news_; }

private:
    TaughtWorld() = default;
    // The place that is meant of those that `place` may name; fails if there are several and nothing says which.
    Result<TaughtPlace> one_of(const LessonPlace& place, const std::vector<TaughtPlace>& candidates) const;
    Result<TaughtPlace> look_up(const LessonPlace& place) const;
    Result<void> know(const LessonPlace& place);
    Result<void> know_asked(const std::string& name, int line);
    Result<void> check_asked(const TaughtStep& step) const;
    Result<void> check_step(const TaughtStep& step);
    std::vector<std::string> names() const;
    // Each by its own name, by its kind where it is the only one, and by the rooms that it joins.
    std::vector<std::pair<std::string, FeatureId>> doors() const;
    std::vector<std::string> door_names() const;
    tl::unexpected<Error> bad(int line, const char* key, const std::string& name,
                              const std::vector<std::string>& known) const;

    LessonFile lesson_;
    std::shared_ptr<const Scene> scene_;
    std::unique_ptr<RoomsOfWorld> rooms_;
    TaughtPlace base_;
    double base_heading_rad_ = 0.0;
    std::map<std::string, TaughtPlace, std::less<>> places_;  // by name in lower case
    std::string news_;
};

}  // namespace handrail
