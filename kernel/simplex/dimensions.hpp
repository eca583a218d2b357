#pragma once

/// Instantiates X(m) for every dimension that the runs support.
#define DELCERT_FOR_EACH_DIMENSION(X) X(1) X(2) X(3) X(4)
