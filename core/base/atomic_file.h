#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

#include "steradian/core/base/api.h"

namespace STERADIAN_API steradian {

/// Writes a whole file so that a reader finds either what was there before or all of `data`, never a part: into a
/// new file beside the target, fsynced, size verified, renamed. The mode of a replaced file is kept.
///
/// Symbolic links are followed, so that the file they point to is replaced and not the link. A target that exists
/// and is no regular file (a device, a pipe) is written in place. The path "-" is standard output.
///
/// Throws `Error` (kind Output) that names the path and the system's reason; nothing is left behind then. Two
/// reasons arrive as signals unless the host ignores them: SIGXFSZ (file size limit) and SIGPIPE (a pipe without a
/// reader). This function sets no handlers.
void writeFileAtomically(const std::filesystem::path& target, std::span<const std::byte> data);

/// Throws the error that `writeFileAtomically` would now throw for a missing directory, missing permission, a
/// directory as target or a read-only file system, so that a long computation fails before it starts. Creates and
/// changes nothing, and does not open pipes or devices. A full disk can only be seen when writing.
void checkWritable(const std::filesystem::path& target);

}  // namespace steradian
