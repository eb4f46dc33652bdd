# Looks for the texts of FOLDERS (below ROOT) and brings the translations FILES up to date; with CHECK in copies only, and
# fails where one of them lacks a text. Lists what is not translated. Items of FOLDERS and FILES are separated by |.
# WORK: a folder for the copies; LUPDATE: the tool.
cmake_policy(VERSION 3.25)
string(REPLACE "|" ";" FOLDERS "${FOLDERS}")
string(REPLACE "|" ";" FILES "${FILES}")

# What lupdate does not know by itself: sim marks its texts with SIM_TEXT, as it knows no Qt; a lesson.json has a title
# and a summary. So it reads copies that say it in lupdate's way.
function(copy_texts folder)
    file(GLOB_RECURSE sources RELATIVE ${ROOT} ${ROOT}/${folder}/*.cpp ${ROOT}/${folder}/*.h)
    foreach(source ${sources})
        file(READ ${ROOT}/${source} text)
        string(REPLACE "SIM_TEXT(" "QT_TRANSLATE_NOOP(\"sim\", " text "${text}")
        file(WRITE ${WORK}/${source} "${text}")
    endforeach()
    file(GLOB lesson ${ROOT}/${folder}/lesson.json)
    if(lesson)
        file(READ ${lesson} description)
        foreach(field title summary)
            string(JSON text GET "${description}" ${field})
            string(REGEX REPLACE "([\"\\\\])" "\\\\\\1" text "${text}")
            file(APPEND ${WORK}/${folder}/lesson.json.cpp "QT_TRANSLATE_NOOP(\"lesson.json\", \"${text}\")\n")
        endforeach()
    endif()
endfunction()

# The texts without a translation in a file, one a line.
function(list_missing file result)
    file(READ ${file} text)
    foreach(letter "&apos;/'" "&quot;/\"" "&gt;/>" "&amp;/&" ";/,") # a list of CMake's ends its items at ;
        string(REGEX MATCH "^(.*)/(.*)$" both "${letter}")
        string(REPLACE "${CMAKE_MATCH_1}" "${CMAKE_MATCH_2}" text "${text}")
    endforeach()
    string(REGEX REPLACE "\\[|\\]" "|" text "${text}")
    string(REGEX MATCHALL "<source>[^<]*</source>[^/]*(<comment>[^<]*</comment>[^/]*)?<translation type=\"unfinished\"" found
        "${text}")
    list(TRANSFORM found REPLACE "<source>([^<]*)</source>.*" "  \\1")
    set(${result} "${found}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${WORK})
set(copies)
foreach(folder ${FOLDERS})
    copy_texts(${folder})
    list(APPEND copies ${WORK}/${folder})
endforeach()

set(lacking)
foreach(file ${FILES})
    set(updated ${file})
    cmake_path(GET file STEM stem)
    if(CHECK)
        set(updated ${WORK}/${stem}.ts)
        file(COPY_FILE ${file} ${updated})
    endif()
    set(plural)
    if(stem MATCHES "_en$") # there, only texts with a number differ from the code's
        set(plural -pluralonly)
    endif()
    execute_process(
        COMMAND ${LUPDATE} -silent -no-obsolete -locations none -extensions cpp,h -I ${WORK} ${plural} ${copies}
                -ts ${updated}
        RESULT_VARIABLE failed ERROR_VARIABLE said OUTPUT_VARIABLE said)
    if(failed)
        message(FATAL_ERROR "${said}")
    endif()
    list_missing(${updated} missing)
    list(LENGTH missing count)
    if(count)
        list(APPEND lacking ${stem})
        list(JOIN missing "\n" lines)
        message("${stem}.ts: not translated: ${count}\n${lines}")
    endif()
endforeach()
if(CHECK AND lacking)
    list(JOIN lacking ", " names)
    message(FATAL_ERROR "Translate what is missing in ${names}: run the target texts, then Qt Linguist.")
endif()
