# This file looks for the libraries. What is found decides what is built. Without LibTorch, a catkin workspace gets only
# the messages and services, and a plain build only the core and the simulation. Without Bullet there is no simulation.

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

# The headers of Gloo are not always installed with those of LibTorch. Without them, training runs in one process only.
find_path(GLOO_INCLUDE_DIR gloo/algorithm.h HINTS ${TORCH_INCLUDE_DIRS})
set(gloo_found OFF)
if(Torch_FOUND AND GLOO_INCLUDE_DIR)
  set(gloo_found ON)
endif()
option(RIGIDFORMER_DISTRIBUTED "Train over several processes with c10d" ${gloo_found})
option(RIGIDFORMER_NCCL "NCCL between GPUs, for a LibTorch with CUDA and nccl.h" OFF)

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
  message(STATUS "${PROJECT_NAME}: Bullet not found. Scene generation and physics baselines are NOT built (install libbullet-dev).")
endif()

# The CMake package of MuJoCo is not used, because Debian's version of it names a folder that may be missing.
find_path(MUJOCO_INCLUDE_DIR mujoco/mujoco.h)
find_library(MUJOCO_LIBRARY mujoco)
set(MUJOCO_FOUND OFF)
if(MUJOCO_INCLUDE_DIR AND MUJOCO_LIBRARY)
  set(MUJOCO_FOUND ON)
else()
  message(STATUS "${PROJECT_NAME}: MuJoCo not found. `generate_scenes --engine mujoco` and `evaluate --baselines "
                 "mujoco` are NOT built (install libmujoco-dev).")
endif()

# Qhull (Delaunay tetrahedra) and HACD (from Bullet's extras) cut a cloud into convex parts for one of the baselines.
find_path(QHULL_INCLUDE_DIR libqhull_r/qhull_ra.h)
find_library(QHULL_LIBRARY qhull_r)
find_path(HACD_INCLUDE_DIR HACD/hacdHACD.h PATH_SUFFIXES bullet)
find_library(HACD_LIBRARY HACD)
set(CONVEX_PARTS_FOUND OFF)
if(QHULL_INCLUDE_DIR AND QHULL_LIBRARY AND HACD_INCLUDE_DIR AND HACD_LIBRARY)
  set(CONVEX_PARTS_FOUND ON)
else()
  message(STATUS "${PROJECT_NAME}: Qhull or HACD not found. `evaluate --baselines bullet_parts` is NOT built (install "
                 "libqhull-dev and libbullet-extras-dev).")
endif()

# PCL serves the example that segments the clouds of a bare depth camera, and the benchmark of the registration.
if(RIGIDFORMER_ROS)
  # PCL looks for VTK, which wants the C library of MPI. The workspace of catkin_make has enabled C already.
  enable_language(C)
  find_package(PCL QUIET COMPONENTS common kdtree octree registration search sample_consensus segmentation)
  if(NOT PCL_FOUND)
    message(STATUS "${PROJECT_NAME}: PCL not found. The example `segment_cloud` is NOT built (install libpcl-dev).")
  endif()
endif()
