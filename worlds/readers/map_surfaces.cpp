#include "worlds/readers/map_surfaces.h"

#include <fmt/format.h>

#include <algorithm>

#include "worlds/base/language.h"
#include "worlds/base/text.h"
#include "worlds/readers/height_picture.h"

namespace handrail::readers {
namespace {

// Greatest friction, that of rubber on rubber. With more friction, the hand sticks to the wall.
constexpr double kMostFriction = 2.0;
// Greatest damping. With more damping, the hand feels the noise of the device itself.
constexpr double kMostDampingNsPerM = 10.0;
constexpr double kMillimetre = 1e-3;
// Used if the map gives no depth or period.
constexpr double kWaveDepth_mm = 0.4, kPictureDepth_mm = 2.0, kPeriod_mm = 10.0;

constexpr NumberKey kStiffness{"stiffness", 0.0, 1.0, "map.range"};
constexpr NumberKey kFriction{"friction", 0.0, kMostFriction, "map.range"};
constexpr NumberKey kFrictionStatic{"friction_static", 0.0, kMostFriction, "map.range"};
constexpr NumberKey kDamping{"damping", 0.0, kMostDampingNsPerM, "map.range_viscosity"};
constexpr NumberKey kTextureDepth{"texture_depth", 0.0, 5.0, "map.range_millimetres"};
constexpr NumberKey kTextureAngle{"texture_angle", -360.0, 360.0, "map.range_degrees"};
constexpr NumberKey kFrictionWave{"friction_wave", 0.0, 0.3, "map.range"};
constexpr NumberKey kTexturePeriod{"texture_period", 1.0, 100.0, "map.range_millimetres"};
constexpr NumberKey kTextureSize{"texture_size", 1.0, 1e5, "map.range_in_units"};

}  // namespace

std::string look_of_surface(const Material& m) {
    const auto of = [](const std::optional<double>& value) { return value.value_or(-1.0); };
    std::string look = fmt::format("{} {} {} {}", of(m.stiffness_fraction), of(m.friction_mu), of(m.friction_static),
                                   of(m.damping_ns_per_m));
    if (m.wave)
        look += fmt::format(" wave {} {} {} {} {}", static_cast<int>(m.wave->shape), m.wave->depth_hand_m,
                            m.wave->period_hand_m, m.wave->friction_share, m.wave->turn_rad);
    if (m.picture)
        look += fmt::format(" picture {} {} {} {}", static_cast<const void*>(m.picture->heights.get()),
                            m.picture->depth_hand_m, m.picture->size_m, m.picture->turn_rad);
    return look;
}

Material MapSurfaces::read(const MapEntity& entity) {
    Material surface;
    surface.stiffness_fraction = keys_.number_of(entity, kStiffness);
    surface.friction_mu = keys_.number_of(entity, kFriction);
    surface.friction_static = keys_.number_of(entity, kFrictionStatic);
    surface.damping_ns_per_m = keys_.number_of(entity, kDamping);
    if (surface.friction_static && surface.friction_mu) {
        const TextPlace place = entity.find("friction_static")->place;
        if (*surface.friction_static < *surface.friction_mu) {
            diagnostics_.warn(place, "map.then_number", "map.low_static", {{"taken", *surface.friction_mu}});
            surface.friction_static = surface.friction_mu;
        } else if (*surface.friction_static > kMostStaticOverKinetic * *surface.friction_mu) {
            diagnostics_.warn(place, "map.then_taken", "map.high_static", {{"times", kMostStaticOverKinetic}});
        }
    }
    const std::optional<double> depth_mm = keys_.number_of(entity, kTextureDepth);
    const double turn_rad = radians_from_degrees(keys_.number_of(entity, kTextureAngle).value_or(0.0));
    read_wave(entity, depth_mm, turn_rad, surface);
    read_picture(entity, depth_mm, turn_rad, surface);
    return surface;
}

void MapSurfaces::read_wave(const MapEntity& entity, std::optional<double> depth_mm, double turn_rad,
                            Material& surface) {
    const std::optional<double> share = keys_.number_of(entity, kFrictionWave);
    const std::optional<double> period_mm = keys_.number_of(entity, kTexturePeriod);
    std::optional<WaveShape> shape;
    if (const MapKey* key = entity.find("texture_wave")) {
        const std::string word = lower_ascii(trimmed(key->value).substr(0, 16));
        if (word == "sine") shape = WaveShape::Sine;
        else if (word == "square") shape = WaveShape::Square;
        else if (word == "none") shape = WaveShape::Level;
        else diagnostics_.warn(key->place, "map.then_plain", "map.no_wave", {{"value", excerpt(key->value)}});
    }
    if (!share && !shape) return;
    TextureWave wave;
    wave.shape = shape.value_or(WaveShape::Level);
    wave.period_hand_m = period_mm.value_or(kPeriod_mm) * kMillimetre;
    wave.depth_hand_m = wave.shape == WaveShape::Level ? 0.0 : depth_mm.value_or(kWaveDepth_mm) * kMillimetre;
    wave.friction_share = share.value_or(0.0);
    wave.turn_rad = turn_rad;
    surface.wave = wave;
}

void MapSurfaces::read_picture(const MapEntity& entity, std::optional<double> depth_mm, double turn_rad,
                               Material& surface) {
    const std::optional<double> size_units = keys_.number_of(entity, kTextureSize);
    const MapKey* key = entity.find("texture_picture");
    if (!key) return;
    const std::string name = unquoted(trimmed(key->value).substr(0, 256));
    const auto [found, is_new] = pictures_.try_emplace(name);
    if (is_new) {
        const Result<std::string> bytes =
            options_.read_next_to ? options_.read_next_to(name) : fail(phrase("map.no_folder"), name);
        Result<HeightPicture> picture = bytes ? read_height_picture(*bytes, name) : tl::unexpected(bytes.error());
        if (picture) found->second = std::make_shared<const HeightPicture>(std::move(*picture));
        else
            diagnostics_.warn(key->place, "map.then_plain", "map.bad_picture",
                              {{"picture", excerpt(name, 60)}, {"why", picture.error().message}});
    }
    if (!found->second) return;
    TexturePicture picture;
    picture.heights = found->second;
    picture.depth_hand_m = depth_mm.value_or(kPictureDepth_mm) * kMillimetre;
    picture.turn_rad = turn_rad;
    for (const MapBrush& brush : entity.brushes)
        if (const BuiltSolid built = built_(brush); built.fault == SolidFault::None)
            picture.box_m.include(built.solid.bounds_m);
    if (picture.box_m.empty()) return;
    const Vec3 size = picture.box_m.size_m();
    picture.size_m = size_units ? *size_units * units_ : std::max(size.x, size.y);
    surface.picture = picture;
}

}  // namespace handrail::readers
