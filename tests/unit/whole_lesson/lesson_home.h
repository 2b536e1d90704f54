// Provides what tests of lessons need: a private home folder, a learner who consents to everything, the lesson as the
// command line begins it, and the instructor's desk.
#pragma once

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstring>
#include <span>
#include <sstream>
#include <string>

#include "app/learners/learners.h"
#include "app/main/learner_start.h"
#include "tests/support/environment.h"
#include "tests/support/names.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/whole_lesson/sitting.h"

namespace handrail::test {

inline constexpr const char* kPupil = "Oak Owl";

// Sends commands to the desk of the current lesson, as `handrail lesson watch` does.
class DeskLine {
public:
    DeskLine() : socket_(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        const std::string path = (desk_folder() / fmt::format("{}.sock", ::getpid())).string();
        std::strncpy(static_cast<char*>(address.sun_path), path.c_str(), sizeof address.sun_path - 1);
        connected_ = ::connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
    }
    ~DeskLine() { ::close(socket_); }
    DeskLine(const DeskLine&) = delete;
    DeskLine& operator=(const DeskLine&) = delete;
    bool connected() const { return connected_; }
    // Sends a command to the desk. Returns what the desk has sent since the last call, including the answer to this
    // command.
    std::string order(Sitting& sitting, const std::string& words) const {
        const std::string line = words + "\n";
        if (::send(socket_, line.data(), line.size(), MSG_NOSIGNAL) != static_cast<ssize_t>(line.size())) return {};
        sitting.live(0.5);
        std::string reported(4096, '\0');
        const ssize_t got = ::recv(socket_, reported.data(), reported.size(), MSG_DONTWAIT);
        reported.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
        return reported;
    }

private:
    int socket_;
    bool connected_ = false;
};

class LessonHome : public testing::Test {
protected:
    void SetUp() override {
        for (const char* name : {"data", "state", "config", "run"})
            std::filesystem::create_directories(home_.path() / name);
        std::filesystem::permissions(home_.path() / "run", std::filesystem::perms::owner_all);
    }
    // Makes a learner who consents to the purposes in `agreed`.
    static Learner pupil(std::span<const Purpose> agreed = kPurposes) {
        Learners learners(user_data_folder());
        const auto made = learners.make(kPupil, {});
        EXPECT_TRUE(made) << made.error().sentence();
        if (!made) return {};
        EXPECT_TRUE(learners.change(made->id, [&](Learner& one) {
            for (const Purpose purpose : agreed) one.consent(purpose) = Consent{today(), {}, {}};
        }));
        return *made;
    }

    // Returns the arguments of `handrail lesson FILE --learner NAME --session N`.
    static ExploreArguments taught(const std::filesystem::path& file, std::size_t session) {
        LessonCall call;
        call.arguments.file = file;
        call.arguments.session = session;
        call.arguments.learner = kPupil;
        call.explore.arguments.program_version = "1.0";
        if (const auto begun = begin_as_learner(call); !begun) ADD_FAILURE() << begun.error().sentence();
        std::ostringstream out, err;
        EXPECT_FALSE(run_lesson(call.arguments, call.explore.arguments, out, err)) << err.str();
        return call.explore.arguments;
    }

    TemporaryFolder home_;
    WithEnvironment data_{"XDG_DATA_HOME", (home_.path() / "data").c_str()},
        state_{"XDG_STATE_HOME", (home_.path() / "state").c_str()},
        config_{"XDG_CONFIG_HOME", (home_.path() / "config").c_str()},
        run_{"XDG_RUNTIME_DIR", (home_.path() / "run").c_str()};
};

}  // namespace handrail::test
