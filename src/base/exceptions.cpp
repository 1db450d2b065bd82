#include "base/exceptions.h"

#include <new>
#include <stdexcept>
#include <system_error>
#include <typeinfo>

#include "base/log.h"

namespace macula {

Error errorOf(const std::exception& thrown, Text task, std::string where) {
    if (dynamic_cast<const std::bad_alloc*>(&thrown) != nullptr) {
        return {ErrorCode::outOfMemory, Text("There is not enough memory to {}.", std::move(task)),
                std::move(where), Text("Close other programs, or choose something smaller.")};
    }
    log::warning("an exception of type {} ended what was done", typeid(thrown).name());
    if (const auto* failed = dynamic_cast<const std::system_error*>(&thrown)) {
        const std::error_code& code = failed->code();
        if (code == std::errc::resource_unavailable_try_again || code == std::errc::not_enough_memory) {
            return {ErrorCode::outOfMemory,
                    Text("The system has no memory or threads left to {}.", std::move(task)),
                    std::move(where), Text("Close other programs.")};
        }
        return {ErrorCode::inputNotUsable,
                Text("The system gave an error when the program was to {}.", std::move(task)),
                std::move(where), Text("Check disk, connection and permissions, and try again.")};
    }
    if (dynamic_cast<const std::length_error*>(&thrown) != nullptr) {
        return {ErrorCode::inputNotUsable,
                Text("The program could not {}: a size in it is beyond all bounds.", std::move(task)),
                std::move(where), Text("Copy it again from its source.")};
    }
    return {ErrorCode::inputNotUsable,
            Text("The program could not {}, for a reason that it did not foresee.", std::move(task)),
            std::move(where), Text("Try again; if it fails again, report it, with the log of the program.")};
}

}  // namespace macula
