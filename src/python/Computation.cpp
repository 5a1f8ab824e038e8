// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "python/Computation.h"

#include "python/arrays.h"

#include <future>
#include <stdexcept>
#include <utility>

namespace python {

namespace {

// Runs signal handlers if this is the main thread. Throws the exception that they raise. Requires
// the GIL.
void handle_signals()
{
  if(PyErr_CheckSignals() != 0)
    throw py::error_already_set();
}

} // namespace

void Guard::lock()
{
  if(m_owner == std::this_thread::get_id())
    throw std::runtime_error("A callback uses the object whose computation has called it.");
  while(!m_mutex.try_lock_for(time_between_checks))
  {
    if(Cancellation::is_this_thread_canceled())
      throw GP::Cancelled();
    py::gil_scoped_acquire gil;
    handle_signals();
  }
  m_owner = std::this_thread::get_id();
}

void Guard::unlock()
{
  m_owner = std::thread::id();
  m_mutex.unlock();
}

thread_local const Cancellation* Cancellation::m_current = nullptr;

py::object Cancellation::call(const py::function& function, const py::args& arguments)
{
  struct Reset
  {
    ~Reset() { m_current = nullptr; }
  } reset;
  m_current = this;
  return function(*arguments);
}

Computation::Computation(py::object callback)
    : m_callback(std::move(callback)), m_cancellation(Cancellation::current()),
      m_last_check(std::chrono::steady_clock::now())
{
  if(!m_callback.is_none() && !PyCallable_Check(m_callback.ptr()))
    reject("callback is not a function.");
}

std::function<bool(double)> Computation::callback()
{
  return [this](double fraction) { return should_continue(fraction); };
}

bool Computation::should_continue(double fraction)
{
  if(is_canceled())
    return false;
  const auto now = std::chrono::steady_clock::now();
  const bool has_callback = m_callback.ptr() != Py_None;
  if(!has_callback && now - m_last_check < time_between_checks)
    return true;
  m_last_check = now;
  py::gil_scoped_acquire gil;
  try
  {
    handle_signals();
    if(!has_callback)
      return true;
    const py::object result = m_callback(fraction);
    const int is_true = result.is_none() ? 1 : PyObject_IsTrue(result.ptr());
    if(is_true < 0)
      throw py::error_already_set();
    return is_true == 1;
  }
  catch(const py::error_already_set&)
  {
    m_error = std::current_exception();
    m_is_canceled = true;
    return false;
  }
}

// The exception of a callback has precedence over the exception Cancelled that it causes.
void Computation::rethrow(std::exception_ptr thrown)
{
  if(m_error)
    std::rethrow_exception(std::exchange(m_error, nullptr));
  if(thrown)
    std::rethrow_exception(std::move(thrown));
}

void Computation::run_without_gil(const std::function<void()>& f)
{
  std::exception_ptr thrown;
  {
    py::gil_scoped_release release;
    try
    {
      f();
    }
    catch(...)
    {
      thrown = std::current_exception();
    }
  }
  rethrow(std::move(thrown));
}

void Computation::run_in_other_thread(const std::function<void()>& f)
{
  std::exception_ptr thrown, interrupt;
  {
    py::gil_scoped_release release;
    std::future<void> result = std::async(std::launch::async, f);
    while(result.wait_for(time_between_checks) != std::future_status::ready)
    {
      if(interrupt)
        continue;
      py::gil_scoped_acquire gil;
      try
      {
        handle_signals();
      }
      catch(const py::error_already_set&)
      {
        interrupt = std::current_exception();
        m_is_canceled = true;
      }
    }
    try
    {
      result.get();
    }
    catch(...)
    {
      thrown = std::current_exception();
    }
  }
  if(interrupt)
    m_error = interrupt;
  rethrow(std::move(thrown));
}

} // namespace python
