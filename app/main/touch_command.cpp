#include <fmt/ranges.h>

#include <charconv>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "app/core/kept/side_file.h"
#include "app/core/world/entering.h"
#include "app/learners/export_gate.h"
#include "app/main/commands.h"
#include "app/main/path_csv.h"
#include "app/main/world_files.h"
#include "haptic/compile/compile_haptic.h"
#include "haptic/device/device_spec.h"
#include "haptic/dynamics/dynamics.h"
#include "haptic/render/touch.h"
#include "haptic/servo/bodies_in_reach.h"
#include "settings/settings.h"
#include "worlds/base/files.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail::program {
namespace {

constexpr double kFarthest_m = 1e6;
constexpr double kFirstTick_s = 1e-3;
constexpr double kMostReact_s = 0.01;  // at each row, the hand pushes free bodies for at most this time
constexpr double kMostGap_s = 10.0;    // longest simulated time between two rows; free bodies come to rest sooner
// Force limit, in newtons, with which the hand pushes bodies if no device with a limit is given.
constexpr double kIdealCeiling_n = 2.5;
// If a hand travels farther than this between two rows, the row is a fault of the device.
constexpr double kJump_hand_m = 0.020;

// Appends the shortest decimal that reads back as the same double. Zero never has a sign.
void append_number(std::string& out, double value) {
    if (std::isnan(value)) {
        out += "nan";
        return;
    }
    std::array<char, 32> digits;
    const auto written = std::to_chars(digits.data(), digits.data() + digits.size(), value == 0.0 ? 0.0 : value);
    out.append(digits.data(), written.ptr);
}

// Appends a text as in RFC 4180: in quotes if it contains a comma, a quote or a line break.
void append_text(std::string& out, std::string_view text) {
    if (text.find_first_of(",\"\r\n") == std::string_view::npos) {
        out += text;
        return;
    }
    out += '"';
    for (const char c : text) {
        out += c;
        if (c == '"') out += c;
    }
    out += '"';
}

// Finds faulty rows, so that the renderer receives only rows without faults.
class RowChecks {
public:
    // `jump_m`: greatest distance between two rows that is not a fault; infinity if no device's limits apply.
    explicit RowChecks(double jump_m) : jump_m_(jump_m) {}

    // Returns the name of the row's fault, or an empty string. A position must be near that of the last good row, or
    // near that of the row before. So a single spike is refused, but a real jump is accepted from its second row on.
    const char* judge(const Vec3& p) {
        if (!is_finite(p)) return "not_finite";
        if (std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) > kFarthest_m) return "out_of_range";
        const bool jumped = has_last_ && glm::length(p - last_m_) > jump_m_ && glm::length(p - last_good_m_) > jump_m_;
        last_m_ = p;
        if (jumped) return "jump";
        has_last_ = true;
        last_good_m_ = p;
        return "";
    }

private:
    double jump_m_;
    bool has_last_ = false;
    Vec3 last_m_{0.0}, last_good_m_{0.0};
};

render::TouchTuning tuning_of(const TouchArguments& arguments, const device::DeviceSpec& device) {
    render::TouchTuning tuning;
    tuning.radius_m = arguments.radius_m;
    tuning.world_m_per_hand_m = arguments.scale_world_m_per_hand_m;
    tuning.rated_stiffness_n_per_m = device.rated_stiffness_n_per_m;
    constexpr double kNotGiven = -1.0;
    tuning.override_stiffness_n_per_m = arguments.stiffness_n_per_m.value_or(kNotGiven);
    tuning.override_damping_ns_per_m = arguments.damping_ns_per_m.value_or(kNotGiven);
    // If only one of the two friction options is given, its value applies to both kinds of friction.
    tuning.override_friction_static =
        arguments.friction_static.value_or(arguments.friction_kinetic.value_or(kNotGiven));
    tuning.override_friction_kinetic =
        arguments.friction_kinetic.value_or(arguments.friction_static.value_or(kNotGiven));
    return tuning;
}

// Simulates the free bodies of the world. At each row, the hand pushes and feels them; between rows, the physics engine
// advances in its own steps. Equal rows give bit-identical results. Does nothing if no body is free.
class MovingThings {
public:
    // `felt` is compiled from the same scene, before its free bodies were separated.
    MovingThings(const core::EnteringWorld& world, const render::HapticScene& felt, const render::TouchTuning& tuning,
                 double ceiling_n)
        : scene_(world.moves_freely), engine_(scene_) {
        feel_.world_m_per_hand_m = tuning.world_m_per_hand_m;
        feel_.proxy_radius_m = tuning.radius_m;
        feel_.ceiling_n = ceiling_n;
        feel_.felt_gain = servo::felt_gain(ceiling_n, settings::Settings().dynamics.strength_n);
        bodies_.enter(scene_.get());
        for (const auto& body : felt.bodies) poses_.push_back({body.start, true});
        engine_.step(frame_, events_);
    }
    // Computes the contact of the hand with the scene and with the free bodies, at their positions at the time of this
    // row.
    render::TouchResult touch(render::TouchState& state, const render::HapticScene& felt,
                              const render::TouchTuning& tuning, const Vec3& hand_m, double dt_s) {
        bodies_.hear(frame_);
        if (bodies_.place(now_s_, hand_m, feel_, poses_)) ++number_;
        const render::TouchResult touched =
            render::touch_tick(state, felt, tuning, hand_m, dt_s, bodies_.carried_m(), {poses_, number_});
        const double wanted_n = glm::length(touched.force_n), step_s = std::min(dt_s, kMostReact_s);
        bodies_.react(touched, wanted_n > feel_.ceiling_n ? feel_.ceiling_n / wanted_n : 1.0, now_s_, step_s, feel_,
                      pushes_);
        engine_.place_hand(0, {hand_m, feel_.proxy_radius_m, true});
        for (render::HandPush push; pushes_.pop(push);) engine_.push(0, push);
        now_s_ += std::min(dt_s, kMostGap_s);
        while (engine_.time_s() + dynamics::Dynamics::kStep_s <= now_s_) {
            events_.clear();
            engine_.step(frame_, events_);
        }
        return touched;
    }

private:
    std::shared_ptr<const render::DynamicsScene> scene_;
    dynamics::Dynamics engine_;
    servo::BodyFeel feel_;
    servo::BodiesInReach bodies_{0};
    render::HandPushRing pushes_;
    std::vector<render::BodyPose> poses_;
    std::uint64_t number_ = 1;
    render::DynamicsFrame frame_;
    std::vector<render::BodyEvent> events_;
    double now_s_ = dynamics::Dynamics::kStep_s;
};

