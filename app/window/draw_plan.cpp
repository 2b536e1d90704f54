#include "app/window/draw_plan.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/window/large_text.h"
#include "worlds/base/language.h"

namespace handrail::window {
namespace {

constexpr ImU32 kWallColour = IM_COL32(200, 200, 200, 255);

ImVec2 im(const Vec2& p) { return {static_cast<float>(p.x), static_cast<float>(p.y)}; }

// Returns the rooms on the storey as indices into ViewState::rooms. The smallest comes first, except that the current
// room is the last.
std::vector<std::size_t> rooms_of_storey(const core::ViewState& view) {
    std::vector<std::size_t> rooms;
    if (!view.rooms) return rooms;
    for (std::size_t r = 0; r < view.rooms->size(); ++r)
        if (const core::DrawnRoom& room = (*view.rooms)[r];
            r == view.room || (room.outline.lowest_m < view.feet_m.z + plan::kPlanCutAboveFeet_m &&
                               room.outline.highest_m > view.feet_m.z - plan::kPlanDeep_m))
            rooms.push_back(r);
    std::stable_sort(rooms.begin(), rooms.end(), [&](std::size_t a, std::size_t b) {
        return std::pair(a == view.room, (*view.rooms)[a].area_m2) <
               std::pair(b == view.room, (*view.rooms)[b].area_m2);
    });
    return rooms;
}

// Draws the name of each room white on black in the middle of the room. The name of the current room is inverted. If
// names would cover each other or the walker, a name moves up or down or becomes smaller. If that does not suffice, the
// name is left out, except that of the current room. Names of larger rooms are placed first.
void draw_room_names(ImDrawList& list, ImFont& font, const PlanLayout& layout, const core::ViewState& view,
                     float unit_px) {
    const std::vector<std::size_t> rooms = rooms_of_storey(view);
    const Vec2 feet = layout.to_pixels(view.feet_m);
    const float walker_px = 5.0F * unit_px;
    std::vector<std::pair<ImVec2, ImVec2>> taken{
        {{static_cast<float>(feet.x) - walker_px, static_cast<float>(feet.y) - walker_px},
         {static_cast<float>(feet.x) + walker_px, static_cast<float>(feet.y) + walker_px}}};
    for (auto at = rooms.rbegin(); at != rooms.rend(); ++at) {
        const core::DrawnRoom& room = (*view.rooms)[*at];
        const bool here = *at == view.room;
        const ImVec2 middle = im(layout.to_pixels(room.middle_m));
        const auto place = [&](float text_px, float moved, std::vector<std::string_view>& lines, ImVec2& from,
                               ImVec2& to) {
            lines = wrapped_lines(font, text_px, room.name, 6.0F * text_px);
            float wide = 0.0F;
            for (const std::string_view line : lines)
                wide =
                    std::max(wide, font.CalcTextSizeA(text_px, 1e9F, 0.0F, line.data(), line.data() + line.size()).x);
            const float edge = 0.5F * unit_px, high = text_px * static_cast<float>(lines.size());
            from = {middle.x - 0.5F * wide - edge, middle.y + (moved - 0.5F) * high - edge};
            to = {middle.x + 0.5F * wide + edge, middle.y + (moved + 0.5F) * high + edge};
            return std::none_of(taken.begin(), taken.end(), [&](const auto& other) {
                return from.x < other.second.x && other.first.x < to.x && from.y < other.second.y &&
                       other.first.y < to.y;
            });
        };
        std::vector<std::string_view> lines;
        ImVec2 from, to;
        float text_px = 0.0F;
        bool free = false;
        for (const float size : {5.0F, 4.0F, 3.0F}) {
            text_px = size * unit_px;
            for (const float moved : {0.0F, 1.0F, -1.0F, 2.0F, -2.0F})
                if ((free = place(text_px, moved, lines, from, to))) break;
            if (free) break;
        }
        if (!free && here) place(text_px = 5.0F * unit_px, 1.5F, lines, from, to);
        else if (!free) continue;
        taken.emplace_back(from, to);
        const ImU32 white = IM_COL32(255, 255, 255, 255), black = IM_COL32(0, 0, 0, 255);
        list.AddRectFilled(from, to, here ? white : black);
        for (std::size_t i = 0; i < lines.size(); ++i)
            list.AddText(&font, text_px,
                         {from.x + 0.5F * unit_px, from.y + 0.5F * unit_px + static_cast<float>(i) * text_px},
                         here ? black : white, lines[i].data(), lines[i].data() + lines[i].size());
    }
}

void draw_hand(ImDrawList& list, const PlanLayout& layout, const core::ViewState& view, float unit_px) {
    if (!view.show_hand) return;
    const ImVec2 at = im(layout.to_pixels(view.proxy_m));
    const float radius_px = 1.2F * unit_px;
    if (view.touching) list.AddCircleFilled(at, 2.0F * radius_px, IM_COL32(255, 255, 255, 255));
    list.AddCircleFilled(at, 1.3F * radius_px, IM_COL32(0, 0, 0, 255));
    list.AddCircleFilled(at, radius_px, view.touching ? IM_COL32(255, 13, 13, 255) : IM_COL32(13, 255, 51, 255));
}

// Draws the walker as an arrow that points where the walker faces.
void draw_walker(ImDrawList& list, const PlanLayout& layout, const core::ViewState& view, float unit_px) {
    const ImVec2 at = im(layout.to_pixels(view.feet_m));
    const double turn = view.heading_rad - layout.turn_rad;
    const auto corner = [&](double forward, double right, float scale) {
        return ImVec2(at.x + scale * static_cast<float>(forward * std::sin(turn) + right * std::cos(turn)),
                      at.y + scale * static_cast<float>(-forward * std::cos(turn) + right * std::sin(turn)));
    };
    for (const auto& [scale, colour] :
         {std::pair(6.6F * unit_px, IM_COL32(0, 0, 0, 255)), std::pair(4.8F * unit_px, IM_COL32(255, 255, 0, 255))}) {
        list.AddTriangleFilled(corner(1.0, 0.0, scale), corner(-0.6, 0.6, scale), corner(-0.3, 0.0, scale), colour);
        list.AddTriangleFilled(corner(1.0, 0.0, scale), corner(-0.3, 0.0, scale), corner(-0.6, -0.6, scale), colour);
    }
}

void draw_scale_and_north(ImDrawList& list, ImFont& font, const PlanLayout& layout, float unit_px) {
    const ImU32 white = IM_COL32(255, 255, 255, 255), black = IM_COL32(0, 0, 0, 255);
    const float text_px = 6.0F * unit_px;
    const ScaleBar bar = scale_bar(layout.pixels_per_m, 0.25 * (layout.box.max_px.x - layout.box.min_px.x));
    const float length_px = static_cast<float>(bar.length_m * layout.pixels_per_m);
    const ImVec2 text_size = font.CalcTextSizeA(text_px, 1e9F, 0.0F, bar.words.c_str());
    const ImVec2 start(2.0F * unit_px, static_cast<float>(layout.box.max_px.y) - 3.0F * unit_px);
    list.AddRectFilled({0.0F, start.y - text_px - 2.0F * unit_px},
                       {start.x + std::max(length_px, text_size.x) + 2.0F * unit_px, start.y + 3.0F * unit_px}, black);
    list.AddLine(start, {start.x + length_px, start.y}, white, unit_px);
    for (const float x : {start.x, start.x + length_px})
        list.AddLine({x, start.y - 1.5F * unit_px}, {x, start.y + 1.5F * unit_px}, white, 0.6F * unit_px);
    list.AddText(&font, text_px, {start.x, start.y - text_px - 1.5F * unit_px}, white, bar.words.c_str());

    // The tip of the needle points north.
    const ImVec2 middle(static_cast<float>(layout.box.max_px.x) - 8.0F * unit_px, 8.0F * unit_px);
    const auto needle = [&](double along, double across) {
        return ImVec2(middle.x + unit_px * static_cast<float>(across * std::cos(layout.turn_rad) -
                                                              along * std::sin(layout.turn_rad)),
                      middle.y - unit_px * static_cast<float>(along * std::cos(layout.turn_rad) +
                                                              across * std::sin(layout.turn_rad)));
    };
    list.AddCircleFilled(middle, 7.5F * unit_px, black);
    list.AddCircle(middle, 7.5F * unit_px, white, 0, 2.0F);
    list.AddTriangleFilled(needle(6.5, 0.0), needle(1.0, 2.0), needle(1.0, -2.0), white);
    const std::string north = phrase("window.north");
    const ImVec2 letter = font.CalcTextSizeA(text_px, 1e9F, 0.0F, north.c_str());
    const ImVec2 below = needle(-2.5, 0.0);
    list.AddText(&font, text_px, {below.x - 0.5F * letter.x, below.y - 0.5F * letter.y}, white, north.c_str());
}

}  // namespace

void PlanDrawing::cut(const core::ViewState& view) {
    const Scene& scene = *view.scene;
    free_.assign(scene.placed.size(), false);
    for (std::size_t i = 0; i < scene.placed.size(); ++i)
        free_[i] = std::any_of(scene.bodies.begin(), scene.bodies.end(),
                               [&](const FreeBody& body) { return body.feature == scene.placed[i].feature; });
    cut_ = plan::cut_plan(scene, view.feet_m.z, [&](std::size_t thing) {
        return free_[thing] ? std::nullopt : std::optional(scene.placed[thing].at);
    });
}

void PlanDrawing::draw(const core::ViewState& view, ImFont& font, PixelSize picture) {
    const PixelBox box{Vec2(0.0), Vec2(picture.width, picture.height)};
    const PlanLayout layout = lay_out_plan(view.scene->bounds_m, view.feet_m, view.heading_rad, view.north_up, box);
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.PushClipRect({0.0F, 0.0F}, im(box.max_px));
    // Compute the plan's cut again after a step up or down, but not after each of the small height changes on a slope.
    if (!cut_ || std::abs(cut_->feet_height_m - view.feet_m.z) > 0.1) cut(view);
    for (const plan::PlanShape& shape : cut_->shapes) draw_shape(list, layout, shape);
    const auto where_free = [&](std::size_t thing) -> std::optional<Placement> {
        if (!free_[thing]) return std::nullopt;
        const auto moved = std::find_if(view.moved.begin(), view.moved.end(),
                                        [&](const core::MovedThing& one) { return one.thing == thing; });
        return moved == view.moved.end() ? view.scene->placed[thing].at : moved->at;
    };
    for (const plan::PlanShape& shape : plan::cut_things(*view.scene, view.feet_m.z, where_free))
        draw_shape(list, layout, shape);
    for (const auto& [a, b] : cut_->sheets_m)
        list.AddLine(im(layout.to_pixels(a)), im(layout.to_pixels(b)), kWallColour, 3.0F);

    const float unit_px = static_cast<float>(picture.height) / 100.0F;
    draw_room_outlines(list, layout, view, unit_px);
    points_.clear();
    for (const Vec3& step : view.path_m) points_.push_back(im(layout.to_pixels(step)));
    if (!points_.empty()) {
        points_.push_back(im(layout.to_pixels(view.feet_m)));
        list.AddPolyline(points_.data(), static_cast<int>(points_.size()), IM_COL32(0, 255, 255, 255), 0,
                         std::max(2.0F, 0.6F * unit_px));
    }
    draw_hand(list, layout, view, unit_px);
    draw_walker(list, layout, view, unit_px);
    draw_room_names(list, font, layout, view, unit_px);
    draw_scale_and_north(list, font, layout, unit_px);
    list.PopClipRect();
}

// Draws a shape of the plan. Kinds of shapes differ in filling and outline:
// - floors are dark, and walls are filled;
// - objects are darker with a light border;
// - doors have a cross and no filling, and movers have no filling;
// - liquids are hatched, and low things have thin outlines.
void PlanDrawing::draw_shape(ImDrawList& list, const PlanLayout& layout, const plan::PlanShape& shape) {
    // ImGui smooths borders correctly if the corners are clockwise as seen. They are, because the y axis is flipped.
    points_.clear();
    Aabb bounds_px;
    for (const Vec2& p : shape.outline_m) {
        const Vec2 q = layout.to_pixels(p);
        bounds_px.include(Vec3(q, 0.0));
        points_.push_back(im(q));
    }
    if (bounds_px.max_m.x < layout.box.min_px.x || bounds_px.min_m.x > layout.box.max_px.x ||
        bounds_px.max_m.y < layout.box.min_px.y || bounds_px.min_m.y > layout.box.max_px.y)
        return;
    std::reverse(points_.begin(), points_.end());
    const int count = static_cast<int>(points_.size());
    const ImU32 white = IM_COL32(255, 255, 255, 255), black = IM_COL32(0, 0, 0, 255);
    switch (shape.kind) {
        case plan::PlanKind::Floor:
            list.AddConvexPolyFilled(points_.data(), count, IM_COL32(34, 42, 66, 255));
            break;
        case plan::PlanKind::Wall:
            list.AddConvexPolyFilled(points_.data(), count, kWallColour);
            break;
        case plan::PlanKind::Object:
            list.AddConvexPolyFilled(points_.data(), count, IM_COL32(130, 100, 60, 255));
            list.AddPolyline(points_.data(), count, white, ImDrawFlags_Closed, 2.0F);
            break;
        case plan::PlanKind::Door:
            list.AddConvexPolyFilled(points_.data(), count, black);
            list.AddPolyline(points_.data(), count, IM_COL32(255, 240, 120, 255), ImDrawFlags_Closed, 3.0F);
            for (int i = 0; i < count / 2; ++i)
                list.AddLine(points_[static_cast<std::size_t>(i)], points_[static_cast<std::size_t>(i + count / 2)],
                             IM_COL32(255, 240, 120, 255), 2.0F);
            break;
        case plan::PlanKind::Mover:
            list.AddConvexPolyFilled(points_.data(), count, black);
            list.AddPolyline(points_.data(), count, IM_COL32(190, 230, 255, 255), ImDrawFlags_Closed, 3.0F);
            break;
        case plan::PlanKind::Liquid:
            draw_hatch(list, bounds_px);
            break;
        case plan::PlanKind::Low:
            list.AddPolyline(points_.data(), count, IM_COL32(150, 150, 150, 255), ImDrawFlags_Closed, 2.5F);
            break;
    }
}

// Draws the outlines of the rooms on the storey. Draws the outline of the current room last and three times as thick.
// All outlines are white on black, like everything important on the plan.
void PlanDrawing::draw_room_outlines(ImDrawList& list, const PlanLayout& layout, const core::ViewState& view,
                                     float unit_px) {
    for (const std::size_t r : rooms_of_storey(view)) {
        const float thick_px = (r == view.room ? 1.2F : 0.4F) * unit_px;
        for (const std::vector<Vec2>& loop : (*view.rooms)[r].outline.loops_m) {
            points_.clear();
            for (const Vec2& corner : loop) points_.push_back(im(layout.to_pixels(corner)));
            const int count = static_cast<int>(points_.size());
            list.AddPolyline(points_.data(), count, IM_COL32(0, 0, 0, 255), ImDrawFlags_Closed,
                             thick_px + 0.6F * unit_px);
            list.AddPolyline(points_.data(), count, IM_COL32(255, 255, 255, 255), ImDrawFlags_Closed, thick_px);
        }
    }
}

// Draws horizontal lines across the shape in points_.
void PlanDrawing::draw_hatch(ImDrawList& list, const Aabb& bounds_px) {
    const ImU32 colour = IM_COL32(90, 170, 255, 255);
    list.AddPolyline(points_.data(), static_cast<int>(points_.size()), colour, ImDrawFlags_Closed, 2.0F);
    for (double y = std::ceil(bounds_px.min_m.y / 6.0) * 6.0; y < bounds_px.max_m.y; y += 6.0) {
        float from = std::numeric_limits<float>::infinity(), to = -from;
        for (std::size_t i = 0; i < points_.size(); ++i) {
            const ImVec2 a = points_[i], b = points_[(i + 1) % points_.size()];
            if ((a.y > y) == (b.y > y)) continue;
            const float x = a.x + (static_cast<float>(y) - a.y) / (b.y - a.y) * (b.x - a.x);
            from = std::min(from, x);
            to = std::max(to, x);
        }
        if (from < to) list.AddLine({from, static_cast<float>(y)}, {to, static_cast<float>(y)}, colour, 1.0F);
    }
}

}  // namespace handrail::window
