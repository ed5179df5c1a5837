# This file sets the build type, language level, warnings and compiler cache of all targets.

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

# Libraries are shared, so that LibTorch and Bullet stay inside the libraries that use them. Catkin wants this too.
option(BUILD_SHARED_LIBS "Build shared libraries" ON)

# All code is compiled position-independent, because libraries, tools and tests share a precompiled header, which needs
# the same options everywhere.
add_compile_options(-fPIC)

# This is the real folder of the sources. In a catkin workspace, the folder of the package may consist of links.
get_filename_component(RIGIDFORMER_SOURCE_DIR ${PROJECT_SOURCE_DIR}/CMakeLists.txt REALPATH)
get_filename_component(RIGIDFORMER_SOURCE_DIR ${RIGIDFORMER_SOURCE_DIR} DIRECTORY)

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER
      ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime
      ${CCACHE_PROGRAM})
  add_compile_options($<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
endif()

# rigidformer_warnings(TARGET) sets the warning level of the project's own targets.
function(rigidformer_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra)
  if(RIGIDFORMER_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
endfunction()
