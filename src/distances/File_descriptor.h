// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_FILE_DESCRIPTOR_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_FILE_DESCRIPTOR_H

#include <CGAL/Geodesic_processing/internal/core/export.h>

#include <cstddef>
#include <string>

namespace CGAL::Geodesic_processing::internal {

// Throws File_error with the path and the reason, which is a sentence without its period.
[[noreturn]] void throw_file_error(const std::string& path, const std::string& reason);

// A file that is open for reading and writing. The file is closed by the destructor. All functions
// throw File_error.
class CGAL_GEODESIC_PROCESSING_EXPORT File_descriptor
{
public:
  // Opens a file, with O_CREAT as a flag also a new one.
  explicit File_descriptor(const std::string& path, int flags = 0);
  ~File_descriptor();
  File_descriptor(const File_descriptor&) = delete;
  File_descriptor& operator=(const File_descriptor&) = delete;

  const std::string& path() const { return m_path; }

  // Locks the file until it is closed or the process ends. Returns false if it is locked already.
  // File systems without locks are not protected.
  bool lock();
  // Returns whether the file still has a name.
  bool has_name() const;
  std::size_t size() const;

  // Returns `size` bytes, or fewer at the end of the file.
  std::string read(std::size_t size, std::size_t position) const;
  void write(const char* bytes, std::size_t size, std::size_t position);
  void resize(std::size_t size);
  // Extends the file to this size, which must be positive, and reserves the space of the disk.
  void reserve(std::size_t size);
  // Waits until everything is on the disk.
  void synchronize();

private:
  std::string m_path;
  int m_file = -1; // POSIX file descriptor
};

// Renames a file, replaces a file of the new name, and synchronizes the folder.
CGAL_GEODESIC_PROCESSING_EXPORT void rename_file(const std::string& from, const std::string& to);

// Removes a file if it exists.
CGAL_GEODESIC_PROCESSING_EXPORT void remove_file(const std::string& path);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_FILE_DESCRIPTOR_H
