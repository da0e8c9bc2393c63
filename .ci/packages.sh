# The Debian 12 packages this project needs, each list once, for ./run, ./test and docker/Dockerfile. Sourced, not run; plain POSIX
# shell, because the Dockerfile's shell is dash.
# shellcheck shell=sh disable=SC2034  # whoever sources this file reads the lists

compiler_packages="g++ cmake ninja-build pkg-config glslang-tools"
library_packages="libwebsockets-dev libssl-dev libturbojpeg0-dev libpng-dev libopenexr-dev libarchive-dev libglm-dev libspdlog-dev
  nlohmann-json3-dev libcli11-dev libegl-dev libopengl-dev libgl-dev libopenvdb-dev libboost-dev"
viewer_packages="libsdl2-dev"
# What the server loads at run time: the vendor-neutral dispatch finds Mesa's llvmpipe, and NVIDIA's driver where it is mounted.
runtime_packages="libwebsockets17 libssl3 libturbojpeg0 libpng16-16 libopenexr-3-1-30 libarchive13 libspdlog1.10 libfmt9 libopenvdb10.0 libtbb12
  libglvnd0 libegl1 libopengl0 libegl-mesa0 libgl1-mesa-dri"
test_packages="libgtest-dev libgmock-dev ccache clang-format universal-ctags shellcheck python3 git curl ca-certificates
  valgrind libc6-dbg chromium fonts-dejavu-core"
node_packages="nodejs npm"
