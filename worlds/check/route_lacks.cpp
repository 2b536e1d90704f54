#include "worlds/check/route_lacks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <queue>
#include <utility>

#include "worlds/navigation/reach.h"

namespace handrail::check {
namespace {

constexpr double kTallEnough = 0.5, kThinEnough = 0.2, kHigher_m = 0.6;

// The best routes from one place to every other place. For each span, `worth` is the worth of the worst place on the
// route to that span, and `worst` is that worst place.
struct BestRoutes {
    std::vector<double> worth;
    std::vector<std::uint32_t> worst;  // kNothing if there is no route
};

// `worth_of(from, to)` returns the worth of the step from the span `from` to the span `to`.
template <class Worth>
BestRoutes best_routes(const navigation::WalkSpace& space, std::uint32_t first, const Worth& worth_of) {
    BestRoutes best{std::vector<double>(space.spans.size(), -std::numeric_limits<double>::infinity()),
                    std::vector<std::uint32_t>(space.spans.size(), navigation::kNothing)};
    const std::vector<std::vector<std::uint32_t>> leads_to = navigation::spans_led_to(space);
    struct Open {
        double worth;
        std::uint32_t span;
        // The queue returns the highest worth first, and the lower span if two are equal.
        bool operator<(const Open& other) const {
            return worth < other.worth || (worth == other.worth && span > other.span);
        }
    };
    std::priority_queue<Open> open;
    best.worth[first] = std::numeric_limits<double>::infinity();
    best.worst[first] = first;
    open.push({best.worth[first], first});
    while (!open.empty()) {
        const Open here = open.top();
        open.pop();
        if (here.worth < best.worth[here.span]) continue;
        const auto go = [&](std::uint32_t next, double step) {
            const double worth = std::min(here.worth, step);
            if (!(worth > best.worth[next])) return;
            best.worth[next] = worth;
            best.worst[next] = step < here.worth ? next : best.worst[here.span];
            open.push({worth, next});
        };
        for (const std::uint32_t next : space.spans[here.span].next)
            if (next != navigation::kNothing) go(next, worth_of(here.span, next));
        for (const std::uint32_t next : leads_to[here.span]) go(next, here.worth);
    }
    return best;
}

std::uint32_t place_in(const navigation::WalkSpace& space, const Vec3& at_m) {
    return space.nearest(at_m, 1.0, 0.6, 1.0);
}

// Finds what the best routes of a walker lack. It tries smaller bodies, and bodies that climb higher, and follows their
// best routes. On these routes it measures what the walker lacks. Each kind of lack is tested only for the places that
// have no answer yet.
class Search {
public:
    Search(const Scene& scene, const navigation::WalkerMeasures& body, const Vec3& from_m,
           std::span<const Vec3> places_m, std::optional<navigation::WalkTrial::Stretch> within, std::stop_token stop)
        : scene_(scene),
          body_(body),
          from_m_(from_m),
          places_m_(places_m),
          within_(within),
          stop_(std::move(stop)),
          found_(places_m.size()) {}

    std::vector<RouteLacks> find(std::span<const Lack> kinds) {
        navigation::WalkerMeasures any = low();
        any.radius_m = thin().radius_m;
        any.step_up_m = climbing().step_up_m;
        // If even a body that is low and thin and climbs high cannot reach any of the places, walls are the reason, so
        // no other walkable space is needed.
        if (kinds.size() > 1 && !comes_to_any(any)) return std::move(found_);
        for (const Lack kind : kinds) look(kind);
        return std::move(found_);
    }

private:
    navigation::WalkerMeasures low() const {
        navigation::WalkerMeasures body = body_;
        body.height_m *= kTallEnough;
        return body;
    }
    navigation::WalkerMeasures thin() const {
        navigation::WalkerMeasures body = body_;
        body.radius_m *= kThinEnough;
        return body;
    }
    navigation::WalkerMeasures climbing() const {
        navigation::WalkerMeasures body = body_;
        body.step_up_m += kHigher_m;
        return body;
    }

