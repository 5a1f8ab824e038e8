// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PYTHON_COMPUTATION_H
#define GEODESIC_PYTHON_COMPUTATION_H

#include <CGAL/Geodesic_processing/exceptions.h>

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

namespace python {

namespace py = pybind11;

// The time between two checks for signals. Ctrl-C must act within half a second.
constexpr std::chrono::milliseconds time_between_checks(50);

// Allows one thread at a time to use an object. A thread that waits does not hold the GIL and reacts
// to Ctrl-C.
class Guard
{
public:
  // Throws std::runtime_error if the calling thread already has the object: its callback must not
  // use it. Throws error_already_set if a signal handler raises an exception, and Cancelled if the
  // call of this thread is canceled. Requires that the GIL is not held.
  void lock();
  void unlock();

private:
  std::timed_mutex m_mutex;
  std::atomic<std::thread::id> m_owner{std::thread::id()};
};

// Lets another thread cancel the computations of a call. Signal handlers run in the main thread only,
// so that it waits for long calls of another thread, and cancels them on Ctrl-C.
class Cancellation
{
public:
  // Returns function(*arguments). From then on, cancel() cancels the computations of this thread.
  py::object call(const py::function& function, const py::args& arguments);
  void cancel() { m_is_canceled = true; }
  bool is_canceled() const { return m_is_canceled; }

  // Returns whether the call of this thread is canceled.
  static bool is_this_thread_canceled() { return m_current && m_current->is_canceled(); }
  // Returns that of the call of this thread, or null.
  static const Cancellation* current() { return m_current; }

private:
  static thread_local const Cancellation* m_current;
  std::atomic<bool> m_is_canceled{false};
};

// Runs a computation of the library without the GIL. Its callback handles signals and calls the
// callback of the caller.
class Computation
{
public:
  // `callback` is None or a function that takes the completed fraction. The computation is canceled
  // if it returns a false value other than None, or if it raises an exception.
  explicit Computation(py::object callback = py::none());

  // Returns the callback for the library.
  std::function<bool(double)> callback();

  // Calls f() without the GIL. If the callback raised an exception, throws this exception.
  template <typename Function>
  void run(const Function& f)
  {
    run_without_gil(std::function<void()>(std::ref(f)));
  }
  // As run(), but calls f() in another thread, while this thread handles signals. For functions of
  // the library that call the callback in several threads.
  template <typename Function>
  void run_beside(const Function& f)
  {
    run_in_other_thread(std::function<void()>(std::ref(f)));
  }

private:
  void run_without_gil(const std::function<void()>& f);
  void run_in_other_thread(const std::function<void()>& f);
  bool should_continue(double fraction);
  bool is_canceled() const
  {
    return m_is_canceled || (m_cancellation && m_cancellation->is_canceled());
  }
  void rethrow(std::exception_ptr thrown);

  py::object m_callback;
  const Cancellation* m_cancellation; // that of the calling thread, or null
  std::exception_ptr m_error;         // of the callback or of a signal handler
  std::atomic<bool> m_is_canceled{false};
  std::chrono::steady_clock::time_point m_last_check;
};

} // namespace python

#endif // GEODESIC_PYTHON_COMPUTATION_H
