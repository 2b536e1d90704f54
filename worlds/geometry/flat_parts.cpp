#include "worlds/geometry/flat_parts.h"

#include <algorithm>
#include <map>

namespace handrail {
namespace {

constexpr double kSame_m = 1e-6;

double cross(const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; }

Ring without_repeats(const Ring& ring) {
    Ring kept;
    for (const Vec2& p : ring)
        if (kept.empty() || glm::length(p - kept.back()) > kSame_m) kept.push_back(p);
    while (kept.size() > 1 && glm::length(kept.front() - kept.back()) <= kSame_m) kept.pop_back();
    return kept;
}

// Returns the ring without corners that are on a straight line between their neighbours.
Ring tidied(const Ring& ring) {
    const Ring all = without_repeats(ring);
    Ring kept;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Vec2 in = all[i] - all[(i + all.size() - 1) % all.size()], out = all[(i + 1) % all.size()] - all[i];
        if (std::abs(cross(in, out)) > 1e-9 * glm::length(in) * glm::length(out) || glm::dot(in, out) < 0.0)
            kept.push_back(all[i]);
    }
    return kept;
}

// True if no corner turns right and all corners together make one full turn.
bool is_convex(const Ring& ring, double slack) {
    double turn = 0.0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vec2 in = ring[(i + 1) % ring.size()] - ring[i],
                   out = ring[(i + 2) % ring.size()] - ring[(i + 1) % ring.size()];
        const double c = cross(in, out);
        if (c < -slack * glm::length(in) * glm::length(out)) return false;
        turn += std::atan2(c, glm::dot(in, out));
    }
    return std::abs(turn - 2.0 * kPi) < 0.1;
}

struct Edge {
    Vec2 left{0.0}, right{0.0};
    double at(double x) const { return left.y + (right.y - left.y) * (x - left.x) / (right.x - left.x); }
};

// A trapezoid between two edges and two lines parallel to the y axis.
struct Trapezoid {
    std::size_t low = 0, high = 0;
    double from = 0.0, to = 0.0;
};

std::vector<Edge> upright_free_edges(const std::vector<Ring>& rings) {
    std::vector<Edge> edges;
    for (const Ring& ring : rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Vec2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
            if (std::abs(a.x - b.x) <= kSame_m) continue;
            edges.push_back(a.x < b.x ? Edge{a, b} : Edge{b, a});
        }
    return edges;
}

// Returns the x coordinates where edges begin, end or cross. Coordinates within kSame_m of each other are treated as
// one.
std::vector<double> lines_of(const std::vector<Edge>& edges) {
    std::vector<double> lines;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        lines.push_back(edges[i].left.x);
        lines.push_back(edges[i].right.x);
        for (std::size_t j = 0; j < i; ++j) {
            const double from = std::max(edges[i].left.x, edges[j].left.x),
                         to = std::min(edges[i].right.x, edges[j].right.x);
            if (!(from < to)) continue;
            const double a = edges[i].at(from) - edges[j].at(from), b = edges[i].at(to) - edges[j].at(to);
            if ((a > kSame_m && b < -kSame_m) || (a < -kSame_m && b > kSame_m))
                lines.push_back(from + (to - from) * a / (a - b));
        }
    }
    std::sort(lines.begin(), lines.end());
    lines.erase(std::unique(lines.begin(), lines.end(), [](double a, double b) { return b - a <= kSame_m; }),
                lines.end());
    return lines;
}

// Makes the union of two polygons that share an edge. Returns false if they share none or the union is not convex.
bool joined(const Ring& a, const Ring& b, Ring& both) {
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < b.size(); ++j) {
            const Vec2 &a0 = a[i], &a1 = a[(i + 1) % a.size()], &b0 = b[j], &b1 = b[(j + 1) % b.size()];
            if (glm::length(a0 - b1) > 2.0 * kSame_m || glm::length(a1 - b0) > 2.0 * kSame_m) continue;
            both.clear();
            for (std::size_t k = 1; k <= a.size(); ++k) both.push_back(a[(i + k) % a.size()]);
            for (std::size_t k = 2; k < b.size(); ++k) both.push_back(b[(j + k) % b.size()]);
            both = tidied(both);
            return both.size() >= 3 && is_convex(both, 1e-9);
        }
    return false;
}

