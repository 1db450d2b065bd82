// DCMTK's log quotes what it reads, which may be of a patient, and its level is one for the whole process, in
// which Macula may be a guest.
#pragma once

namespace macula::dicom {

// While one lives, what DCMTK logs in this thread does not come to the root logger's appenders. The log of
// other threads, and of this one before and after, is as it was.
class QuietToolkit {
  public:
    QuietToolkit();
    ~QuietToolkit();
    QuietToolkit(const QuietToolkit&) = delete;
    QuietToolkit& operator=(const QuietToolkit&) = delete;
};

// Switches the log off in the whole process: for programs of our own, never for what others embed.
void silenceToolkit();

}  // namespace macula::dicom
