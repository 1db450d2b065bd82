#include "session/trouble.h"

#include <cerrno>

namespace macula::session {

namespace {

struct Sentence {
    ErrorCode code;
    Text message;
    Text hint;
};

// In the order of Trouble.
const Sentence kSentences[] = {
    {ErrorCode::outputNotWritable,
     Text("Sessions cannot be stored: the folder or a file in it is read-only."),
     Text("Make the folder writable for you, or choose another one.")},
    {ErrorCode::outputNotWritable, Text("Sessions cannot be stored: the disk is full."),
     Text("Free some space on that disk; what was stored before is unharmed.")},
    {ErrorCode::outputNotWritable, Text("Sessions cannot be stored: the drive cannot lock files."),
     Text("Choose a folder on a local disk, or have locks switched on for that network drive.")},
    {ErrorCode::outputNotWritable, Text("Stored sessions are in use by another program."),
     Text("Wait a moment and try again, or close other windows of Macula.")},
    {ErrorCode::inputNotUsable, Text("The file of stored sessions is damaged."),
     Text(
         "Close all windows of Macula and start it again: it rescues what can be read, and keeps the file.")},
    {ErrorCode::inputNotUsable, Text("Stored sessions were written by a newer version of Macula."),
     Text("Use that version, or choose another folder. Nothing was changed.")},
    {ErrorCode::inputNotUsable, Text("The folder for sessions holds files of another program."),
     Text("Choose an empty folder, or one that Macula made. Nothing was changed.")},
    {ErrorCode::outputNotWritable, Text("The disk reported an error while sessions were read or stored."),
     Text("Have the disk checked, or choose a folder on another one.")},
    {ErrorCode::outOfMemory, Text("There is not enough memory to read or store sessions."),
     Text("Close other programs and try again.")},
    {ErrorCode::inputNotUsable, Text("A stored model is damaged; it was set aside."),
     Text("Nothing has to be done: the model is learnt anew.")},
    {ErrorCode::outputNotWritable, Text("A model is larger than all that may be stored."),
     Text("Raise the limit for stored models.")},
    {ErrorCode::inputNotUsable, Text("The stored model is no longer there."),
     Text("Nothing has to be done: the model is learnt anew.")},
    {ErrorCode::inputNotUsable, Text("A stored setting is damaged; it was set aside."),
     Text("Make the setting once more.")},
    {ErrorCode::usage, Text("What is to be stored is no valid setting."),
     Text("Check that it has a name of at most 200 bytes, and is a JSON object of at most 8 MB and 64 "
          "levels.")},
    {ErrorCode::inputNotUsable, Text("The folder holds no exported sessions."),
     Text("Choose a folder that the export of sessions made.")},
    {ErrorCode::outputNotWritable,
     Text("The data are deleted, but traces may remain in a file that another program is reading."),
     Text("Close other windows of Macula and delete the same once more.")},
};
static_assert(std::size(kSentences) == kTroubles);

}  // namespace

Error errorOf(Trouble trouble, const std::filesystem::path& where) {
    const Sentence& sentence = kSentences[static_cast<std::size_t>(trouble)];
    return {sentence.code, sentence.message, where.string(), sentence.hint};
}

std::optional<Trouble> troubleOf(const Error& error) {
    for (int i = 0; i < kTroubles; ++i)
        if (error.message == kSentences[i].message) return static_cast<Trouble>(i);
    return {};
}

Trouble troubleOfErrno(int reason) {
    switch (reason) {
        case EACCES:
        case EPERM:
        case EROFS:
        case ENOENT:
        case ENOTDIR:
            return Trouble::readOnly;
        case ENOSPC:
        case EDQUOT:
        case EFBIG:
            return Trouble::diskFull;
        case ENOLCK:
        case ENOSYS:
        case EOPNOTSUPP:
            return Trouble::noLocks;
        case ENOMEM:
            return Trouble::noMemory;
        default:
            return Trouble::diskError;
    }
}

}  // namespace macula::session
