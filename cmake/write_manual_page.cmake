# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Writes FILE.gz, the compressed manual page that PROGRAM prints.
execute_process(COMMAND ${PROGRAM} --manual-page OUTPUT_FILE ${FILE} COMMAND_ERROR_IS_FATAL ANY)
# If this variable is set, the archive has no time stamp.
set(ENV{SOURCE_DATE_EPOCH} 0)
file(ARCHIVE_CREATE OUTPUT ${FILE}.gz PATHS ${FILE} FORMAT raw COMPRESSION GZip COMPRESSION_LEVEL 9)
