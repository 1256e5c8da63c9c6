# Installs the npm packages of the current folder in its build tree, so that node_modules stays out of the source
# tree. `packages.stamp` there is newer than all that they were installed from.
function(rouleau_npm_packages whose)
  set(files package.json package-lock.json .npmrc)
  list(TRANSFORM files PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/)
  add_custom_command(
    OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/packages.stamp
    COMMAND ${CMAKE_COMMAND} -E copy ${files} ${CMAKE_CURRENT_BINARY_DIR}
    COMMAND ${NPM} ci --ignore-scripts --no-audit --no-fund --loglevel=error
    COMMAND ${CMAKE_COMMAND} -E touch packages.stamp
    DEPENDS ${files}
    WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}
    COMMENT "Installing the npm packages of ${whose}"
    VERBATIM)
endfunction()
