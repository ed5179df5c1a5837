# This file installs everything: into bin, lib, include and share, or into catkin's folders in a workspace.

include(GNUInstallDirs)
set(bin_dir ${CMAKE_INSTALL_BINDIR})
set(lib_dir ${CMAKE_INSTALL_LIBDIR})
set(include_dir ${CMAKE_INSTALL_INCLUDEDIR})
set(share_dir ${CMAKE_INSTALL_DATADIR}/${PROJECT_NAME})
if(RIGIDFORMER_ROS)
  set(bin_dir ${CATKIN_PACKAGE_BIN_DESTINATION})
  set(lib_dir ${CATKIN_PACKAGE_LIB_DESTINATION})
  set(include_dir ${CATKIN_GLOBAL_INCLUDE_DESTINATION})
  set(share_dir ${CATKIN_PACKAGE_SHARE_DESTINATION})
endif()

# What other projects may link.
set(api_libraries rigidformer_core)
foreach(target rigidformer_simulation rigidformer)
  if(TARGET ${target})
    list(APPEND api_libraries ${target})
  endif()
endforeach()

# Installed programs find their libraries by the path from one to the other, so that the installed folder can be moved.
# In a catkin workspace the environment tells where libraries are.
if(NOT RIGIDFORMER_ROS)
  file(RELATIVE_PATH lib_from_bin /${bin_dir} /${lib_dir})
  set_property(TARGET ${RIGIDFORMER_APPS} PROPERTY INSTALL_RPATH "$ORIGIN/${lib_from_bin}")
  set_property(TARGET ${RIGIDFORMER_APPS} ${api_libraries} APPEND PROPERTY INSTALL_RPATH "$ORIGIN")
  set_property(TARGET ${RIGIDFORMER_APPS} ${api_libraries} PROPERTY INSTALL_RPATH_USE_LINK_PATH ON)
endif()

set(programs ${RIGIDFORMER_APPS})
foreach(target prediction_node demo_publisher forecast_report depth_camera push_planner record_depth_camera
        segment_cloud still_scenes tracking_accuracy)
  if(TARGET ${target})
    list(APPEND programs ${target})
  endif()
endforeach()
set(libraries rigidformer_baselines)
foreach(target rigidformer_ros_node rigidformer_ros_nodelet)
  if(TARGET ${target})
    list(APPEND libraries ${target})
  endif()
endforeach()

# The public API is a CMake package: find_package(rigidformer) gives rigidformer::core, rigidformer::simulation and
# rigidformer::rigidformer, as far as they were built.
include(CMakePackageConfigHelpers)
set(package_dir ${lib_dir}/cmake/rigidformer)
install(TARGETS ${api_libraries} EXPORT rigidformer
  RUNTIME DESTINATION ${bin_dir}
  LIBRARY DESTINATION ${lib_dir}
  ARCHIVE DESTINATION ${lib_dir})
install(EXPORT rigidformer NAMESPACE rigidformer:: FILE rigidformerTargets.cmake DESTINATION ${package_dir})
set(package_files ${PROJECT_BINARY_DIR}/rigidformer_package)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/rigidformerConfig.cmake.in
  ${package_files}/rigidformerConfig.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${package_files}/rigidformerConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(DIRECTORY ${package_files}/ DESTINATION ${package_dir})

install(TARGETS ${programs} ${libraries}
  RUNTIME DESTINATION ${bin_dir}
  LIBRARY DESTINATION ${lib_dir}
  ARCHIVE DESTINATION ${lib_dir})
# Folders are installed from where they really are: in a workspace of links, CMake would install the links.
install(DIRECTORY ${RIGIDFORMER_SOURCE_DIR}/config ${RIGIDFORMER_SOURCE_DIR}/models DESTINATION ${share_dir})
if(RIGIDFORMER_ROS)
  install(DIRECTORY ${RIGIDFORMER_SOURCE_DIR}/include/ DESTINATION ${include_dir} FILES_MATCHING PATTERN "*.hpp")
  install(DIRECTORY ${RIGIDFORMER_SOURCE_DIR}/launch DESTINATION ${share_dir})
  # This file is installed with the folder config already. It is named here for catkin_lint, which does not look into
  # folders.
  install(FILES config/nodelet_plugins.xml DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION}/config)
else()
  install(DIRECTORY ${RIGIDFORMER_SOURCE_DIR}/include/rigidformer DESTINATION ${include_dir} FILES_MATCHING PATTERN "*.hpp")
endif()
