// Thread priorities, for when all threads want the processor at once.
#pragma once

namespace macula {

// How far a thread lowers its priority below that of the user interface's thread, by the kind of its work.
enum class GiveWay {
    toTheHand,   // for work on the host that follows the user's hand, such as slices
    toTheFrame,  // for the picture, and what it waits for; where the CPU is the device, it uses every core
    toAll,       // for work that nobody waits for
};

// Lowers the priority (nice value) of the calling thread and of the threads that it starts later, such as
// those of a driver when this thread creates the device. Does nothing on systems other than Linux. If the
// system refuses, there is no error: everything works, only less smoothly.
void giveWay(GiveWay to);

}  // namespace macula
