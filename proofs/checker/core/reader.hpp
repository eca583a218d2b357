#pragma once

#include "proofs/checker/certificate/certificate.hpp"
#include "proofs/checker/core/data.hpp"

namespace delcert::checker::core {

/// What a certificate of a flat torus or a space form says of its complex. Refers to the certificate.
Data data_of(const Certificate& c);

/// exp_o v in the linear model, K != 0.
Vector<Interval> exponential(int K, std::size_t m, const Vector<Interval>& v);

}  // namespace delcert::checker::core
