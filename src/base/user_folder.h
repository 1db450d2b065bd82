// The folder for the user's data.
#pragma once

#include <filesystem>

namespace macula {

// $XDG_DATA_HOME/macula, else ~/.local/share/macula. It may not exist.
std::filesystem::path userDataFolder();

}  // namespace macula
