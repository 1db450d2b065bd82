// Silences DCMTK's log, which quotes data that may name a patient. Its level holds for the whole process, in
// which Macula may be a guest.
#pragma once

namespace macula {

// While such an object exists, nothing that DCMTK logs in this thread reaches the root logger's appenders.
// The logs of other threads, and of this one before and after, stay as they are.
class QuietToolkit {
  public:
    QuietToolkit();
    ~QuietToolkit();
    QuietToolkit(const QuietToolkit&) = delete;
    QuietToolkit& operator=(const QuietToolkit&) = delete;
};

// Switches the log off in the whole process: for programs of our own, never for what others embed.
void silenceToolkit();

}  // namespace macula
