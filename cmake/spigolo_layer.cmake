# Copyright 2026 The spigolo authors
# SPDX-License-Identifier: Apache-2.0
#
# spigolo_layer(NAME SOURCES a.cpp ... LAYERS core ... PRIVATE TBB::tbb ...)
#   one static library a layer, target spigolo_NAME, exported as spigolo::NAME
# spigolo_target(TARGET)
#   the language level, warnings and sanitizers that every target of ours gets

function(spigolo_target target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF POSITION_INDEPENDENT_CODE ON)
  # -ffp-contract=off: the same bits on every instruction set, fused multiply-add or not
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wshadow -Wconversion -Werror
                                           -ffp-contract=off)
  # gcc 12 sees overlaps in std::string where there are none (gcc bug 105651)
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O3>)
  if(SPIGOLO_SANITIZE)
    target_compile_options(${target} PRIVATE -fsanitize=${SPIGOLO_SANITIZE}
                                             -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_link_options(${target} PUBLIC -fsanitize=${SPIGOLO_SANITIZE})
  endif()
endfunction()

function(spigolo_layer name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LAYERS;PRIVATE" ${ARGN})
  add_library(spigolo_${name} STATIC ${ARG_SOURCES})
  add_library(spigolo::${name} ALIAS spigolo_${name})
  set_target_properties(spigolo_${name} PROPERTIES EXPORT_NAME ${name})
  target_include_directories(
    spigolo_${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>
                           $<INSTALL_INTERFACE:include>)
  foreach(layer IN LISTS ARG_LAYERS)
    target_link_libraries(spigolo_${name} PUBLIC spigolo_${layer})
  endforeach()
  foreach(library IN LISTS ARG_PRIVATE)
    if(library STREQUAL "Eigen3::Eigen") # headers only: whoever links the layer needs none of it
      set(library $<BUILD_INTERFACE:${library}>)
    endif()
    target_link_libraries(spigolo_${name} PRIVATE ${library})
  endforeach()
  spigolo_target(spigolo_${name})
  if(SPIGOLO_FUZZ)
    target_compile_options(spigolo_${name} PRIVATE -fsanitize=fuzzer-no-link)
  endif()
  set_property(GLOBAL APPEND PROPERTY SPIGOLO_LAYERS spigolo_${name})
endfunction()
