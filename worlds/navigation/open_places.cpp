#include "worlds/navigation/open_places.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <map>
#include <numeric>
#include <unordered_map>

#include "worlds/navigation/stated_rooms.h"
#include "worlds/scene/outer_ground.h"

namespace handrail::navigation {
namespace {

// A place is a doorway if the walker's centre has less clearance than this, as in an opening of at most 1.2 m.
constexpr double kDoorwayClear_m = 0.35;
// The clearance in a doorway must also be less than this fraction of the clearance on both sides.
constexpr double kDoorwayShare = 0.6;
constexpr double kWideShare = 0.5;  // the fraction for an opening that is wider than a doorway
constexpr double kLeastPiece_m2 = 0.3, kLeastWide_m2 = 4.0;
constexpr double kHuge_m2 = 150.0, kHugeShare = 0.75, kLeastOfHuge_m2 = 10.0;
// Greatest width of a rim without a wall, in radii of the walker. A corner makes it wider than one radius.
constexpr double kRim = 1.5;
constexpr double kRimLevel_m = 0.3;  // beyond a rim, another floor is at least this much higher or lower
constexpr double kLong = 6.0;        // an area longer than this many times its greatest width is split into corridors

bool is_plain(const WallSpan& s) { return !s.door && !s.stairs && !s.liquid; }

class PlaceFinder {
public:
    PlaceFinder(const Scene& scene, const SpanGrid<WallSpan>& walls, double cell_area_m2, double radius_m,
                const std::stop_token& stop)
        : scene_(scene), walls_(walls), cell_area_m2_(cell_area_m2), radius_m_(radius_m), stop_(stop) {}

    OpenPlaces find() {
        stated_ = scene_.stated ? stated_rooms_of(*scene_.stated, walls_)
                                : std::vector<std::uint32_t>(walls_.spans.size(), kNothing);
        add_rims();
        watershed();
        if (stop_.stop_requested()) return {};
        label_basins();
        label_stated();
        label_outside();
        part_long_ones();
        return std::move(places_);
    }

private:
    struct Basin {
        double peak_m = 0.0;
        std::size_t cells = 0;
        std::uint32_t name = kNothing;  // name of the basin: index in Scene::room_names
    };
    // Returns whether span `s` is plain floor that is in no room of the file.
    bool open(std::uint32_t s) const { return is_plain(walls_.spans[s]) && stated_[s] == kNothing; }
    double area(std::size_t cells) const { return static_cast<double>(cells) * cell_area_m2_; }
    double wide_m(std::uint32_t s) const { return static_cast<double>(walls_.spans[s].clearance_m); }
    std::uint32_t& place(std::uint32_t s) { return places_.of_span[s]; }

    std::uint32_t add_place(std::string name) {
        places_.names.push_back(std::move(name));
        return static_cast<std::uint32_t>(places_.names.size() - 1);
    }

    std::uint32_t root(std::uint32_t s) {
        while (parent_[s] != s) s = parent_[s] = parent_[parent_[s]];
        return s;
    }
    Basin& basin(std::uint32_t root) { return basins_[place(root)]; }

    bool cut(const Basin& a, const Basin& b, std::uint32_t at) const {
        if (a.name != kNothing && b.name != kNothing)
            return scene_.room_names[a.name].name != scene_.room_names[b.name].name;
        const double s = wide_m(at), peak = std::min(a.peak_m, b.peak_m), least = area(std::min(a.cells, b.cells)),
                     both = area(a.cells + b.cells);
        if (both > kHuge_m2 && s <= kHugeShare * peak && least >= kLeastOfHuge_m2) return true;
        const bool doorway = s < kDoorwayClear_m && s <= kDoorwayShare * peak && least >= kLeastPiece_m2;
        const bool wide = s <= kWideShare * peak && least >= kLeastWide_m2;
        return doorway || wide;
    }

