// Which handles are open, and who uses them. A pointer that is closed, of another kind, or in use elsewhere
// is refused and never followed: a mistake of the host must not cause a crash or a wrong picture.
#pragma once

#include <macula.h>

#include <atomic>
#include <memory>
#include <mutex>
#include <type_traits>
#include <unordered_map>
#include <utility>

#include "base/result.h"
#include "c/last_error.h"

namespace macula::c {

// Many read, or one changes; nobody waits.
class InUse {
  public:
    bool beginReading() {
        int users = users_.load();
        while (users >= 0)
            if (users_.compare_exchange_weak(users, users + 1)) return true;
        return false;
    }
    bool beginChanging() {
        int nobody = 0;
        return users_.compare_exchange_strong(nobody, kChanged);
    }
    void endReading() { users_.fetch_sub(1); }
    void endChanging() { users_.store(0); }

  private:
    static constexpr int kChanged = -1;
    std::atomic<int> users_{0};
};

template <class Handle>
struct OpenHandle {
    std::unique_ptr<Handle> handle;
    InUse use;
};

// A handle in use; `const` if others may read it too. Its object lives as long as this, even if another
// thread closes the handle meanwhile.
template <class Handle>
class Held {
    using Open = OpenHandle<std::remove_const_t<Handle>>;

  public:
    explicit Held(std::shared_ptr<Open> open) : open_(std::move(open)) {}
    Held(Held&&) noexcept = default;
    Held& operator=(Held&&) = delete;
    ~Held() {
        if (!open_) return;
        if constexpr (std::is_const_v<Handle>)
            open_->use.endReading();
        else
            open_->use.endChanging();
    }

    Handle& operator*() const { return *open_->handle; }
    Handle* operator->() const { return open_->handle.get(); }

  private:
    std::shared_ptr<Open> open_;
};

// The open handles of one kind in this process.
template <class Handle>
class OpenHandles {
  public:
    // Never destroyed: a handle that a host leaves open must not be closed after the driver that it uses.
    static OpenHandles& all() {
        static OpenHandles& handles = *new OpenHandles;
        return handles;
    }

    Handle* add(std::unique_ptr<Handle> handle) {
        auto open = std::make_shared<OpenHandle<Handle>>();
        open->handle = std::move(handle);
        Handle* const key = open->handle.get();
        const std::scoped_lock lock(mutex_);
        open_.emplace(key, std::move(open));
        return key;
    }
    // Null when there is none.
    std::shared_ptr<OpenHandle<Handle>> find(const Handle* handle) {
        const std::scoped_lock lock(mutex_);
        const auto found = open_.find(handle);
        return found == open_.end() ? nullptr : found->second;
    }
    void close(const Handle* handle) {
        std::shared_ptr<OpenHandle<Handle>> closed;  // destroyed after the lock, as it may take long
        const std::scoped_lock lock(mutex_);
        const auto found = open_.find(handle);
        if (found == open_.end()) return;
        closed = std::move(found->second);
        open_.erase(found);
    }

  private:
    std::mutex mutex_;
    std::unordered_map<const Handle*, std::shared_ptr<OpenHandle<Handle>>> open_;
};

inline Error closedHandle() {
    return badArgument(
        Text("A handle is closed, or of another kind."),
        Text("Close each handle once, when nothing uses it any more, and give each function what "
             "macula.h says."));
}

inline Error handleInUse() {
    return badArgument(
        Text("A handle is in use by another call."),
        Text("Use it by one thread at a time, or make one for each thread; and call nothing of Macula "
             "while it tells progress."));
}

// Marks the handle as read until Held is destroyed. MACULA_USAGE if it is null, closed, of another kind, or
// if another call changes it.
template <class Handle>
Result<Held<const Handle>> reading(const Handle* handle) {
    if (handle == nullptr) return nullHandle();
    auto open = OpenHandles<Handle>::all().find(handle);
    if (open == nullptr) return closedHandle();
    if (!open->use.beginReading()) return handleInUse();
    return Held<const Handle>(std::move(open));
}

// Marks the handle as changed until Held is destroyed. MACULA_USAGE as above, and if another call reads it.
template <class Handle>
Result<Held<Handle>> changing(Handle* handle) {
    static_assert(!std::is_const_v<Handle>);
    if (handle == nullptr) return nullHandle();
    auto open = OpenHandles<Handle>::all().find(handle);
    if (open == nullptr) return closedHandle();
    if (!open->use.beginChanging()) return handleInUse();
    return Held<Handle>(std::move(open));
}

template <class Handle>
Handle* opened(std::unique_ptr<Handle> handle) {
    return OpenHandles<Handle>::all().add(std::move(handle));
}

// Does nothing if it is null or closed. A handle in use lives until the call that uses it ends.
template <class Handle>
void close(Handle* handle) noexcept {
    if (handle != nullptr) OpenHandles<Handle>::all().close(handle);
}

// A text by its index; null if there is none, or if reading() refuses the handle.
template <class Handle, class TextsOf>
const char* textAt(const Handle* handle, std::uint32_t index, const TextsOf& textsOf) noexcept {
    const char* text = nullptr;
    guarded([&]() -> Result<void> {
        MACULA_TRY(const Held<const Handle> of, reading(handle));
        const auto& texts = textsOf(*of);
        if (index < texts.size()) text = texts[index].c_str();
        return {};
    });
    return text;
}

}  // namespace macula::c
