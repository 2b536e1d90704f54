// Holds the state that a client shares with the thread that talks to the client's server, which may hang. Through it,
// the client can wake the thread, tell it to end, or abandon it. Both sides hold it by shared_ptr, because a thread
// whose server never answers outlives its owner.
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

// Runs `work` on a thread called `name` until `quit` is set. If that thread writes to a server that has gone, the call
// returns an error code and no signal is raised.
std::thread start_client(std::shared_ptr<ServerClient> shared, const char* name, std::function<void()> work);
// Tells the thread to quit and waits for at most kPatienceAtTheEnd_s. If the thread is still running, shuts its
// connection down and waits that long again. A thread that still does not end is left behind and ends when it can.
void end_client(ServerClient& shared, std::thread& thread);

}  // namespace handrail::sinks
