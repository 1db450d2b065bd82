// Where programs keep what they keep of a person.
#pragma once

#include <filesystem>

namespace macula {

// $XDG_DATA_HOME/macula, else ~/.local/share/macula. It need not be there.
std::filesystem::path userDataFolder();

}  // namespace macula