void join_neighbours(std::vector<Ring>& parts) {
    constexpr std::size_t kMostTried = 400;
    if (parts.size() > kMostTried) return;
    for (std::size_t i = 0; i < parts.size(); ++i)
        for (std::size_t j = i + 1; j < parts.size();) {
            Ring both;
            if (!joined(parts[i], parts[j], both)) {
                ++j;
                continue;
            }
            parts[i] = std::move(both);
            parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(j));
            j = i + 1;  // tries all other parts again, because parts that could not be joined before may be joined now
        }
}

}  // namespace

double signed_area(const Ring& ring) {
    double twice = 0.0;
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) twice += cross(ring[i] - ring[0], ring[i + 1] - ring[0]);
    return 0.5 * twice;
}

bool inside(const std::vector<Ring>& rings, const Vec2& at) {
    bool in = false;
    for (const Ring& ring : rings)
        for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
            if ((ring[i].y > at.y) != (ring[j].y > at.y) &&
                at.x < (ring[j].x - ring[i].x) * (at.y - ring[i].y) / (ring[j].y - ring[i].y) + ring[i].x)
                in = !in;
    return in;
}

std::vector<Ring> convex_parts(const std::vector<Ring>& rings) {
    std::vector<Ring> good;
    std::size_t corners = 0;
    for (const Ring& ring : rings) {
        Ring kept = tidied(ring);
        corners += kept.size();
        if (kept.size() >= 3) good.push_back(std::move(kept));
    }
    if (good.empty() || corners > kMostCorners) return {};
    if (good.size() == 1) {
        if (signed_area(good[0]) < 0.0) std::reverse(good[0].begin(), good[0].end());
        if (is_convex(good[0], 1e-9)) return good;
    }
    const std::vector<Edge> edges = upright_free_edges(good);
    const std::vector<double> lines = lines_of(edges);
    std::vector<Trapezoid> all, open;
    for (std::size_t k = 0; k + 1 < lines.size(); ++k) {
        const double from = lines[k], to = lines[k + 1], middle = 0.5 * (from + to);
        std::vector<std::pair<double, std::size_t>> across;
        for (std::size_t e = 0; e < edges.size(); ++e)
            if (edges[e].left.x < middle && edges[e].right.x > middle) across.emplace_back(edges[e].at(middle), e);
        std::sort(across.begin(), across.end());
        std::vector<Trapezoid> next;
        for (std::size_t i = 0; i + 1 < across.size(); i += 2) {
            Trapezoid made{across[i].second, across[i + 1].second, from, to};
            const auto before = std::find_if(
                open.begin(), open.end(), [&](const Trapezoid& o) { return o.low == made.low && o.high == made.high; });
            if (before != open.end()) {
                made.from = before->from;
                open.erase(before);
            }
            next.push_back(made);
        }
        all.insert(all.end(), open.begin(), open.end());
        open = std::move(next);
    }
    all.insert(all.end(), open.begin(), open.end());
    std::vector<Ring> parts;
    for (const Trapezoid& t : all) {
        const Edge &low = edges[t.low], &high = edges[t.high];
        Ring part =
            tidied({{t.from, low.at(t.from)}, {t.to, low.at(t.to)}, {t.to, high.at(t.to)}, {t.from, high.at(t.from)}});
        if (part.size() >= 3 && signed_area(part) > 1e-8) parts.push_back(std::move(part));
    }
    join_neighbours(parts);
    return parts;
}

namespace {

// The borders of rings as a graph of corners. If two borders run in opposite directions along the same line, both are
// removed.
class RingNet {
public:
    void add(const Ring& ring) {
        for (const Vec2& p : ring) corner(p);
        rings_.push_back(ring);
    }

