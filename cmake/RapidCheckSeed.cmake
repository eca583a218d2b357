# The seed of random properties: that of DELCERT_RAPIDCHECK, which tests get as a property; or, if there is none, another
# one each day, which ctest itself sets when it starts, so that a build that is configured once does not keep its seed.
if(DELCERT_RAPIDCHECK MATCHES "seed=")
  set(DELCERT_RAPIDCHECK_ENVIRONMENT ENVIRONMENT "RC_PARAMS=${DELCERT_RAPIDCHECK}")
else()
  set(DELCERT_RAPIDCHECK_ENVIRONMENT "")
  configure_file(${CMAKE_CURRENT_LIST_DIR}/rotating_seed.cmake.in ${CMAKE_CURRENT_BINARY_DIR}/rotating_seed.cmake @ONLY)
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${CMAKE_CURRENT_BINARY_DIR}/rotating_seed.cmake)
endif()
