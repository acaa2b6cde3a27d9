# SPDX-License-Identifier: MIT
# cmake -DCTEST= -DBUILD= -DROWS= -DPAGE_PROGRAM= -DPAGE= -DCOMPILER= -DFLAGS= -P write_page.cmake
# Runs the suites with a fresh file of rows and writes the page, also where a test failed; then fails as ctest did.
file(REMOVE ${ROWS})
set(ENV{BOLIDE_VERIFY_TABLE} ${ROWS})
execute_process(COMMAND ${CTEST} --test-dir ${BUILD} --output-on-failure --no-tests=error -L "verify|extreme" RESULT_VARIABLE tests)
execute_process(COMMAND ${PAGE_PROGRAM} ${ROWS} ${PAGE} "compiler=${COMPILER}" "flags=${FLAGS}" RESULT_VARIABLE page)
if(NOT page EQUAL 0)
  message(FATAL_ERROR "the page was not written")
endif()
if(NOT tests EQUAL 0)
  message(FATAL_ERROR "the page is written, but a test failed: see above")
endif()
