// Checks guarantees that Handrail's own code makes to itself. A broken contract is a fault of Handrail, never of a
// file, a device or a person (functions that deal with those return Result<T>). A failed check prints its place in the
// source on stderr and ends the program, in every build. Do not use these checks in the servo tick, where a fault must
// lead to zero force instead.
#pragma once

namespace handrail::detail {

[[noreturn]] void contract_failed(const char* condition, const char* file, int line);

}  // namespace handrail::detail

// Checks a whole value: `result` is the Result<void> that the value's validator returned. Only builds with
// HANDRAIL_VALIDATE (the preset "debug") run this check, because it costs about as much as making the value.
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
