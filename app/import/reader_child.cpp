// Implements the side of the protocol with read_apart that runs in handrail-reader.
#include <fmt/format.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <new>

#include "app/import/kept_scene.h"
#include "app/import/reader_answer.h"
#include "app/import/reader_process.h"
#include "app/import/requested_files.h"
#include "app/import/toml_apart.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"
#include "worlds/cache/cache.h"
#include "worlds/cache/sha256.h"
#include "worlds/confine/confine.h"
#include "worlds/stored/stored_navigation.h"

namespace handrail::importing {
namespace {

void limit(int what, rlim_t most) {
    rlimit both{most, most};
    // For processor time, the hard limit is a second later than the soft limit. So the signal at the soft limit ends
    // the process first, and tells the parent the reason.
    if (what == RLIMIT_CPU) ++both.rlim_max;
    ::setrlimit(static_cast<__rlimit_resource_t>(what), &both);
}

bool write_all(int fd, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t put = ::write(fd, bytes.data(), bytes.size());
        if (put < 0 && errno == EINTR) continue;
        if (put <= 0) return false;
        bytes.remove_prefix(static_cast<std::size_t>(put));
    }
    return true;
}

template <class T>
T number(const char* word) {
    T value{};
    const std::string_view text = word;
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

double metres(const char* word) {
    double value = 0.0;
    return parse_finite(word, value) ? value : 0.0;
}

// From now on, ends the process with kCutMeanwhile if it reads a part of a mapped file that somebody has cut off since
// it was mapped.
void end_where_the_file_was_cut() {
    struct sigaction act {};
    act.sa_sigaction = [](int, siginfo_t* info, void*) {
        if (info->si_code == BUS_ADRERR) ::_exit(kCutMeanwhile);
        // For any other bus error, restore the default action: the faulting access is repeated, and the signal then
        // ends the process.
        ::signal(SIGBUS, SIG_DFL);
    };
    act.sa_flags = SA_SIGINFO;
    ::sigaction(SIGBUS, &act, nullptr);
}

int answer(const ReaderAnswer& reported, std::string_view bytes) {
    stored::Packer pack;
    pack(reported);
    return write_all(kAnswerFd, pack.take()) && write_all(kAnswerFd, bytes) ? 0 : kNoRoom;
}

Result<std::string> read_requested_next_to(const std::string& name) {
    const Result<OpenFile> file = request_next_to(kFilesFd, name);
    return file ? read_whole_file(*file, readers::kLargestNeighbour_bytes, {}) : tl::unexpected(file.error());
}

Result<Scene> read_requested(const std::string& name, const readers::ReadOptions& options) {
    const Result<OpenFile> world = request_world(kFilesFd);
    if (!world) return tl::unexpected(world.error());
    const Result<MappedFile> mapped = map_file(*world, readers::kLargestWorld_bytes);
    return mapped ? readers::read_world_bytes(name, mapped->bytes(), options) : tl::unexpected(mapped.error());
}

// Returns true if the files in `beside`, which the world needs next to its own file, are unchanged. Files that were
// missing must still be missing.
bool same_beside(const std::vector<NeighbourFile>& beside) {
    return std::all_of(beside.begin(), beside.end(), [](const NeighbourFile& file) {
        const Result<std::string> bytes = read_requested_next_to(file.name);
        return (bytes ? cache::sha256_of(*bytes) : std::string()) == file.sha256;
    });
}

// Returns the cached scene with that name. Returns nothing if the scene is out of date, or if its bytes are damaged. In
// the second case, sets `damaged`.
std::optional<Scene> scene_kept(const std::string& name, bool& damaged) {
    const std::optional<std::string> kept = cache::kept_content(kKeptFd, name);
    Result<std::optional<Scene>> scene = fail("");
    if (kept) scene = scene_in(*kept, same_beside);
    damaged = !scene.has_value();
    return scene ? std::move(*scene) : std::nullopt;
}

int answer_with_scene(const std::string& name, readers::ReadOptions& options, const std::string& kept_name) {
    ReaderAnswer reported;
    if (!kept_name.empty())
        if (const std::optional<Scene> kept = scene_kept(kept_name, reported.kept_damaged)) {
            reported.read = reported.kept = true;
            return answer(reported, stored::stored(*kept));
        }
    options.read_next_to = [&](const std::string& other) {
        Result<std::string> bytes = read_requested_next_to(other);
        reported.beside.push_back({other, bytes ? cache::sha256_of(*bytes) : std::string()});
        return bytes;
    };
    const Result<Scene> scene = read_requested(name, options);
    reported.read = scene.has_value();
    if (!scene) reported.error = scene.error();
    return answer(reported, scene ? stored::stored(*scene) : std::string());
}

int answer_with_navigation(const std::string& kept_name) {
    ReaderAnswer reported;
    const std::string ways = stored::unpacked_navigation(cache::kept_content(kKeptFd, kept_name).value_or(""));
    reported.read = reported.kept = !ways.empty();
    return answer(reported, ways);
}

int answer_with_toml() {
    const OpenFile text{Descriptor(kKeptFd), kLargestToml_bytes, {}};
    const Result<std::string> bytes = read_whole_file(text, kLargestToml_bytes, {});
    if (!bytes) return kNoRoom;
    TomlAnswer found;
    if (Result<settings::TomlValue> values = settings::toml_of(*bytes)) found.values = std::move(*values);
    else found.fault = values.error();
    stored::Packer pack;
    pack(found);
    ReaderAnswer reported;
    reported.read = true;
    return answer(reported, pack.take());
}

}  // namespace

int reader_process(int argc, char** argv) {
    if (argc != kReaderWords) return kWrongUse;
    const auto parent = number<pid_t>(argv[3]);
    // The kernel ends this process together with its parent, but only if the parent was still running at the time of
    // this call. If the parent had already ended, return at once.
    if (::prctl(PR_SET_PDEATHSIG, SIGKILL) != 0 || ::getppid() != parent) return kWrongUse;
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_FSIZE, kMostHandedOver_bytes);
    ::signal(SIGXFSZ, SIG_IGN);  // writing beyond RLIMIT_FSIZE then fails instead of ending the process
    limit(RLIMIT_CPU, number<rlim_t>(argv[5]));
#ifndef HANDRAIL_SANITIZED
    limit(RLIMIT_AS, number<rlim_t>(argv[4]));
#endif
    end_where_the_file_was_cut();
    std::set_new_handler([] { ::_exit(kNoMemory); });
    const std::string name = argv[6];
    const bool reads_toml = name.empty() && std::string_view(argv[11]) == kTomlText;
    if (!reads_toml) {  // parsing TOML needs neither the language nor Libgcrypt, and a person waits for the result
        (void)speak_language(argv[1], argv[2]);
        // When Libgcrypt is first used, it reads files of the system. That must happen before confinement.
        (void)cache::sha256_of("");
    }
    confine::Permissions permissions;
#if defined(HANDRAIL_SANITIZED)
    permissions.read.emplace_back("/proc");  // the leak check of the sanitizer reads files in /proc
#endif
    // Ignore a failure: `handrail devices` reports what the kernel does not support.
    (void)confine::confine(permissions);

    readers::ReadOptions options;
    options.map_metres_per_unit = metres(argv[7]);
    options.obj_metres_per_unit = metres(argv[8]);
    options.unit_is_known = argv[9][0] == '1';
    options.guess_materials = argv[9][1] == '1';
    options.solid_meshes = argv[9][2] == '1';
    options.building = argv[10];
    // Send progress as lines through the pipe, but only when the percentage has changed. So the number of lines stays
    // small, however often the reader calls this function.
    int reported = -1;
    options.progress = [&](double fraction) {
        const int percent = static_cast<int>(100.0 * std::clamp(fraction, 0.0, 1.0));
        if (percent != std::exchange(reported, percent)) write_all(kProgressFd, fmt::format("p{}\n", percent));
    };
    options.stage = [](std::string_view stage) { write_all(kProgressFd, fmt::format("s{}\n", stage)); };
    try {
        if (reads_toml) return answer_with_toml();
        return name.empty() ? answer_with_navigation(argv[11]) : answer_with_scene(name, options, argv[11]);
    } catch (const std::bad_alloc&) {
        return kNoMemory;
    }
}

}  // namespace handrail::importing
