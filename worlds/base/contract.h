// What our own code promises to itself. A broken promise is a fault of Handrail, never of a file, a device or a person
// (those are Result<T>): it names the place on stderr and ends the program, in every build. Not for the servo tick,
// where a fault means zero force.
#pragma once

namespace handrail::detail {

[[noreturn]] void contract_failed(const char* condition, const char* file, int line);

}  // namespace handrail::detail

// Looks all of a value through with its validator, a Result<void>, in builds with HANDRAIL_VALIDATE alone (the preset
// debug): it costs about as much as what made the value.
#ifdef HANDRAIL_VALIDATE
#define contract_valid(result)                                                                                    \
    do {                                                                                                          \
        if (const auto looked_through = (result); !looked_through)                                                \
            ::handrail::detail::contract_failed(looked_through.error().message.c_str(), __FILE_NAME__, __LINE__); \
    } while (false)
#else
#define contract_valid(result) static_cast<void>(0)
#endif

#define contract_pre(condition)                          \
    (static_cast<bool>(condition) ? static_cast<void>(0) \
                                  : ::handrail::detail::contract_failed(#condition, __FILE_NAME__, __LINE__))
