#include "app/import/reader_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>

#include "app/import/reader_answer.h"
#include "app/import/requested_files.h"
#include "worlds/base/clock.h"
#include "worlds/base/descriptor.h"
#include "worlds/base/files.h"
#include "worlds/base/language.h"
#include "worlds/confine/confine.h"

namespace handrail::importing {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kReaderProgram = "handrail-reader";
constexpr int kLookEvery_ms = 50;  // interval at which the waiting caller checks whether the result is still wanted

// The handrail-reader process must not write to the person's terminal, because terminals obey control sequences that
// are written to them.
#if defined(HANDRAIL_SANITIZED)
constexpr bool kSanitized = true;  // a sanitizer writes its reports to the terminal
#else
constexpr bool kSanitized = false;
#endif

// Owns a process. The destructor kills the process if it has not ended.
class Reading {
public:
    explicit Reading(pid_t process) : process_(process) {}
    ~Reading() {
        if (ended_) return;
        // The process leads its own process group, so this also kills all processes that it may have started.
        ::kill(-process_, SIGKILL);
        wait();
    }
    Reading(const Reading&) = delete;
    Reading& operator=(const Reading&) = delete;

    int wait() {
        int status = 0;
        while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
        }
        ended_ = true;
        return status;
    }

private:
    pid_t process_;
    bool ended_ = false;
};

// Passes a line of progress to `options`. "p57" means 57 percent, and "stext.key" contains the key of the current
// stage.
void report_progress(const readers::ReadOptions& options, std::string_view line) {
    if (line.starts_with('p') && options.progress) {
        int percent = 0;
        std::from_chars(line.data() + 1, line.data() + line.size(), percent);
        options.progress(0.01 * percent);
    } else if (line.starts_with('s') && options.stage) {
        options.stage(line.substr(1));
    }
}

Result<std::string> everything_in(int fd, std::size_t most_bytes) {
    struct stat of {};
    if (::fstat(fd, &of) != 0) return fail(reason_of(errno));
    if (static_cast<std::size_t>(of.st_size) > most_bytes) return fail(phrase("import.too_large"));
    std::string bytes(static_cast<std::size_t>(of.st_size), '\0');
    std::size_t done = 0;
    while (done < bytes.size()) {
        const ssize_t got = ::pread(fd, bytes.data() + done, bytes.size() - done, static_cast<off_t>(done));
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return fail(reason_of(got < 0 ? errno : EIO));
        done += static_cast<std::size_t>(got);
    }
    return bytes;
}

std::string end_words(int status, const ReaderLimits& limits, double cpu_s) {
    const auto too_long = [&] { return phrase("import.too_long", {{"seconds", limits.cpu_s}}); };
    const auto too_much = [&] {
        return phrase("import.too_much_memory", {{"gigabytes", 1e-9 * static_cast<double>(limits.memory_bytes)}});
    };
    if (WIFSIGNALED(status)) {
        const int signal = WTERMSIG(status);
        if (signal == SIGXCPU) return too_long();
        // The kernel killed the process: either the process used up its processor time, or the machine had no memory
        // left.
        if (signal == SIGKILL) return cpu_s >= limits.cpu_s ? too_long() : too_much();
        return phrase("import.broke_down", {{"reason", ::strsignal(signal)}});
    }
    if (WEXITSTATUS(status) == kNoMemory) return too_much();
    if (WEXITSTATUS(status) == kCutMeanwhile) return phrase("import.cut_meanwhile");
    if (WEXITSTATUS(status) == kNoRoom) return phrase("import.too_large");
    return phrase("import.broke_down", {{"reason", phrase("import.status", {{"status", WEXITSTATUS(status)}})}});
}

// Returns the processor time that the process has used; 0 if the process has ended.
double processor_s(pid_t process) {
    clockid_t its{};
    timespec used{};
    if (::clock_getcpuclockid(process, &its) != 0 || ::clock_gettime(its, &used) != 0) return 0.0;
    return static_cast<double>(used.tv_sec) + 1e-9 * static_cast<double>(used.tv_nsec);
}

double children_cpu_s() {
    rusage use{};
    ::getrusage(RUSAGE_CHILDREN, &use);
    return static_cast<double>(use.ru_utime.tv_sec + use.ru_stime.tv_sec) +
           1e-6 * static_cast<double>(use.ru_utime.tv_usec + use.ru_stime.tv_usec);
}

Result<ReadApart> read_answer(int fd, std::size_t most_bytes) {
    Result<std::string> bytes = everything_in(fd, most_bytes);
    if (!bytes) return tl::unexpected(bytes.error());
    stored::Unpacker unpack(*bytes);
    ReaderAnswer answer;
    unpack(answer);
    if (!unpack.good()) return fail(phrase("import.damaged"));
    if (!answer.read) return tl::unexpected(answer.error);
    bytes->erase(0, bytes->size() - unpack.rest().size());
    return ReadApart{std::move(*bytes), answer.kept, answer.kept_damaged, std::move(answer.beside)};
}

