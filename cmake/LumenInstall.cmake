# bin lib share: the layout that Installation (host/installation.h) expects, also made in the build tree.
install(TARGETS lumenshop RUNTIME DESTINATION bin)
install(TARGETS lumenshop-helper RUNTIME DESTINATION lib/lumenshop)
install(TARGETS lumen LIBRARY DESTINATION lib)
install(TARGETS lumen-section ARCHIVE DESTINATION lib)
install(DIRECTORY sdk/lumen DESTINATION include FILES_MATCHING PATTERN "*.h")
install(FILES ${CMAKE_BINARY_DIR}/include/lumen/abi.h DESTINATION include/lumen)
install(DIRECTORY shaders sessions templates DESTINATION share/lumenshop)
install(FILES LICENSE README.md CHANGELOG.md DESTINATION share/doc/lumenshop)

# In the build tree shaders, sessions and templates are the sources themselves, so that an edit is seen at once.
file(MAKE_DIRECTORY ${LUMEN_STAGE}/share/lumenshop)
foreach(folder shaders sessions templates)
  file(CREATE_LINK ${CMAKE_SOURCE_DIR}/${folder} ${LUMEN_STAGE}/share/lumenshop/${folder} SYMBOLIC)
endforeach()
file(CONFIGURE OUTPUT ${LUMEN_STAGE}/share/lumenshop/build.json @ONLY CONTENT
[[{"sources": "@CMAKE_SOURCE_DIR@", "build": "@CMAKE_BINARY_DIR@", "command": ["@CMAKE_COMMAND@", "--build", "@CMAKE_BINARY_DIR@", "--target", "lumen-plugins"]}
]])
