#include "app/accessible/reader_watch.h"

#include <sys/stat.h>

#include <cstdlib>
#include <string>
#include <string_view>

namespace handrail::accessible {
namespace {

struct FreeVariant {
    void operator()(GVariant* variant) const { g_variant_unref(variant); }
};
using Variant = std::unique_ptr<GVariant, FreeVariant>;

constexpr int kCallPatience_ms = 1000;

Variant call(GDBusConnection* bus, const char* name, const char* path, const char* interface, const char* method,
             GVariant* arguments) {
    return Variant(g_dbus_connection_call_sync(bus, name, path, interface, method, arguments, nullptr,
                                               G_DBUS_CALL_FLAGS_NO_AUTO_START, kCallPatience_ms, nullptr, nullptr));
}

GDBusConnection* open(const gchar* address) {
    constexpr auto kFlags = static_cast<GDBusConnectionFlags>(G_DBUS_CONNECTION_FLAGS_AUTHENTICATION_CLIENT |
                                                              G_DBUS_CONNECTION_FLAGS_MESSAGE_BUS_CONNECTION);
    return g_dbus_connection_new_for_address_sync(address, kFlags, nullptr, nullptr, nullptr);
}

}  // namespace

bool session_bus_is_there() {
    const char* address = std::getenv("DBUS_SESSION_BUS_ADDRESS");
    if (address && *address) return std::string_view(address) != "disabled:";
    const char* folder = std::getenv("XDG_RUNTIME_DIR");
    struct stat socket {};
    return folder && ::stat((std::string(folder) + "/bus").c_str(), &socket) == 0 && S_ISSOCK(socket.st_mode);
}

bool ReaderWatch::listens() {
    if (!connect()) return false;
    const Variant answer = call(bus_.get(), "org.a11y.atspi.Registry", "/org/a11y/atspi/registry",
                                "org.a11y.atspi.Registry", "GetRegisteredEvents", nullptr);
    if (!answer || !g_variant_is_of_type(answer.get(), G_VARIANT_TYPE("(a(ss))"))) return false;
    GVariantIter* events = nullptr;
    g_variant_get(answer.get(), "(a(ss))", &events);
    const gchar* who = nullptr;
    const gchar* event = nullptr;
    bool names = false, focus = false;
    while (g_variant_iter_loop(events, "(&s&s)", &who, &event)) {
        names |= g_ascii_strcasecmp(event, "Object:PropertyChange:AccessibleName") == 0 ||
                 g_ascii_strcasecmp(event, "Object:PropertyChange:") == 0;
        focus |= g_ascii_strcasecmp(event, "Object:StateChanged:Focused") == 0 ||
                 g_ascii_strcasecmp(event, "Object:StateChanged:") == 0;
    }
    g_variant_iter_free(events);
    return names && focus;
}

// Connects to the bus that screen readers use, if that bus runs. Never starts the bus.
bool ReaderWatch::connect() {
    if (bus_ && !g_dbus_connection_is_closed(bus_.get())) return true;
    forget();
    if (!session_ || g_dbus_connection_is_closed(session_.get())) {
        session_.reset();
        gchar* address = g_dbus_address_get_for_bus_sync(G_BUS_TYPE_SESSION, nullptr, nullptr);
        if (address) session_.reset(open(address));
        g_free(address);
        if (!session_) return false;
    }
    const Variant answer = call(session_.get(), "org.a11y.Bus", "/org/a11y/bus", "org.a11y.Bus", "GetAddress", nullptr);
    if (!answer || !g_variant_is_of_type(answer.get(), G_VARIANT_TYPE("(s)"))) return false;
    const gchar* address = nullptr;
    g_variant_get(answer.get(), "(&s)", &address);
    bus_.reset(open(address));
    if (!bus_) return false;
    for (const auto& [interface, member] : {std::pair{"org.a11y.atspi.Registry", static_cast<const char*>(nullptr)},
                                            {"org.freedesktop.DBus", "NameOwnerChanged"}})
        subscriptions_.push_back(g_dbus_connection_signal_subscribe(
            bus_.get(), nullptr, interface, member, nullptr, nullptr, G_DBUS_SIGNAL_FLAGS_NONE,
            [](GDBusConnection*, const gchar*, const gchar*, const gchar*, const gchar*, GVariant*, gpointer self) {
                static_cast<ReaderWatch*>(self)->news_();
            },
            this, nullptr));
    return true;
}

void ReaderWatch::forget() {
    for (const guint subscription : subscriptions_) g_dbus_connection_signal_unsubscribe(bus_.get(), subscription);
    subscriptions_.clear();
    bus_.reset();
}

}  // namespace handrail::accessible
