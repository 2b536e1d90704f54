// What our own code promises to itself. A broken promise is a fault of Handrail, never of a file, a device or a person (those are Result<T>):
// it names the place on stderr and ends the program, in every build. Not for the servo tick, where a fault means zero force.
#pragma once

namespace handrail::detail {

[[noreturn]] void contract_failed(const char* condition, const char* file, int line);

}  // namespace handrail::detail

#define contract_pre(condition) (static_cast<bool>(condition) ? static_cast<void>(0) : ::handrail::detail::contract_failed(#condition, __FILE_NAME__, __LINE__))
