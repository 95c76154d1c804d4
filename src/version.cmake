# Writes version.cpp at every build, so that a result always names its commit. The file changes
# only if its text changes.
#   cmake -DSOURCE=<source folder> -DNUMBER=<version> -DCOMPILER=<name and version> -DOUTPUT=<file> -P version.cmake
find_package(Git QUIET)
set(commit "unknown")
set(dirty "false")
if(GIT_FOUND)
  execute_process(COMMAND ${GIT_EXECUTABLE} -C "${SOURCE}" rev-parse HEAD OUTPUT_VARIABLE found RESULT_VARIABLE status
                  OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(status EQUAL 0)
    set(commit "${found}")
    execute_process(COMMAND ${GIT_EXECUTABLE} -C "${SOURCE}" status --porcelain --untracked-files=no
                    OUTPUT_VARIABLE changes ERROR_QUIET)
    if(NOT changes STREQUAL "")
      set(dirty "true")
    endif()
  endif()
endif()
set(text "#include \"base/version.hpp\"

namespace ehl::program {

Version version() { return {\"${NUMBER}\", \"${commit}\", ${dirty}, \"${COMPILER}\"}; }

}  // namespace ehl::program
")
set(old "")
if(EXISTS "${OUTPUT}")
  file(READ "${OUTPUT}" old)
endif()
if(NOT old STREQUAL text)
  file(WRITE "${OUTPUT}" "${text}")
endif()