    // Returns the spans, widest first. Each entry has the inverted width in its upper half and the span in its lower
    // half. Sorting such whole numbers takes a third of the time.
    std::vector<std::uint64_t> by_width() const {
        std::vector<std::uint64_t> order;
        order.reserve(walls_.spans.size());
        for (std::uint32_t s = 0; s < walls_.spans.size(); ++s)
            if (open(s))
                order.push_back(std::uint64_t{~std::bit_cast<std::uint32_t>(walls_.spans[s].clearance_m)} << 32 | s);
        std::sort(order.begin(), order.end());
        return order;
    }

    // Assigns each name that the file gives to a place to the widest span near that place.
    std::unordered_map<std::uint32_t, std::uint32_t> names_at_peaks() const {
        std::unordered_map<std::uint32_t, std::uint32_t> names;  // never iterated
        for (std::uint32_t k = 0; k < scene_.room_names.size(); ++k) {
            const RoomName& given = scene_.room_names[k];
            std::uint32_t s = walls_.nearest(given.at_m, 1.5, 1.0, 3.0);
            if (s == kNothing || given.name.empty()) continue;
            for (bool higher = true; higher;) {
                higher = false;
                for (const std::uint32_t n : walls_.spans[s].next)
                    if (n != kNothing && is_plain(walls_.spans[n]) && wide_m(n) > wide_m(s)) {
                        s = n;
                        higher = true;
                        break;
                    }
            }
            names.try_emplace(s, k);
        }
        return names;
    }

    // Floods from the widest spans to the narrowest. If only a narrow spot connects two areas, they become separate
    // places.
    void watershed() {
        const std::vector<std::uint64_t> order = by_width();
        const std::unordered_map<std::uint32_t, std::uint32_t> names = names_at_peaks();
        parent_.resize(walls_.spans.size());
        std::iota(parent_.begin(), parent_.end(), 0U);
        // While the flood runs, the entry of of_span is the number of the basin for each root, and kMet for every other
        // visited span.
        constexpr std::uint32_t kMet = kNothing - 1;
        places_.of_span.assign(walls_.spans.size(), kNothing);
        for (std::size_t k = 0; k < order.size(); ++k) {
            if ((k & 0xffff) == 0 && stop_.stop_requested()) return;
            const auto s = static_cast<std::uint32_t>(order[k]);
            const auto given = names.find(s);
            const std::uint32_t name = given == names.end() ? kNothing : given->second;
            // Sorts the neighbours by width. A span on a border then joins the widest basin.
            std::array<std::uint32_t, 4> around = {kNothing, kNothing, kNothing, kNothing};
            std::size_t count = 0;
            for (const std::uint32_t n : walls_.spans[s].next)
                if (n != kNothing && open(n) && place(n) != kNothing) around[count++] = root(n);
            for (std::size_t i = 1; i < count; ++i)
                for (std::size_t j = i; j > 0 && basin(around[j]).peak_m > basin(around[j - 1]).peak_m; --j)
                    std::swap(around[j], around[j - 1]);
            if (count == 0) {
                place(s) = static_cast<std::uint32_t>(basins_.size());
                basins_.push_back({wide_m(s), 1, name});
                continue;
            }
            // This span is narrower than all spans before it, so it becomes part of its widest neighbour's basin.
            place(s) = kMet;
            parent_[s] = around[0];
            basin(around[0]).cells += 1;
            if (basin(around[0]).name == kNothing) basin(around[0]).name = name;
            for (std::size_t i = 1; i < count; ++i) {
                const std::uint32_t a = root(s), b = root(around[i]);
                if (a == b || cut(basin(a), basin(b), s)) continue;
                // The basin with the wider peak absorbs the other one.
                const std::uint32_t keep = basin(a).peak_m > basin(b).peak_m ? a : b, gone = keep == a ? b : a;
                parent_[gone] = keep;
                basin(keep).cells += basin(gone).cells;
                if (basin(keep).name == kNothing) basin(keep).name = basin(gone).name;
                place(gone) = kMet;
            }
        }
    }