// Starts the program. In the new process, the descriptors in `passed` are 3, 4 and so on.
Result<pid_t> start(const fs::path& program, std::vector<std::string> words, const std::vector<int>& passed) {
    // First move the descriptors to high numbers, so that none is overwritten before it is passed on.
    std::vector<Descriptor> high;
    for (const int fd : passed) high.emplace_back(::fcntl(fd, F_DUPFD_CLOEXEC, 64));
    for (const Descriptor& fd : high)
        if (fd.get() < 0) return fail(reason_of(errno));
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    for (const int quiet : {STDIN_FILENO, STDOUT_FILENO})
        posix_spawn_file_actions_addopen(&actions, quiet, "/dev/null", O_RDWR, 0);
    if (!kSanitized) posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
    int next = kAnswerFd;
    for (const Descriptor& fd : high) posix_spawn_file_actions_adddup2(&actions, fd.get(), next++);
    posix_spawn_file_actions_addclosefrom_np(&actions, next);
    posix_spawnattr_t how;
    posix_spawnattr_init(&how);
    // Put the process into its own process group. Keys of a terminal then signal only this program, which then ends the
    // process.
    sigset_t none, all;
    sigemptyset(&none);
    sigfillset(&all);
    posix_spawnattr_setsigmask(&how, &none);
    posix_spawnattr_setsigdefault(&how, &all);
    posix_spawnattr_setpgroup(&how, 0);
    posix_spawnattr_setflags(&how, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    pid_t process = -1;
    const int status =
        ::posix_spawn(&process, program.c_str(), &actions, &how, argv.data(), confine::environment_with({}).data());
    posix_spawnattr_destroy(&how);
    posix_spawn_file_actions_destroy(&actions);
    if (status != 0) return fail(reason_of(status));
    return process;
}

}  // namespace

fs::path find_reader_program() {
    std::error_code ec;
    const fs::path here = fs::read_symlink("/proc/self/exe", ec).parent_path();
    for (const fs::path& candidate :
         {here / kReaderProgram, here.parent_path() / "libexec" / "handrail" / kReaderProgram})
        if (!ec && ::access(candidate.c_str(), X_OK) == 0) return candidate;
    return {};
}

Result<ReadApart> read_apart(const fs::path& path, const readers::ReadOptions& options, const fs::path& program,
                             const ReaderLimits& limits, const KeptForReader& kept) {
    const std::string name = path.filename().string();
    const auto problem = [&](const std::string& why) {
        return fail(phrase("import.cannot_start", {{"reason", why}}), name);
    };
    const Descriptor answer(::memfd_create("handrail-scene", MFD_CLOEXEC));
    std::array<int, 2> ends{-1, -1};
    if (answer.get() < 0 || ::pipe2(ends.data(), O_CLOEXEC) != 0) return problem(reason_of(errno));
    const Descriptor ours(ends[0]);
    Descriptor theirs(ends[1]);
    if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) != 0) return problem(reason_of(errno));
    const Descriptor files(ends[0]);
    std::string flags = options.unit_is_known ? "1" : "0";
    flags += options.guess_materials ? '1' : '0';
    flags += options.solid_meshes ? '1' : '0';
    const double before_s = children_cpu_s();
    pid_t process = -1;
    {
        const Descriptor progress = std::move(theirs), requested(ends[1]);
        std::vector<int> passed{answer.get(), progress.get(), requested.get()};
        if (kept.file >= 0) passed.push_back(kept.file);
        const Result<pid_t> started =
            start(program,
                  {program.string(), spoken_language(), spoken_language_folder().string(), std::to_string(::getpid()),
                   std::to_string(limits.memory_bytes), std::to_string(limits.cpu_s), name,
                   fmt::format("{}", options.map_metres_per_unit), fmt::format("{}", options.obj_metres_per_unit),
                   flags, options.building, kept.file < 0 ? std::string() : kept.name},
                  passed);
        if (!started) return problem(started.error().message);
        process = *started;
    }
    Reading reading(process);
    const SteadyClock clock;
    // On a busy machine, reading takes long. So the limit of time on the clock ends the process only if it has used no
    // processor time during that time.
    double worked_s = 0.0, idle_since_s = clock.now_s();
    std::string line;
    // True if the process may request files. Unpacking routes and parsing TOML need no world, so `path` is empty.
    bool may_request = !path.empty();
    for (bool open = true; open;) {
        if (options.stop.stop_requested()) return fail(phrase("files.stopped"), name);
        if (const double now_worked_s = processor_s(process); now_worked_s > worked_s) {
            worked_s = now_worked_s;
            idle_since_s = clock.now_s();
        } else if (clock.now_s() - idle_since_s > limits.idle_s) {
            return fail(phrase("import.too_long", {{"seconds", limits.idle_s}}), name);
        }
        std::array<pollfd, 2> wait{pollfd{ours.get(), POLLIN, 0}, pollfd{may_request ? files.get() : -1, POLLIN, 0}};
        if (::poll(wait.data(), wait.size(), kLookEvery_ms) <= 0) continue;
        if (wait[1].revents != 0) may_request = answer_request(files.get(), path);
        if (wait[0].revents == 0) continue;
        std::array<char, 4096> bytes;
        const ssize_t got = ::read(ours.get(), bytes.data(), bytes.size());
        if (got < 0 && errno == EINTR) continue;
        open = got > 0;
        for (ssize_t i = 0; i < got; ++i) {
            if (bytes[static_cast<std::size_t>(i)] != '\n') line += bytes[static_cast<std::size_t>(i)];
            else report_progress(options, std::exchange(line, {}));
        }
    }
    const int status = reading.wait();
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
        return fail(end_words(status, limits, children_cpu_s() - before_s), name);
    return read_answer(answer.get(), limits.answer_bytes);
}

std::string unpack_navigation_apart(const KeptForReader& kept, const fs::path& program, const std::stop_token& stop,
                                    const ReaderLimits& limits) {
    readers::ReadOptions options;
    options.stop = stop;
    // Pass an empty path, because the process unpacks the routes from the cached file in `kept`.
    Result<ReadApart> read = read_apart({}, options, program, limits, kept);
    return read ? std::move(read->scene) : std::string();
}

}  // namespace handrail::importing
