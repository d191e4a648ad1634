# How a plugin and a worker module are built.

# The flags of a library that can be replaced under a running host. The precompiled SDK makes a rebuild take half a second.
function(lumen_library_options target folder)
  set_target_properties(${target} PROPERTIES PREFIX "" CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON
    LIBRARY_OUTPUT_DIRECTORY ${LUMEN_STAGE}/lib/lumenshop/${folder}
    BUILD_RPATH "$ORIGIN/../.." INSTALL_RPATH "$ORIGIN/../..")
  target_link_libraries(${target} PRIVATE lumen)
  install(TARGETS ${target} LIBRARY DESTINATION lib/lumenshop/${folder})
endfunction()

# lumen_plugin(KIND NAME [SOURCES ...] [LIBRARIES ...] [OPTIMIZE])
# One library KIND.NAME.so of the sources (default: all *.cpp of the folder). OPTIMIZE: -O2, for what computes on the CPU.
function(lumen_plugin kind name)
  cmake_parse_arguments(PARSE_ARGV 2 plugin "OPTIMIZE" "" "SOURCES;LIBRARIES")
  if(NOT plugin_SOURCES)
    file(GLOB plugin_SOURCES CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  endif()
  set(target plugin-${kind}-${name})
  add_library(${target} MODULE ${plugin_SOURCES})
  lumen_library_options(${target} plugins)
  set_target_properties(${target} PROPERTIES OUTPUT_NAME ${kind}.${name})
  target_link_libraries(${target} PRIVATE ${plugin_LIBRARIES})
  target_link_options(${target} PRIVATE -Wl,--version-script=${CMAKE_SOURCE_DIR}/cmake/plugin.map)
  if(plugin_OPTIMIZE)
    target_compile_options(${target} PRIVATE -O2)
  else()
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
    target_precompile_headers(${target} REUSE_FROM lumen-plugin-pch)
  endif()
  add_dependencies(lumen-plugins ${target})
endfunction()

# lumen_worker(NAME SOURCES ... LIBRARIES ...): a worker module NAME.so, loaded by the helper process alone.
function(lumen_worker name)
  cmake_parse_arguments(PARSE_ARGV 1 worker "" "" "SOURCES;LIBRARIES")
  set(target worker-${name})
  add_library(${target} MODULE ${worker_SOURCES})
  lumen_library_options(${target} workers)
  set_target_properties(${target} PROPERTIES OUTPUT_NAME ${name})
  target_link_libraries(${target} PRIVATE ${worker_LIBRARIES})
  target_link_options(${target} PRIVATE -Wl,--version-script=${CMAKE_SOURCE_DIR}/cmake/worker.map)
  add_dependencies(lumen-plugins ${target})
endfunction()
