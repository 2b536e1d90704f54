// What the address sanitizer looks for besides its own in programs of tests that take seconds. It doubles what runs, so
// the long ones go without: what they call these call too.

extern "C" const char* __asan_default_options();

extern "C" const char* __asan_default_options() {
    return "detect_stack_use_after_return=1:strict_string_checks=1:check_initialization_order=1";
}
