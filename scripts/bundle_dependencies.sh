#!/bin/bash
# SPDX-FileCopyrightText: 2026 rigidformer_ros contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Collects what the plain CMake build needs besides LibTorch into one folder (default bundle/, ignored by git), for
# training machines of the same processor family that have only LibTorch, CMake and g++ and cannot install packages:
#   scripts/bundle_dependencies.sh            # on a Debian 12 machine with the development packages
#   cmake -S . -B build/plain -DRIGIDFORMER_ROS=OFF -DCMAKE_PREFIX_PATH="$PWD/bundle;<LibTorch prefix>"
set -euo pipefail

root=$(cd "$(dirname "$0")/.." && pwd)
bundle=$(realpath -m "${1:-$root/bundle}")
library_dir=/usr/lib/$(/usr/bin/g++ -dumpmachine)

# Headers of Eigen without the adapters to other solvers, sparse matrices and LAPACK, which nothing here uses.
copy_eigen() {
  mkdir -p "$bundle/include/eigen3"
  cp -r /usr/include/eigen3/Eigen "$bundle/include/eigen3/"
  local src=$bundle/include/eigen3/Eigen/src
  rm -rf "$src"/*Support "$src"/Sparse* "$src"/OrderingMethods "$src"/IterativeLinearSolvers "$src"/misc/lapack*
}

# Only the OpenSSL headers that <openssl/evp.h> includes; <openssl/ssl.h> is what CMake looks for.
copy_openssl() {
  mkdir -p "$bundle/include/openssl"
  echo '#include <openssl/evp.h>' | /usr/bin/g++ -M -x c++ - | tr -s '[:space:]' '\n' | grep '/openssl/' |
    xargs -I{} cp {} "$bundle/include/openssl/"
  cp /usr/include/openssl/ssl.h /usr/include/openssl/opensslv.h "$bundle/include/openssl/"
}

copy_headers() {
  copy_eigen
  copy_openssl
  cp -r /usr/include/{nlohmann,CLI,yaml-cpp,nanoflann.hpp,gtest} "$bundle/include/"
  mkdir -p "$bundle/include/bullet"
  cp -r /usr/include/bullet/{BulletCollision,BulletDynamics,LinearMath,btBullet{Collision,Dynamics}Common.h} \
    "$bundle/include/bullet/"
}

# A shared library under its link name and under the name that the loader asks for.
copy_shared() {
  local soname
  soname=$(objdump -p "$library_dir/lib$1.so" | awk '$1 == "SONAME" {print $2}')
  cp -L "$library_dir/lib$1.so" "$bundle/lib/$soname"
  ln -sf "$soname" "$bundle/lib/lib$1.so"
}

# The shared libcrypto is half the size of the static one.
copy_libraries() {
  mkdir -p "$bundle/lib"
  cp "$library_dir"/lib{yaml-cpp,gtest,gtest_main}.a "$bundle/lib/"
  for library in crypto LinearMath BulletCollision BulletDynamics BulletSoftBody; do
    copy_shared "$library"
  done
}

# cmake_config PACKAGE TARGET VERSION INCLUDE_SUBDIR [LIBRARY]: a relocatable package file with one imported target.
# OpenSSL, Bullet and GoogleTest need none: CMake's own find modules see the folder through CMAKE_PREFIX_PATH.
cmake_config() {
  local dir=$bundle/lib/cmake/$1 kind=INTERFACE
  [ -z "${5:-}" ] || kind=STATIC
  mkdir -p "$dir"
  cat >"$dir/$1Config.cmake" <<CONFIG
get_filename_component(_prefix "\${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)
if(NOT TARGET $2)
  add_library($2 $kind IMPORTED)
  set_target_properties($2 PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "\${_prefix}/$4")
  if(NOT "${5:-}" STREQUAL "")
    set_target_properties($2 PROPERTIES IMPORTED_LOCATION "\${_prefix}/lib/${5:-}")
  endif()
endif()
CONFIG
  cat >"$dir/$1ConfigVersion.cmake" <<VERSION
set(PACKAGE_VERSION $3)
if(PACKAGE_FIND_VERSION VERSION_LESS_EQUAL PACKAGE_VERSION)
  set(PACKAGE_VERSION_COMPATIBLE TRUE)
endif()
VERSION
}

version_of() { dpkg-query -W -f '${Version}' "$1" | sed 's/^[0-9]*://; s/[^0-9.].*//'; }

rm -rf "$bundle"
copy_headers
copy_libraries
cmake_config Eigen3 Eigen3::Eigen "$(version_of libeigen3-dev)" include/eigen3
cmake_config nlohmann_json nlohmann_json::nlohmann_json "$(version_of nlohmann-json3-dev)" include
cmake_config CLI11 CLI11::CLI11 "$(version_of libcli11-dev)" include
cmake_config nanoflann nanoflann::nanoflann "$(version_of libnanoflann-dev)" include
cmake_config yaml-cpp yaml-cpp "$(version_of libyaml-cpp-dev)" include libyaml-cpp.a
echo "$bundle: $(du -sm --apparent-size "$bundle" | cut -f1) MB." \
  "Configure with -DCMAKE_PREFIX_PATH=\"$bundle;<LibTorch prefix>\""
