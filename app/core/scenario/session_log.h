// Defines the log of a headless session, tick by tick, and checks a scenario's expectations against this log. Pure
// functions over plain data.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/core/scenario/log_measures.h"
#include "app/core/scenario/scenario.h"
#include "audio-cues/plan/sinks.h"
#include "worlds/base/feature_id.h"
#include "worlds/scene/scene.h"

namespace handrail::core {

struct LoggedTick {
    double time_s = 0.0;
    Vec3 force_n{0.0};  // force commanded to the device, in world axes
    Vec3 hip_m{0.0}, proxy_m{0.0};
    double radius_m = 0.0;
    double scale = 1.0;  // world metres per hand metre
    FeatureId touched = kNoFeature;
    bool contact = false;
    Vec3 feet_m{0.0};
    double heading_rad = 0.0;
};

struct LoggedSound {
    double time_s = 0.0;  // time when the sink received the sound
    cues::SoundCue cue;
    bool loop = false;
};

struct LoggedLine {
    double time_s = 0.0;
    std::string text;
};

struct SessionLog {
    std::vector<LoggedTick> ticks;       // one entry for each millisecond
    std::vector<LoggedTick> left_ticks;  // ticks of the left hand, if there are two
    std::vector<LoggedSound> sounds;
    std::vector<LoggedLine> lines;
    std::map<std::string, std::pair<double, double>> action_times;  // start and end of each action, by its name
    std::shared_ptr<const Scene> scene;  // the world at the end; it has the names of all things that were ever added
    double end_s = 0.0;
};

// Returns one sentence for each expectation that is not met. The sentence contains the line in the file, the time, what
// was expected and what happened instead.
std::vector<std::string> failures(const Scenario& scenario, const SessionLog& log, const Scene& scene);

}  // namespace handrail::core
