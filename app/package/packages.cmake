# The target `package`: springstep_*.deb and springstep-dev_*.deb in the build folder. See app/README.md.
find_program(SPRINGSTEP_DPKG dpkg-shlibdeps DOC "Finds the packages that a Debian package depends on")
if(NOT SPRINGSTEP_DPKG)
    return()
endif()

# The maintainer is the person who distributes the package. Debian's own tools read the same variables.
set(CPACK_PACKAGE_CONTACT "Springstep developers <springstep@example.org>")
if(DEFINED ENV{DEBFULLNAME} AND DEFINED ENV{DEBEMAIL})
    set(CPACK_PACKAGE_CONTACT "$ENV{DEBFULLNAME} <$ENV{DEBEMAIL}>")
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME springstep)
set(CPACK_PACKAGE_VENDOR "Springstep developers")
set(CPACK_COMPONENTS_ALL program development)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE
    GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/compress.cmake)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME springstep)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION education)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/bin)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "fonts-inter, fonts-hack, qt6-translations-l10n, qt6-wayland")
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "physically based animation, step by step
Springstep teaches physically based animation in lessons, from one spring to
creatures that walk, a tree in the wind and a ragdoll to throw. Stop time
anywhere, even inside a frame, and see the code that runs beside the picture.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME springstep-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "springstep (= ${PROJECT_VERSION}), libeigen3-dev (>= 3.4)")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SUGGESTS "qt6-base-dev (>= 6.4)")
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "headers of Springstep's simulation core and lessons
With these files, CMake finds Springstep::sim, the simulation core, which
needs no Qt, and Springstep::lesson_api, with which lessons are written.")

configure_file(changelog.in changelog @ONLY)
foreach(component program development)
    string(TOUPPER ${component} key)
    set(documents ${CMAKE_INSTALL_DATADIR}/doc/${CPACK_DEBIAN_${key}_PACKAGE_NAME})
    install(FILES copyright ${CMAKE_CURRENT_BINARY_DIR}/changelog DESTINATION ${documents}
        COMPONENT ${component} EXCLUDE_FROM_ALL)
endforeach()

include(CPack)
