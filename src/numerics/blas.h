// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_NUMERICS_BLAS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_NUMERICS_BLAS_H

#if defined(GEODESIC_PROCESSING_HAS_CHOLMOD) && __has_include(<dlfcn.h>)
#  include <dlfcn.h>
#endif

#include <mutex>

// Run-time lookup of functions of OpenBLAS and OpenMP, which are loaded only if CHOLMOD uses them.
// Include this header in source files only.

namespace CGAL::Geodesic_processing::internal {

// Returns a function of a loaded library, or null if it is not loaded.
template <typename Function>
Function* find_function([[maybe_unused]] const char* name)
{
#if defined(GEODESIC_PROCESSING_HAS_CHOLMOD) && defined(RTLD_DEFAULT)
  return reinterpret_cast<Function*>(dlsym(RTLD_DEFAULT, name));
#else
  return nullptr;
#endif
}

// While an instance exists, OpenBLAS uses one thread. Otherwise sums would depend on the number of
// threads. For 100,000 unknowns, more threads bring no speedup. The destructor of the last instance
// restores the number of threads.
class Single_threaded_blas
{
public:
  Single_threaded_blas()
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    if(m_number_of_instances++ == 0 && set_number_of_threads && get_number_of_threads)
    {
      m_saved_number_of_threads = get_number_of_threads();
      set_number_of_threads(1);
    }
  }
  ~Single_threaded_blas()
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    if(--m_number_of_instances == 0 && set_number_of_threads && get_number_of_threads)
      set_number_of_threads(m_saved_number_of_threads);
  }
  Single_threaded_blas(const Single_threaded_blas&) = delete;

private:
  inline static int (*const get_number_of_threads)() =
      find_function<int()>("openblas_get_num_threads");
  inline static void (*const set_number_of_threads)(int) =
      find_function<void(int)>("openblas_set_num_threads");
  inline static std::mutex m_mutex;
  inline static int m_number_of_instances = 0, m_saved_number_of_threads = 1;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_NUMERICS_BLAS_H
