// Simulates a sound card that can be pulled out. Tests load this library before OpenAL. While the file
// $STANDIN_SOUND_PULLED exists, the stand-in reports that the device is gone and opens no device. It also observes the
// program's own voice, which is the only source with queued buffers. It appends a line to $STANDIN_SOUND_VOICE with the
// steady clock's seconds and a word: "speak" when the voice begins, "hush" when the voice's gain goes to zero while it
// speaks.
#include <AL/al.h>
#include <AL/alc.h>
#include <dlfcn.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <iterator>

namespace {

bool pulled() {
    const char* file = std::getenv("STANDIN_SOUND_PULLED");
    return file && ::access(file, F_OK) == 0;
}

std::atomic<bool> queued_to[4096];  // whether buffers were queued to a source; the index is the source's number

bool is_voice(ALuint source) { return source < std::size(queued_to) && queued_to[source]; }

void note(const char* what) {
    const char* file = std::getenv("STANDIN_SOUND_VOICE");
    if (!file) return;
    if (std::FILE* to = std::fopen(file, "a")) {
        std::fprintf(to, "%.6f %s\n",
                     std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(), what);
        std::fclose(to);
    }
}

constexpr ALCenum kConnected = 0x313;  // ALC_CONNECTED of the extension ALC_EXT_disconnect

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

extern "C" void alSourceQueueBuffers(ALuint source, ALsizei count, const ALuint* buffers) {
    static const auto real =
        reinterpret_cast<decltype(&alSourceQueueBuffers)>(::dlsym(RTLD_NEXT, "alSourceQueueBuffers"));
    real(source, count, buffers);
    if (source < std::size(queued_to)) queued_to[source] = true;
}

extern "C" void alSourcePlay(ALuint source) {
    static const auto real = reinterpret_cast<decltype(&alSourcePlay)>(::dlsym(RTLD_NEXT, "alSourcePlay"));
    real(source);
    if (is_voice(source)) note("speak");
}

extern "C" void alSourcef(ALuint source, ALenum what, ALfloat value) {
    static const auto real = reinterpret_cast<decltype(&alSourcef)>(::dlsym(RTLD_NEXT, "alSourcef"));
    ALint state = 0;
    if (is_voice(source) && what == AL_GAIN && value == 0.0F) alGetSourcei(source, AL_SOURCE_STATE, &state);
    real(source, what, value);
    if (state == AL_PLAYING) note("hush");
}
