# cmake --install: the programs, the libraries with their headers, the manifolds and claims of the examples, the
# docs, and what find_package(delcert) reads.
include(CMakePackageConfigHelpers)
include(CheckerInstall)
set(DELCERT_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/delcert)

set_target_properties(delcert_rigour PROPERTIES EXPORT_NAME rigour)
set_target_properties(delcert_support PROPERTIES EXPORT_NAME support)
set_target_properties(delcert_kernel PROPERTIES EXPORT_NAME kernel)
set_target_properties(delcert_certificates PROPERTIES EXPORT_NAME certificates)
set_target_properties(delcert_spectra PROPERTIES EXPORT_NAME spectra)
set_target_properties(delcert_ranks PROPERTIES EXPORT_NAME ranks)
set_target_properties(delcert_publication PROPERTIES EXPORT_NAME publication)
set_target_properties(delcert_proofs PROPERTIES EXPORT_NAME proofs)
set_target_properties(delcert_properties PROPERTIES EXPORT_NAME properties)
install(TARGETS delcert_rigour delcert_support delcert_kernel delcert_certificates EXPORT delcert
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
install(TARGETS delcert delcert-certify RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT delcert)
# What ./run builds only when it is called for: a folder where it has not been built is installed without it.
install(TARGETS delcert_spectra delcert_publication delcert_proofs delcert_properties EXPORT delcert-claims
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development OPTIONAL)
install(TARGETS delcert_ranks EXPORT delcert-ranks
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development OPTIONAL)
install(TARGETS delcert-publish delcert-claims delcert-replay RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT delcert OPTIONAL)

# Below include/delcert/, so that consumers write the same includes as we do.
foreach(folder support kernel proofs/constants proofs/certificate proofs/formula proofs/prover properties/instances properties/attack)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${folder}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/delcert/${folder}
    COMPONENT development FILES_MATCHING PATTERN "*.hpp")
endforeach()
install(FILES ${PROJECT_BINARY_DIR}/generated/delcert_version.hpp DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/delcert
  COMPONENT development)

install(DIRECTORY ${PROJECT_SOURCE_DIR}/examples/manifolds ${PROJECT_SOURCE_DIR}/examples/claims ${PROJECT_SOURCE_DIR}/examples/complexes
  DESTINATION ${CMAKE_INSTALL_DATADIR}/delcert COMPONENT delcert)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/examples/campaigns ${PROJECT_SOURCE_DIR}/examples/checks DESTINATION ${CMAKE_INSTALL_DATADIR}/delcert COMPONENT delcert
  USE_SOURCE_PERMISSIONS)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs/ DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT delcert)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/README.md ${PROJECT_SOURCE_DIR}/CHANGELOG.md
  ${PROJECT_SOURCE_DIR}/CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT delcert)
install(FILES ${PROJECT_SOURCE_DIR}/cmake/completions/delcert DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
  COMPONENT delcert)
install(FILES ${PROJECT_SOURCE_DIR}/cmake/completions/_delcert DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions
  COMPONENT delcert)
# What the checker is built from: `delcert bundle` puts it into supplements.
file(STRINGS ${PROJECT_SOURCE_DIR}/cmake/checker-source.txt checker_source)
foreach(path IN LISTS checker_source)
  if(path MATCHES "/$")
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/${path} DESTINATION ${CMAKE_INSTALL_DATADIR}/delcert/checker-source/${path} COMPONENT delcert)
  else()
    cmake_path(GET path PARENT_PATH folder)
    install(FILES ${PROJECT_SOURCE_DIR}/${path} DESTINATION ${CMAKE_INSTALL_DATADIR}/delcert/checker-source/${folder} COMPONENT delcert)
  endif()
endforeach()
# ./run asks whether what is installed is what stands here.
install(FILES ${PROJECT_BINARY_DIR}/generated/commit DESTINATION ${CMAKE_INSTALL_DATADIR}/delcert COMPONENT delcert)
install(DIRECTORY ${PROJECT_BINARY_DIR}/man/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT delcert OPTIONAL
  FILES_MATCHING PATTERN "delcert.1" PATTERN "delcert-*.1" PATTERN "delcert-check.1" EXCLUDE)

install(EXPORT delcert NAMESPACE delcert:: FILE delcertTargets.cmake DESTINATION ${DELCERT_PACKAGE_DIR} COMPONENT development)
install(EXPORT delcert-claims NAMESPACE delcert:: FILE delcertClaimsTargets.cmake DESTINATION ${DELCERT_PACKAGE_DIR}
  COMPONENT development)
install(EXPORT delcert-ranks NAMESPACE delcert:: FILE delcertRanksTargets.cmake DESTINATION ${DELCERT_PACKAGE_DIR}
  COMPONENT development)
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/delcertConfig.cmake.in
  ${PROJECT_BINARY_DIR}/generated/delcertConfig.cmake INSTALL_DESTINATION ${DELCERT_PACKAGE_DIR})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/generated/delcertConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/generated/delcertConfig.cmake
  ${PROJECT_BINARY_DIR}/generated/delcertConfigVersion.cmake ${PROJECT_SOURCE_DIR}/cmake/Libraries.cmake
  ${PROJECT_SOURCE_DIR}/cmake/CheckerLibraries.cmake
  DESTINATION ${DELCERT_PACKAGE_DIR} COMPONENT development)

foreach(subcommand attack bundle campaign certify cite claims constants errata export figure formalise homology info manifolds power prove report sample
    split tables tighten)
  delcert_manual(delcert-${subcommand} delcert "delcert ${subcommand}" ${subcommand})
  if(TARGET manual-of-delcert-${subcommand})
    add_dependencies(manual-of-delcert-${subcommand} delcert-publish delcert-claims)
  endif()
endforeach()
delcert_manual(delcert delcert "certified Delaunay triangulations of manifolds")
include(Packages)
