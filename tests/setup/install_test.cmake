# ./run builds delcert and delcert-check only, and what it has built can be installed. The install scripts of this build
# are run with programs that have not been built: without delcert-replay the rest is installed, without one of the two
# others nothing passes for an installation.
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE ${WORK})
file(READ ${BUILD}/cmake_install.cmake script)

# install_without(NAME status): what `cmake --install` does where the program NAME has not been built.
function(install_without name status)
  string(FIND "${script}" "/${name}\"" position)
  if(position EQUAL -1)
    message(FATAL_ERROR "the install script does not speak of ${name}")
  endif()
  string(REPLACE "/${name}\"" "/never-built/${name}\"" changed "${script}")
  # What is copied stays where it was; only the programs of the build are to be missing.
  string(REPLACE "bin/never-built/${name}" "bin/${name}" changed "${changed}")
  file(WRITE ${WORK}/${name}.cmake "${changed}")
  execute_process(COMMAND ${CMAKE_COMMAND} -D CMAKE_INSTALL_PREFIX=${WORK}/without-${name} -P ${WORK}/${name}.cmake
    RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  set(${status} ${result} PARENT_SCOPE)
  set(output "${output}" PARENT_SCOPE)
endfunction()

install_without(delcert-replay status)
if(NOT status EQUAL 0)
  message(SEND_ERROR "without delcert-replay nothing is installed (${status}):\n${output}")
endif()
foreach(name bin/delcert bin/delcert-check share/doc/delcert/README.md)
  if(NOT EXISTS ${WORK}/without-delcert-replay/${name})
    message(SEND_ERROR "without delcert-replay ${name} is not installed")
  endif()
endforeach()
if(EXISTS ${WORK}/without-delcert-replay/bin/delcert-replay)
  message(SEND_ERROR "delcert-replay is installed although it has not been built: the test tests nothing")
endif()

install_without(delcert-check status)
if(status EQUAL 0)
  message(SEND_ERROR "without delcert-check the installation passes")
endif()
file(REMOVE_RECURSE ${WORK})
