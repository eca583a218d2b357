# Nothing yet but the project's version, as a header that every program prints from.
configure_file(${PROJECT_SOURCE_DIR}/cmake/version.hpp.in ${PROJECT_BINARY_DIR}/generated/delcert_version.hpp @ONLY)
