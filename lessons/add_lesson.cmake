# springstep_add_lesson(NAME FOLDER): builds the plugin lesson_NAME of the lesson in FOLDER: its *.cpp and *.h, all of which
# the code panel can show, the documents of its steps, <step>.md and <step>.<language>.md, their listings, <step>.code, the
# scene that its project starts with, project.json, and the experiments that come with it, examples/*.json. Springstep's own
# CMake files and find_package(Springstep) both include this file.
function(springstep_add_lesson name folder)
    file(GLOB sources CONFIGURE_DEPENDS ${folder}/*.cpp ${folder}/*.h)
    qt_add_plugin(lesson_${name} SHARED)
    target_sources(lesson_${name} PRIVATE ${sources}) # qt_add_plugin of Qt 6.4 drops sources that it is given
    target_include_directories(lesson_${name} PRIVATE ${folder})
    target_link_libraries(lesson_${name} PRIVATE Springstep::lesson_api)
    set_target_properties(lesson_${name} PROPERTIES AUTOMOC ON)

    file(GLOB documents CONFIGURE_DEPENDS ${folder}/*.md ${folder}/project.json)
    file(GLOB listings CONFIGURE_DEPENDS ${folder}/*.code)
    file(GLOB examples CONFIGURE_DEPENDS ${folder}/examples/*.json)
    qt_add_resources(lesson_${name} source_${name} PREFIX /source/lessons/${name} BASE ${folder} FILES ${sources})
    qt_add_resources(lesson_${name} documents_${name} PREFIX /documents/${name} BASE ${folder} FILES ${documents})
    if(listings)
        qt_add_resources(lesson_${name} listings_${name} PREFIX /listings/${name} BASE ${folder} FILES ${listings})
    endif()
    if(examples)
        qt_add_resources(lesson_${name} examples_${name} PREFIX /examples/${name} BASE ${folder}/examples
            FILES ${examples})
    endif()
endfunction()
