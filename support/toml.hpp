#pragma once

// toml++, always through this header: its parser is compiled once, in support/toml.cpp, and all programs see the same
// inline functions. toml++ 3.3.0 asserts what a file can break ("[#"), and where assertions are off it lets the
// compiler assume it. Neither: what follows reports the error.
#define TOML_HEADER_ONLY 0
#pragma push_macro("NDEBUG")
#undef NDEBUG
#define TOML_ASSERT(condition) static_cast<void>(0)
#include <toml++/toml.h>
#pragma pop_macro("NDEBUG")
