#include "haptic/c/handrail.h"

#include <cstring>
#include <exception>
#include <new>

#include "haptic/compile/compile_haptic.h"
#include "haptic/render/force_limiter.h"
#include "haptic/render/touch.h"
#include "worlds/readers/reader.h"

using handrail::Vec3;

struct handrail_world {
    handrail::Scene scene;
    std::shared_ptr<const handrail::render::HapticScene> felt;
};

struct handrail_hand {
    std::shared_ptr<const handrail::render::HapticScene> felt;
    handrail::render::TouchState state;
    handrail::render::TouchTuning tuning;
    handrail::render::ForceLimiter limiter;
    double ceiling_n = 0.0;
    handrail::render::ForceFlow flow = handrail::render::ForceFlow::Run;
};

namespace handrail {
namespace {

constexpr double kFarthest_m = 1e6;
constexpr double kLongestTick_s = 1.0;

// Copies `text` to `out` and always adds the final zero. If `text` is too long, it is cut after a whole UTF-8
// character. Writes nothing if `size` is 0 or `out` is null.
void copy_text(const std::string& text, char* out, std::size_t size) noexcept {
    if (!out || size == 0) return;
    std::size_t length = std::min(text.size(), size - 1);
    if (length < text.size())
        while (length > 0 && (static_cast<unsigned char>(text[length]) & 0xC0) == 0x80) --length;
    std::memcpy(out, text.data(), length);
    out[length] = '\0';
}

bool within(double value, double least, double most) noexcept { return value >= least && value <= most; }

bool take_feel(const handrail_feel* feel, handrail_hand& hand) noexcept {
    if (!feel || feel->size != sizeof(handrail_feel)) return false;
    const bool good = within(feel->radius_m, 0.0, 1000.0) && feel->world_m_per_hand_m > 0.0 &&
                      feel->world_m_per_hand_m <= 1e6 && within(feel->rated_stiffness_n_per_m, 0.0, 1e6) &&
                      within(feel->default_stiffness_fraction, 0.0, 1.0) &&
                      within(feel->damping_ns_per_m, 0.0, 1000.0) && within(feel->friction_kinetic, 0.0, 10.0) &&
                      within(feel->friction_static, feel->friction_kinetic, 10.0) && feel->ceiling_n >= 0.0;
    if (!good) return false;
    hand.tuning.radius_m = feel->radius_m;
    hand.tuning.world_m_per_hand_m = feel->world_m_per_hand_m;
    hand.tuning.rated_stiffness_n_per_m = feel->rated_stiffness_n_per_m;
    hand.tuning.default_stiffness_fraction = feel->default_stiffness_fraction;
    hand.tuning.damping_ns_per_m = feel->damping_ns_per_m;
    hand.tuning.default_friction_static = feel->friction_static;
    hand.tuning.default_friction_kinetic = feel->friction_kinetic;
    hand.ceiling_n = feel->ceiling_n;
    return true;
}

// Catches every C++ exception, because none may cross the C interface. Reports the exception as a sentence in `error`
// and returns null.
template <class Read>
handrail_world* world_of(Read read, char* error, std::size_t error_size) noexcept {
    try {
        Result<Scene> scene = read();
        if (!scene) {
            copy_text(scene.error().sentence(), error, error_size);
            return nullptr;
        }
        auto world = std::make_unique<handrail_world>();
        world->felt = compile::compile_haptic(*scene, compile::MaterialSource::Library);
        world->scene = std::move(*scene);
        copy_text("", error, error_size);
        return world.release();
    } catch (const std::exception& thrown) {
        copy_text(thrown.what(), error, error_size);
        return nullptr;
    }
}

}  // namespace
}  // namespace handrail

uint32_t handrail_api_version(void) { return HANDRAIL_API_VERSION; }

handrail_world* handrail_world_read(const char* path, char* error, size_t error_size) {
    return handrail::world_of([&] { return handrail::readers::read_world(path ? path : ""); }, error, error_size);
}

