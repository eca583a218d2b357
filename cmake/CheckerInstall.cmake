# cmake --install of the checker: the program, the page that says what it reads, its manual page if it has been made, and what
# completes its command line.
set(shared ${CMAKE_CURRENT_LIST_DIR}/..)
install(TARGETS delcert-check RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT checker)
install(FILES ${shared}/LICENSE ${shared}/docs/certificate-format.md DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/delcert-check
  COMPONENT checker)
install(FILES ${CMAKE_BINARY_DIR}/man/delcert-check.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT checker OPTIONAL)
install(FILES ${shared}/cmake/completions/delcert-check DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
  COMPONENT checker)
install(FILES ${shared}/cmake/completions/_delcert-check DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions
  COMPONENT checker)

# The manual pages, from what --help prints: `cmake --build build/release --target man`. Neither ./run nor ./test needs them.
find_program(DELCERT_HELP2MAN help2man)
mark_as_advanced(DELCERT_HELP2MAN)
if(DELCERT_HELP2MAN)
  add_custom_target(man)
endif()

# delcert_manual(page program name [subcommand])
function(delcert_manual page program name)
  if(NOT DELCERT_HELP2MAN)
    return()
  endif()
  add_custom_command(OUTPUT ${CMAKE_BINARY_DIR}/man/${page}.1
    COMMAND ${CMAKE_COMMAND} -E make_directory ${CMAKE_BINARY_DIR}/man
    COMMAND ${CMAKE_COMMAND} -E env LC_ALL=C.UTF-8 ${DELCERT_HELP2MAN} --no-info --name=${name} "--help-option=${ARGN} --help" --version-string=${DELCERT_VERSION}
      --output=${CMAKE_BINARY_DIR}/man/${page}.1 $<TARGET_FILE:${program}>
    DEPENDS ${program} VERBATIM)
  add_custom_target(manual-of-${page} DEPENDS ${CMAKE_BINARY_DIR}/man/${page}.1)
  add_dependencies(man manual-of-${page})
endfunction()
delcert_manual(delcert-check delcert-check "checks certificates of Delaunay triangulations of manifolds")
