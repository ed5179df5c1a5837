# Build type, language level, warnings and compiler cache, in one place.
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()
if(NOT CMAKE_BUILD_TYPE MATCHES "^(Release|RelWithDebInfo)$")
  message(WARNING "${PROJECT_NAME}: build type is '${CMAKE_BUILD_TYPE}'; inference and simulation are many times "
                  "slower than with Release.")
endif()

if(NOT CMAKE_CXX_STANDARD)
  set(CMAKE_CXX_STANDARD 17)
endif()
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

# Shared, so that LibTorch and Bullet stay inside the libraries that use them. Catkin asks for the same.
option(BUILD_SHARED_LIBS "Build shared libraries" ON)

# One position-independent flavour everywhere, so that libraries, tools and tests share a precompiled header.
add_compile_options(-fPIC)

# Where the sources really are: in a workspace the package folder may consist of links.
get_filename_component(RIGIDFORMER_SOURCE_DIR ${PROJECT_SOURCE_DIR}/CMakeLists.txt REALPATH)
get_filename_component(RIGIDFORMER_SOURCE_DIR ${RIGIDFORMER_SOURCE_DIR} DIRECTORY)

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER
      ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime
      ${CCACHE_PROGRAM})
  add_compile_options($<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
endif()

# rigidformer_warnings(TARGET): the project's own warning level.
function(rigidformer_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra)
  if(RIGIDFORMER_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
endfunction()
