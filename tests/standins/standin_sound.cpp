// A sound card that can be pulled out: loaded before OpenAL, it says that the device is gone, and opens none, while the file $STANDIN_SOUND_PULLED is there.
#include <AL/alc.h>
#include <dlfcn.h>
#include <unistd.h>

#include <cstdlib>

namespace {

bool pulled() {
    const char* file = std::getenv("STANDIN_SOUND_PULLED");
    return file && ::access(file, F_OK) == 0;
}

constexpr ALCenum kConnected = 0x313;  // ALC_CONNECTED of ALC_EXT_disconnect

}  // namespace

extern "C" void alcGetIntegerv(ALCdevice* device, ALCenum what, ALCsizei size, ALCint* values) {
    static const auto real = reinterpret_cast<decltype(&alcGetIntegerv)>(::dlsym(RTLD_NEXT, "alcGetIntegerv"));
    real(device, what, size, values);
    if (what == kConnected && size > 0 && pulled()) *values = 0;
}

extern "C" ALCdevice* alcOpenDevice(const ALCchar* name) {
    static const auto real = reinterpret_cast<decltype(&alcOpenDevice)>(::dlsym(RTLD_NEXT, "alcOpenDevice"));
    return pulled() ? nullptr : real(name);
}
