// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "allocation/expect_safe.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <new>

namespace {

std::atomic<long> number_of_blocks{0}, number_of_allocations{0};
std::atomic<std::size_t> number_of_bytes{0}; // of all allocations
// The number of the allocation that fails, counted from 1, or zero.
std::atomic<long> failing_position{0};

bool fails(std::size_t size)
{
  number_of_bytes += size;
  return ++number_of_allocations == failing_position;
}

void* counted(void* block)
{
  number_of_blocks += block != nullptr;
  return block;
}

} // namespace

// The linker replaces malloc by __wrap_malloc and __real_malloc by malloc, likewise the others
// (option --wrap).

extern "C" {
void* __real_malloc(std::size_t size);
void* __real_calloc(std::size_t number, std::size_t size);
void* __real_realloc(void* block, std::size_t size);
void __real_free(void* block);

void __wrap_free(void* block);

void* __wrap_malloc(std::size_t size)
{
  return fails(size) ? nullptr : counted(__real_malloc(size));
}

void* __wrap_calloc(std::size_t number, std::size_t size)
{
  return fails(number * size) ? nullptr : counted(__real_calloc(number, size));
}

void* __wrap_realloc(void* block, std::size_t size)
{
  if(block && size == 0) // an empty matrix of Eigen
  {
    __wrap_free(block);
    return nullptr;
  }
  if(fails(size))
    return nullptr;
  return block ? __real_realloc(block, size) : counted(__real_realloc(block, size));
}

void __wrap_free(void* block)
{
  number_of_blocks -= block != nullptr;
  __real_free(block);
}
}

void* operator new(std::size_t size)
{
  if(void* const block = std::malloc(size))
    return block;
  throw std::bad_alloc();
}

void operator delete(void* block) noexcept { std::free(block); }
void operator delete(void* block, std::size_t) noexcept { std::free(block); }

namespace allocation_test {

namespace {

// Returns the next allocation that fails: each of the first 500, and then one in 50 or more,
// because the time of a test is the number of failures times the time of a query. The last
// allocation always fails.
long next_position(long position, long last)
{
  const long step = position < 500 ? 1 : position / 10;
  return position < last ? std::min(position + step, last) : last + 1;
}

// Some constructors of dependencies leak their first block if their second allocation fails, so
// that the destructor does not run: SparseMatrix of Eigen 3.4, Surface_mesh and Kd_tree of CGAL.
constexpr long max_leak = 1;

} // namespace

void expect_safe(const std::function<Values()>& query)
{
  // The first queries allocate what lasts, for example function-local statics, and the one-rings that
  // a front stores after about eight queries on the whole surface.
  const Values expected = query();
  for(int repetition = 0; repetition < 10; ++repetition)
    ASSERT_EQ(query(), expected);
  number_of_allocations = 0;
  ASSERT_EQ(query(), expected);
  const long last = number_of_allocations;
  int number_of_failures = 0, number_of_exceptions = 0;
  for(long position = 1; position <= last && !testing::Test::HasFailure();
      position = next_position(position, last))
  {
    ++number_of_failures;
    const long initial_blocks = number_of_blocks;
    number_of_allocations = 0;
    failing_position = position;
    try
    {
      const Values found = query();
      failing_position = 0;
      EXPECT_EQ(found, expected) << "allocation " << position << " of " << last;
    }
    catch(const std::bad_alloc&)
    {
      ++number_of_exceptions;
    }
    catch(const std::exception& error)
    {
      failing_position = 0;
      ADD_FAILURE() << "allocation " << position << " of " << last << ": " << error.what();
    }
    failing_position = 0;
    EXPECT_EQ(query(), expected) << "after allocation " << position << " of " << last;
    EXPECT_LE(number_of_blocks, initial_blocks + max_leak)
        << "allocation " << position << " of " << last;
  }
  EXPECT_GT(number_of_exceptions, 0);
  testing::Test::RecordProperty("failures", number_of_failures);
  testing::Test::RecordProperty("exceptions", number_of_exceptions);
}

std::size_t allocated_bytes(const std::function<void()>& query)
{
  const std::size_t initial_bytes = number_of_bytes;
  query();
  return number_of_bytes - initial_bytes;
}

} // namespace allocation_test
