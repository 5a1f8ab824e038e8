// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture/Display.h"

#include "io/errors.h"

#ifdef GEODESIC_PROCESSING_HAS_VTK

#  include <cerrno>
#  include <csignal>
#  include <cstdlib>
#  include <string>

#  include <dlfcn.h>
#  include <fcntl.h>
#  include <poll.h>
#  include <sys/wait.h>
#  include <unistd.h>
#  ifdef __linux__
#    include <sys/prctl.h>
#  endif

namespace program {

namespace {

// Returns the display number that Xvfb writes when it is ready, or an empty text if it does not
// start.
std::string read_number(int pipe)
{
  std::string number;
  for(;;)
  {
    // Xvfb starts in about 0.1 s, on a busy machine in a few seconds.
    ::pollfd ready = {pipe, POLLIN, 0};
    char c;
    if(::poll(&ready, 1, 20000) <= 0 || ::read(pipe, &c, 1) != 1)
      return {};
    if(c == '\n')
      return number;
    number += c;
  }
}

// VTK terminates the process if it cannot open a display, so this is checked first.
bool can_open_display()
{
  if(std::getenv("DISPLAY") == nullptr)
    return false;
  void* const library = ::dlopen("libX11.so.6", RTLD_NOW);
  if(library == nullptr)
    return false;
  using Open = void* (*)(const char*);
  using Close = int (*)(void*);
  const auto open = reinterpret_cast<Open>(::dlsym(library, "XOpenDisplay"));
  const auto close = reinterpret_cast<Close>(::dlsym(library, "XCloseDisplay"));
  void* const display = open != nullptr && close != nullptr ? open(nullptr) : nullptr;
  if(display == nullptr)
    return false;
  close(display);
  return true;
}

} // namespace

Display::Display()
{
  if(const char* const shared = std::getenv("GEODESIC_DISPLAY"))
  {
    ::setenv("DISPLAY", shared, 1);
    if(can_open_display())
      return;
  }
  int pipe_ends[2];
  if(::pipe(pipe_ends) != 0)
    throw Usage_error("--picture: a pipe to the display server cannot be created.");
  const ::pid_t parent = ::getpid();
  m_server = ::fork();
  if(m_server == 0)
  {
#  ifdef __linux__
    // The server is terminated when this process ends or crashes.
    ::prctl(PR_SET_PDEATHSIG, SIGTERM);
    if(::getppid() != parent)
      ::_exit(1);
#  else
    (void)parent;
#  endif
    // A separate process group: a keyboard interrupt must reach the program but not the server.
    ::setpgid(0, 0);
    ::close(pipe_ends[0]);
    const int null_device = ::open("/dev/null", O_RDWR);
    ::dup2(null_device, STDIN_FILENO);
    ::dup2(null_device, STDOUT_FILENO);
    ::dup2(null_device, STDERR_FILENO);
    const std::string number = std::to_string(pipe_ends[1]);
    // By default, the server resets itself when the last connection is closed, and then refuses
    // connections for a moment.
    ::execlp("Xvfb", "Xvfb", "-displayfd", number.c_str(), "-screen", "0", "1600x1200x24",
             "-nolisten", "tcp", "-noreset", static_cast<char*>(nullptr));
    ::_exit(127);
  }
  ::close(pipe_ends[1]);
  const std::string number = m_server > 0 ? read_number(pipe_ends[0]) : std::string();
  ::close(pipe_ends[0]);
  if(!number.empty())
  {
    ::setenv("DISPLAY", (":" + number).c_str(), 1);
    return;
  }
  if(!can_open_display())
    throw Usage_error(
        "--picture: no display is available and Xvfb cannot be started; is it installed?");
}

Display::~Display()
{
  if(m_server <= 0)
    return;
  ::kill(m_server, SIGTERM);
  while(::waitpid(m_server, nullptr, 0) < 0 && errno == EINTR)
    ;
}

} // namespace program

#else

namespace program {

Display::Display()
{
  throw Usage_error(
      "--picture: pictures are not supported, because this program was built without VTK.");
}

Display::~Display() = default;

} // namespace program

#endif