handrail_world* handrail_world_from_map(const char* text, size_t length, char* error, size_t error_size) {
    return handrail::world_of(
        [&] {
            return handrail::readers::read_quake_map(text ? std::string_view(text, length) : std::string_view(), "map");
        },
        error, error_size);
}

void handrail_world_free(handrail_world* world) { delete world; }

int handrail_world_start(const handrail_world* world, double place_m[3]) {
    const handrail::Start* base = nullptr;
    for (const handrail::Start& start : world->scene.starts)
        if (!base || (start.base && !base->base)) base = &start;
    if (!base) return 0;
    for (int axis = 0; axis < 3; ++axis) place_m[axis] = base->feet_m[axis];
    return 1;
}

size_t handrail_world_name(const handrail_world* world, uint32_t feature, char* name, size_t name_size) {
    try {
        const std::string stored = handrail::stored_name(world->scene, handrail::FeatureId{feature});
        handrail::copy_text(stored, name, name_size);
        return stored.size();
    } catch (const std::exception&) {
        handrail::copy_text("", name, name_size);
        return 0;
    }
}

void handrail_feel_default(handrail_feel* feel) {
    const handrail::render::TouchTuning tuning;
    *feel = {sizeof(handrail_feel),
             0,
             tuning.radius_m,
             tuning.world_m_per_hand_m,
             tuning.rated_stiffness_n_per_m,
             tuning.default_stiffness_fraction,
             tuning.damping_ns_per_m,
             tuning.default_friction_static,
             tuning.default_friction_kinetic,
             2.5};
}

handrail_hand* handrail_hand_new(const handrail_world* world, const handrail_feel* feel) {
    try {
        auto hand = std::make_unique<handrail_hand>();
        if (!world || !handrail::take_feel(feel, *hand)) return nullptr;
        hand->felt = world->felt;
        return hand.release();
    } catch (const std::bad_alloc&) {
        return nullptr;
    }
}

void handrail_hand_free(handrail_hand* hand) { delete hand; }

int handrail_hand_set_feel(handrail_hand* hand, const handrail_feel* feel) {
    return handrail::take_feel(feel, *hand) ? 1 : 0;
}

void handrail_hand_set_flow(handrail_hand* hand, enum handrail_flow flow) {
    hand->flow = flow == HANDRAIL_RUN    ? handrail::render::ForceFlow::Run
                 : flow == HANDRAIL_FADE ? handrail::render::ForceFlow::Fade
                                         : handrail::render::ForceFlow::Cut;
}

void handrail_hand_tick(handrail_hand* hand, const double place_m[3], double dt_s, handrail_touch* touch) {
    if (touch->size != sizeof(handrail_touch)) return;
    *touch = {sizeof(handrail_touch), 0, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, HANDRAIL_NO_FEATURE, 0};
    const Vec3 goal_m(place_m[0], place_m[1], place_m[2]);
    bool good = dt_s > 0.0 && dt_s <= handrail::kLongestTick_s;
    for (int axis = 0; axis < 3; ++axis) good = good && std::abs(goal_m[axis]) <= handrail::kFarthest_m;
    if (!good) {
        hand->state.reset_filters();
        hand->limiter.limit(Vec3(0.0), hand->ceiling_n, handrail::render::ForceFlow::Cut, 1e-3);
        touch->refused = 1;
        return;
    }
    const handrail::render::TouchResult felt =
        handrail::render::touch_tick(hand->state, *hand->felt, hand->tuning, goal_m, dt_s);
    const Vec3 force_n = hand->limiter.limit(felt.force_n, hand->ceiling_n, hand->flow, dt_s);
    touch->contacts = felt.contacts.count;
    for (int axis = 0; axis < 3; ++axis) {
        touch->force_n[axis] = force_n[axis];
        touch->ball_m[axis] = felt.proxy_m[axis];
    }
    if (felt.contacts.count == 0) return;
    const handrail::render::Contact& strongest = felt.contacts.contacts[felt.contacts.strongest];
    for (int axis = 0; axis < 3; ++axis) touch->normal[axis] = strongest.normal[axis];
    touch->feature = strongest.feature.value;
}
