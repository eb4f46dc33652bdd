# The headers of sim and of lessons/api, and the files with which find_package(Springstep) finds them.
include(CMakePackageConfigHelpers)
set(config ${CMAKE_INSTALL_LIBDIR}/cmake/Springstep)

foreach(folder sim lessons/api)
    file(GLOB_RECURSE headers RELATIVE ${PROJECT_SOURCE_DIR} CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${folder}/*.h)
    foreach(header IN LISTS headers)
        cmake_path(GET header PARENT_PATH where)
        install(FILES ${PROJECT_SOURCE_DIR}/${header} DESTINATION ${SPRINGSTEP_INSTALL_INCLUDEDIR}/${where}
            COMPONENT development)
    endforeach()
endforeach()

install(EXPORT sim NAMESPACE Springstep:: FILE SpringstepSim.cmake DESTINATION ${config} COMPONENT development)
install(EXPORT lesson_api NAMESPACE Springstep:: FILE SpringstepLessonApi.cmake DESTINATION ${config}
    COMPONENT development)
configure_package_config_file(SpringstepConfig.cmake.in SpringstepConfig.cmake INSTALL_DESTINATION ${config})
write_basic_package_version_file(SpringstepConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/SpringstepConfig.cmake
    ${CMAKE_CURRENT_BINARY_DIR}/SpringstepConfigVersion.cmake
    ${PROJECT_SOURCE_DIR}/lessons/add_lesson.cmake DESTINATION ${config} COMPONENT development)
