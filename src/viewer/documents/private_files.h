// Files for another program of this computer, which only their owner can read and which do not stay.
#pragma once

#include <QString>
#include <QTemporaryDir>
#include <memory>
#include <string>
#include <string_view>

#include "base/result.h"

namespace macula::viewer {

// They are removed with this object. Their names say nothing of the patient.
class PrivateFiles {
  public:
    // A new file "document-1.pdf" with these bytes. Fails with outputNotWritable.
    Result<QString> write(std::string_view bytes, const QString& suffix);

  private:
    std::unique_ptr<QTemporaryDir> folder_;
    int files_ = 0;
};

}  // namespace macula::viewer