    std::vector<Ring> joined() {
        for (const Ring& ring : rings_)
            for (std::size_t i = 0; i < ring.size(); ++i)
                add_side(corner(ring[i]), corner(ring[(i + 1) % ring.size()]));
        std::vector<Ring> made;
        for (auto& [from, ends] : ways_)
            while (!ends.empty())
                if (Ring ring = tidied(chain(from)); ring.size() > 2 && std::abs(signed_area(ring)) > kLeastRing_m2)
                    made.push_back(std::move(ring));
        std::stable_sort(made.begin(), made.end(), [](const Ring& a, const Ring& b) {
            return std::abs(signed_area(a)) > std::abs(signed_area(b));
        });
        return made;
    }

private:
    static constexpr double kOneCorner_m = 1e-3, kLeastRing_m2 = 1e-4;

    std::size_t corner(const Vec2& at) {
        for (std::size_t i = 0; i < corners_.size(); ++i)
            if (glm::length(corners_[i] - at) <= kOneCorner_m) return i;
        corners_.push_back(at);
        return corners_.size() - 1;
    }

    // A side is cut at every corner that is on it, including corners of other rings.
    void add_side(std::size_t from, std::size_t to) {
        const Vec2 a = corners_[from], way = corners_[to] - a;
        const double length = glm::length(way);
        if (length <= kOneCorner_m) return;
        std::vector<std::pair<double, std::size_t>> on{{0.0, from}, {length, to}};
        for (std::size_t i = 0; i < corners_.size(); ++i) {
            const Vec2 off = corners_[i] - a;
            const double along = glm::dot(off, way) / length;
            if (i != from && i != to && along > kOneCorner_m && along < length - kOneCorner_m &&
                std::abs(cross(way, off)) / length <= kOneCorner_m)
                on.emplace_back(along, i);
        }
        std::sort(on.begin(), on.end());
        for (std::size_t i = 1; i < on.size(); ++i) add_piece(on[i - 1].second, on[i].second);
    }

    void add_piece(std::size_t from, std::size_t to) {
        std::vector<std::size_t>& back = ways_[to];
        if (const auto there = std::find(back.begin(), back.end(), from); there != back.end()) back.erase(there);
        else ways_[from].push_back(to);
    }

    // Follows the borders from a corner until it returns to that corner. At a fork it follows the leftmost border.
    Ring chain(std::size_t from) {
        Ring ring;
        std::size_t now = from;
        Vec2 way{0.0};
        do {
            std::vector<std::size_t>& ends = ways_[now];
            if (ends.empty()) return {};
            auto take = ends.begin();
            double most = -1e300;
            for (auto end = ends.begin(); end != ends.end(); ++end) {
                const Vec2 next = corners_[*end] - corners_[now];
                const double turn = ring.empty() ? 0.0 : std::atan2(cross(way, next), glm::dot(way, next));
                if (turn > most) most = turn, take = end;
            }
            const std::size_t to = *take;
            ends.erase(take);
            ring.push_back(corners_[now]);
            way = corners_[to] - corners_[now];
            now = to;
        } while (now != from);
        return ring;
    }

    std::vector<Vec2> corners_;
    std::vector<Ring> rings_;
    std::map<std::size_t, std::vector<std::size_t>> ways_;  // borders as a graph: from each corner to the next corners
};

}  // namespace

std::vector<Ring> joined_rings(const std::vector<Ring>& rings) {
    std::size_t corners = 0;
    for (const Ring& ring : rings) corners += ring.size();
    if (rings.size() < 2 || corners > kMostCorners) return rings;
    RingNet net;
    for (std::size_t i = 0; i < rings.size(); ++i) {
        const std::vector<Ring> parts = convex_parts({rings[i]});
        if (parts.empty()) continue;
        Vec2 within{0.0};
        for (const Vec2& p : parts[0]) within += p / static_cast<double>(parts[0].size());
        int around = 0;
        for (std::size_t k = 0; k < rings.size(); ++k) around += k != i && inside({rings[k]}, within) ? 1 : 0;
        Ring ring = rings[i];
        // A ring runs counter-clockwise, or clockwise if an odd number of other rings surround it.
        if ((signed_area(ring) > 0.0) != (around % 2 == 0)) std::reverse(ring.begin(), ring.end());
        net.add(ring);
    }
    return net.joined();
}

}  // namespace handrail
