# cpack: Debian packages, one for the checker and, where the whole is built, one for the program and one for consumers of the
# library; and a tarball of all of it that can be unpacked anywhere. cmake/package.sh makes them.
set(CPACK_PACKAGE_NAME ${PROJECT_NAME})
set(CPACK_PACKAGE_VENDOR "The delcert developers")
set(CPACK_PACKAGE_CONTACT "The delcert developers")
set(CPACK_PACKAGE_VERSION ${DELCERT_VERSION})
set(CPACK_PACKAGE_FILE_NAME ${PROJECT_NAME}-${DELCERT_VERSION}-${CMAKE_SYSTEM_NAME}-${CMAKE_SYSTEM_PROCESSOR})
set(CPACK_RESOURCE_FILE_LICENSE ${CMAKE_CURRENT_LIST_DIR}/../LICENSE)
# gzip: an empty Debian has no zstd.
set(CPACK_GENERATOR DEB TGZ)
set(CPACK_STRIP_FILES ON)
# What was not built is not packed.
set(CPACK_COMPONENTS_ALL checker)
if(TARGET delcert)
  list(APPEND CPACK_COMPONENTS_ALL delcert development)
endif()

if(TARGET _delcert)
  # The module is for one version of Python only.
  get_target_property(DELCERT_PYTHON_VERSION _delcert DELCERT_PYTHON_VERSION)
  get_target_property(DELCERT_NEXT_PYTHON _delcert DELCERT_NEXT_PYTHON)
  list(APPEND CPACK_COMPONENTS_ALL python)
endif()

set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SECTION math)
set(CPACK_DEBIAN_CHECKER_PACKAGE_NAME delcert-check)
set(CPACK_DEBIAN_CHECKER_DESCRIPTION "checks certificates of Delaunay triangulations of manifolds
Verifies anew what delcert has certified, with code and arithmetic of its own.")
set(CPACK_DEBIAN_DELCERT_PACKAGE_NAME delcert)
set(CPACK_DEBIAN_DELCERT_PACKAGE_DEPENDS "delcert-check (= ${DELCERT_VERSION})")
set(CPACK_DEBIAN_DELCERT_DESCRIPTION "certified Delaunay triangulations of manifolds
Runs the perturbation algorithm of Boissonnat, Dyer and Ghosh in exact arithmetic, writes certificates, and attacks
and proves the lemmas behind it.")
set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-delcert)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
  "delcert-check (= ${DELCERT_VERSION}), python3 (>= ${DELCERT_PYTHON_VERSION}), python3 (<< ${DELCERT_NEXT_PYTHON}), python3-numpy")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-gudhi, python3-meshio, python3-vtk9, regina-normal")
set(CPACK_DEBIAN_PYTHON_DESCRIPTION "certified Delaunay triangulations of manifolds, from Python
Certifies, attacks and draws in the process that calls it; has certificates checked by delcert-check.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libdelcert-dev)
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "libraries and headers of delcert
Static libraries for programs that decide exactly; find_package(delcert) says what else they need.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SHLIBDEPS OFF)
set(CPACK_PROJECT_CONFIG_FILE ${CMAKE_CURRENT_LIST_DIR}/PackagesByGenerator.cmake)
include(CPack)
