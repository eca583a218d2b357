#include "kernel/number/interval.hpp"

namespace delcert {

bool asks_for_what_is_not_there(const Interval& x) { return x.left_behind(); }

}  // namespace delcert
