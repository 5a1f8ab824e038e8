// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later

// Replaces operator new of the program, so that arrays of many megabytes are backed by huge pages.
// On a mesh of a million vertices, page faults otherwise take 40 % of the time from the file to the
// front. Other systems than Linux keep their operator new. Sanitizers do, too: they replace it
// themselves.

#if defined(__has_feature)
#  if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#    define GEODESIC_PROGRAM_HAS_SANITIZER
#  endif
#elif defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#  define GEODESIC_PROGRAM_HAS_SANITIZER
#endif

#if defined(__linux__) && !defined(GEODESIC_PROGRAM_HAS_SANITIZER)

#  include <sys/mman.h>

#  include <cstddef>
#  include <cstdlib>
#  include <new>

namespace {

constexpr std::size_t huge_page_size = std::size_t(1) << 21;
// Smaller arrays would waste a part of their last page.
constexpr std::size_t min_size = 4 * huge_page_size;

void* allocate(std::size_t size) noexcept
{
  if(size < min_size)
    return std::malloc(size == 0 ? 1 : size);
  if(size > std::size_t(-1) - huge_page_size)
    return nullptr;
  const std::size_t rounded = (size + huge_page_size - 1) / huge_page_size * huge_page_size;
  void* const result = std::aligned_alloc(huge_page_size, rounded);
  if(result)
    madvise(result, rounded, MADV_HUGEPAGE); // a failure only costs time
  return result;
}

} // namespace

void* operator new(std::size_t size)
{
  for(;;)
  {
    if(void* const result = allocate(size))
      return result;
    const std::new_handler handler = std::get_new_handler();
    if(!handler)
      throw std::bad_alloc();
    handler();
  }
}

void operator delete(void* pointer) noexcept { std::free(pointer); }
void operator delete(void* pointer, std::size_t) noexcept { std::free(pointer); }

#endif
