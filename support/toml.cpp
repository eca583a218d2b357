// The parser of toml++, for all that include its header.
#define TOML_IMPLEMENTATION
#include "support/toml.hpp"