std::string replay(const std::shared_ptr<const Scene>& file, const std::vector<PathRow>& rows,
                   const render::TouchTuning& tuning, const device::DeviceSpec* limits) {
    core::EnteringWorld world;
    if (!file->bodies.empty()) world = core::make_ready(file);
    const Scene& scene = world.moves_freely ? *world.scene : *file;
    const std::shared_ptr<const render::HapticScene> haptic =
        compile::compile_haptic(scene, compile::MaterialSource::KeysOnly);
    std::optional<MovingThings> moving;
    if (world.moves_freely) moving.emplace(world, *haptic, tuning, limits ? limits->peak_force_n : kIdealCeiling_n);
    render::TouchState state;
    RowChecks checks(limits ? kJump_hand_m * tuning.world_m_per_hand_m : std::numeric_limits<double>::infinity());
    Vec3 proxy_m(0.0);
    std::string out = "t,x,y,z,px,py,pz,fx,fy,fz,contacts,feature,fault,tick_ns\r\n";
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const PathRow& row = rows[i];
        const char* fault = checks.judge(row.position_m);
        Vec3 force_n(0.0);
        int contacts = 0;
        std::string feature;
        long long tick_ns = 0;
        if (*fault != '\0') {
            state.reset_filters();
        } else {
            const double dt_s = i > 0 ? row.t_s - rows[i - 1].t_s : kFirstTick_s;
            const auto start = std::chrono::steady_clock::now();
            const render::TouchResult result = moving
                                                   ? moving->touch(state, *haptic, tuning, row.position_m, dt_s)
                                                   : render::touch_tick(state, *haptic, tuning, row.position_m, dt_s);
            tick_ns =
                std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::steady_clock::now() - start).count();
            proxy_m = result.proxy_m;
            force_n = result.force_n;
            const double length = glm::length(force_n);
            if (limits && length > limits->peak_force_n) force_n *= limits->peak_force_n / length;
            contacts = result.contacts.count;
            if (contacts > 0) feature = stored_name(scene, result.contacts.contacts[result.contacts.strongest].feature);
        }
        append_number(out, row.t_s);
        for (const Vec3& v : {row.position_m, proxy_m, force_n})
            for (int axis = 0; axis < 3; ++axis) {
                out += ',';
                append_number(out, v[axis]);
            }
        out += fmt::format(",{},", contacts);
        append_text(out, feature);
        out += fmt::format(",{},{}\r\n", fault, tick_ns);
    }
    return out;
}

}  // namespace

int run_touch(const TouchArguments& arguments, std::ostream&, std::ostream& err, const LongWork& progress) {
    const device::DeviceSpec* limits = nullptr;
    if (arguments.device) {
        limits = device::find_device_spec(*arguments.device);
        if (!limits) {
            err << one_line(phrase("program.no_model",
                                   {{"name", *arguments.device},
                                    {"known", fmt::format("{}", fmt::join(device::device_names(), ", "))}}))
                << '\n';
            return 2;
        }
        // The ideal device has no limits.
        if (limits->name == device::ideal_device_spec().name) limits = nullptr;
    }
    const auto refuse = [&](const Error& error) {
        progress.done();
        err << error.sentence() << '\n';
        return 1;
    };
    const Result<std::filesystem::path> world = world_given(arguments.world);
    if (!world) return refuse(world.error());
    readers::ReadOptions options = arguments.common.read_options(*world);
    options.guess_materials = false;
    options.solid_meshes = false;
    Result<Scene> scene = imported(*world, progress.followed(options)).map([](importing::ImportedWorld&& one) {
        return std::move(one.scene);
    });
    if (!scene) return refuse(scene.error());
    const learners::Learners learners(core::user_data_folder());
    Result<learners::ExportGate> export_gate = learners::ExportGate::of(learners, arguments.path_csv);
    if (export_gate && !export_gate->learner()) export_gate = learners::ExportGate::of(learners, *world);
    if (!export_gate) return refuse(export_gate.error());
    const Result<std::string> text = read_whole_file(arguments.path_csv);
    if (!text) return refuse(text.error());
    const Result<std::vector<PathRow>> rows = parse_path(*text, arguments.path_csv.filename().string());
    if (!rows) return refuse(rows.error());
    progress.at(phrase("progress.path"));
    const std::string result = replay(std::make_shared<const Scene>(std::move(*scene)), *rows,
                                      tuning_of(arguments, limits ? *limits : device::ideal_device_spec()), limits);
    const Result<void> written = export_gate->write(arguments.out_csv, result, write_named_file_atomically);
    progress.done();
    return written ? 0 : refuse(written.error());
}

}  // namespace handrail::program
