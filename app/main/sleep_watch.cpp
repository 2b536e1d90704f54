#include "app/main/sleep_watch.h"

#include <dbus/dbus.h>

#include <cstdlib>
#include <memory>
#include <string>
#include <utility>

#include "worlds/base/clock.h"
#include "worlds/base/executor.h"
#include "worlds/base/language.h"

namespace handrail::program {
namespace {

constexpr int kLook_ms = 50;  // interval at which the thread checks whether it has to end
constexpr const char* kLogin = "org.freedesktop.login1";
constexpr const char* kLoginPath = "/org/freedesktop/login1";
constexpr const char* kManager = "org.freedesktop.login1.Manager";

struct Unref {
    void operator()(DBusMessage* message) const { dbus_message_unref(message); }
};
using Message = std::unique_ptr<DBusMessage, Unref>;

const char* system_bus() {
    const char* address = std::getenv("DBUS_SYSTEM_BUS_ADDRESS");
    return address && *address ? address : "unix:path=/run/dbus/system_bus_socket";
}

Message method(const char* service, const char* path, const char* interface, const char* name) {
    return Message(dbus_message_new_method_call(service, path, interface, name));
}

// Sends a message on the bus. Returns its serial number; 0 if it could not be sent.
unsigned send(DBusConnection* bus, const Message& message) {
    dbus_uint32_t serial = 0;
    return message && dbus_connection_send(bus, message.get(), &serial) ? serial : 0;
}

}  // namespace

SleepWatch::SleepWatch(std::function<void()> release) : release_(std::move(release)) {
    dbus_threads_init_default();
    thread_ = std::jthread([this](const std::stop_token& end) {
        name_this_thread("sleep-watch");
        run(end);
    });
}

SleepWatch::~SleepWatch() = default;

bool SleepWatch::delays_sleep() const {
    const std::lock_guard lock(mutex_);
    return delaying_;
}

void SleepWatch::let_sleep() {
    const std::lock_guard lock(mutex_);
    delaying_ = false;
    inhibitor_ = Descriptor(-1);
}

// Runs on the thread of this object. libdbus's own calls wait up to 25 s for an answer. So this function only sends
// messages, and take() receives the answers.
void SleepWatch::run(const std::stop_token& end) {
    bus_ = dbus_connection_open_private(system_bus(), nullptr);
    if (!bus_) return;
    dbus_connection_set_exit_on_disconnect(bus_, FALSE);
    hello_ = send(bus_, method(DBUS_SERVICE_DBUS, DBUS_PATH_DBUS, DBUS_INTERFACE_DBUS, "Hello"));
    const SteadyClock clock;
    while (!end.stop_requested() && dbus_connection_read_write(bus_, kLook_ms)) {
        while (const Message message{dbus_connection_pop_message(bus_)}) take(message.get());
        if (delays_sleep() && clock.now_s() - announced_s_ > kMostDelay_s) let_sleep();
    }
    dbus_connection_close(bus_);
    dbus_connection_unref(bus_);
    let_sleep();
}

void SleepWatch::take(DBusMessage* message) {
    const unsigned answers = dbus_message_get_reply_serial(message);
    const bool returns = dbus_message_get_type(message) == DBUS_MESSAGE_TYPE_METHOD_RETURN;
    if (returns && answers == hello_) {
        subscribe();
        inhibit();
    } else if (int inhibitor = -1;
               returns && answers == inhibit_ &&
               dbus_message_get_args(message, nullptr, DBUS_TYPE_UNIX_FD, &inhibitor, DBUS_TYPE_INVALID)) {
        const std::lock_guard lock(mutex_);
        inhibitor_ = Descriptor(inhibitor);
    } else if (dbus_bool_t sleeps = FALSE;
               dbus_message_is_signal(message, kManager, "PrepareForSleep") &&
               dbus_message_get_args(message, nullptr, DBUS_TYPE_BOOLEAN, &sleeps, DBUS_TYPE_INVALID)) {
        if (sleeps) {
            release_();
            announced_s_ = SteadyClock().now_s();
            const std::lock_guard lock(mutex_);
            delaying_ = true;
        } else {
            let_sleep();
            woken_ = true;
            inhibit();
        }
    }
}

void SleepWatch::subscribe() {
    const Message match = method(DBUS_SERVICE_DBUS, DBUS_PATH_DBUS, DBUS_INTERFACE_DBUS, "AddMatch");
    const char* rule =
        "type='signal',sender='org.freedesktop.login1',interface='org.freedesktop.login1.Manager',"
        "member='PrepareForSleep'";
    if (match && dbus_message_append_args(match.get(), DBUS_TYPE_STRING, &rule, DBUS_TYPE_INVALID)) send(bus_, match);
}

void SleepWatch::inhibit() {
    const Message message = method(kLogin, kLoginPath, kManager, "Inhibit");
    const std::string reason = phrase("program.delays_sleep");
    const char *what = "sleep", *who = "Handrail", *why = reason.c_str(), *mode = "delay";
    if (message && dbus_message_append_args(message.get(), DBUS_TYPE_STRING, &what, DBUS_TYPE_STRING, &who,
                                            DBUS_TYPE_STRING, &why, DBUS_TYPE_STRING, &mode, DBUS_TYPE_INVALID))
        inhibit_ = send(bus_, message);
}

}  // namespace handrail::program
