// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_PICTURE_DISPLAY_H
#define GEODESIC_PROGRAM_PICTURE_DISPLAY_H

#include <sys/types.h>

namespace program {

// An X display for off-screen rendering. Uses the X server that the environment variable
// GEODESIC_DISPLAY names, so that several runs can share one. Otherwise, starts Xvfb (a server
// without a screen) and terminates it in the destructor. If Xvfb does not start, uses the display
// that DISPLAY names. Throws Usage_error that names the missing component.
class Display
{
public:
  Display();
  ~Display();
  Display(const Display&) = delete;
  Display& operator=(const Display&) = delete;

private:
  [[maybe_unused]] ::pid_t m_server = -1; // unused if built without pictures
};

} // namespace program

#endif // GEODESIC_PROGRAM_PICTURE_DISPLAY_H
