// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "distances/File_descriptor.h"

#include <CGAL/Geodesic_processing/exceptions.h>

#include <cerrno>
#include <filesystem>
#include <system_error>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace CGAL::Geodesic_processing::internal {

namespace {

[[noreturn]] void throw_system_error(const std::string& path, const std::string& reason, int error)
{
  throw_file_error(path, reason + " (" + std::generic_category().message(error) + ")");
}

std::filesystem::path folder_of(const std::string& path)
{
  std::error_code error;
  return std::filesystem::absolute(path, error).parent_path();
}

} // namespace

void throw_file_error(const std::string& path, const std::string& reason)
{
  throw File_error(path + ": " + reason + ".");
}

File_descriptor::File_descriptor(const std::string& path, int flags)
    : m_path(path), m_file(::open(path.c_str(), O_RDWR | O_CLOEXEC | flags, 0666))
{
  if(m_file < 0)
    throw_system_error(path, "it cannot be opened for writing", errno);
}

File_descriptor::~File_descriptor() { ::close(m_file); }

bool File_descriptor::lock()
{
  return ::flock(m_file, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
}

bool File_descriptor::has_name() const
{
  struct stat status;
  return ::fstat(m_file, &status) == 0 && status.st_nlink > 0;
}

std::size_t File_descriptor::size() const
{
  struct stat status;
  if(::fstat(m_file, &status) != 0)
    throw_system_error(m_path, "its size cannot be read", errno);
  return static_cast<std::size_t>(status.st_size);
}

std::string File_descriptor::read(std::size_t size, std::size_t position) const
{
  std::string result(size, '\0');
  std::size_t number_read = 0;
  while(number_read < size)
  {
    const ssize_t count = ::pread(m_file, result.data() + number_read, size - number_read,
                                  static_cast<off_t>(position + number_read));
    if(count < 0 && errno == EINTR)
      continue;
    if(count < 0)
      throw_system_error(m_path, "it cannot be read", errno);
    if(count == 0)
      break;
    number_read += static_cast<std::size_t>(count);
  }
  result.resize(number_read);
  return result;
}

void File_descriptor::write(const char* bytes, std::size_t size, std::size_t position)
{
  while(size > 0)
  {
    const ssize_t count = ::pwrite(m_file, bytes, size, static_cast<off_t>(position));
    if(count < 0 && errno == EINTR)
      continue;
    if(count <= 0)
      throw_system_error(m_path, "it cannot be written", errno);
    bytes += count;
    size -= static_cast<std::size_t>(count);
    position += static_cast<std::size_t>(count);
  }
}

void File_descriptor::resize(std::size_t size)
{
  if(::ftruncate(m_file, static_cast<off_t>(size)) != 0)
    throw_system_error(m_path, "it cannot be written", errno);
}

void File_descriptor::reserve(std::size_t size)
{
  // Reserving would fill the disk before it fails.
  std::error_code error;
  const std::filesystem::space_info space = std::filesystem::space(folder_of(m_path), error);
  if(!error && space.available < size)
    throw_file_error(m_path, "it needs " + std::to_string(size) + " bytes, but the disk has only " +
                                 std::to_string(space.available));
  if(const int failure = ::posix_fallocate(m_file, 0, static_cast<off_t>(size)); failure != 0)
    throw_system_error(m_path, "the disk has no space for " + std::to_string(size) + " bytes",
                       failure);
}

void File_descriptor::synchronize()
{
  if(::fsync(m_file) != 0)
    throw_system_error(m_path, "it cannot be synchronized with the disk", errno);
}

void rename_file(const std::string& from, const std::string& to)
{
  if(::rename(from.c_str(), to.c_str()) != 0)
    throw_system_error(from, "it cannot be renamed to " + to, errno);
  // Some file systems cannot synchronize folders. The name is then written later.
  const int folder = ::open(folder_of(to).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if(folder >= 0)
  {
    ::fsync(folder);
    ::close(folder);
  }
}

void remove_file(const std::string& path)
{
  if(::unlink(path.c_str()) != 0 && errno != ENOENT)
    throw_system_error(path, "it cannot be removed", errno);
}

} // namespace CGAL::Geodesic_processing::internal
