# Installs into a folder of its own, builds examples/consumer against that and runs it; where delcert is not
# installed, the same project must not configure.
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE ${WORK})
set(prefix ${WORK}/prefix)

function(run title)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${title} failed (${status}):\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

run("install" ${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix})
foreach(name bin/delcert bin/delcert-check share/delcert/manifolds/torus-3.toml
    share/delcert/claims/circumradius-below-edge.toml share/doc/delcert/certificate-format.md)
  if(NOT EXISTS ${prefix}/${name})
    message(SEND_ERROR "${name} is not installed")
  endif()
endforeach()
file(GLOB_RECURSE texts ${prefix}/lib/*.cmake ${prefix}/include/*.hpp)
foreach(name IN LISTS texts)
  file(READ ${name} content)
  string(FIND "${content}" "${SOURCE}" position)
  if(NOT position EQUAL -1)
    message(SEND_ERROR "${name} points back to the source folder")
  endif()
endforeach()

set(configure ${CMAKE_COMMAND} -G Ninja -S ${SOURCE}/examples/consumer -D CMAKE_CXX_COMPILER=${CXX}
  -D CMAKE_BUILD_TYPE=Release -D CMAKE_CXX_FLAGS_RELEASE=${FLAGS}
  -D CMAKE_EXE_LINKER_FLAGS=${LINKER_FLAGS})
execute_process(COMMAND ${configure} -B ${WORK}/without RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(status EQUAL 0 OR NOT output MATCHES "delcertConfig.cmake")
  message(SEND_ERROR "the consumer configures without an installed delcert:\n${output}")
endif()

run("configure" ${configure} -B ${WORK}/build -D CMAKE_PREFIX_PATH=${prefix})
run("build" ${CMAKE_COMMAND} --build ${WORK}/build)
run("near_square" ${WORK}/build/near_square)
set(expected "delcert ${VERSION}
squared circumradius 1/2
squared thickness 1/16
cocircular corners of the square: proved
after a move by 2^-100: refuted, which took more than doubles
")
if(NOT output STREQUAL expected)
  message(SEND_ERROR "near_square says\n${output}and not\n${expected}")
endif()

run("claim" ${WORK}/build/claim)
if(NOT output MATCHES "^100 triangles, undecided: 0, refuted\n{\n.*\"points\": .*}\ndecided anew: refuted\n$")
  message(SEND_ERROR "claim says\n${output}")
endif()
