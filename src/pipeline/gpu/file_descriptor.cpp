#include "pipeline/gpu/file_descriptor.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>

namespace macula::gpu {

Result<FileDescriptor> FileDescriptor::copyOf(int descriptor) {
    // Above stdin, stdout and stderr: if a program has closed these, output meant for them must not be
    // written into the copy.
    const int copy = fcntl(descriptor, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
    if (copy >= 0) return FileDescriptor(copy);
    if (errno == EMFILE || errno == ENFILE)
        return Error{
            ErrorCode::outOfMemory,
            Text("This program has as many files open as it may, so what is shared cannot be opened."), "",
            Text("Close what is not needed, or let the program open more files (ulimit -n).")};
    return Error{
        ErrorCode::usage, Text("A file descriptor of what is shared is not open."), "",
        Text("Give one that vkGetMemoryFdKHR or vkGetSemaphoreFdKHR made, and close it afterwards.")};
}

FileDescriptor::~FileDescriptor() {
    if (descriptor_ >= 0) close(descriptor_);
}

}  // namespace macula::gpu
