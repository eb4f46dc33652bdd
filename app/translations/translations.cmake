# The texts of the program and of the lessons in other languages, by Qt Linguist.
find_package(Qt6 6.4 REQUIRED COMPONENTS LinguistTools)

# add_translations(target name where FOLDERS...): builds each name_<language>.ts in the folder `where` into the target, as
# its resource :/i18n/name_<language>.qm. They hold the texts of FOLDERS (from the project's top folder).
function(add_translations target name where)
    file(GLOB files CONFIGURE_DEPENDS ${where}/${name}_*.ts)
    set(compiled)
    foreach(file ${files})
        cmake_path(GET file STEM stem)
        set(result ${CMAKE_CURRENT_BINARY_DIR}/i18n/${stem}.qm)
        add_custom_command(OUTPUT ${result}
            COMMAND ${CMAKE_COMMAND} -E make_directory ${CMAKE_CURRENT_BINARY_DIR}/i18n
            COMMAND Qt6::lrelease -silent ${file} -qm ${result}
            DEPENDS ${file} VERBATIM)
        list(APPEND compiled ${result})
    endforeach()
    if(compiled)
        qt_add_resources(${target} ${target}_languages PREFIX /i18n BASE ${CMAKE_CURRENT_BINARY_DIR}/i18n
            FILES ${compiled})
    endif()
    list(JOIN files "|" files) # a list would end at a ; on its way through the build
    list(JOIN ARGN "|" folders)
    set(arguments -D LUPDATE=$<TARGET_FILE:Qt6::lupdate> -D ROOT=${PROJECT_SOURCE_DIR}
        -D WORK=${CMAKE_CURRENT_BINARY_DIR}/${name}.texts -D "FOLDERS=${folders}" -D "FILES=${files}")
    if(files)
        add_custom_target(${target}_texts COMMAND ${CMAKE_COMMAND} ${arguments}
            -P ${PROJECT_SOURCE_DIR}/app/translations/texts.cmake VERBATIM)
        add_dependencies(texts ${target}_texts)
        set_property(GLOBAL APPEND PROPERTY SPRINGSTEP_TRANSLATED ${target})
        set_property(GLOBAL PROPERTY SPRINGSTEP_TEXTS_OF_${target} "${arguments}")
    endif()
endfunction()

# By hand, after texts have changed: brings every .ts up to date and lists what is not translated yet.
add_custom_target(texts)