    // Makes each basin a place, in the order of its first span.
    void label_basins() {
        std::vector<std::uint32_t> label(basins_.size(), kNothing);
        for (std::uint32_t s = 0; s < walls_.spans.size(); ++s) {
            if (!open(s)) continue;
            std::uint32_t& made = label[place(root(s))];
            if (made != kNothing) continue;
            const std::uint32_t name = basin(root(s)).name;
            made = add_place(name == kNothing ? std::string() : scene_.room_names[name].name);
        }
        for (std::uint32_t s = 0; s < walls_.spans.size(); ++s) parent_[s] = root(s);
        for (const bool roots : {false, true})
            for (std::uint32_t s = 0; s < walls_.spans.size(); ++s)
                if (open(s) && (parent_[s] == s) == roots) place(s) = label[place(parent_[s])];
        std::vector<std::uint32_t>().swap(parent_);
    }

    // Adds the rims of floors without walls, such as platforms, to the rooms of the file. The middle of a walker can be
    // up to the walker's radius beyond the edge of a floor, where no room of the file is. Without this function, the
    // strip along the edge of a long platform would become dozens of rooms.
    void add_rims() {
        std::vector<std::uint32_t> added;
        const auto add_next_to = [&](std::uint32_t s) {
            for (const std::uint32_t n : walls_.spans[s].next)
                if (n != kNothing && open(n) && is_rim(scene_.stated->rooms[stated_[s]], n)) {
                    stated_[n] = stated_[s];
                    added.push_back(n);
                }
        };
        for (std::uint32_t s = 0; s < stated_.size(); ++s)
            if (stated_[s] != kNothing) add_next_to(s);
        for (std::size_t i = 0; i < added.size(); ++i) add_next_to(added[i]);
    }

    // Returns whether the span is near the outline of the room, and no floor continues beyond it.
    bool is_rim(const StatedRoom& room, std::uint32_t s) const {
        const Vec3 place_m = walls_.place_m(s);
        Vec2 out(1e9);  // from the nearest point of the outline to the span
        for (const std::vector<Vec2>& ring : room.rings)
            for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
                const Vec2 along = ring[i] - ring[j], off = Vec2(place_m) - ring[j];
                const double share =
                    std::clamp(glm::dot(off, along) / std::max(glm::dot(along, along), 1e-12), 0.0, 1.0);
                if (glm::length(off - along * share) < glm::length(out)) out = off - along * share;
            }
        const double far_m = glm::length(out), most_m = kRim * radius_m_;
        if (far_m < 1e-9 || far_m > most_m) return false;
        const Vec3 beyond_m = place_m + Vec3(out * (most_m / far_m), 0.0);
        return walls_.nearest(beyond_m, 0.0, kRimLevel_m, kRimLevel_m) == kNothing;
    }

    // Makes each room that the file states one place, even if something divides its floor.
    void label_stated() {
        places_.of_stated.assign(scene_.stated ? scene_.stated->rooms.size() : 0, kNothing);
        for (std::uint32_t s = 0; s < stated_.size(); ++s) {
            if (stated_[s] == kNothing || !is_plain(walls_.spans[s])) continue;
            std::uint32_t& made = places_.of_stated[stated_[s]];
            if (made == kNothing) made = add_place(scene_.stated->rooms[stated_[s]].name);
            place(s) = made;
        }
    }

