// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/Output_file.h"

#include "io/errors.h"

#include <atomic>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

namespace program {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail_to_write(const std::string& filename, int error)
{
  throw Output_error(filename + ": it cannot be written: " + std::strerror(error) + ".");
}

// The name of the temporary file that is being written, or null.
std::atomic<const char*> unfinished_file{nullptr};

// Calls only functions that are safe in a signal handler.
void remove_unfinished_file(int signal)
{
  if(const char* const filename = unfinished_file)
    ::unlink(filename);
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

// A file descriptor. The destructor closes the file and deletes a temporary file that was not
// committed.
class Descriptor
{
public:
  Descriptor(const std::string& filename, int flags, bool is_temporary)
      : m_filename(filename), m_is_temporary(is_temporary)
  {
    if(m_is_temporary)
      unfinished_file = m_filename.c_str();
    m_descriptor = ::open(filename.c_str(), flags, 0666);
  }

  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  ~Descriptor()
  {
    if(m_descriptor >= 0)
      ::close(m_descriptor);
    if(m_is_temporary && was_opened())
      ::unlink(m_filename.c_str());
    unfinished_file = nullptr;
  }

  bool is_open() const { return m_descriptor >= 0; }

  // Writes all bytes. Returns 0 or the value of errno.
  int write(std::string_view bytes)
  {
    while(!bytes.empty())
    {
      const ::ssize_t n = ::write(m_descriptor, bytes.data(), bytes.size());
      if(n < 0 && errno == EINTR)
        continue;
      if(n < 0)
        return errno;
      bytes.remove_prefix(static_cast<std::size_t>(n));
    }
    return 0;
  }

  int close()
  {
    const int error = ::close(m_descriptor) == 0 ? 0 : errno;
    m_descriptor = -1;
    m_is_closed = true;
    return error;
  }

  void commit() { m_is_temporary = false; }

private:
  bool was_opened() const { return m_descriptor >= 0 || m_is_closed; }

  std::string m_filename;
  bool m_is_temporary;
  int m_descriptor = -1;
  bool m_is_closed = false;
};

// Returns the target of symbolic links, so that writing replaces the target and keeps the link.
fs::path resolve_links(const std::string& filename)
{
  std::error_code error;
  const fs::path target = fs::weakly_canonical(filename, error);
  return error ? fs::path(filename) : target;
}

} // namespace

std::string temporary_filename(const std::string& filename)
{
  static unsigned count = 0;
  const fs::path target = resolve_links(filename);
  return (target.parent_path() / ("." + target.filename().string() + "." +
                                  std::to_string(::getpid()) + "." + std::to_string(count++)))
      .string();
}

void replace_file(const std::string& temporary, const std::string& filename)
{
  if(::rename(temporary.c_str(), resolve_links(filename).c_str()) != 0)
  {
    const int error = errno;
    ::unlink(temporary.c_str());
    fail_to_write(filename, error);
  }
}

void write_file(const std::string& filename, std::string_view bytes)
{
  std::error_code ignored;
  const auto status = fs::status(filename, ignored);
  if(fs::is_directory(status))
    fail_to_write(filename, EISDIR);
  const bool is_special_file = fs::exists(status) && !fs::is_regular_file(status);
  const std::string name = is_special_file ? filename : temporary_filename(filename);
  Descriptor file(name, is_special_file ? O_WRONLY : O_WRONLY | O_CREAT | O_EXCL, !is_special_file);
  if(!file.is_open())
    fail_to_write(filename, errno);
  if(const int error = file.write(bytes); error != 0)
    fail_to_write(filename, error);
  if(const int error = file.close(); error != 0)
    fail_to_write(filename, error);
  if(!is_special_file)
  {
    replace_file(name, filename);
    file.commit();
  }
}

void remove_unfinished_file_on_signals()
{
  for(const int signal : {SIGINT, SIGTERM, SIGHUP})
    if(std::signal(signal, remove_unfinished_file) == SIG_IGN)
      std::signal(signal, SIG_IGN); // nohup ignores SIGHUP
}

void check_directory(const std::string& filename)
{
  const fs::path directory = fs::path(filename).parent_path();
  std::error_code ignored;
  if(!directory.empty() && !fs::is_directory(directory, ignored))
    throw Output_error(filename + ": it cannot be written, the directory " + directory.string() +
                       " does not exist.");
}

void append_number(std::string& text, double value)
{
  if(std::isnan(value))
    text += "nan";
  else if(std::isinf(value))
    text += value < 0 ? "-inf" : "inf";
  else
  {
    char buffer[32];
    text.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr);
  }
}

std::string number_text(double value)
{
  std::string text;
  append_number(text, value);
  return text;
}

std::string number_lines(const std::vector<double>& values)
{
  constexpr std::size_t usual_size = 20;
  std::string text;
  text.reserve(usual_size * values.size());
  for(const double value : values)
  {
    append_number(text, value);
    text += '\n';
  }
  return text;
}

} // namespace program
