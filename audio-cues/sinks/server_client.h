// Shared state of a client and the thread that talks to its server, which may hang. With it, the client can wake the
// thread, tell it to end, or abandon it. Both sides hold it by shared_ptr, because a thread whose server never answers
// outlives its owner.
#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

namespace handrail::sinks {

struct ServerClient {
    static constexpr double kPatienceAtTheEnd_s = 0.5;

    ServerClient();
    ~ServerClient();
    ServerClient(const ServerClient&) = delete;
    ServerClient& operator=(const ServerClient&) = delete;

    const int wake;  // an eventfd on which the thread waits

    std::mutex mutex;  // protects all members below, and those that derived types add
    std::condition_variable ended_changed;
    bool quit = false, ended = false;
    int socket = -1;  // socket of the open connection; the owner shuts it down if the server does not answer

    // Any thread. rouse() wakes the thread; take_wake() consumes the wake-up call.
    void rouse() const;
    void take_wake() const;
};

// Runs `work` on a thread with this name until `quit` is set. On this thread, writing to a server that has gone gives
// an error code and no signal.
std::thread start_client(std::shared_ptr<ServerClient> shared, const char* name, std::function<void()> work);
// Tells the thread to quit and waits at most twice kPatienceAtTheEnd_s, the second time after shutting its connection
// down. A thread that still does not end is left behind and ends when it can.
void end_client(ServerClient& shared, std::thread& thread);

}  // namespace handrail::sinks