    // Makes the ground that the reader added outside one place, from all spans at its height. If most of a place is at
    // that height, the rest of that place, such as ledges and thresholds, is also outside.
    void label_outside() {
        const auto ground = std::find_if(scene_.features.begin(), scene_.features.end(), is_outer_ground);
        if (!scene_.stated || ground == scene_.features.end()) return;
        std::vector<std::uint32_t> level(places_.names.size(), 0), rest(places_.names.size(), 0);
        const auto lies_level = [&](std::uint32_t s) {
            return std::abs(walls_.place_m(s).z - ground->bounds_m.max_m.z) <= 0.005;
        };
        for (std::uint32_t s = 0; s < stated_.size(); ++s)
            if (place(s) != kNothing && stated_[s] == kNothing) ++(lies_level(s) ? level : rest)[place(s)];
        if (std::all_of(level.begin(), level.end(), [](std::uint32_t count) { return count == 0; })) return;
        places_.outside = add_place({});
        for (std::uint32_t s = 0; s < stated_.size(); ++s)
            if (const std::uint32_t l = place(s);
                l != kNothing && stated_[s] == kNothing && (lies_level(s) || level[l] > rest[l]))
                place(s) = places_.outside;
    }

    // Splits long places that are nowhere wide into corridors. Such a place turns and branches, but no doorway divides
    // it. Each straight stretch becomes a separate place.
    void part_long_ones() {
        const std::vector<bool> parts = long_places();
        if (std::none_of(parts.begin(), parts.end(), [](bool p) { return p; }) || stop_.stop_requested()) return;
        std::vector<std::uint32_t> stretch = stretches_of(parts);
        join_crumbs(stretch);
        std::map<std::uint32_t, std::uint32_t> label;
        // For each place: true once one of its stretches has kept the label of the place.
        std::vector<bool> kept(parts.size(), false);
        for (std::uint32_t s = 0; s < stretch.size(); ++s) {
            if (stretch[s] == kNothing) continue;
            const auto [found, is_new] = label.try_emplace(stretch[s], place(s));
            if (is_new && kept[place(s)]) found->second = add_place({});
            else if (is_new) kept[place(s)] = true;
            place(s) = found->second;
        }
    }

    std::vector<bool> long_places() {
        const std::size_t count = places_.names.size();
        std::vector<std::size_t> cells(count, 0);
        std::vector<double> widest_m(count, 0.0);
        for (std::uint32_t s = 0; s < places_.of_span.size(); ++s)
            if (const std::uint32_t l = place(s); l != kNothing) {
                ++cells[l];
                widest_m[l] = std::max(widest_m[l], 2.0 * (wide_m(s) + radius_m_));
            }
        std::vector<bool> parts(count, false);
        for (std::size_t l = 0; l < count; ++l)
            parts[l] = l != places_.outside && places_.names[l].empty() && area(cells[l]) > kHuge_m2 &&
                       area(cells[l]) > kLong * widest_m[l] * widest_m[l];
        return parts;
    }

    // Returns the number of the straight stretch of each span in these places. Two rows of spans cross in each span,
    // one from west to east and one from south to north. The longer one determines the stretch. A row never leaves its
    // place.
    std::vector<std::uint32_t> stretches_of(const std::vector<bool>& parts) {
        const std::vector<std::uint32_t> east = runs(0, 2), north = runs(1, 3);
        const auto along = [&](std::uint32_t s) { return east[s] >= north[s]; };
        std::vector<std::uint32_t> stretch(places_.of_span.size(), kNothing), left;
        std::uint32_t count = 0;
        for (std::uint32_t s = 0; s < stretch.size(); ++s) {
            if (place(s) == kNothing || !parts[place(s)] || stretch[s] != kNothing) continue;
            left.assign(1, s);
            stretch[s] = count++;
            while (!left.empty()) {
                const std::uint32_t here = left.back();
                left.pop_back();
                for (const std::uint32_t n : walls_.spans[here].next)
                    if (n != kNothing && place(n) == place(s) && stretch[n] == kNothing && along(n) == along(s)) {
                        stretch[n] = stretch[s];
                        left.push_back(n);
                    }
            }
        }
        return stretch;
    }

    using Borders = std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t>;

