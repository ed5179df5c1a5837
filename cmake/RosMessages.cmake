# This file declares the catkin package, its messages and its services. Messages and services need no LibTorch, so that
# a planner can compile against them on any machine with ROS.

if(RIGIDFORMER_MESSAGES_ONLY)
  set(ros_packages actionlib_msgs geometry_msgs sensor_msgs std_msgs)
else()
  set(ros_packages actionlib actionlib_msgs diagnostic_msgs diagnostic_updater dynamic_reconfigure geometry_msgs nav_msgs nodelet pluginlib roscpp
      rosbag_storage rosgraph_msgs roslib sensor_msgs std_msgs std_srvs tf2 tf2_msgs tf2_ros visualization_msgs)
  # Other packages may link these libraries. LibTorch and Bullet stay inside them.
  set(exported_libraries rigidformer_ros_node rigidformer rigidformer_core)
  if(BULLET_FOUND)
    list(APPEND exported_libraries rigidformer_simulation)
  endif()
  set(exported_folders include)
  set(exported_systems EIGEN3)
endif()
find_package(catkin REQUIRED COMPONENTS message_generation ${ros_packages})

catkin_python_setup()

file(GLOB message_files RELATIVE ${PROJECT_SOURCE_DIR}/msg CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/msg/*.msg)
file(GLOB service_files RELATIVE ${PROJECT_SOURCE_DIR}/srv CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/srv/*.srv)
file(GLOB action_files RELATIVE ${PROJECT_SOURCE_DIR}/action CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/action/*.action)
add_message_files(DIRECTORY msg FILES ${message_files})
add_service_files(DIRECTORY srv FILES ${service_files})
add_action_files(DIRECTORY action FILES ${action_files})
generate_messages(DEPENDENCIES actionlib_msgs geometry_msgs sensor_msgs std_msgs)

catkin_package(
  INCLUDE_DIRS ${exported_folders}
  LIBRARIES ${exported_libraries}
  CATKIN_DEPENDS message_runtime ${ros_packages}
  DEPENDS ${exported_systems})
