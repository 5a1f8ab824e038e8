// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_PICTURE_DISPLAY_H
#define GEODESIC_PROGRAM_PICTURE_DISPLAY_H

#include <sys/types.h>

namespace program {

// Something to draw on.  Uses the X server that the environment variable GEODESIC_DISPLAY names, so
// that several runs share one.  Otherwise it starts Xvfb, a server without a screen, and ends it with
// its own life.  If Xvfb does not start, it uses the display that DISPLAY names.
// Throws Usage_error with a sentence that says what is missing.
class Display
{
public:
  Display();
  ~Display();
  Display(const Display&) = delete;
  Display& operator=(const Display&) = delete;

private:
  [[maybe_unused]] ::pid_t m_server = -1; // unused without pictures
};

} // namespace program

#endif // GEODESIC_PROGRAM_PICTURE_DISPLAY_H
