# Copyright 2026 The spigolo authors
# SPDX-License-Identifier: Apache-2.0
#
# Installs BUILD below SCRATCH, then configures, builds and runs tests/package/outside against it.
set(prefix ${SCRATCH}/prefix)
set(outside ${SCRATCH}/outside)
file(REMOVE_RECURSE ${prefix} ${outside})

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "failed: ${ARGN}")
  endif()
endfunction()

run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix})
run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/outside -B ${outside} -G ${GENERATOR}
    -D CMAKE_PREFIX_PATH=${prefix} -D CMAKE_CXX_COMPILER=${COMPILER})
run(${CMAKE_COMMAND} --build ${outside})
run(${outside}/outside)

file(GLOB_RECURSE private ${prefix}/include/*-inl.h ${prefix}/include/*.cpp)
if(private)
  message(FATAL_ERROR "private files are installed: ${private}")
endif()

# A header can be included alone. The build shows it of those with a source file, which includes its
# header first; the others are tried here.
file(GLOB_RECURSE headers RELATIVE ${prefix}/include ${prefix}/include/*.h)
foreach(header IN LISTS headers)
  string(REGEX REPLACE "[.]h$" ".cpp" source ${CMAKE_CURRENT_LIST_DIR}/../../src/${header})
  if(NOT EXISTS ${source})
    run(${COMPILER} -std=c++20 -fsyntax-only -I ${prefix}/include -include ${header} -x c++ /dev/null)
  endif()
endforeach()
