// Thread priorities, for when all threads want the processor at once.
#pragma once

namespace macula {

// How far a thread lowers its priority below that of the user interface's thread.
enum class GiveWay {
    toTheHand,   // work on the host that follows the user's hand, such as slices
    toTheFrame,  // the picture, and what it waits for. Where the device is the CPU, tracing takes every core.
    toAll,       // work that nobody waits for
};

// Lowers the priority (nice value) of the calling thread and of those that it starts from now on, such as a
// driver's when it makes the device. Does nothing on systems other than Linux. A refusal is no error:
// everything works, only less smoothly.
void giveWay(GiveWay to);

}  // namespace macula