    // Joins recesses, and the fragments along slanting walls, to the stretch with which they have the longest common
    // border.
    void join_crumbs(std::vector<std::uint32_t>& stretch) {
        std::vector<std::size_t> size;
        for (int round = 0; round < 8 && !stop_.stop_requested(); ++round) {
            const Borders borders = measure(stretch, size);
            bool any = false;
            std::vector<std::uint32_t> goes(size.size());
            for (std::uint32_t part = 0; part < size.size(); ++part) {
                const bool crumb = size[part] > 0 && area(size[part]) < kLeastOfHuge_m2;
                goes[part] = crumb ? longest_border(part, borders, size) : part;
                any = any || goes[part] != part;
            }
            if (!any) return;
            for (std::uint32_t& part : stretch)
                if (part != kNothing) part = goes[part];
        }
    }

    // For each stretch, counts its cells and the cells that border on another stretch of the same place.
    Borders measure(const std::vector<std::uint32_t>& stretch, std::vector<std::size_t>& size) {
        Borders borders;
        std::fill(size.begin(), size.end(), 0);
        for (std::uint32_t s = 0; s < stretch.size(); ++s) {
            if (stretch[s] == kNothing) continue;
            if (stretch[s] >= size.size()) size.resize(stretch[s] + 1, 0);
            ++size[stretch[s]];
            for (const std::uint32_t n : walls_.spans[s].next)
                if (n != kNothing && stretch[n] != kNothing && stretch[n] != stretch[s] && place(n) == place(s))
                    ++borders[{stretch[s], stretch[n]}];
        }
        return borders;
    }

    // Returns the larger stretch that has the longest common border with `part`. If several borders are equally long,
    // returns the first of these stretches. Returns `part` itself if there is no larger stretch.
    static std::uint32_t longest_border(std::uint32_t part, const Borders& borders,
                                        const std::vector<std::size_t>& size) {
        std::size_t longest = 0;
        std::uint32_t best = part;
        for (auto it = borders.lower_bound({part, 0}); it != borders.end() && it->first.first == part; ++it) {
            const std::uint32_t other = it->first.second;
            const bool smaller = size[other] < size[part] || (size[other] == size[part] && other > part);
            if (smaller || it->second <= longest) continue;
            longest = it->second;
            best = other;
        }
        return best;
    }

    // For each cell of a place, counts how many cells of that place are in one row with it, in the directions `way` and
    // `back`.
    std::vector<std::uint32_t> runs(std::size_t way, std::size_t back) {
        const auto on = [&](std::uint32_t s, std::size_t to) {
            const std::uint32_t n = walls_.spans[s].next[to];
            return n != kNothing && place(n) == place(s) && walls_.spans[n].next[(to + 2) % 4] == s ? n : kNothing;
        };
        std::vector<std::uint32_t> length(places_.of_span.size(), 0), row;
        for (std::uint32_t s = 0; s < length.size(); ++s) {
            if (place(s) == kNothing || on(s, back) != kNothing) continue;
            row.clear();
            for (std::uint32_t at = s; at != kNothing; at = on(at, way)) row.push_back(at);
            for (const std::uint32_t at : row) length[at] = static_cast<std::uint32_t>(row.size());
        }
        return length;
    }

    const Scene& scene_;
    const SpanGrid<WallSpan>& walls_;
    const double cell_area_m2_, radius_m_;
    const std::stop_token& stop_;
    OpenPlaces places_;
    std::vector<std::uint32_t> stated_;  // for each span: the room that the file states there
    std::vector<std::uint32_t> parent_;  // for each span, the next one towards the root of its basin
    std::vector<Basin> basins_;
};

}  // namespace

OpenPlaces open_places(const Scene& scene, const SpanGrid<WallSpan>& walls, double cell_area_m2, double radius_m,
                       const std::stop_token& stop) {
    return PlaceFinder(scene, walls, cell_area_m2, radius_m, stop).find();
}

}  // namespace handrail::navigation
