#include "app/window/draw_plan.h"

#include <algorithm>
#include <cmath>

#include "app/window/drawn_colour.h"
#include "app/window/force_arrow.h"
#include "app/window/plan_labels.h"
#include "worlds/base/language.h"

namespace handrail::window {
namespace {

// The outlines of rooms are a walker's radius inside the walls; the ground of rooms continues this far beyond them.
constexpr double kBeyondOutline_m = 0.35;

ImVec2 im(const Vec2& p) { return {static_cast<float>(p.x), static_cast<float>(p.y)}; }

LabelBox box_around(const ImVec2& middle, float half_px) {
    return {{middle.x - half_px, middle.y - half_px}, {middle.x + half_px, middle.y + half_px}};
}

void draw_label(ImDrawList& list, ImFont& font, const PlacedLabel& label, const Palette& palette, float unit_px) {
    const ImU32 text = colour_of(palette.text), ground = colour_of(palette.ground);
    list.AddRectFilled(label.box.from, label.box.to, label.inverted ? text : ground);
    for (std::size_t i = 0; i < label.lines.size(); ++i)
        list.AddText(&font, label.text_px,
                     {label.box.from.x + 0.5F * unit_px,
                      label.box.from.y + 0.5F * unit_px + static_cast<float>(i) * label.text_px},
                     label.inverted ? ground : text, label.lines[i].c_str());
}

// Returns the names in the order of their importance: the present room, the beacon, the marks, then rooms by size.
std::vector<Label> labels_of(const core::ViewState& view, const PlanLayout& layout) {
    std::vector<Label> labels;
    std::vector<std::size_t> rooms = rooms_of_storey(view);
    std::stable_sort(rooms.begin(), rooms.end(), [&](std::size_t a, std::size_t b) {
        return std::pair(a == view.room, (*view.rooms)[a].area_m2) >
               std::pair(b == view.room, (*view.rooms)[b].area_m2);
    });
    const auto add_room = [&](std::size_t r) {
        const bool here = r == view.room;
        labels.push_back({(*view.rooms)[r].name, im(layout.to_pixels((*view.rooms)[r].middle_m)), here});
    };
    const bool here = !rooms.empty() && rooms.front() == view.room;
    if (here) add_room(rooms.front());
    if (view.guidance.goal)
        labels.push_back({view.guidance.goal->name, im(layout.to_pixels(view.guidance.goal->place_m)), true});
    if (view.guidance.beacon)
        labels.push_back({view.guidance.beacon->name, im(layout.to_pixels(view.guidance.beacon->place_m))});
    for (const core::DrawnPlace& mark : view.guidance.marks)
        labels.push_back({mark.name, im(layout.to_pixels(mark.place_m))});
    for (std::size_t i = here ? 1 : 0; i < rooms.size(); ++i) add_room(rooms[i]);
    return labels;
}

void draw_hand(ImDrawList& list, const PlanLayout& layout, const core::ViewState& view, const Palette& palette,
               float unit_px) {
    const ImVec2 at = im(layout.to_pixels(view.proxy_m));
    const float radius_px = 1.2F * unit_px;
    if (view.touching) list.AddCircleFilled(at, 2.0F * radius_px, colour_of(palette.text));
    list.AddCircleFilled(at, 1.3F * radius_px, colour_of(palette.ground));
    list.AddCircleFilled(at, radius_px, colour_of(view.touching ? palette.touching : palette.hand));
    const Vec2 to = layout.to_pixels(view.proxy_m + view.force_n) - layout.to_pixels(view.proxy_m);
    if (const double length = glm::length(to); length > 1e-9)
        draw_force(list, at, im(to / length), glm::length(Vec2(view.force_n.x, view.force_n.y)), unit_px, palette);
}

// Draws the walker as an arrow that points where the walker faces.
void draw_walker(ImDrawList& list, const PlanLayout& layout, const core::ViewState& view, const Palette& palette,
                 float unit_px) {
    const ImVec2 at = im(layout.to_pixels(view.feet_m));
    const double turn = view.heading_rad - layout.turn_rad;
    const auto corner = [&](double forward, double right, float scale) {
        return ImVec2(at.x + scale * static_cast<float>(forward * std::sin(turn) + right * std::cos(turn)),
                      at.y + scale * static_cast<float>(-forward * std::cos(turn) + right * std::sin(turn)));
    };
    for (const auto& [scale, colour] :
         {std::pair(6.6F * unit_px, palette.ground), std::pair(4.8F * unit_px, palette.walker)}) {
        list.AddTriangleFilled(corner(1.0, 0.0, scale), corner(-0.6, 0.6, scale), corner(-0.3, 0.0, scale),
                               colour_of(colour));
        list.AddTriangleFilled(corner(1.0, 0.0, scale), corner(-0.3, 0.0, scale), corner(-0.6, -0.6, scale),
                               colour_of(colour));
    }
}

// Draws the parts of a labyrinth so that they differ without colour: the border as a double frame, holes as dark discs
// with a rim, goals as crosses, and the ball as a bright disc with a ring and a dot.
void draw_labyrinth(ImDrawList& list, const PlanLayout& layout, const core::ViewState& view, const Palette& palette,
                    float unit_px) {
    const Scene& scene = *view.scene;
    const auto corners = [&](const Aabb& box) {
        return std::pair(im(layout.to_pixels(box.min_m)), im(layout.to_pixels(box.max_m)));
    };
    for (const LabyrinthPlan::Place& hole : scene.labyrinth.holes) {
        const auto [a, b] = corners(hole.box_m);
        const ImVec2 middle(0.5F * (a.x + b.x), 0.5F * (a.y + b.y));
        const float radius = 0.5F * std::min(std::abs(b.x - a.x), std::abs(b.y - a.y));
        list.AddCircleFilled(middle, radius, colour_of(palette.ground));
        list.AddCircle(middle, radius, colour_of(palette.text), 0, 0.6F * unit_px);
    }
    for (const LabyrinthPlan::Place& goal : scene.labyrinth.goals) {
        const auto [a, b] = corners(goal.box_m);
        for (const auto& [wide, colour] :
             {std::pair(2.4F * unit_px, palette.ground), std::pair(1.2F * unit_px, palette.beacon)}) {
            list.AddLine(a, b, colour_of(colour), wide);
            list.AddLine({a.x, b.y}, {b.x, a.y}, colour_of(colour), wide);
        }
    }
    for (const FeatureId border : scene.labyrinth.borders) {
        const auto [a, b] = corners(scene.features[border.value].bounds_m);
        const ImVec2 from(std::min(a.x, b.x), std::min(a.y, b.y)), to(std::max(a.x, b.x), std::max(a.y, b.y));
        for (const float inside : {0.0F, 1.6F * unit_px})
            list.AddRect({from.x + inside, from.y + inside}, {to.x - inside, to.y - inside}, colour_of(palette.text),
                         0.0F, 0, 0.6F * unit_px);
    }
    const auto is_ball = [&](std::size_t thing) { return scene.placed[thing].feature == scene.labyrinth.ball; };
    for (std::size_t i = 0; i < scene.placed.size(); ++i) {
        if (!scene.labyrinth.there() || !is_ball(i)) continue;
        const auto moved = std::find_if(view.moved.begin(), view.moved.end(),
                                        [&](const core::MovedThing& one) { return one.thing == i; });
        const Placement& at = moved == view.moved.end() ? scene.placed[i].at : moved->at;
        const ImVec2 middle = im(layout.to_pixels(at.position_m));
        const double half_m = 0.5 * scene.placed[i].model->bounds_m.size_m().x * at.scale;
        const float radius = std::max(1.6F * unit_px, static_cast<float>(half_m * layout.pixels_per_m));
        list.AddCircleFilled(middle, radius, colour_of(palette.text));
        list.AddCircle(middle, radius + 0.8F * unit_px, colour_of(palette.ground), 0, 0.8F * unit_px);
        list.AddCircle(middle, radius + 1.4F * unit_px, colour_of(palette.text), 0, 0.5F * unit_px);
        list.AddCircleFilled(middle, 0.3F * radius, colour_of(palette.ground));
    }
}

// Draws the place of the beacon as three rings, a mark as a flag on a pole, and the end of the route as a square.
void draw_places(ImDrawList& list, const PlanLayout& layout, const core::ViewState& view, const Palette& palette,
                 float unit_px) {
    for (const core::DrawnPlace& mark : view.guidance.marks) {
        const ImVec2 foot = im(layout.to_pixels(mark.place_m)), top(foot.x, foot.y - 6.0F * unit_px);
        for (const auto& [wide, colour] :
             {std::pair(1.6F * unit_px, palette.ground), std::pair(0.6F * unit_px, palette.mark)}) {
            list.AddLine(foot, top, colour_of(colour), wide);
            list.AddTriangleFilled({top.x, top.y - 0.5F * wide}, {top.x + 3.5F * unit_px, top.y + 1.5F * unit_px},
                                   {top.x, top.y + 3.0F * unit_px + 0.5F * wide}, colour_of(colour));
        }
    }
    if (view.guidance.goal) {
        const ImVec2 end = im(layout.to_pixels(view.guidance.goal->place_m));
        for (const auto& [half, colour] :
             {std::pair(2.4F * unit_px, palette.ground), std::pair(1.8F * unit_px, palette.route)})
            list.AddRectFilled({end.x - half, end.y - half}, {end.x + half, end.y + half}, colour_of(colour));
    }
    if (!view.guidance.beacon) return;
    const ImVec2 at = im(layout.to_pixels(view.guidance.beacon->place_m));
    for (const float radius : {1.2F, 2.6F, 4.0F}) {
        list.AddCircle(at, radius * unit_px, colour_of(palette.ground), 0, 1.4F * unit_px);
        list.AddCircle(at, radius * unit_px, colour_of(palette.beacon), 0, 0.6F * unit_px);
    }
}

// Draws the scale bar at the bottom left and the north needle at the top right. Returns the boxes that they cover.
std::array<LabelBox, 2> draw_scale_and_north(ImDrawList& list, ImFont& font, const PlanLayout& layout,
                                             const Palette& palette, float unit_px) {
    const ImU32 text = colour_of(palette.text), ground = colour_of(palette.ground);
    const float text_px = 4.0F * unit_px;
    const ImVec2 min = im(layout.box.min_px), max = im(layout.box.max_px);
    const ScaleBar bar = scale_bar(layout.pixels_per_m, 0.25 * (layout.box.max_px.x - layout.box.min_px.x));
    const float length_px = static_cast<float>(bar.length_m * layout.pixels_per_m);
    const ImVec2 text_size = font.CalcTextSizeA(text_px, 1e9F, 0.0F, bar.words.c_str());
    const ImVec2 start(min.x + 2.0F * unit_px, max.y - 3.0F * unit_px);
    const LabelBox scale{{min.x, start.y - text_px - 2.0F * unit_px},
                         {start.x + std::max(length_px, text_size.x) + 2.0F * unit_px, max.y}};
    list.AddRectFilled(scale.from, scale.to, ground);
    list.AddLine(start, {start.x + length_px, start.y}, text, unit_px);
    for (const float x : {start.x, start.x + length_px})
        list.AddLine({x, start.y - 1.5F * unit_px}, {x, start.y + 1.5F * unit_px}, text, 0.6F * unit_px);
    list.AddText(&font, text_px, {start.x, start.y - text_px - 1.5F * unit_px}, text, bar.words.c_str());

    // The tip of the needle points north.
    const ImVec2 middle(max.x - 6.0F * unit_px, min.y + 6.0F * unit_px);
    const auto needle = [&](double along, double across) {
        return ImVec2(middle.x + unit_px * static_cast<float>(across * std::cos(layout.turn_rad) -
                                                              along * std::sin(layout.turn_rad)),
                      middle.y - unit_px * static_cast<float>(along * std::cos(layout.turn_rad) +
                                                              across * std::sin(layout.turn_rad)));
    };
    list.AddCircleFilled(middle, 5.5F * unit_px, ground);
    list.AddCircle(middle, 5.5F * unit_px, text, 0, 2.0F);
    list.AddTriangleFilled(needle(5.0, 0.0), needle(0.8, 1.6), needle(0.8, -1.6), text);
    const std::string north = phrase("window.north");
    const ImVec2 letter = font.CalcTextSizeA(text_px, 1e9F, 0.0F, north.c_str());
    const ImVec2 below = needle(-2.0, 0.0);
    list.AddText(&font, text_px, {below.x - 0.5F * letter.x, below.y - 0.5F * letter.y}, text, north.c_str());
    return {scale, box_around(middle, 5.5F * unit_px)};
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

void PlanDrawing::draw(const core::ViewState& view, ImFont& font, const PixelBox& box, float text_px) {
    palette_ = &palette_of(view.display.colours);
    unit_px_ = text_px / 5.0F;
    line_ = static_cast<float>(view.display.outline_width);
    const PlanLayout layout = lay_out_plan(plan_extent(view), view.camera_m.value_or(view.feet_m), view.heading_rad,
                                           view.north_up || view.camera_m, box);
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.PushClipRect(im(box.min_px), im(box.max_px));
    // Compute the plan's cut again after a step up or down, but not after each of the small height changes on a slope.
    if (!cut_ || std::abs(cut_->feet_height_m - view.feet_m.z) > 0.1) cut(view);
    draw_grounds(list, layout, view);
    for (const plan::PlanShape& shape : cut_->shapes)
        if (shape.kind != plan::PlanKind::Floor) draw_shape(list, layout, shape);
    const auto where_free = [&](std::size_t thing) -> std::optional<Placement> {
        if (!free_[thing]) return std::nullopt;
        const auto moved = std::find_if(view.moved.begin(), view.moved.end(),
                                        [&](const core::MovedThing& one) { return one.thing == thing; });
        return moved == view.moved.end() ? view.scene->placed[thing].at : moved->at;
    };
    for (const plan::PlanShape& shape : plan::cut_things(*view.scene, view.feet_m.z, where_free))
        draw_shape(list, layout, shape);
    for (const auto& [a, b] : cut_->sheets_m)
        list.AddLine(im(layout.to_pixels(a)), im(layout.to_pixels(b)), colour_of(palette_->wall), 3.0F * line_);
    draw_room_outlines(list, layout, view);
    draw_labyrinth(list, layout, view, *palette_, unit_px_);

    std::vector<Vec3> path_m = view.path_m;
    if (!path_m.empty()) path_m.push_back(view.feet_m);
    draw_line(list, layout, path_m, palette_->path, 0.6F, 0.0F);
    draw_line(list, layout, view.hand_path_m, palette_->hand_path, 0.4F, 0.8F);
    draw_line(list, layout, view.guidance.route_m, palette_->route, 1.0F, 3.0F);
    draw_places(list, layout, view, *palette_, unit_px_);
    if (view.show_hand) draw_hand(list, layout, view, *palette_, unit_px_);
    draw_walker(list, layout, view, *palette_, unit_px_);

    const auto scale_and_north = draw_scale_and_north(list, font, layout, *palette_, unit_px_);
    std::vector<LabelBox> signs(scale_and_north.begin(), scale_and_north.end());
    signs.push_back(box_around(im(layout.to_pixels(view.feet_m)), 5.0F * unit_px_));
    if (view.show_hand) signs.push_back(box_around(im(layout.to_pixels(view.proxy_m)), 3.0F * unit_px_));
    for (const core::DrawnPlace& mark : view.guidance.marks) {
        const ImVec2 foot = im(layout.to_pixels(mark.place_m));
        signs.push_back({{foot.x - unit_px_, foot.y - 7.0F * unit_px_}, {foot.x + 4.0F * unit_px_, foot.y}});
    }
    for (std::size_t i = 1; i < view.guidance.route_m.size(); ++i) {
        // Boxes along the route, so that no name covers it.
        const Vec2 a = layout.to_pixels(view.guidance.route_m[i - 1]), b = layout.to_pixels(view.guidance.route_m[i]);
        const double step = 2.0 * unit_px_, length = glm::distance(a, b);
        for (double t = 0.0; t <= length; t += step)
            signs.push_back(box_around(im(a + (length > 0.0 ? t / length : 0.0) * (b - a)), unit_px_));
    }
    if (view.guidance.beacon)
        signs.push_back(box_around(im(layout.to_pixels(view.guidance.beacon->place_m)), 4.5F * unit_px_));
    for (const PlacedLabel& label : place_labels(font, labels_of(view, layout), std::move(signs), box, unit_px_))
        draw_label(list, font, label, *palette_, unit_px_);
    list.PopClipRect();
}

// Fills the ground outside and inside the building. The inside is where rooms are, or the floors while no rooms are
// known. Rooms that the walker has visited are dotted.
void PlanDrawing::draw_grounds(ImDrawList& list, const PlanLayout& layout, const core::ViewState& view) {
    list.AddRectFilled(im(layout.box.min_px), im(layout.box.max_px), colour_of(palette_->outside));
    if (!view.rooms) {
        for (const plan::PlanShape& shape : cut_->shapes)
            if (shape.kind == plan::PlanKind::Floor) draw_shape(list, layout, shape);
        return;
    }
    const auto flags = list.Flags;
    list.Flags &= ~ImDrawListFlags_AntiAliasedFill;  // otherwise thin gaps would be visible between the rows
    const auto each_loop = [&](std::size_t r, const std::function<void()>& use) {
        for (const std::vector<Vec2>& loop : (*view.rooms)[r].outline.loops_m) {
            points_.clear();
            for (const Vec2& corner : loop) points_.push_back(im(layout.to_pixels(corner)));
            if (points_.size() >= 3) use();
        }
    };
    const ImU32 inside = colour_of(palette_->inside);
    const std::vector<std::size_t> rooms = rooms_of_storey(view);
    constexpr float kRow_px = 2.0F;
    for (const std::size_t r : rooms) {
        if ((*view.rooms)[r].outside) continue;
        each_loop(r, [&] {
            for_each_span(kRow_px, [&](float y, float from, float to) {
                list.AddRectFilled({from, y}, {to, y + kRow_px}, inside);
            });
            list.AddPolyline(points_.data(), static_cast<int>(points_.size()), inside, ImDrawFlags_Closed,
                             static_cast<float>(2.0 * kBeyondOutline_m * layout.pixels_per_m));
        });
    }
    const float step = std::max(4.0F, 2.0F * unit_px_), dot = std::max(1.0F, 0.3F * unit_px_);
    for (const std::size_t r : rooms) {
        if (r >= view.visited.size() || !view.visited[r]) continue;
        each_loop(r, [&] {
            for_each_span(step, [&](float y, float from, float to) {
                for (float x = std::ceil(from / step) * step; x < to; x += step)
                    list.AddRectFilled({x, y}, {x + dot, y + dot}, colour_of(palette_->room_outline));
            });
        });
    }
    list.Flags = flags;
}

// Draws a line with a border, in dashes if `dash_px` is not 0. Both widths are in units.
void PlanDrawing::draw_line(ImDrawList& list, const PlanLayout& layout, const std::vector<Vec3>& line_m,
                            const Rgb& colour, float wide, float dash) {
    if (line_m.size() < 2) return;
    const float wide_px = std::max(2.0F, wide * unit_px_ * line_), dash_px = dash * unit_px_;
    points_.clear();
    for (const Vec3& point : line_m) points_.push_back(im(layout.to_pixels(point)));
    const int count = static_cast<int>(points_.size());
    if (dash <= 0.0F) {
        list.AddPolyline(points_.data(), count, colour_of(colour), 0, wide_px);
        return;
    }
    list.AddPolyline(points_.data(), count, colour_of(palette_->ground), 0, wide_px + 0.8F * unit_px_);
    float along = 0.0F;
    for (std::size_t i = 1; i < points_.size(); ++i) {
        const ImVec2 a = points_[i - 1], b = points_[i];
        const float length = std::hypot(b.x - a.x, b.y - a.y);
        if (length < 1e-3F) continue;
        const auto at = [&](float t) { return ImVec2(a.x + (b.x - a.x) * t / length, a.y + (b.y - a.y) * t / length); };
        // The dashes continue across the corners of the line.
        for (float t = -std::fmod(along, 2.0F * dash_px); t < length; t += 2.0F * dash_px)
            if (t + dash_px > 0.0F)
                list.AddLine(at(std::max(0.0F, t)), at(std::min(length, t + dash_px)), colour_of(colour), wide_px);
        along += length;
    }
}

// Draws a shape of the plan. Kinds of shapes differ in filling and outline:
// - floors and walls are filled;
// - objects are filled and have an outline;
// - doors have a cross, and movers have an outline; both have the same filling;
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
    const auto fill = [&](const Rgb& colour) { list.AddConvexPolyFilled(points_.data(), count, colour_of(colour)); };
    const auto outline = [&](const Rgb& colour, float wide_px) {
        list.AddPolyline(points_.data(), count, colour_of(colour), ImDrawFlags_Closed, wide_px * line_);
    };
    switch (shape.kind) {
        case plan::PlanKind::Floor:
            fill(palette_->inside);
            break;
        case plan::PlanKind::Wall:
            fill(palette_->wall);
            break;
        case plan::PlanKind::Object:
            fill(palette_->object);
            outline(palette_->object_outline, 2.0F);
            break;
        case plan::PlanKind::Door:
            fill(palette_->door);
            outline(palette_->door_outline, 3.0F);
            for (int i = 0; i < count / 2; ++i)
                list.AddLine(points_[static_cast<std::size_t>(i)], points_[static_cast<std::size_t>(i + count / 2)],
                             colour_of(palette_->door_outline), 2.0F * line_);
            break;
        case plan::PlanKind::Mover:
            fill(palette_->door);
            outline(palette_->mover_outline, 3.0F);
            break;
        case plan::PlanKind::Liquid:
            draw_hatch(list);
            break;
        case plan::PlanKind::Low:
            outline(palette_->low, 2.5F);
            break;
    }
}

// Draws the outlines of the rooms on the storey. Draws the outline of the current room last and three times as thick.
// Each outline has a border in the colour of the ground.
void PlanDrawing::draw_room_outlines(ImDrawList& list, const PlanLayout& layout, const core::ViewState& view) {
    std::vector<std::size_t> rooms = rooms_of_storey(view);
    std::stable_partition(rooms.begin(), rooms.end(), [&](std::size_t r) { return r != view.room; });
    for (const std::size_t r : rooms) {
        const float thick_px = (r == view.room ? 1.2F : 0.4F) * unit_px_ * line_;
        for (const std::vector<Vec2>& loop : (*view.rooms)[r].outline.loops_m) {
            points_.clear();
            for (const Vec2& corner : loop) points_.push_back(im(layout.to_pixels(corner)));
            const int count = static_cast<int>(points_.size());
            list.AddPolyline(points_.data(), count, colour_of(palette_->ground), ImDrawFlags_Closed,
                             thick_px + 0.6F * unit_px_);
            list.AddPolyline(points_.data(), count, colour_of(palette_->room_outline), ImDrawFlags_Closed, thick_px);
        }
    }
}

// Draws horizontal lines across the shape in points_.
void PlanDrawing::draw_hatch(ImDrawList& list) {
    const ImU32 colour = colour_of(palette_->liquid);
    list.AddPolyline(points_.data(), static_cast<int>(points_.size()), colour, ImDrawFlags_Closed, 2.0F * line_);
    for_each_span(6.0F, [&](float y, float from, float to) { list.AddLine({from, y}, {to, y}, colour, 1.0F); });
}

void PlanDrawing::for_each_span(float step_px, const std::function<void(float, float, float)>& use) const {
    float top = points_.front().y, bottom = top;
    for (const ImVec2& p : points_) {
        top = std::min(top, p.y);
        bottom = std::max(bottom, p.y);
    }
    std::vector<float> crossings;
    for (float y = std::ceil(top / step_px) * step_px; y < bottom; y += step_px) {
        crossings.clear();
        for (std::size_t i = 0; i < points_.size(); ++i) {
            const ImVec2 a = points_[i], b = points_[(i + 1) % points_.size()];
            if ((a.y > y) == (b.y > y)) continue;
            crossings.push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
        }
        std::sort(crossings.begin(), crossings.end());
        for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) use(y, crossings[i], crossings[i + 1]);
    }
}

}  // namespace handrail::window