    // True if a walker with these measures reaches at least one of the places.
    bool comes_to_any(const navigation::WalkerMeasures& body) const {
        const Result<navigation::WalkSpace> space = navigation::make_trial_space(scene_, body, {false, within_}, stop_);
        const std::uint32_t first = space ? place_in(*space, from_m_) : navigation::kNothing;
        if (first == navigation::kNothing) return false;
        const std::vector<bool> reached = navigation::spans_reached(*space, first);
        return std::any_of(places_m_.begin(), places_m_.end(), [&](const Vec3& at_m) {
            const std::uint32_t span = place_in(*space, at_m);
            return span != navigation::kNothing && reached[span];
        });
    }

    void look(Lack kind) {
        switch (kind) {
            case Lack::Headroom:
                // The clear height between two spans is measured from the higher floor to the lower ceiling.
                return look(kind, low(), body_.height_m,
                            [](const navigation::WalkSpace& space, std::uint32_t from, std::uint32_t to) {
                                const navigation::WalkSpan &a = space.spans[from], &b = space.spans[to];
                                return static_cast<double>(std::min(a.ceiling_m, b.ceiling_m)) -
                                       static_cast<double>(std::max(a.floor_m, b.floor_m)) + space.body.height_m;
                            });
            case Lack::Step:
                return look(kind, climbing(), -body_.step_up_m,
                            [](const navigation::WalkSpace& space, std::uint32_t from, std::uint32_t to) {
                                return -std::abs(static_cast<double>(space.spans[from].floor_m) -
                                                 static_cast<double>(space.spans[to].floor_m));
                            });
            case Lack::Width:
                return look(kind, thin(), 2.0 * body_.radius_m,
                            [](const navigation::WalkSpace& space, std::uint32_t, std::uint32_t to) {
                                return 2.0 * (space.body.radius_m + static_cast<double>(space.spans[to].clearance_m));
                            });
            case Lack::Nothing:
            case Lack::Things:
                return;
        }
    }

    template <class Worth>
    void look(Lack lack, const navigation::WalkerMeasures& body, double least, const Worth& worth_in) {
        if (std::all_of(found_.begin(), found_.end(), [](const RouteLacks& f) { return f.lack != Lack::Nothing; }))
            return;
        const Result<navigation::WalkSpace> space =
            navigation::make_trial_space(scene_, body, {lack == Lack::Width, within_}, stop_);
        const std::uint32_t first = space ? place_in(*space, from_m_) : navigation::kNothing;
        if (first == navigation::kNothing) return;
        const BestRoutes ways = best_routes(
            *space, first, [&](std::uint32_t from, std::uint32_t to) { return worth_in(*space, from, to); });
        for (std::size_t i = 0; i < places_m_.size(); ++i) {
            const std::uint32_t span = place_in(*space, places_m_[i]);
            if (found_[i].lack != Lack::Nothing || span == navigation::kNothing ||
                ways.worst[span] == navigation::kNothing)
                continue;
            if (ways.worth[span] >= least) continue;
            found_[i] = {lack, std::abs(ways.worth[span]), std::abs(least), space->place_m(ways.worst[span])};
        }
    }

    const Scene& scene_;
    navigation::WalkerMeasures body_;
    Vec3 from_m_;
    std::span<const Vec3> places_m_;
    std::optional<navigation::WalkTrial::Stretch> within_;
    std::stop_token stop_;
    std::vector<RouteLacks> found_;
};

}  // namespace

std::string_view word_of(Lack lack) {
    constexpr std::array<std::string_view, 5> kWords{"nothing", "headroom", "step", "width", "things"};
    return kWords[static_cast<std::size_t>(lack)];
}

std::vector<RouteLacks> route_lacks(const Scene& scene, const navigation::WalkSpace& space, const Vec3& from_m,
                                    std::span<const Vec3> places_m, std::span<const Lack> kinds,
                                    const std::stop_token& stop) {
    if (places_m.empty()) return {};
    return Search(scene, space.body, from_m, places_m, std::nullopt, stop).find(kinds);
}

RouteLacks route_lacks_within(const Scene& scene, const navigation::WalkSpace& space, const Vec3& from_m,
                              const Vec3& place_m, const Aabb& box_m, std::span<const Lack> kinds) {
    const std::array places_m{place_m};
    return Search(scene, space.body, from_m, places_m, navigation::WalkTrial::Stretch{from_m, box_m}, {})
        .find(kinds)[0];
}

}  // namespace handrail::check
