# Debian requires compressed man pages and changelogs. -n leaves out the time, so that equal files stay equal.
file(GLOB_RECURSE files ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/changelog
    ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/springstep.1)
foreach(file IN LISTS files)
    execute_process(COMMAND gzip -9nf ${file} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
