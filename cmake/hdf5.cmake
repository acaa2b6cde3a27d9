# SPDX-License-Identifier: MIT
# Imported target hdf5::hdf5 with the C library of HDF5, and HDF5_FOUND. Used by this build and, installed, by find_package(bolide COMPONENTS
# hdf5). CMake's own FindHDF5 asks for a project in C.
if(NOT TARGET hdf5::hdf5)
  find_path(HDF5_C_HEADER hdf5.h PATH_SUFFIXES hdf5/serial)
  find_library(HDF5_C_LIBRARY NAMES hdf5 hdf5_serial PATH_SUFFIXES hdf5/serial)
  mark_as_advanced(HDF5_C_HEADER HDF5_C_LIBRARY)
  if(HDF5_C_HEADER AND HDF5_C_LIBRARY)
    add_library(hdf5::hdf5 UNKNOWN IMPORTED)
    set_target_properties(hdf5::hdf5 PROPERTIES IMPORTED_LOCATION "${HDF5_C_LIBRARY}" INTERFACE_INCLUDE_DIRECTORIES "${HDF5_C_HEADER}")
  endif()
endif()
if(TARGET hdf5::hdf5)
  set(HDF5_FOUND TRUE)
else()
  set(HDF5_FOUND FALSE)
endif()
