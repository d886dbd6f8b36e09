# SPDX-License-Identifier: LGPL-2.1-or-later
# Writes OUTPUT, a header that says which commit of SOURCE is built, with a plus behind it
# if files differ from it; "unknown" where there is no git or no clone. A header that says
# so already stays untouched, and nothing is compiled again.
#
# Usage: cmake -DSOURCE=DIR -DOUTPUT=FILE -P commit.cmake
find_program(GIT git)
set(commit "unknown")
if(GIT)
  execute_process(COMMAND ${GIT} -C ${SOURCE} describe --always --exclude=* --abbrev=12 --dirty=+
    OUTPUT_VARIABLE found OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE status)
  if(status EQUAL 0)
    set(commit "${found}")
  endif()
endif()
set(text "#define LAMELLA_COMMIT \"${commit}\"\n")
set(old "")
if(EXISTS ${OUTPUT})
  file(READ ${OUTPUT} old)
endif()
if(NOT text STREQUAL old)
  file(WRITE ${OUTPUT} "${text}")
endif()
