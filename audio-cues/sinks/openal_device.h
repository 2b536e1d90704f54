// Manages one OpenAL device with its context: a sound card, or the loopback device, which renders samples on request.
// Audio thread only, except for OpenALEnvironment.
#pragma once

#include <AL/al.h>
#include <AL/alc.h>
#include <AL/alext.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "worlds/base/result.h"

namespace handrail::sinks {

// Passes to OpenAL the settings that it reads only from a file. The file exists only in memory, and only while this
// object exists. If the person has set a configuration file of their own, OpenAL reads that one instead. Create this
// object before other threads read the environment.
class OpenALEnvironment {
public:
    // `periods` is the number of periods of 256 samples.
    explicit OpenALEnvironment(int periods);
    ~OpenALEnvironment();
    OpenALEnvironment(const OpenALEnvironment&) = delete;
    OpenALEnvironment& operator=(const OpenALEnvironment&) = delete;

private:
    int file_ = -1;
};

class OpenALDevice {
public:
    // `wanted` is OpenAL's name of a playback device; empty: the default device. Without `hrtf` the sound is plain
    // stereo. `hrtf_set` is part of the name of a set of head-related filters, or "auto".
    OpenALDevice(std::string wanted, bool hrtf, std::string hrtf_set)
        : wanted_(std::move(wanted)), hrtf_(hrtf), hrtf_set_(std::move(hrtf_set)) {}
    ~OpenALDevice() { close(); }
    OpenALDevice(const OpenALDevice&) = delete;
    OpenALDevice& operator=(const OpenALDevice&) = delete;

    // open_playback() and open_loopback() open the device at 48 kHz and make its context current. If one
    // fails, the caller must close the device.
    bool open_playback();
    Result<void> open_loopback();
    // Closes the device. Call it after all objects of its context have been deleted.
    void close();

    bool is_open() const { return device_ != nullptr; }
    bool has_context() const { return context_ != nullptr; }
    bool is_loopback() const { return loopback_; }
    ALCdevice* handle() const { return device_; }
    std::string name() const;
    bool hrtf_active() const;
    // Returns false if the named set of filters does not exist, so that another one is used.
    bool has_wanted_hrtf() const { return has_wanted_hrtf_; }
    bool connected() const;
    // Returns true if the playback device could be opened now. Does not affect the device that is open.
    bool playback_is_there() const;
    // Returns the time by the device's own clock, if it has one.
    std::optional<double> clock_s() const;
    // Renders samples with the loopback device, with left and right alternating.
    void render(float* stereo, int frames) const { render_samples_(device_, stereo, frames); }

private:
    bool make_context(std::vector<ALCint> attributes);
    std::optional<ALCint> hrtf_named(std::string_view name) const;

    std::string wanted_;
    bool hrtf_;
    std::string hrtf_set_;
    bool has_wanted_hrtf_ = true;
    ALCdevice* device_ = nullptr;
    ALCcontext* context_ = nullptr;
    bool loopback_ = false;
    LPALCRENDERSAMPLESSOFT render_samples_ = nullptr;
    LPALCGETINTEGER64VSOFT get_clock_ = nullptr;
};

}  // namespace handrail::sinks
