# What is found decides what is built: in a catkin workspace without LibTorch only messages and services; in a plain
# build without LibTorch the core and the simulation; without Bullet no simulation.
find_package(Torch QUIET)
set(RIGIDFORMER_MESSAGES_ONLY OFF)
if(NOT Torch_FOUND)
  if(RIGIDFORMER_ROS)
    set(RIGIDFORMER_MESSAGES_ONLY ON)
    message(STATUS "${PROJECT_NAME}: LibTorch not found. ONLY messages and services are built, not the node and the "
                   "tools. Install libtorch-dev or add a LibTorch folder to CMAKE_PREFIX_PATH.")
    return()
  endif()
  message(STATUS "${PROJECT_NAME}: LibTorch not found. Model, training and evaluation are NOT built. "
                 "Install libtorch-dev or add a LibTorch folder to CMAKE_PREFIX_PATH.")
endif()

find_package(Eigen3 3.3 REQUIRED NO_MODULE)
find_package(nlohmann_json 3.9 REQUIRED)
find_package(OpenSSL REQUIRED COMPONENTS Crypto)
find_package(Threads REQUIRED)
find_package(CLI11 REQUIRED)
find_package(yaml-cpp REQUIRED)
find_package(nanoflann REQUIRED)
find_package(benchmark QUIET)

find_package(Bullet QUIET)
if(NOT BULLET_FOUND)
  message(STATUS "${PROJECT_NAME}: Bullet not found. Scene generation is NOT built (install libbullet-dev).")
endif()
