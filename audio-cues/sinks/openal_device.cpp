#include "audio-cues/sinks/openal_device.h"

#include <dlfcn.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdlib>

#include "audio-cues/sinks/synth.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail::sinks {
namespace {

// Settings that OpenAL Soft reads only from a file, and only once in a process. Shorter periods cause drop-outs on a
// loaded machine; the default of 3 x 1024 has a delay of 44 ms. Measured with the null device: 256 x 2 has a delay of
// 6.3 ms, 256 x 3 one of 11.7 ms.
std::string configuration(int periods) { return fmt::format("period_size = 256\nperiods = {}\n", periods); }

void ignore_alsa_message(const char* /*file*/, int /*line*/, const char* /*function*/, int /*error*/,
                         const char* /*format*/, ...) {}

// Looks up a function of an extension. Its context or device must exist already.
template <class Function>
Function alc_function(ALCdevice* device, const char* name) {
    return reinterpret_cast<Function>(alcGetProcAddress(device, name));
}

}  // namespace

OpenALEnvironment::OpenALEnvironment(int periods) {
    // OpenAL, PipeWire and ALSA print messages to standard error if there is no sound card. They are disabled here,
    // because the sink reports this in a sentence.
    ::setenv("ALSOFT_LOGLEVEL", "0", 0);
    ::setenv("PIPEWIRE_DEBUG", "0", 0);
    if (void* alsa = ::dlopen("libasound.so.2", RTLD_NOW | RTLD_LOCAL)) {
        using SetHandler = int (*)(decltype(&ignore_alsa_message));
        if (void* set_handler = ::dlsym(alsa, "snd_lib_error_set_handler"))
            reinterpret_cast<SetHandler>(set_handler)(&ignore_alsa_message);
    }  // The library stays loaded, because OpenAL uses it too.
    if (std::getenv("ALSOFT_CONF") != nullptr) return;
    file_ = ::memfd_create("openal.conf", MFD_CLOEXEC);
    if (file_ < 0) return;
    const std::string text = configuration(periods);
    if (::write(file_, text.data(), text.size()) == static_cast<ssize_t>(text.size()))
        ::setenv("ALSOFT_CONF", fmt::format("/proc/self/fd/{}", file_).c_str(), 1);
}

OpenALEnvironment::~OpenALEnvironment() {
    if (file_ < 0) return;
    ::unsetenv("ALSOFT_CONF");
    ::close(file_);
}

bool OpenALDevice::open_playback() {
    device_ = alcOpenDevice(wanted_.empty() ? nullptr : wanted_.c_str());
    loopback_ = false;
    return device_ != nullptr && make_context({ALC_FREQUENCY, kSampleRate_hz});
}

Result<void> OpenALDevice::open_loopback() {
    const auto open_device = alc_function<LPALCLOOPBACKOPENDEVICESOFT>(nullptr, "alcLoopbackOpenDeviceSOFT");
    render_samples_ = alc_function<LPALCRENDERSAMPLESSOFT>(nullptr, "alcRenderSamplesSOFT");
    if (open_device != nullptr && render_samples_ != nullptr) device_ = open_device(nullptr);
    if (device_ == nullptr) return fail(phrase("sound_output.no_loopback"));
    loopback_ = true;
    if (make_context({ALC_FORMAT_CHANNELS_SOFT, ALC_STEREO_SOFT, ALC_FORMAT_TYPE_SOFT, ALC_FLOAT_SOFT, ALC_FREQUENCY,
                      kSampleRate_hz}))
        return {};
    return fail(phrase("sound_output.no_48_khz"));
}

bool OpenALDevice::make_context(std::vector<ALCint> attributes) {
    attributes.insert(attributes.end(), {ALC_HRTF_SOFT, hrtf_ ? ALC_TRUE : ALC_FALSE});
    // OpenAL Soft 1.19 sets the device to the sample rate of the HRTF data set, and chooses a set with 44.1 kHz if none
    // is named. Version 1.24 has no set of this name: it resamples its only set to the rate of the device.
    if (hrtf_) {
        const bool any = hrtf_set_ == "auto";
        const auto named = any ? std::nullopt : hrtf_named(hrtf_set_);
        has_wanted_hrtf_ = any || named.has_value();
        if (const auto id = named ? named : hrtf_named("default-48000"))
            attributes.insert(attributes.end(), {ALC_HRTF_ID_SOFT, *id});
    }
    attributes.push_back(0);
    context_ = alcCreateContext(device_, attributes.data());
    if (context_ == nullptr || alcMakeContextCurrent(context_) == ALC_FALSE) return false;
    get_clock_ = nullptr;
    if (alcIsExtensionPresent(device_, "ALC_SOFT_device_clock") == ALC_TRUE)
        get_clock_ = alc_function<LPALCGETINTEGER64VSOFT>(device_, "alcGetInteger64vSOFT");
    return true;
}

void OpenALDevice::close() {
    if (context_ != nullptr) {
        alcMakeContextCurrent(nullptr);
        alcDestroyContext(context_);
        context_ = nullptr;
    }
    if (device_ != nullptr) alcCloseDevice(device_);
    device_ = nullptr;
}

std::optional<ALCint> OpenALDevice::hrtf_named(std::string_view name) const {
    const auto name_of = alc_function<LPALCGETSTRINGISOFT>(device_, "alcGetStringiSOFT");
    if (name_of == nullptr || alcIsExtensionPresent(device_, "ALC_SOFT_HRTF") == ALC_FALSE) return std::nullopt;
    ALCint count = 0;
    alcGetIntegerv(device_, ALC_NUM_HRTF_SPECIFIERS_SOFT, 1, &count);
    for (ALCint i = 0; i < count; ++i) {
        const ALCchar* found = name_of(device_, ALC_HRTF_SPECIFIER_SOFT, i);
        // OpenAL Soft 1.24 calls "default-48000" "Default HRTF".
        if (found != nullptr && lower_ascii(found).find(lower_ascii(name)) != std::string::npos) return i;
    }
    return std::nullopt;
}

std::string OpenALDevice::name() const {
    const bool all = alcIsExtensionPresent(device_, "ALC_ENUMERATE_ALL_EXT") == ALC_TRUE;
    const ALCchar* found = alcGetString(device_, all ? ALC_ALL_DEVICES_SPECIFIER : ALC_DEVICE_SPECIFIER);
    return found != nullptr ? std::string(found) : phrase("sound_output.unnamed");
}

bool OpenALDevice::hrtf_active() const {
    ALCint active = ALC_FALSE;
    alcGetIntegerv(device_, ALC_HRTF_SOFT, 1, &active);
    return active == ALC_TRUE;
}

bool OpenALDevice::connected() const {
    if (alcIsExtensionPresent(device_, "ALC_EXT_disconnect") == ALC_FALSE) return true;
    ALCint answer = ALC_TRUE;
    alcGetIntegerv(device_, ALC_CONNECTED, 1, &answer);
    return answer == ALC_TRUE;
}

// Checks for a playback device without closing the loopback device, which would then have to be set up again.
bool OpenALDevice::playback_is_there() const {
    ALCdevice* found = alcOpenDevice(wanted_.empty() ? nullptr : wanted_.c_str());
    if (found != nullptr) alcCloseDevice(found);
    return found != nullptr;
}

std::optional<double> OpenALDevice::clock_s() const {
    if (get_clock_ == nullptr) return std::nullopt;
    ALCint64SOFT clock_ns = 0;
    get_clock_(device_, ALC_DEVICE_CLOCK_SOFT, 1, &clock_ns);
    return static_cast<double>(clock_ns) * 1e-9;
}

}  // namespace handrail::sinks
